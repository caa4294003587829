// SPDX-License-Identifier: MIT
// De Casteljau's construction on a mesh as it is written down: every midpoint is that of a shortest path found anew.
// The oracle of sdk/surfaces/tracing/surface_bezier.h, where shortest paths are unique.
#pragma once

#include <array>
#include <vector>

#include "surfaces/mesh/surface_point.h"

namespace flg::literal {

// The points of a Bezier curve at multiples of 2^-halvings, both ends included.
std::vector<SurfacePoint> surface_bezier(const Mesh& mesh, const std::array<SurfacePoint, 4>& control,
                                         uint32_t halvings);

// The control points of the segments of a natural or closed curve through points that lie within triangles.
std::vector<std::array<SurfacePoint, 4>> surface_handles(const Mesh& mesh, const std::vector<SurfacePoint>& given,
                                                         bool closed);

}  // namespace flg::literal
