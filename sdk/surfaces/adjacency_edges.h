// SPDX-License-Identifier: MIT
// The corners of triangles sorted by the edges that start there, so that those of an edge, in whichever direction, lie side
// by side. Sorted by counting, first by the greater vertex, then by the lesser: linear in the triangles whatever the mesh,
// also for vertices and edges of many triangles.
#pragma once

#include <algorithm>
#include <utility>

#include "surfaces/mesh.h"

namespace flg {

// An edge without its direction.
struct Edge {
    uint32_t lesser, greater;
    bool operator==(const Edge&) const = default;
};

inline Edge edge_at(const GrowingBuffer<Triple>& triangles, Corner corner) {
    const Triple& triangle = triangles[corner / 3];
    const auto [lesser, greater] = std::minmax(triangle[corner % 3], triangle[(corner + 1) % 3]);
    return {lesser, greater};
}

// A unit is a triangle, a corner or a vertex: a few nanoseconds. Memory: 12 bytes a triangle, and 8 a vertex
// while it runs.
class EdgeSortKernel {
public:
    // Needs triangles whose vertices are below vertex_count. `scratch` has as many triples, which are overwritten: those
    // that take the neighbours afterwards. Both outlive the kernel.
    EdgeSortKernel(const GrowingBuffer<Triple>& triangles, uint32_t vertex_count, GrowingBuffer<Triple>& scratch,
                   Memory* memory);
    bool run(uint32_t count);
    // After run() returned true: by lesser vertex, then greater vertex, then corner.
    Buffer<Corner> take() { return std::move(sorted_); }

private:
    enum class Pass { clear, count, sum, by_greater, by_lesser, done };
    uint32_t pass_size() const;
    void run_pass(uint32_t begin, uint32_t end);

    const GrowingBuffer<Triple>& triangles_;
    uint32_t vertex_count_;
    // Where the next corner goes whose edge has this vertex as its lesser or greater one.
    Buffer<uint32_t> lesser_, greater_;
    Corner* half_sorted_;
    Buffer<Corner> sorted_;
    Pass pass_ = Pass::clear;
    uint32_t at_ = 0;
    uint32_t lesser_sum_ = 0, greater_sum_ = 0;
};

}  // namespace flg
