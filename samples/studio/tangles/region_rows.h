// SPDX-License-Identifier: MIT
// The lines of the panel's list of regions, as a tree or by groups: made when something changed, drawn only where they
// are seen.
#pragma once

#include "tangles/region_list.h"

namespace flg::studio {

struct RegionRow {
    uint32_t region;  // of a group its first leaf
    uint32_t depth;
    uint32_t size;  // children, or leaves of the group
    bool is_open;
};

class RegionRows {
public:
    // Cheap where nothing changed since.
    void refresh(const RegionList& regions, uint32_t mesh, uint32_t revision, bool by_groups);
    const std::vector<RegionRow>& rows() const { return rows_; }
    void toggle(uint32_t region);

private:
    void add_tree(const RegionList& regions);
    void add_groups(const RegionList& regions);

    std::vector<RegionRow> rows_;
    std::vector<bool> closed_;
    uint32_t mesh_ = 0, revision_ = 0;
    bool by_groups_ = false, stale_ = true;
};

}  // namespace flg::studio
