// SPDX-License-Identifier: MIT
#include "tangles/region_list.h"

#include <algorithm>

namespace flg::studio {
namespace {

constexpr const char* kOperators[] = {"band", "stripe", "cell", "side"};
constexpr const char* kMacros[] = {"ray", "dot", "frame", "petal", "square", "outline", "scallop", "cell"};

}  // namespace

void RegionList::refresh(const filigree::Tangle& tangle) {
    const FlgTangleInfo info = tangle.info();
    regions_.resize(info.region_count);
    leaves_.clear();
    uint32_t operations = 0;
    for (uint32_t r = 0; r < info.region_count; ++r) {
        regions_[r] = tangle.region(r);
        operations = std::max(operations, regions_[r].operation);
        if (is_leaf(r)) leaves_.push_back(r);
    }
    group_count_ = info.group_count;
    undo_count_ = info.undo_count;
    operations_.assign(operations + 1, {});
    const FlgTangleHistory history = tangle.history();
    for (uint32_t s = 0; s < history.made_count; ++s) {
        const FlgTangleStep& step = *history.steps[s];
        const bool divides = step.kind == FLG_TANGLE_STEP_KIND_DIVIDE || step.kind == FLG_TANGLE_STEP_KIND_MACRO;
        if (!divides || step.made_count == 0 || step.first_region >= info.region_count) continue;
        const uint32_t number = regions_[step.first_region].operation;
        if (step.kind == FLG_TANGLE_STEP_KIND_DIVIDE) {
            operations_[number] = {kOperators[step.divide->kind], step.divide->grouping, step.divide->cycle};
            continue;
        }
        operations_[number].name = kMacros[step.macro->kind];
        if (step.macro->kind != FLG_TANGLE_MACRO_GRID || number == operations) continue;
        operations_[number].name = "row";
        operations_[number + 1] = {.name = kMacros[FLG_TANGLE_MACRO_GRID], .is_chequer = true};
    }
}

const Operation& RegionList::operation(uint32_t number) const {
    static const Operation kNone{};
    return number < operations_.size() ? operations_[number] : kNone;
}

std::string RegionList::name(uint32_t region) const {
    if (region == 0) return "whole mesh";
    const FlgTangleRegion& r = regions_[region];
    const Operation& made_by = operation(r.operation);
    const std::string part = std::to_string(r.part + 1);
    return (made_by.name.empty() ? std::string("part") : made_by.name) + " " + part + (r.scaffold ? " (scaffold)" : "");
}

Regions RegionList::leaves_below(std::span<const uint32_t> regions) const {
    std::vector<uint32_t> open(regions.begin(), regions.end());
    Regions leaves;
    while (!open.empty()) {
        uint32_t r = open.back();
        open.pop_back();
        if (r >= count()) continue;
        while (regions_[r].joined_into != FLG_NO_INDEX) r = regions_[r].joined_into;
        if (regions_[r].child_count == 0) leaves.push_back(r);
        for (uint32_t c = 0; c < regions_[r].child_count; ++c) open.push_back(regions_[r].first_child + c);
    }
    std::sort(leaves.begin(), leaves.end());
    leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
    return leaves;
}

Regions RegionList::of_group(uint32_t group) const {
    Regions some;
    for (const uint32_t leaf : leaves_)
        if (regions_[leaf].group == group) some.push_back(leaf);
    return some;
}

Regions RegionList::parents(std::span<const uint32_t> regions) const {
    Regions above;
    for (const uint32_t r : existing(regions)) above.push_back(r == 0 ? 0 : regions_[r].parent);
    std::sort(above.begin(), above.end());
    above.erase(std::unique(above.begin(), above.end()), above.end());
    std::erase_if(above, [&](uint32_t r) {
        for (uint32_t at = regions_[r].parent; at != FLG_NO_INDEX; at = regions_[at].parent)
            if (std::binary_search(above.begin(), above.end(), at)) return true;
        return false;
    });
    return above;
}

Regions RegionList::existing(std::span<const uint32_t> regions) const {
    Regions some;
    for (const uint32_t r : regions)
        if (r < count() && regions_[r].joined_into == FLG_NO_INDEX) some.push_back(r);
    return some;
}

}  // namespace flg::studio
