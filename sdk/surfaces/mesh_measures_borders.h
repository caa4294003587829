// SPDX-License-Identifier: MIT
// The borders of a mesh as loops of vertices.
#pragma once

#include <deque>

#include "surfaces/mesh.h"

namespace flg {

// Loop l has the vertices offsets[l] to offsets[l + 1] - 1, in the direction of the triangles' edges (the surface lies to
// the left); the last is joined to the first. Each loop begins at its least vertex; loops are ordered by these.
struct BorderLoops {
    explicit BorderLoops(Memory* memory) : vertices(memory), offsets(memory) { offsets.push_back(0); }

    uint32_t loop_count() const { return static_cast<uint32_t>(offsets.size()) - 1; }
    // As many as there are border vertices, and border edges.
    uint32_t vertex_count() const { return static_cast<uint32_t>(vertices.size()); }

    std::pmr::deque<uint32_t> vertices;
    std::pmr::deque<uint32_t> offsets;
};

// A unit is a vertex: a few nanoseconds, tens at a border. Memory: a bit a vertex beside the result.
class BordersKernel {
public:
    // Outlives the kernel.
    BordersKernel(const Mesh& mesh, Memory* memory);
    bool run(uint32_t count);
    // After run() returned true.
    const BorderLoops& loops() const { return loops_; }
    BorderLoops take() { return std::move(loops_); }

private:
    bool visit(uint32_t vertex);

    const Mesh& mesh_;
    BorderLoops loops_;
    Buffer<uint64_t> visited_;  // a bit a vertex
    uint32_t cleared_ = 0;      // words of it
    uint32_t at_ = 0;           // the vertex where a loop may begin
    uint32_t walker_ = no_index;
};

}  // namespace flg
