// SPDX-License-Identifier: MIT
// Points far from each other in space, each as far as possible from those before it: Gonzalez (1985). What is so far
// apart in space is at least as far apart along any surface.
#pragma once

#include <vector>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh.h"

namespace flg {

// Of how many vertices the points are chosen for each one that there is room for: this fixes how evenly they lie.
constexpr uint32_t vertices_a_spaced_point = 32;
constexpr uint32_t max_spaced_points = 512;

struct SpacedCandidate {
    uint32_t vertex;
    float distance;  // metres, >= 0: no less from what points keep away from
};

// At most max_count, and max_spaced_points, of the candidates, no nearer to each other or to what they keep away from
// than `spacing`, metres; in the order they were chosen. The seed draws among those equally far. 2 ns a candidate and
// point.
Task<std::pmr::vector<uint32_t>> choose_spaced_points(Pace& pace, const Mesh& mesh,
                                                      const Buffer<SpacedCandidate>& candidates, float spacing,
                                                      uint32_t max_count, uint64_t seed);

}  // namespace flg
