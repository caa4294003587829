// SPDX-License-Identifier: MIT
#include "bones/bone_order.h"

#include <algorithm>

namespace flg {

BoneOrderKernel::BoneOrderKernel(const BoneGraph& graph, std::span<const uint32_t> roots, BoneTree& tree,
                                 std::pmr::vector<uint32_t>& number, Memory* memory)
    : graph_(graph), roots_(roots), tree_(tree), number_(number), stack_(memory) {
    number_.assign(graph.joints().size(), no_joint);
}

bool BoneOrderKernel::run(uint32_t count) {
    for (; count > 0; --count) {
        if (stack_.empty()) {
            if (root_ == roots_.size()) return true;
            stack_.push_back({roots_[root_++], no_joint});
        }
        const Next next = stack_.back();
        stack_.pop_back();
        const BoneGraph::Joint& joint = graph_.joints()[next.joint];
        const auto self = static_cast<uint32_t>(tree_.joints.size());
        number_[next.joint] = self;
        tree_.joints.push_back({joint.at, joint.radius, next.parent, joint.part});
        const size_t begin = stack_.size();
        for (uint32_t end = graph_.first_end(next.joint); end != no_number; end = graph_.next_end(end)) {
            const uint32_t child = graph_.other(BoneGraph::bone_of(end), next.joint);
            if (number_[child] == no_joint) stack_.push_back({child, self});
        }
        std::reverse(stack_.begin() + static_cast<ptrdiff_t>(begin), stack_.end());
    }
    return false;
}

}  // namespace flg
