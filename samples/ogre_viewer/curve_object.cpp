// SPDX-License-Identifier: MIT
#include "curve_object.h"

#include <OgreCamera.h>
#include <OgreHardwareBufferManager.h>
#include <OgreNode.h>

#include <cstddef>
#include <stdexcept>

namespace viewer {
namespace {

const FlgColumn* find(const FlgCurveSetView& view, FlgAttribute attribute) {
    for (uint32_t c = 0; c < view.column_count; ++c)
        if (view.columns[c].attribute == attribute) return &view.columns[c];
    return nullptr;
}

void check(FlgResult result) {
    if (result != FLG_OK) throw std::runtime_error(flgErrorGetMessage());
}

}  // namespace

CurveObject::CurveObject(uint32_t max_points, uint32_t max_curves, const Look& look, const Ogre::MaterialPtr& material)
    : look_(look), max_vertices_(size_t{kSides} * (max_points + size_t{kCapRings} * max_curves)) {
    setMaterial(material);
    Ogre::VertexDeclaration& declaration = *vertex_data_.vertexDeclaration;
    declaration.addElement(0, offsetof(Vertex, position), Ogre::VET_FLOAT3, Ogre::VES_POSITION);
    declaration.addElement(0, offsetof(Vertex, normal), Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
    declaration.addElement(0, offsetof(Vertex, colour), Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE);
    Ogre::HardwareBufferManager& manager = Ogre::HardwareBufferManager::getSingleton();
    vertices_ = manager.createVertexBuffer(sizeof(Vertex), max_vertices_, Ogre::HBU_CPU_TO_GPU);
    vertex_data_.vertexBufferBinding->setBinding(0, vertices_);
    // Two triangles for each vertex: from it to the next around, and to the next ring.
    index_data_.indexBuffer =
        manager.createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT, 6 * max_vertices_, Ogre::HBU_CPU_TO_GPU);
    mRenderOp.vertexData = &vertex_data_;
    mRenderOp.indexData = &index_data_;
    mRenderOp.operationType = Ogre::RenderOperation::OT_TRIANGLE_LIST;
    mRenderOp.useIndexes = true;
    clear();
}

void CurveObject::clear() {
    points_ = 0;
    state_ = flgBrushMeshStateDefaults();
    first_vertex_ = first_index_ = vertex_count_ = index_count_ = uploaded_ = 0;
    vertex_data_.vertexCount = 0;
    index_data_.indexCount = 0;
    mBox.setNull();
    setVisible(false);
}

void CurveObject::append(const FlgCurveSetView& view, bool continues) {
    if (view.curve_count == 0) return;
    FlgBrushMeshDesc desc = flgBrushMeshDefaults();
    desc.curves = &view;
    desc.curve_count = 1;
    desc.sides = kSides;
    desc.join = FLG_BRUSH_JOIN_NARROW;
    desc.start_cap = desc.end_cap = FLG_BRUSH_CAP_TAPERED;
    desc.default_radius = look_.radius;
    desc.radius_scale = find(view, FLG_ATTRIBUTE_RADIUS) ? look_.radius_scale : 1.0f;
    for (int k = 0; k < 4; ++k) desc.default_color[k] = look_.colour[k];
    uploaded_ = 0;
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        if (c > 0 || !continues) {
            state_ = flgBrushMeshStateDefaults();
            first_vertex_ = vertex_count_;
            first_index_ = index_count_;
        }
        desc.first_curve = c;
        desc.base_vertex = static_cast<uint32_t>(first_vertex_);
        const bool closed = view.curve_flags && (view.curve_flags[c] & FLG_CURVE_CLOSED);
        write(desc, closed ? nullptr : &state_);
    }
    const FlgColumn& positions = *find(view, FLG_ATTRIBUTE_POSITION);
    const uint32_t count = view.curve_offsets[view.curve_count];
    for (uint32_t i = 0; i < count; ++i) mBox.merge(Ogre::Vector3(positions.data + 3 * size_t{i}));
    points_ += count;
    vertex_data_.vertexCount = vertex_count_;
    index_data_.indexCount = index_count_;
    setVisible(index_count_ > 0);
    if (getParentNode()) getParentNode()->needUpdate();
}

void CurveObject::write(const FlgBrushMeshDesc& desc, FlgBrushMeshState* state) {
    FlgBrushMeshSizes sizes = flgBrushMeshSizesDefaults();
    check(flgBrushMeshGetSizes(&desc, state, &sizes));
    FlgBrushMeshOutput output = flgBrushMeshOutputDefaults();
    if (sizes.vertex_count == 0) return check(flgBrushMeshWrite(&desc, state, &output, nullptr));  // a single point
    const size_t vertex = first_vertex_ + sizes.first_vertex, index = first_index_ + sizes.first_index;
    vertex_count_ = vertex + sizes.vertex_count;
    index_count_ = index + sizes.index_count;
    if (vertex_count_ > max_vertices_) throw std::length_error("CurveObject: no room for so many points");
    const size_t vertex_bytes = sizes.vertex_count * sizeof(Vertex), index_bytes = sizes.index_count * sizeof(uint32_t);
    const Ogre::HardwareBufferLockGuard vertices(vertices_, vertex * sizeof(Vertex), vertex_bytes,
                                                 Ogre::HardwareBuffer::HBL_WRITE_ONLY);
    const Ogre::HardwareBufferLockGuard indices(index_data_.indexBuffer, index * sizeof(uint32_t), index_bytes,
                                                Ogre::HardwareBuffer::HBL_WRITE_ONLY);
    auto* const to = static_cast<unsigned char*>(vertices.pData);
    const FlgBufferColumn columns[] = {
        {FLG_ATTRIBUTE_POSITION,
         FLG_NUMBER_FORMAT_FLOAT32,
         to + offsetof(Vertex, position),
         sizeof(Vertex),
         0,
         {},
         0,
         0},
        {FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_FLOAT32, to + offsetof(Vertex, normal), sizeof(Vertex), 0, {}, 0, 0},
        {FLG_ATTRIBUTE_COLOR, FLG_NUMBER_FORMAT_UNORM8, to + offsetof(Vertex, colour), sizeof(Vertex), 0, {}, 0, 0}};
    output.columns = columns;
    output.column_count = 3;
    output.vertex_capacity = sizes.vertex_count;
    output.indices = indices.pData;
    output.index_capacity = sizes.index_count;
    check(flgBrushMeshWrite(&desc, state, &output, nullptr));
    uploaded_ += vertex_bytes + index_bytes;
}

Ogre::Real CurveObject::getBoundingRadius() const {
    return mBox.isFinite() ? Ogre::Math::boundingRadiusFromAABB(mBox) : 0.0f;
}

Ogre::Real CurveObject::getSquaredViewDepth(const Ogre::Camera* camera) const {
    return mBox.isFinite()
               ? (getParentNode()->_getFullTransform() * mBox.getCenter()).squaredDistance(camera->getDerivedPosition())
               : 0.0f;
}

}  // namespace viewer
