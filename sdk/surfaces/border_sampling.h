// SPDX-License-Identifier: MIT
// Points evenly along the borders of regions, by arc length: where operators of tangles begin, sec. 3.3 and 4.2 of Nazzaro,
// Puppo, Pellacini: geoTangle (2021).
#pragma once

#include <span>

#include "surfaces/region_loops.h"
#include "surfaces/surface_curves.h"

namespace flg {

// What is sampled of a loop, in shares of its length from its first vertex on: 0 <= begin < 1, begin < end <= begin + 1.
struct BorderStretch {
    uint32_t loop;
    double begin = 0, end = 1;

    bool is_whole() const { return end - begin >= 1; }
};

// Whole loops become closed curves whose first point is where the stretch begins; of others only points between their ends
// are placed, so that these with the ends cut them into equal pieces. A curve's value is the length of its stretch.
class BorderSamplingKernel {
public:
    // Each stretch gets a whole number of equal steps: as near to `spacing` (metres, > 0) as can be, three at least. Fails
    // with FLG_ERROR_LIMIT if one would get more than 2^24. All outlive the kernel.
    BorderSamplingKernel(const Mesh& mesh, const RegionLoops& loops, std::span<const BorderStretch> stretches,
                         float spacing, SurfaceCurves& curves);

    // A unit is an edge or a point: 10 to 30 ns.
    bool run(uint32_t count);

private:
    void begin_stretch();
    void end_stretch();

    const Mesh& mesh_;
    const RegionLoops& loops_;
    const std::span<const BorderStretch> stretches_;
    const float spacing_;
    SurfaceCurves& curves_;
    size_t at_ = 0;  // stretch
    uint32_t edge_ = 0;
    double walked_ = 0;                // metres, from the loop's beginning up to the edge
    uint32_t placed_ = 0, count_ = 0;  // steps
    bool within_ = false;              // a stretch
};

}  // namespace flg
