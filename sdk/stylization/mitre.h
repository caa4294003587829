// SPDX-License-Identifier: MIT
// Results cut at the planes that halve their targets' corners.
//
// At a corner c with tangents a before and b behind it the plane through c across a + b halves the angle. With
// D = d t + E the displacement times the magnitude, along the target's tangent t and across it, and n the plane's
// normal, the point x + D becomes
//   x + (1 - k) d t + E - l (n . E / n . t) t,   k, l from 1 at the corner to 0 by 1 - 3 r^2 + 2 r^3,
// r being the distance from the corner, in sizes of the style for k, in sizes times tan(turn / 2) for l: at the corner
// it slides along the target into the plane. From both sides it is the same point, because frames turn at corners by
// the smallest rotation: as the offset of a polyline is mitred. Where that still crosses the plane, points slide just
// as far as they have to; where two planes leave no room for that, D gets smaller.
// Turns of more than 127 degrees, where the mitre's tip would be longer than 2 displacements, have narrower ones: E
// gets smaller towards the corner, down to nothing at a reversal.
#pragma once

#include "curves/framed_sampler.h"
#include "runtime/task.h"

namespace flg {

struct MitreInput {
    SamplingPlan plan;  // with pieces
    double magnitude = 1;
    double size = 0;                // of the style as it is drawn, away from the target, metres
    float* positions = nullptr;     // the result's
    float* displacement = nullptr;  // null: not wanted
};

// About 150 ns a sample. What the input refers to outlives the task.
Task<void> mitre_corners(Pace& pace, MitreInput input);

}  // namespace flg
