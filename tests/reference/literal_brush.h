// SPDX-License-Identifier: MIT
// The simplest tube and ribbon: everything stored, one plain step after another. Oracle of sdk/brush.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace flg::literal {

struct BrushMesh {
    std::vector<Vec3> positions;
    std::vector<std::array<uint32_t, 3>> triangles;
};

// Frames of a curve without repeated points: tangents that halve the turn, normals by double reflection (Wang,
// Juettler, Zheng, Liu 2008, table I).
struct BrushFrames {
    std::vector<Vec3> tangents, normals;
};
BrushFrames brush_frames(const std::vector<Vec3>& points, const Vec3& first_normal);

// Open, without caps. A vertex of the ring that stands across the segment to a point slides along it to the plane that
// halves the turn.
BrushMesh tube(const std::vector<Vec3>& points, const std::vector<double>& radii, uint32_t sides);
BrushMesh ribbon(const std::vector<Vec3>& points, const std::vector<double>& radii);

// Any unit normal across a tangent: of the axis that is least along it.
Vec3 first_normal(const Vec3& tangent);

}  // namespace flg::literal
