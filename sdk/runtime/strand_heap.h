// SPDX-License-Identifier: MIT
// Ready strands by the time at which they have to go on at the latest. A leftist heap (C. A. Crane 1972) of the strands
// themselves: it takes no memory, and no call looks at more than some 60 strands, however many there are.
//
// Invariants
// - No strand has to go on earlier than the one above it.
// - Of two subtrees the right one is the shallower: its shortest way down (`rank`) is no longer.
#pragma once

#include <utility>

#include "runtime/job.h"

namespace flg {

class StrandHeap {
public:
    Strand* first() const { return root_; }

    void insert(Strand& strand) {
        strand.latest_ns = strand.job.latest_ns();
        strand.left = strand.right = strand.above = nullptr;
        strand.rank = 1;
        strand.heap = this;
        set_root(merge(root_, &strand));
    }
    void remove(Strand& strand) {
        Strand* const rest = merge(strand.left, strand.right);
        Strand* above = strand.above;
        if (rest) rest->above = above;
        strand.heap = nullptr;
        if (!above) {
            root_ = rest;
            return;
        }
        (above->left == &strand ? above->left : above->right) = rest;
        for (; above && settle(*above); above = above->above) {}
    }

private:
    static uint32_t rank_of(const Strand* strand) { return strand ? strand->rank : 0; }
    static bool is_before(const Strand& a, const Strand& b) {
        return std::pair(a.latest_ns, a.job.serial) < std::pair(b.latest_ns, b.job.serial);
    }
    // Puts the deeper subtree to the left; whether the rank changed.
    static bool settle(Strand& strand) {
        if (rank_of(strand.left) < rank_of(strand.right)) std::swap(strand.left, strand.right);
        return std::exchange(strand.rank, rank_of(strand.right) + 1) != rank_of(strand.right) + 1;
    }
    // As deep as the right ways down are long together: logarithmic.
    static Strand* merge(Strand* a, Strand* b) {
        if (!a || !b) return a ? a : b;
        if (is_before(*b, *a)) std::swap(a, b);
        a->right = merge(a->right, b);
        a->right->above = a;
        settle(*a);
        return a;
    }
    void set_root(Strand* root) {
        root_ = root;
        if (root_) root_->above = nullptr;
    }

    Strand* root_ = nullptr;
};

}  // namespace flg
