// SPDX-License-Identifier: MIT
// Networks: where pinned results meet, those that go on into each other have one direction.
//
// Ends of open targets that are the same point, to the bit, meet in a junction. There they are paired by the smallest
// turn of their tangents, up to 60 degrees, each end once. The directions of both results' first steps, from the
// junction on, are made opposite: each first step s of a result is turned into s', and
//   k (1 - k / n)^2 (s' - s)
// is added to its k-th point, so that it goes on evenly and is itself again behind n points. n is the patch size, or as
// many as keep this from bending more than the style does, up to 4 patch sizes, as at seams (seam_blend). Frames turn
// alike, from the target's tangent to that which both targets' tangents have in common.
#pragma once

#include <span>

#include "curves/curve_set.h"
#include "runtime/task.h"

namespace flg {

struct JunctionInput {
    const CurveSet& target;
    CurveSet& out;  // stylized, with TANGENT and NORMAL behind POSITION
    uint32_t copies = 1;
    uint32_t patch = 1;
    double magnitude = 1;
    double bend = 0;                  // metres, of the style at magnitude 1 and scale 1 of each curve
    std::span<const float> scales{};  // of the target's curves; none: 1
};

// About 1 us an end and 20 ns a point that moves. What the input refers to outlives the task.
Task<void> smooth_junctions(Pace& pace, JunctionInput input);

}  // namespace flg
