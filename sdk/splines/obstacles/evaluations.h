// SPDX-License-Identifier: MIT
// How much work may still be done among obstacles: so its time is bounded, and the same work is done on every machine.
//
// One evaluation: a node put onto a barrier around a few obstacles, or a node's part of a round's system. 0.5 to 1 us;
// 32 obstacles more take as long again.
#pragma once

#include <algorithm>
#include <cstdint>

namespace flg {

class Evaluations {
public:
    // most: 0: no bound.
    Evaluations(uint64_t most, uint32_t obstacles) : most_(most), node_(whole + whole / 32 * obstacles) {
        if (most > 0 && most < UINT64_MAX / whole) left_ = most * whole;
    }

    uint64_t most() const { return most_; }
    bool are_spent() const { return left_ == 0; }
    // As many more rounds and projections of a curve, at least 1.
    uint32_t of_curves(uint32_t nodes) const {
        return static_cast<uint32_t>(std::clamp<uint64_t>(left_ / node_ / nodes, 1, 1 << 30));
    }
    void spend(uint64_t nodes) { take(nodes * node_); }
    // Places looked at for their distance from all obstacles: eight take as long as one evaluation.
    void spend_looks(uint64_t looks) { take(looks * (node_ / 8)); }
    // Nodes that a sweep passes.
    void spend_swept(uint64_t nodes) { take(nodes * (whole / 128)); }
    void spend_all() { left_ = 0; }

private:
    static constexpr uint64_t whole = 256;

    void take(uint64_t parts) { left_ -= std::min(parts, left_); }

    uint64_t most_, node_;
    uint64_t left_ = UINT64_MAX;
};

}  // namespace flg
