// SPDX-License-Identifier: MIT
#include "tangles/region_tree.h"

#include <utility>

namespace flg {

RegionTree::RegionTree(Memory* memory) : nodes_(memory) {
    nodes_.push_back({});
    counts_ = {.nodes = 1, .groups = 1, .looks = 1, .operations = 0};
}

RegionId RegionTree::resolve(RegionId region) const {
    while (nodes_[region].joined_into != no_region) region = nodes_[region].joined_into;
    return region;
}

uint32_t RegionTree::depth(RegionId region) const {
    uint32_t depth = 0;
    for (; nodes_[region].parent != no_region; region = nodes_[region].parent) ++depth;
    return depth;
}

uint32_t RegionTree::visible_group(RegionId region) const {
    while (nodes_[region].scaffold) region = nodes_[region].parent;
    return nodes_[region].group;
}

void RegionTree::begin(TreeEdit& edit) {
    edit.counts_ = counts_;
}

RegionNode& RegionTree::change(TreeEdit& edit, RegionId region) {
    if (region < edit.counts_.nodes) edit.nodes_.push_back({region, nodes_[region]});
    return nodes_[region];
}

RegionId RegionTree::add_child(TreeEdit& edit, RegionId parent, const RegionNode& child) {
    const RegionId region = size();
    nodes_.push_back(child);
    nodes_.back().parent = parent;
    ++counts_.nodes;
    if (nodes_[parent].child_count == 0) change(edit, parent).first_child = region;
    ++nodes_[parent].child_count;
    return region;
}

void RegionTree::set_group(TreeEdit& edit, RegionId region, uint32_t group) {
    change(edit, region).group = group;
}

void RegionTree::join(TreeEdit& edit, std::span<const RegionId> regions) {
    change(edit, regions.front()).look = add_look();
    for (const RegionId region : regions.subspan(1)) change(edit, region).joined_into = regions.front();
}

void RegionTree::end(TreeEdit& edit) {
    for (size_t i = edit.counts_.nodes; i < nodes_.size(); ++i) edit.added_.push_back(nodes_[i]);
}

void RegionTree::take_back(TreeEdit& edit) noexcept {
    std::swap(counts_, edit.counts_);
    while (nodes_.size() > counts_.nodes) nodes_.pop_back();
    for (size_t i = edit.nodes_.size(); i-- > 0;) std::swap(nodes_[edit.nodes_[i].region], edit.nodes_[i].node);
}

void RegionTree::make_again(TreeEdit& edit) {
    try {
        for (const RegionNode& node : edit.added_) nodes_.push_back(node);
    } catch (...) {
        while (nodes_.size() > counts_.nodes) nodes_.pop_back();
        throw;
    }
    std::swap(counts_, edit.counts_);
    for (TreeEdit::Old& old : edit.nodes_) std::swap(nodes_[old.region], old.node);
}

RegionId RegionTree::Leaves::next() {
    while (!waiting_.empty()) {
        const RegionId region = tree_.resolve(waiting_.back().next++);
        if (waiting_.back().next == waiting_.back().end) waiting_.pop_back();
        const RegionNode& node = tree_[region];
        if (node.child_count == 0) return region;
        waiting_.push_back({node.first_child, node.first_child + node.child_count});
    }
    return no_region;
}

}  // namespace flg
