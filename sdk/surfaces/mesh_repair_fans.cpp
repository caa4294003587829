// SPDX-License-Identifier: MIT
#include "surfaces/mesh_repair_fans.h"

namespace flg {

FansKernel::FansKernel(GrowingBuffer<Triple>& triangles, const Mates& mates, uint32_t vertex_count,
                       std::pmr::deque<uint32_t>& copies, Memory* memory)
    : triangles_(triangles),
      mates_(mates),
      vertex_count_(vertex_count),
      copies_(copies),
      visited_(3 * triangles.size(), memory),
      used_(vertex_count + copies.size(), memory) {}

void FansKernel::begin_fan(Corner corner) {
    vertex_ = triangles_[corner / 3][corner % 3];
    if (used_.has(vertex_)) {
        const uint32_t original = vertex_ < vertex_count_ ? vertex_ : copies_[vertex_ - vertex_count_];
        vertex_ = vertex_count_ + static_cast<uint32_t>(copies_.size());
        copies_.push_back(original);
    } else {
        used_.set(vertex_);
        used_count_ += vertex_ < vertex_count_;
    }
    back_ = false;
    visit(corner);
}

void FansKernel::visit(Corner corner) {
    walker_ = corner;
    visited_.set(corner);
    triangles_[corner / 3][corner % 3] = vertex_;
}

bool FansKernel::run(uint32_t count) {
    for (; cleared_ < std::max(visited_.word_count(), used_.word_count()); ++cleared_, --count) {
        if (count == 0) return false;
        if (cleared_ < visited_.word_count()) visited_.clear_word(cleared_);
        if (cleared_ < used_.word_count()) used_.clear_word(cleared_);
    }
    for (; at_ < 3 * triangles_.size(); --count) {
        if (count == 0) return false;
        if (walker_ == no_index) {
            if (visited_.has(at_)) {
                ++at_;
            } else {
                begin_fan(at_);
            }
            continue;
        }
        const Corner next = back_ ? mates_.turn_back(walker_) : mates_.turn(walker_);
        if (next == at_ || (next == no_index && back_)) {
            walker_ = no_index;
        } else if (next == no_index) {
            back_ = true;
            walker_ = at_;
        } else {
            visit(next);
        }
    }
    return true;
}

}  // namespace flg
