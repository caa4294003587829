// SPDX-License-Identifier: MIT
// Makes edges distinct that were left open or cut, yet still have the same two vertices because the fans there hang
// together another way round. One of them keeps its place, a joined one if there is one; triangles of the others are
// detached at the vertex where their edge starts, by cutting the edge before it too.
#pragma once

#include <deque>

#include "surfaces/adjacency_edges.h"
#include "surfaces/mesh_repair_mates.h"

namespace flg {

// A unit is a corner: a few nanoseconds.
class DistinctEdgesKernel {
public:
    // `sorted` is what EdgeSortKernel says of the triangles. All but `memory` outlive the kernel; mates are changed.
    DistinctEdgesKernel(const GrowingBuffer<Triple>& triangles, const Buffer<Corner>& sorted, Mates& mates,
                        Memory* memory);
    bool run(uint32_t count);
    // After run() returned true: edges that were cut. Vertices have to be split, and edges looked at, once more if
    // anything was detached.
    uint32_t cut_count() const { return cut_count_; }
    bool detached() const { return detached_count_ > 0; }

private:
    void look_at_edge();
    void cut(Corner corner);

    const GrowingBuffer<Triple>& triangles_;
    const Buffer<Corner>& sorted_;
    Mates& mates_;
    std::pmr::deque<Corner>
        detached_;  // cut once all edges were looked at: cuts make edges look alike until vertices are split
    uint32_t at_ = 0;
    uint32_t detached_count_ = 0;
    uint32_t cut_count_ = 0;
};

}  // namespace flg
