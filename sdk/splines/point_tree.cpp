// SPDX-License-Identifier: MIT
#include "splines/point_tree.h"

namespace flg {

PointTree::PointTree(uint32_t points, Memory* memory) : points_(points) {
    uint32_t nodes = (points + leaf_size - 1) / leaf_size;
    for (;; nodes = (nodes + fan - 1) / fan) {
        starts_[levels_ + 1] = starts_[levels_] + nodes;
        ++levels_;
        if (nodes == 1) break;
    }
    boxes_ = Buffer<Box>(starts_[levels_], memory);
}

// Children lie below, and are done.
void PointTree::make_node() {
    uint32_t level = 1;
    while (at_ >= starts_[level + 1]) ++level;
    const uint32_t first = starts_[level - 1] + (at_ - starts_[level]) * fan;
    const uint32_t end = std::min(first + fan, starts_[level]);
    Box box = boxes_[first];
    for (uint32_t child = first + 1; child < end; ++child) {
        for (size_t k = 0; k < 3; ++k) {
            box.lower[k] = std::min(box.lower[k], boxes_[child].lower[k]);
            box.upper[k] = std::max(box.upper[k], boxes_[child].upper[k]);
        }
    }
    boxes_[at_] = box;
}

}  // namespace flg
