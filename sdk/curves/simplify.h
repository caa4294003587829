// SPDX-License-Identifier: MIT
// Fewer points of curves, for several tolerances at once.
//
// Source: Douglas, Peucker: Algorithms for the Reduction of the Number of Points Required to Represent a Digitized
// Line, 1973. An error is measured between a point that is left out and the place on the line that has its arc length,
// so that radius, rims and colour are measured there too.
//
// Departure: at least every 1024th point stays, and every third of a closed curve. This bounds the time, which is
// otherwise quadratic for spirals.
#pragma once

#include "curves/curve_set.h"
#include "runtime/task.h"

namespace flg {

constexpr uint32_t max_levels = 16;

struct SimplifyInput {
    std::shared_ptr<const CurveSet> curves;
    std::array<float, max_levels> tolerances;  // metres
    uint32_t level_count;
    float color_tolerance;
    bool ribbons;  // measures their rims
};

// Lays `out` out: curve c at level l is curve l * curve_count + c. Throws FLG_ERROR_LIMIT for more curves or points
// than a set may have, FLG_ERROR_INVALID_ARGUMENT if rims are to be measured and there are no frames.
Task<void> simplify_curves(Pace& pace, SimplifyInput input, std::shared_ptr<CurveSet> out);

}  // namespace flg
