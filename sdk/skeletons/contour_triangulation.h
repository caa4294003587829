// SPDX-License-Identifier: MIT
// The triangulation of what is inside of a contour. Its points come in one by one, those near each other one after
// the other in each of a few rounds (Amenta, Choi, Rote: Incremental constructions con BRIO, 2003), and stay
// Delaunay; then each edge of the contour is made one of the triangulation by flipping what crosses it (Sloan: A fast
// algorithm for generating constrained Delaunay triangulations, 1993).
//
// Invariants
// - Orientations are exact: all triangles turn counter-clockwise at all times. So the contour is simple if and only
//   if all of its edges can be made, and what keeps one from it is the fault that is reported.
// - Circles are not exact, and after flips for the contour triangles are not made Delaunay again: nothing depends on
//   it but time.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/memory.h"
#include "runtime/task.h"
#include "skeletons/contour_fault.h"
#include "skeletons/point2.h"

namespace flg {

// Where a number stands among three, one of which it is.
inline uint32_t place_in(const std::array<int32_t, 3>& three, int32_t number) {
    return three[0] == number ? 0 : three[1] == number ? 1 : 2;
}

struct ContourTriangulation {
    // neighbours[k] and is_edge[k] belong to the side across from vertices[k]. At the border of all the neighbour is
    // -1.
    struct Triangle {
        std::array<int32_t, 3> vertices, neighbours;
        std::array<bool, 3> is_edge;
    };

    bool is_inside(uint32_t triangle) const { return inside[triangle] != 0; }

    Buffer<Triangle> triangles;  // the first `count` of them
    Buffer<uint8_t> inside;
    uint32_t count = 0;
    ContourFault fault;  // the first one found: then the rest is incomplete
};

// Rings follow each other: next[i] is the point after i on its ring; what is inside lies on the left. Coordinates are
// within [-2, 2] and differ somewhere. Both outlive the task. About 1 us a point. The triangulation is in `memory`.
Task<ContourTriangulation> triangulate_contour(Pace& pace, std::span<const Point2> points,
                                               std::span<const uint32_t> next, Memory* memory);

}  // namespace flg
