// SPDX-License-Identifier: MIT
// The borders of regions as loops of edges, also where the surface ends.
#pragma once

#include <deque>

#include "surfaces/region_cursor.h"
#include "surfaces/surface_point.h"

namespace flg {

// Loop l has the edges offsets[l] to offsets[l + 1] - 1, each as its corner within the regions, which lie to its left. At a
// vertex where borders touch each keeps to its own triangles. A loop begins at its least corner; loops are in the order of
// these.
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

class RegionLoopsKernel {
public:
    // All outlive the kernel. Memory: a bit an edge of the mesh.
    RegionLoopsKernel(const Mesh& mesh, const RegionSet& regions, RegionLoops& out, Memory* memory);

    // A unit is 64 bits, 64 triangles outside, a triangle within or a turn about a vertex: 5 to 100 ns.
    bool run(uint32_t count);

private:
    enum class Pass { clear, find, walk, done };

    bool is_border(Corner edge) const;
    void find();
    void walk();

    const Mesh& mesh_;
    const RegionSet& regions_;
    RegionLoops& out_;
    Buffer<uint64_t> visited_;  // a bit an edge
    RegionCursor cursor_;
    Pass pass_ = Pass::clear;
    size_t cleared_ = 0;         // words of visited_
    Corner at_ = 0;              // the edge to look at next, or where the loop begins
    Corner end_ = 0;             // of the triangle's edges
    Corner turning_ = no_index;  // on the way to the loop's next edge: one that starts where its last ends
    double length_ = 0;          // so far
};

}  // namespace flg
