// SPDX-License-Identifier: MIT
// Regions through edits of the history: which one is meant after the step that made it was made anew.
//
// The region of a new step takes the place of an old one if it lies in the same region, is the same part (of cells,
// whose numbers say nothing: any), and if each is the other's nearest, by their places. What is left over then goes by
// order.
#pragma once

#include "tangles/step_record.h"
#include "tangles/tangle.h"

namespace flg {

// From regions before an edit to those after it.
class RegionMap {
public:
    // Those below `base` stay what they are. `count`: of all before the edit.
    RegionMap(RegionId base, Memory* memory) : base_(base), now_(memory) {}
    friend Task<void> begin(Pace& pace, RegionMap& map, size_t count);

    // no_region: it is gone.
    RegionId operator[](RegionId old) const {
        return old < base_ ? old : old - base_ < now_.size() ? now_[old - base_] : no_region;
    }
    void set(RegionId old, RegionId now) { now_[old - base_] = now; }
    RegionId base() const { return base_; }

private:
    RegionId base_;
    std::pmr::deque<RegionId> now_;
};

Task<void> begin(Pace& pace, RegionMap& map, size_t count);

// Of an operator that was made anew. Cost: some ns for each pair of its regions in one region.
Task<void> follow_anew(Pace& pace, const TangleStep& before, const TangleStep& after, RegionMap& map);

// The lists of regions that a request has.
struct RegionLists {
    std::pmr::vector<RegionId>* regions = nullptr;
    std::pmr::vector<RegionId>*a = nullptr, *b = nullptr;
};
RegionLists lists_of(StepRecord::Request& request);

// What finding a step's regions again came to: how many it has, and how many of them are there.
struct RegionsFound {
    size_t wanted = 0, found = 0;
    bool enough = true;  // no list that had regions is empty now
};

// Puts the regions that there are after the edit into the copies of a step's records, and names what is missed.
// `before`: the steps before the edit; `after`: those after it, as far as they are made.
Task<RegionsFound> find_regions(Pace& pace, const RegionTree& tree, const TangleSteps& before, const TangleSteps& after,
                                const RegionMap& map, StepRecords& records);

}  // namespace flg
