// SPDX-License-Identifier: MIT
#include "tangles/region_rows.h"

#include <map>

namespace flg::studio {
namespace {

constexpr uint32_t kOpenChildren = 12;  // of regions with more the list would be too long

}  // namespace

void RegionRows::refresh(const RegionList& regions, uint32_t mesh, uint32_t revision, bool by_groups) {
    if (!stale_ && mesh == mesh_ && revision == revision_ && by_groups == by_groups_) return;
    if (mesh != mesh_) closed_.clear();
    mesh_ = mesh;
    revision_ = revision;
    by_groups_ = by_groups;
    stale_ = false;
    for (uint32_t r = static_cast<uint32_t>(closed_.size()); r < regions.count(); ++r)
        closed_.push_back(regions[r].child_count > kOpenChildren);
    closed_.resize(regions.count());
    rows_.clear();
    by_groups ? add_groups(regions) : add_tree(regions);
}

void RegionRows::add_tree(const RegionList& regions) {
    std::vector<RegionRow> open = {{0, 0, 0, false}};
    while (!open.empty()) {
        RegionRow row = open.back();
        open.pop_back();
        const FlgTangleRegion& r = regions[row.region];
        if (r.joined_into != FLG_NO_INDEX) continue;
        row.size = r.child_count;
        row.is_open = r.child_count > 0 && !closed_[row.region];
        rows_.push_back(row);
        if (!row.is_open) continue;
        for (uint32_t c = r.child_count; c-- > 0;) open.push_back({r.first_child + c, row.depth + 1, 0, false});
    }
}

void RegionRows::add_groups(const RegionList& regions) {
    std::map<uint32_t, size_t> row_of;
    for (const uint32_t leaf : regions.leaves()) {
        const auto [found, is_new] = row_of.emplace(regions[leaf].group, rows_.size());
        if (is_new) rows_.push_back({leaf, 0, 0, false});
        ++rows_[found->second].size;
    }
}

void RegionRows::toggle(uint32_t region) {
    if (region < closed_.size()) closed_[region] = !closed_[region];
    stale_ = true;
}

}  // namespace flg::studio
