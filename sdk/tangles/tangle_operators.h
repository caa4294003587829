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

// Divides regions as part of a step. `revision`: the surface's after the change. If it throws after it changed
// something, the step's last edit says what.
Task<void> divide_regions(Pace& pace, Tangle& tangle, const DivideRequest& request, uint32_t revision,
                          TangleStep& step);

}  // namespace flg
