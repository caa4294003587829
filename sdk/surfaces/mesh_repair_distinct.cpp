// SPDX-License-Identifier: MIT
#include "surfaces/mesh_repair_distinct.h"

namespace flg {

DistinctEdgesKernel::DistinctEdgesKernel(const GrowingBuffer<Triple>& triangles, const Buffer<Corner>& sorted,
                                         Mates& mates, Memory* memory)
    : triangles_(triangles), sorted_(sorted), mates_(mates), detached_(memory) {}

void DistinctEdgesKernel::look_at_edge() {
    const uint32_t begin = at_;
    const Edge edge = edge_at(triangles_, sorted_[begin]);
    Corner kept = sorted_[begin];
    while (++at_ < sorted_.size() && edge_at(triangles_, sorted_[at_]) == edge) {
        if (mates_[kept] == no_index) kept = sorted_[at_];
    }
    if (mates_[kept] == no_index) kept = sorted_[begin];
    for (uint32_t i = begin; i < at_; ++i) {
        if (sorted_[i] != kept && sorted_[i] != mates_[kept]) detached_.push_back(sorted_[i]);
    }
}

void DistinctEdgesKernel::cut(Corner corner) {
    if (mates_[corner] == no_index) return;
    mates_.cut(corner);
    ++cut_count_;
}

bool DistinctEdgesKernel::run(uint32_t count) {
    for (; at_ < sorted_.size(); --count) {
        if (count == 0) return false;
        look_at_edge();
    }
    for (; detached_count_ < detached_.size(); ++detached_count_, --count) {
        if (count == 0) return false;
        // The fan of the corner is then its triangle alone, and so gets a vertex of its own.
        cut(detached_[detached_count_]);
        cut(previous_corner(detached_[detached_count_]));
    }
    return true;
}

}  // namespace flg
