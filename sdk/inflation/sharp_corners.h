// SPDX-License-Identifier: MIT
// Corners of contours that stay corners of the surface. The lattice rounds them, so the nearest vertex of the surface
// takes each one's place.
//
// A corner is where the contour turns by more than an angle within a length, as its chords to either side have it:
// what is drawn round over less than that is a corner too. Of several nearby the sharpest counts.
#pragma once

#include <span>
#include <vector>

#include "inflation/implicit_parts.h"
#include "runtime/task.h"

namespace flg {

struct SharpCorner {
    Vec3 at;  // in the plane of its part
    uint32_t part;
};

// Those on the surface of the union, not buried in other parts. `angle`: radians; `length`: in the model's units. The
// parts outlive the task. Takes about 0.2 us a point of a contour.
Task<std::pmr::vector<SharpCorner>> sharp_corners(Pace& pace, const PartUnion& parts, double angle, double length);

// The vertex that is nearest to each corner, within `reach`; UINT32_MAX where there is none, or where it is another
// corner's. Takes about 2 ns for a vertex and a corner.
Task<Buffer<uint32_t>> vertices_at(Pace& pace, std::span<const SharpCorner> corners, std::span<const Vec3> positions,
                                   double reach);

}  // namespace flg
