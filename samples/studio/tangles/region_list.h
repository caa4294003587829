// SPDX-License-Identifier: MIT
// What the tangle of a mesh was like after its last step: its tree of regions, and what made them. A copy, to be read
// while the next step is under way.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "filigree/filigree.hpp"

namespace flg::studio {

using Regions = std::vector<uint32_t>;

// What an operation made of the regions it divided, for their names and colours.
struct Operation {
    std::string name;
    FlgTangleGrouping grouping = FLG_TANGLE_GROUPING_TWO;
    uint32_t cycle = 3;
    bool is_chequer = false;  // the second of a grid
};

class RegionList {
public:
    // Of a tangle that no step of is under way.
    void refresh(const filigree::Tangle& tangle);

    uint32_t count() const { return static_cast<uint32_t>(regions_.size()); }
    const FlgTangleRegion& operator[](uint32_t region) const { return regions_[region]; }
    bool is_leaf(uint32_t region) const {
        return regions_[region].child_count == 0 && regions_[region].joined_into == FLG_NO_INDEX;
    }
    const Regions& leaves() const { return leaves_; }
    uint32_t group_count() const { return group_count_; }
    // Of FlgTangleRegion::operation; the root's has no name.
    const Operation& operation(uint32_t number) const;
    // "dots 12, inside"
    std::string name(uint32_t region) const;

    // Rising, each once; regions that don't exist are left out.
    Regions leaves_below(std::span<const uint32_t> regions) const;
    Regions of_group(uint32_t group) const;
    // Nearest regions around these, without those below others of them.
    Regions parents(std::span<const uint32_t> regions) const;
    // The regions themselves, without those that are gone.
    Regions existing(std::span<const uint32_t> regions) const;

    uint32_t undo_count() const { return undo_count_; }

private:
    std::vector<FlgTangleRegion> regions_;
    std::vector<Operation> operations_;
    Regions leaves_;
    uint32_t group_count_ = 0, undo_count_ = 0;
};

}  // namespace flg::studio
