// SPDX-License-Identifier: MIT
// Points evenly along the borders of regions, by arc length: where operators of tangles begin, sec. 3.3 and 4.2 of
// Nazzaro, Puppo, Pellacini: geoTangle (2021).
#pragma once

#include <span>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/region_loops.h"
#include "surfaces/mesh/surface_curves.h"

namespace flg {

// What is sampled of a loop, in shares of its length from its first vertex on: 0 <= begin < 1, begin < end <= begin +
// 1.
struct BorderStretch {
    uint32_t loop;
    double begin = 0, end = 1;

    bool is_whole() const { return end - begin >= 1; }
};

// Appends a curve a stretch. Each gets a whole number of equal steps: as near to `spacing` (metres, > 0) as can be,
// three at least; whole loops a multiple of `multiple` (>= 1), unless that is more than twice as many. Whole loops
// become closed curves whose first point is where the stretch begins; of others only points between their ends are
// placed, so that these with the ends cut them into equal pieces. A curve's value is the length of its stretch. Fails
// with FLG_ERROR_LIMIT if one would get more than 2^24 points.
Task<void> sample_stretches(Pace& pace, const Mesh& mesh, const RegionLoops& loops,
                            std::span<const BorderStretch> stretches, float spacing, uint32_t multiple,
                            SurfaceCurves& curves);

}  // namespace flg
