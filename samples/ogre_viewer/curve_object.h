// SPDX-License-Identifier: MIT
// Curves of the SDK as tubes in OGRE's scene: one renderable over hardware buffers of fixed size, to which points are
// appended. What was uploaded stays as it is, but for the ring of a curve's last point, which is a tip until the next
// point says where the curve goes on.
#pragma once

#include <OgreColourValue.h>
#include <OgreSimpleRenderable.h>

#include <vector>

#include "filigree/filigree.h"

namespace viewer {

class CurveObject final : public Ogre::SimpleRenderable {
public:
    // `radius` and `colour` (linear) hold where curves have no such column; a RADIUS column is multiplied by
    // `radius_scale`.
    struct Look {
        float radius = 0.004f, radius_scale = 1.0f;
        Ogre::ColourValue colour = Ogre::ColourValue::White;
    };
    // Room for so many points, and one more for each closed curve.
    CurveObject(uint32_t max_points, const Look& look, const Ogre::MaterialPtr& material);

    // Copies the points of a view to the graphics card; with `continues` its first curve goes on where the last one
    // ended. Throws std::length_error where there is no room.
    void append(const FlgCurveSetView& view, bool continues = false);
    void clear();

    uint32_t point_count() const { return points_; }
    // Of the last append.
    size_t uploaded_bytes() const { return uploaded_; }

    Ogre::Real getBoundingRadius() const override;
    Ogre::Real getSquaredViewDepth(const Ogre::Camera* camera) const override;

private:
    static constexpr uint32_t kSides = 4;
    struct Vertex {
        Ogre::Vector3f position, normal;
        Ogre::uint32 colour;
    };
    struct Point {
        Ogre::Vector3 position;
        float radius;
        Ogre::uint32 colour;
    };

    void add_point(const Point& point, bool tip);
    void place_ring(uint32_t ring, const Ogre::Vector3& tangent, float radius);
    void upload();

    uint32_t max_points_, points_ = 0, curve_points_ = 0;  // of the last curve
    Look look_;
    Point last_ = {}, before_ = {};
    Ogre::Vector3 tangent_, normal_;  // the frame that is carried along, at the point `before_`
    // Not uploaded yet: rings from first_ring_ on, and indices.
    uint32_t first_ring_ = 0;
    std::vector<Vertex> rings_;
    std::vector<uint32_t> indices_;
    size_t index_count_ = 0, uploaded_ = 0;
    Ogre::VertexData vertex_data_;
    Ogre::IndexData index_data_;
    Ogre::HardwareVertexBufferSharedPtr vertices_;
};

}  // namespace viewer
