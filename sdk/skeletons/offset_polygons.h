// SPDX-License-Identifier: MIT
// Offset polygons: where the front of a straight skeleton is at a time, which is the contour moved inwards by a
// distance with its corners kept sharp. Each arc on which that time lies is one of its points; in each face, walked
// around from its edge, an arc that rises through the time and the next one that falls through it are the ends of a
// side.
//
// Invariants
// - Each such arc rises in one of its faces and falls in the other: so the sides make closed rings, without a search.
// - At time 0 the rings are the contour's; above the last node's there are none.
#pragma once

#include <cstdint>
#include <vector>

#include "core/memory.h"
#include "skeletons/skeleton_graph.h"

namespace flg {

// Rings with what is inside on their left: those around a part turn counter-clockwise, those around holes clockwise.
// Each begins with the side of its edge of least number, and they come in the order of these.
struct OffsetRings {
    explicit OffsetRings(Memory* memory) : points(memory), edges(memory), offsets(memory) {}

    std::pmr::vector<Point2> points;
    std::pmr::vector<uint32_t> edges;    // one a point: the contour's edge that the side from it to the next is of
    std::pmr::vector<uint32_t> offsets;  // where each ring begins, and the end
};

// `distance` is not below 0. A plain function, as hosts get the rings at once: about 50 ns a point.
void offset_polygons(const StraightSkeleton& skeleton, double distance, OffsetRings& out, Memory* memory);

}  // namespace flg
