// SPDX-License-Identifier: MIT
// Results cut at the planes that halve their targets' corners.
//
// At a corner c with tangents a before and b behind it the plane through c across a + b halves the angle. With D the
// displacement times the magnitude, n the plane's normal and t the target's tangent, the point x + D becomes
//   x + D - k (n . D / n . t) t,   k from 1 at the corner to 0 by 1 - 3 r^2 + 2 r^3, r = distance / reach:
// at the corner it slides along the target into the plane. From both sides it is the same point, because frames turn at
// corners by the smallest rotation: as the offset of a polyline is mitred. With a reach of (1 + tan(turn / 2)) times
// the largest displacement nothing on a straight side crosses the plane. Where sides are shorter, or bend, points slide
// just as far as they have to; where two planes leave no room for that, D gets smaller.
// Turns of more than 152 degrees, where the mitre's tip would be longer than 4 displacements, have narrower ones: what
// lies across the corner gets smaller towards it, down to nothing at a reversal.
#pragma once

#include "curves/framed_sampler.h"
#include "runtime/task.h"

namespace flg {

struct MitreInput {
    SamplingPlan plan;  // with pieces
    double magnitude = 1;
    double largest = 0;             // displacement times magnitude, metres, about
    float* positions = nullptr;     // the result's
    float* displacement = nullptr;  // null: not wanted
};

// About 100 ns a sample. What the input refers to outlives the task.
Task<void> mitre_corners(Pace& pace, MitreInput input);

}  // namespace flg
