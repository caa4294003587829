// SPDX-License-Identifier: MIT
// The borders of regions, and how large they are: what is highlighted, clicked as a seed, and what sizes are guessed
// from.
#pragma once

#include <glm/glm.hpp>

#include "tangles/region_list.h"

namespace flg::studio {

// Closed; the regions lie to the left.
struct BorderLoop {
    std::vector<glm::vec3> points, normals;
    std::vector<float> shares;  // of its length, up to each point
    float length = 0.0f;
};

struct Outline {
    std::vector<BorderLoop> loops;  // in the order of FlgBorderStretch::loop, beginning where it begins
    float area = 0.0f, perimeter = 0.0f;
    uint32_t leaf_count = 0;
    FlgSurfacePoint top{};  // the highest vertex
    glm::vec3 top_place{0.0f};

    // Metres that a leaf is across: half of the width of long ones.
    float breadth() const;
    // The edge of a square of the same area.
    float size() const;
};

// `leaves` rise.
Outline trace_outline(const FlgSurfaceView& surface, const Regions& leaves);

}  // namespace flg::studio
