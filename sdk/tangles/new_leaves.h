// SPDX-License-Identifier: MIT
// From an operator's partition to leaves of the tree: their places, groups and looks, appendix A of Nazzaro, Puppo, Pellacini:
// geoTangle (2021).
#pragma once

#include "filigree/filigree_tangle.h"
#include "runtime/pace.h"
#include "runtime/task.h"
#include "tangles/region_tree.h"

namespace flg {

struct NewLeaf {
    RegionId parent;
    uint32_t part;  // of the operator's partition, as it numbers them
};

struct LeafRules {
    FlgTangleGrouping grouping;
    uint32_t cycle;
    bool scaffold;
};

// Adds leaves to the tree, children of one parent one behind the other, else in the order given; returns the region of each.
// Fails with FLG_ERROR_LIMIT above FLG_REGION_MAX.
Task<Buffer<RegionId>> add_leaves(Pace& pace, RegionTree& tree, TreeEdit& edit, const Buffer<NewLeaf>& leaves,
                                  LeafRules rules);

}  // namespace flg
