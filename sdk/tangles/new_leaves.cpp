// SPDX-License-Identifier: MIT
#include "tangles/new_leaves.h"

#include <map>

#include "core/failure.h"
#include "filigree/filigree_surface.h"

namespace flg {

namespace {

constexpr uint32_t leaf_chunk = 50;  // about 10 us

// Numbers for pairs, each new one the next.
class PairNumbers {
public:
    explicit PairNumbers(Memory* memory) : numbers_(memory) {}

    template <class Next>
    uint32_t number(uint32_t a, uint32_t b, Next next) {
        const auto [found, is_new] = numbers_.try_emplace({a, b}, 0);
        if (is_new) found->second = next();
        return found->second;
    }

private:
    std::pmr::map<std::pair<uint32_t, uint32_t>, uint32_t> numbers_;
};

uint32_t group_of_part(LeafRules rules, uint32_t part) {
    switch (rules.grouping) {
        case FLG_TANGLE_GROUP_TWO: return part % 2;
        case FLG_TANGLE_GROUP_CYCLE: return part % rules.cycle;
        default: return 0;
    }
}

}  // namespace

Task<Buffer<RegionId>> add_leaves(Pace& pace, RegionTree& tree, TreeEdit& edit, const Buffer<NewLeaf>& leaves,
                                  LeafRules rules) {
    const uint32_t first = tree.size();
    if (first + uint64_t{leaves.size()} > uint64_t{FLG_REGION_MAX} + 1) {
        throw Failure(FLG_ERROR_LIMIT, "%zu more regions beside %u are too many, the largest identifier is %u",
                      leaves.size(), first, FLG_REGION_MAX);
    }
    // Children of one parent together: how many it has, then where its next one goes.
    std::pmr::map<RegionId, uint32_t> places(pace.memory());
    for (size_t i = 0; i < leaves.size(); ++i) {
        ++places[leaves[i].parent];
        if (i % leaf_chunk == 0) co_await pace;
    }
    uint32_t begin = 0, passed = 0;
    for (auto& [parent, place] : places) {
        const uint32_t count = place;
        place = begin;
        begin += count;
        if (++passed % leaf_chunk == 0) co_await pace;
    }
    Buffer<uint32_t> order(leaves.size(), pace.memory());
    for (uint32_t i = 0; i < leaves.size(); ++i) {
        order[places[leaves[i].parent]++] = i;
        if (i % leaf_chunk == 0) co_await pace;
    }

    PairNumbers groups(pace.memory()), looks(pace.memory());
    const uint32_t operation = tree.add_operation();
    Buffer<RegionId> regions(leaves.size(), pace.memory());
    for (uint32_t n = 0; n < order.size(); ++n) {
        const NewLeaf& leaf = leaves[order[n]];
        RegionNode node;
        node.operation = operation;
        node.part = leaf.part;
        node.scaffold = rules.scaffold;
        const uint32_t look = tree[leaf.parent].look;
        node.look = rules.scaffold ? look : looks.number(look, leaf.part, [&] { return tree.add_look(); });
        if (rules.grouping == FLG_TANGLE_GROUP_EACH) {
            node.group = tree.add_group();
        } else {
            node.group = groups.number(tree.visible_group(leaf.parent), group_of_part(rules, leaf.part),
                                       [&] { return tree.add_group(); });
        }
        regions[order[n]] = tree.add_child(edit, leaf.parent, node);
        if (n % leaf_chunk == 0) co_await pace;
    }
    co_return regions;
}

}  // namespace flg
