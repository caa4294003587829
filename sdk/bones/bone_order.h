// SPDX-License-Identifier: MIT
// Directions for bones: joints numbered from the roots on, parents first, each branch in one piece.
#pragma once

#include <span>

#include "bones/bone_graph.h"
#include "skeletons/bone_tree.h"

namespace flg {

class BoneOrderKernel {
public:
    // A tree for each root, which is a joint that is there. `number` gets the number in the tree by joint of the graph,
    // no_joint for those that are gone. All outlive the kernel.
    BoneOrderKernel(const BoneGraph& graph, std::span<const uint32_t> roots, BoneTree& tree,
                    std::pmr::vector<uint32_t>& number, Memory* memory);

    // A unit is a joint, about 0.1 us.
    bool run(uint32_t count);

private:
    struct Next {
        uint32_t joint, parent;  // the parent's number
    };

    const BoneGraph& graph_;
    std::span<const uint32_t> roots_;
    BoneTree& tree_;
    std::pmr::vector<uint32_t>& number_;
    std::pmr::vector<Next> stack_;
    size_t root_ = 0;
};

}  // namespace flg
