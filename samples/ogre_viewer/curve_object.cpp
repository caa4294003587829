// SPDX-License-Identifier: MIT
#include "curve_object.h"

#include <OgreCamera.h>
#include <OgreHardwareBufferManager.h>
#include <OgreNode.h>

#include <cmath>
#include <stdexcept>

namespace viewer {
namespace {

const FlgColumn* find(const FlgCurveSetView& view, FlgAttribute attribute) {
    for (uint32_t c = 0; c < view.column_count; ++c)
        if (view.columns[c].attribute == attribute) return &view.columns[c];
    return nullptr;
}

Ogre::Vector3 reflected(const Ogre::Vector3& v, const Ogre::Vector3& along) {
    const float square = along.squaredLength();
    return square > 0 ? v - along * (2 * along.dotProduct(v) / square) : v;
}

}  // namespace

CurveObject::CurveObject(uint32_t max_points, const Look& look, const Ogre::MaterialPtr& material)
    : max_points_(max_points), look_(look) {
    setMaterial(material);
    Ogre::VertexDeclaration& declaration = *vertex_data_.vertexDeclaration;
    size_t offset = 0;
    offset += declaration.addElement(0, offset, Ogre::VET_FLOAT3, Ogre::VES_POSITION).getSize();
    offset += declaration.addElement(0, offset, Ogre::VET_FLOAT3, Ogre::VES_NORMAL).getSize();
    offset += declaration.addElement(0, offset, Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE).getSize();
    Ogre::HardwareBufferManager& manager = Ogre::HardwareBufferManager::getSingleton();
    vertices_ = manager.createVertexBuffer(offset, size_t{kSides} * max_points, Ogre::HBU_CPU_TO_GPU);
    vertex_data_.vertexBufferBinding->setBinding(0, vertices_);
    index_data_.indexBuffer = manager.createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT,
                                                        size_t{6} * kSides * max_points, Ogre::HBU_CPU_TO_GPU);
    mRenderOp.vertexData = &vertex_data_;
    mRenderOp.indexData = &index_data_;
    mRenderOp.operationType = Ogre::RenderOperation::OT_TRIANGLE_LIST;
    mRenderOp.useIndexes = true;
    clear();
}

void CurveObject::clear() {
    points_ = curve_points_ = 0;
    index_count_ = uploaded_ = 0;
    vertex_data_.vertexCount = 0;
    index_data_.indexCount = 0;
    mBox.setNull();
    setVisible(false);
}

void CurveObject::append(const FlgCurveSetView& view, bool continues) {
    if (view.curve_count == 0) return;
    const FlgColumn& positions = *find(view, FLG_ATTRIBUTE_POSITION);
    const FlgColumn* const radii = find(view, FLG_ATTRIBUTE_RADIUS);
    const FlgColumn* const colours = find(view, FLG_ATTRIBUTE_COLOR);
    first_ring_ = points_;
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        if (c > 0 || !continues) curve_points_ = 0;
        const uint32_t begin = view.curve_offsets[c], count = view.curve_offsets[c + 1] - begin;
        const bool closed = view.curve_flags && (view.curve_flags[c] & FLG_CURVE_CLOSED);
        if (count + closed > max_points_ - points_) throw std::length_error("CurveObject: no room for so many points");
        for (uint32_t k = 0; k < count + closed; ++k) {
            const size_t i = begin + k % count;
            Point point{Ogre::Vector3(positions.data + 3 * i), look_.radius, look_.colour.getAsABGR()};
            if (radii) point.radius = look_.radius_scale * radii->data[i];
            if (colours) {
                const float* const rgba = colours->data + 4 * i;
                point.colour = Ogre::ColourValue(rgba[0], rgba[1], rgba[2]).getAsABGR();
            }
            add_point(point, !closed);
        }
    }
    upload();
}

void CurveObject::add_point(const Point& point, bool tip) {
    if (curve_points_ == 0) {
        tangent_ = normal_ = Ogre::Vector3::ZERO;
    } else {
        // Now it is known where the curve goes from the last point. Its frame is the one before, carried along by two
        // reflections (Wang et al. 2008), which turns it no more than it must.
        const bool first = curve_points_ == 1;
        Ogre::Vector3 tangent = (point.position - (first ? last_ : before_).position).normalisedCopy();
        if (first) {
            normal_ = tangent.perpendicular();
        } else {
            const Ogre::Vector3 step = last_.position - before_.position;
            normal_ = reflected(reflected(normal_, step), tangent - reflected(tangent_, step));
        }
        tangent_ = tangent;
        place_ring(points_ - 1, tangent_, first && tip ? 0.0f : last_.radius);
        for (uint32_t k = 0; k < kSides; ++k) {
            const uint32_t a = (points_ - 1) * kSides + k, b = (points_ - 1) * kSides + (k + 1) % kSides;
            for (const uint32_t index : {a, b, a + kSides, a + kSides, b, b + kSides}) indices_.push_back(index);
        }
    }
    before_ = last_;
    last_ = point;
    ++curve_points_;
    place_ring(points_++, tangent_, tip ? 0.0f : point.radius);
}

// Puts the last point's ring where it will be uploaded from.
void CurveObject::place_ring(uint32_t ring, const Ogre::Vector3& tangent, float radius) {
    if (ring < first_ring_) {  // the tip of what was uploaded before
        first_ring_ = ring;
        rings_.insert(rings_.begin(), kSides, Vertex{});
    }
    rings_.resize(std::max(rings_.size(), size_t{kSides} * (ring - first_ring_ + 1)));
    const Ogre::Vector3 across = tangent.crossProduct(normal_);
    for (uint32_t k = 0; k < kSides; ++k) {
        const float angle = Ogre::Math::TWO_PI * static_cast<float>(k) / kSides;
        const Ogre::Vector3 outwards = std::cos(angle) * normal_ + std::sin(angle) * across;
        const Ogre::Vector3 position = last_.position + radius * outwards;
        rings_[size_t{kSides} * (ring - first_ring_) + k] = {position, outwards, last_.colour};
    }
    mBox.merge(last_.position);
}

void CurveObject::upload() {
    const size_t vertex_bytes = rings_.size() * sizeof(Vertex), index_bytes = indices_.size() * sizeof(uint32_t);
    if (vertex_bytes > 0) vertices_->writeData(first_ring_ * kSides * sizeof(Vertex), vertex_bytes, rings_.data());
    if (index_bytes > 0)
        index_data_.indexBuffer->writeData(index_count_ * sizeof(uint32_t), index_bytes, indices_.data());
    index_count_ += indices_.size();
    uploaded_ = vertex_bytes + index_bytes;
    rings_.clear();
    indices_.clear();
    vertex_data_.vertexCount = size_t{points_} * kSides;
    index_data_.indexCount = index_count_;
    setVisible(index_count_ > 0);
    if (getParentNode()) getParentNode()->needUpdate();
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
