// SPDX-License-Identifier: MIT
// Curves of the SDK as tubes in OGRE's scene: one renderable over hardware buffers of fixed size, to which points are
// appended. The SDK writes rings and triangles straight into the buffers while they are mapped. What was written stays
// as it is, but for a growing curve's last ring and its tip.
#pragma once

#include <OgreColourValue.h>
#include <OgreSimpleRenderable.h>

#include "filigree/filigree_brush.h"

namespace viewer {

class CurveObject final : public Ogre::SimpleRenderable {
public:
    // `radius` and `colour` (linear) hold where curves have no such column; a RADIUS column is multiplied by
    // `radius_scale`.
    struct Look {
        float radius = 0.004f, radius_scale = 1.0f;
        Ogre::ColourValue colour = Ogre::ColourValue::White;
    };
    // Room for so many points in so many curves.
    CurveObject(uint32_t max_points, uint32_t max_curves, const Look& look, const Ogre::MaterialPtr& material);

    // Makes tubes of a view's curves; with `continues` its first curve goes on where the last one ended. Throws
    // std::length_error where there is no room.
    void append(const FlgCurveSetView& view, bool continues = false);
    void clear();

    uint32_t point_count() const { return points_; }
    // Of the last append.
    size_t uploaded_bytes() const { return uploaded_; }

    Ogre::Real getBoundingRadius() const override;
    Ogre::Real getSquaredViewDepth(const Ogre::Camera* camera) const override;

private:
    static constexpr uint32_t kSides = 4;
    static constexpr uint32_t kCapRings = 4;  // of a curve's two ends
    struct Vertex {
        Ogre::Vector3f position, normal;
        Ogre::uint32 colour;
    };

    void write(const FlgBrushMeshDesc& desc, FlgBrushMeshState* state);

    const Look look_;
    const size_t max_vertices_;
    uint32_t points_ = 0;
    FlgBrushMeshState state_;                    // of the last curve
    size_t first_vertex_ = 0, first_index_ = 0;  // likewise
    size_t vertex_count_ = 0, index_count_ = 0;  // of all
    size_t uploaded_ = 0;
    Ogre::VertexData vertex_data_;
    Ogre::IndexData index_data_;
    Ogre::HardwareVertexBufferSharedPtr vertices_;
};

}  // namespace viewer
