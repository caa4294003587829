// SPDX-License-Identifier: MIT
// The borders of regions as loops of edges, also where the surface ends.
#pragma once

#include <deque>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/region_cursor.h"
#include "surfaces/mesh/surface_point.h"

namespace flg {

// Loop l has the edges offsets[l] to offsets[l + 1] - 1, each as its corner within the regions, which lie to its left.
// At a vertex where borders touch each keeps to its own triangles. A loop begins at its least corner; loops are in the
// order of these.
struct RegionLoops {
    explicit RegionLoops(Memory* memory) : edges(memory), offsets(memory), lengths(memory) { offsets.push_back(0); }

    std::pmr::deque<Corner> edges;
    std::pmr::deque<uint32_t> offsets;
    std::pmr::deque<double> lengths;  // metres

    uint32_t count() const { return static_cast<uint32_t>(lengths.size()); }
};

inline double edge_length(const Mesh& mesh, Corner edge) {
    return (mesh.position(mesh.vertex_at(next_corner(edge))) - mesh.position(mesh.vertex_at(edge))).norm();
}

// About 5 ns for 64 triangles outside, tens a triangle within. Memory while it runs: up to 32 bytes a border edge.
Task<RegionLoops> find_region_loops(Pace& pace, const Mesh& mesh, const RegionSet& regions);

}  // namespace flg
