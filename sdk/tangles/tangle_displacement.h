// SPDX-License-Identifier: MIT
// Displacement along normals, growing from the borders of leaves inwards: sec. 3.4 of Nazzaro, Puppo, Pellacini:
// geoTangle (2021), with profiles by Schlick: Fast alternatives to Perlin's bias and gain functions (Graphics Gems IV,
// 1994).
#pragma once

#include "tangles/tangle.h"
#include "tangles/tangle_seeds.h"

namespace flg {

// From [0, 1] onto [0, 1]; bias and gain in (0, 1), 0.5 changes nothing. bias(0.5, b) = b.
double schlick_bias(double t, double bias);
double schlick_gain(double t, double gain);

struct DisplaceRequest {
    explicit DisplaceRequest(Memory* memory) : regions(memory) {}

    FlgTangleDisplaceDesc desc{};  // checked; without what it points to
    std::pmr::vector<RegionId> regions;
};

// Displaces regions as part of a step.
Task<void> displace_regions(Pace& pace, Tangle& tangle, const DisplaceRequest& request, uint32_t revision,
                            TangleStep& step);

}  // namespace flg
