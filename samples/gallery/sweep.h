// SPDX-License-Identifier: MIT
// Meshes of cross-sections swept along curves: what a host does with attributes that the renderer's tubes and ribbons
// don't draw.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "filigree/filigree_surface.h"

namespace flg::gallery {

class Sweep {
public:
    // Tubes with the half axes and the angle of the RADII column.
    static Sweep ellipses(const FlgCurveSetView& curves);
    // Slabs along tangent x normal; `half_width` of a point. Regions: 0 the side that the normal points to, 1 the
    // other, 2 the edges.
    static Sweep bands(const FlgCurveSetView& curves, float thickness,
                       const std::function<float(uint32_t point)>& half_width);

    // Lives as long as the sweep stays where it is.
    FlgMeshView view() const;

private:
    struct Corner {
        float normal, binormal;  // metres along the frame's
        uint32_t region;         // of the side from it to the next corner
    };
    using Section = std::vector<Corner>;
    // Sections of the same number of corners. Corners with equal places are kept apart, so that edges stay sharp.
    Sweep(const FlgCurveSetView& curves, const std::function<Section(uint32_t point)>& section);

    std::vector<glm::vec3> positions_;
    std::vector<uint32_t> triangles_, regions_;
    FlgColumn column_ = {};
};

}  // namespace flg::gallery
