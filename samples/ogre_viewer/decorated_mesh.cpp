// SPDX-License-Identifier: MIT
#include "decorated_mesh.h"

#include <OgreEntity.h>
#include <OgreHardwareBufferManager.h>
#include <OgreMeshManager.h>
#include <OgreSceneManager.h>
#include <OgreSubEntity.h>
#include <OgreSubMesh.h>

#include <array>
#include <cstddef>

namespace viewer {
namespace {

filigree::Surface surface_of(filigree::Context& context, const flg::scenes::Mesh& mesh) {
    const FlgColumn positions = {FLG_ATTRIBUTE_POSITION, 3, &mesh.vertices[0].x, 0, 0};
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    FlgMeshView input = flgMeshViewDefaults();
    input.vertex_count = static_cast<uint32_t>(mesh.vertices.size());
    input.triangle_count = static_cast<uint32_t>(mesh.triangles.size());
    input.columns = &positions;
    input.column_count = 1;
    input.triangles = mesh.triangles[0].data();
    desc.mesh = &input;
    return context.surface(desc);
}

struct Vertex {
    Ogre::Vector3f position, normal;
};

// Means of the triangles' normals by area, for each vertex.
std::vector<Ogre::Vector3f> normals_of(const FlgMeshView& mesh) {
    const auto position = [&](uint32_t v) { return Ogre::Vector3f(mesh.columns[0].data + size_t{3} * v); };
    std::vector<Ogre::Vector3f> normals(mesh.vertex_count, Ogre::Vector3f(0.0f));
    for (size_t t = 0; t < size_t{3} * mesh.triangle_count; t += 3) {
        const uint32_t* const corners = mesh.triangles + t;
        const Ogre::Vector3f a = position(corners[0]), ab = position(corners[1]) - a, ac = position(corners[2]) - a;
        const Ogre::Vector3f twice_area = ab.crossProduct(ac);
        for (size_t k = 0; k < 3; ++k) normals[corners[k]] += twice_area;
    }
    for (Ogre::Vector3f& normal : normals) normal.normalise();
    return normals;
}

}  // namespace

DecoratedMesh::DecoratedMesh(filigree::Context& context, const flg::scenes::Mesh& mesh, Ogre::SceneNode& node,
                             const std::vector<Ogre::MaterialPtr>& materials, const Ogre::MaterialPtr& line)
    : context_(context), node_(node), line_(line), surface_(surface_of(context, mesh)), ornament_(context, surface_) {
    mesh_ = Ogre::MeshManager::getSingleton().createManual("decorated.mesh", Ogre::RGN_DEFAULT);
    mesh_->sharedVertexData = OGRE_NEW Ogre::VertexData();
    Ogre::VertexDeclaration& declaration = *mesh_->sharedVertexData->vertexDeclaration;
    declaration.addElement(0, offsetof(Vertex, position), Ogre::VET_FLOAT3, Ogre::VES_POSITION);
    declaration.addElement(0, offsetof(Vertex, normal), Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
    for (const Ogre::MaterialPtr& material : materials) mesh_->createSubMesh()->setMaterialName(material->getName());
}

void DecoratedMesh::update() {
    if (ready()) return;
    if (border_curves_) return draw_borders();
    // While steps are under way the surface can't be looked at: OGRE goes on drawing what it has.
    if (!ornament_.published() || !surface_.ready()) return;
    refresh(surface_.view());
    if (ornament_.start_next()) return;
    border_curves_ = ornament_.tangle().trace_borders();
    lifted_ = border_curves_.lift();
    filigree::CurveSetResampleDesc even;
    even.spacing = 0.006f;
    lines_ = lifted_.resample(even);
}

void DecoratedMesh::refresh(const FlgSurfaceView& view) {
    refresh_vertices(*view.mesh);
    if (!entity_) node_.attachObject(entity_ = node_.getCreator()->createEntity(mesh_));
    std::array<std::vector<uint32_t>, kColourCount> triangles;
    for (size_t t = 0; t < view.mesh->triangle_count; ++t) {
        auto& list = triangles[static_cast<size_t>(ornament_.colours()[view.mesh->regions[t]])];
        list.insert(list.end(), view.mesh->triangles + 3 * t, view.mesh->triangles + 3 * t + 3);
    }
    for (size_t c = 0; c < kColourCount; ++c) {
        Ogre::IndexData& data = *mesh_->getSubMesh(static_cast<unsigned short>(c))->indexData;
        entity_->getSubEntity(c)->setVisible(!triangles[c].empty());
        data.indexCount = triangles[c].size();
        if (triangles[c].empty()) continue;
        data.indexBuffer = Ogre::HardwareBufferManager::getSingleton().createIndexBuffer(
            Ogre::HardwareIndexBuffer::IT_32BIT, data.indexCount, Ogre::HBU_GPU_ONLY);
        data.indexBuffer->writeData(0, data.indexCount * sizeof(uint32_t), triangles[c].data(), true);
    }
}

// The SDK interleaves both columns in the buffer itself.
void DecoratedMesh::refresh_vertices(const FlgMeshView& mesh) {
    const std::vector<Ogre::Vector3f> normals = normals_of(mesh);
    const Ogre::HardwareVertexBufferSharedPtr buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        sizeof(Vertex), mesh.vertex_count, Ogre::HBU_GPU_ONLY);
    {
        const Ogre::HardwareBufferLockGuard lock(buffer, Ogre::HardwareBuffer::HBL_DISCARD);
        auto* const to = static_cast<unsigned char*>(lock.pData);
        const FlgColumn columns[] = {mesh.columns[0], {FLG_ATTRIBUTE_NORMAL, 3, normals[0].ptr(), 0, 0}};
        FlgBufferColumn targets[2] = {};
        targets[0].attribute = FLG_ATTRIBUTE_POSITION;
        targets[0].data = to + offsetof(Vertex, position);
        targets[1].attribute = FLG_ATTRIBUTE_NORMAL;
        targets[1].data = to + offsetof(Vertex, normal);
        for (FlgBufferColumn& target : targets) target.stride = sizeof(Vertex);
        filigree::BufferOutput output;
        output.set_columns(targets);
        output.row_capacity = mesh.vertex_count;
        filigree::ColumnsWriteDesc desc;
        desc.set_columns(columns);
        desc.row_count = mesh.vertex_count;
        desc.output = &output;
        filigree::columns_write(desc);
    }
    Ogre::AxisAlignedBox box;
    for (size_t v = 0; v < mesh.vertex_count; ++v) box.merge(Ogre::Vector3(mesh.columns[0].data + 3 * v));
    Ogre::VertexData& data = *mesh_->sharedVertexData;
    data.vertexCount = mesh.vertex_count;
    data.vertexBufferBinding->setBinding(0, buffer);
    mesh_->_setBounds(box);
}

void DecoratedMesh::draw_borders() {
    if (!lines_.ready()) return;
    const FlgCurveSetView view = lines_.view();
    CurveObject::Look look;
    look.radius = 0.0012f;
    look.colour = Ogre::ColourValue(0.012f, 0.016f, 0.03f);
    borders_ = std::make_unique<CurveObject>(view.curve_offsets[view.curve_count], view.curve_count, look, line_);
    borders_->append(view);
    borders_->setCastShadows(false);
    node_.attachObject(borders_.get());
    lines_.reset();
    lifted_.reset();
    border_curves_.reset();
}

}  // namespace viewer
