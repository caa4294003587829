// SPDX-License-Identifier: MIT
// The four operators: sec. 3.3 of Nazzaro, Puppo, Pellacini: geoTangle (2021). Each makes a field, cuts along its
// isolines or along curves that follow from it, and makes leaves of what the cuts leave connected (region_partition.h).
#pragma once

#include "tangles/tangle.h"
#include "tangles/tangle_seeds.h"

namespace flg {

struct DivideRequest {
    explicit DivideRequest(Memory* memory) : regions(memory), a(memory), b(memory) {}

    FlgTangleDivideDesc desc{};  // checked; without what it points to, which is copied below
    std::pmr::vector<RegionId> regions;
    TangleSeeds a, b;

    Perturbation perturbation() const { return {desc.perturbation, desc.frequency, desc.seed}; }
};

// ---- From a partition to leaves of the tree: their places, groups and looks, appendix A

struct NewLeaf {
    RegionId parent;
    uint32_t part;  // of the operator's partition, as it numbers them
};

struct LeafRules {
    FlgTangleGrouping grouping;
    uint32_t cycle;
    bool scaffold;
};

// Adds leaves to the tree, children of one parent one behind the other, else in the order given; returns the region of
// each. Fails with FLG_ERROR_LIMIT above FLG_REGION_MAX.
Task<Buffer<RegionId>> add_leaves(Pace& pace, RegionTree& tree, TreeEdit& edit, const Buffer<NewLeaf>& leaves,
                                  LeafRules rules);

// Divides regions as part of a step. `revision`: the surface's after the change. If it throws after it changed
// something, the step's last edit says what.
Task<void> divide_regions(Pace& pace, Tangle& tangle, const DivideRequest& request, uint32_t revision,
                          TangleStep& step);

}  // namespace flg
