// SPDX-License-Identifier: MIT
#include "surfaces/adjacency_edges.h"

namespace flg {

EdgeSortKernel::EdgeSortKernel(const GrowingBuffer<Triple>& triangles, uint32_t vertex_count,
                               GrowingBuffer<Triple>& scratch, Memory* memory)
    : triangles_(triangles),
      vertex_count_(vertex_count),
      lesser_(vertex_count, memory),
      greater_(vertex_count, memory),
      half_sorted_(reinterpret_cast<Corner*>(scratch.data())),
      sorted_(3 * triangles.size(), memory) {}

uint32_t EdgeSortKernel::pass_size() const {
    switch (pass_) {
        case Pass::clear:
        case Pass::sum: return vertex_count_;
        case Pass::count:
        case Pass::by_greater: return static_cast<uint32_t>(triangles_.size());
        default: return static_cast<uint32_t>(sorted_.size());
    }
}

void EdgeSortKernel::run_pass(uint32_t begin, uint32_t end) {
    switch (pass_) {
        case Pass::clear:
            for (uint32_t vertex = begin; vertex < end; ++vertex) lesser_[vertex] = greater_[vertex] = 0;
            break;
        case Pass::count:
            for (uint32_t t = begin; t < end; ++t) {
                for (uint32_t k = 0; k < 3; ++k) {
                    const Edge edge = edge_at(triangles_, 3 * t + k);
                    ++lesser_[edge.lesser];
                    ++greater_[edge.greater];
                }
            }
            break;
        case Pass::sum:
            for (uint32_t vertex = begin; vertex < end; ++vertex) {
                lesser_sum_ += std::exchange(lesser_[vertex], lesser_sum_);
                greater_sum_ += std::exchange(greater_[vertex], greater_sum_);
            }
            break;
        case Pass::by_greater:
            for (uint32_t t = begin; t < end; ++t) {
                for (uint32_t k = 0; k < 3; ++k) {
                    half_sorted_[greater_[edge_at(triangles_, 3 * t + k).greater]++] = 3 * t + k;
                }
            }
            break;
        case Pass::by_lesser:
            for (uint32_t i = begin; i < end; ++i) {
                const Corner corner = half_sorted_[i];
                sorted_[lesser_[edge_at(triangles_, corner).lesser]++] = corner;
            }
            break;
        case Pass::done: break;
    }
}

bool EdgeSortKernel::run(uint32_t count) {
    while (pass_ != Pass::done) {
        const uint32_t size = pass_size();
        const uint32_t end = at_ + std::min(count, size - at_);
        count -= end - at_;
        run_pass(at_, end);
        at_ = end;
        if (at_ < size) return false;
        at_ = 0;
        pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
    }
    return true;
}

}  // namespace flg
