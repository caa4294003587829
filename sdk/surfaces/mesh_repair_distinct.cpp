// SPDX-License-Identifier: MIT
#include "surfaces/mesh_repair_distinct.h"

namespace flg {

DistinctEdgesKernel::DistinctEdgesKernel(const GrowingBuffer<Triple>& triangles, const Buffer<Corner>& sorted,
                                         Mates& mates)
    : triangles_(triangles), sorted_(sorted), mates_(mates) {}

void DistinctEdgesKernel::cut(Corner corner) {
    if (mates_[corner] == no_index) return;
    mates_.cut(corner);
    ++cut_count_;
}

// The fan of the corner is then its triangle alone, and so gets a vertex of its own.
void DistinctEdgesKernel::detach(Corner corner) {
    cut(corner);
    cut(previous_corner(corner));
    detached_ = true;
}

bool DistinctEdgesKernel::run(uint32_t count) {
    for (; at_ < sorted_.size(); --count) {
        if (count == 0) return false;
        const uint32_t begin = at_;
        const Edge edge = edge_at(triangles_, sorted_[begin]);
        Corner kept = sorted_[begin];
        while (++at_ < sorted_.size() && edge_at(triangles_, sorted_[at_]) == edge) {
            if (mates_[kept] == no_index) kept = sorted_[at_];
        }
        if (mates_[kept] == no_index) kept = sorted_[begin];
        const Corner kept_mate = mates_[kept];
        for (uint32_t i = begin; i < at_; ++i) {
            if (sorted_[i] != kept && sorted_[i] != kept_mate) detach(sorted_[i]);
        }
    }
    return true;
}

}  // namespace flg
