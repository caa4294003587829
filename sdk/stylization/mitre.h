// SPDX-License-Identifier: MIT
// Results cut at the planes that halve their targets' corners.
//
// At a corner c with sides along a before and b behind it the plane through c across a + b halves the angle. a and b
// are fitted to the sides, over a window of arc length: edges next to a corner that a hand has drawn point anywhere.
// With D = d t + E the displacement times the magnitude, along the target's tangent t and across it, and n the plane's
// normal, the point x + D becomes
//   x + (1 - k) d t + K (E - k (n . E / n . t) t),   k = 1 - 3 r^2 + 2 r^3,
// r being the distance from the corner along the target, from 0 to 1 at the reach R: at the corner it slides along the
// target into the plane. From both sides it is the same point, because frames turn at corners by the smallest rotation:
// as the offset of a polyline is mitred.
// R is two sizes of the style, or half of the side. No point slides farther than 2 / 3 R, which is as far as results go
// on along the target without turning back, and at turns by more than 90 degrees less, so that tips are no spikes:
// where a corner asks for more, K makes E smaller towards it, down to nothing at a reversal. What crosses the plane
// even so, near the corner, gets smaller until it does not. A side shorter than the style is wide leaves no room:
// from there down to a third of that, the style goes through the corner more and more.
#pragma once

#include "curves/framed_sampler.h"
#include "runtime/task.h"

namespace flg {

struct MitreInput {
    SamplingPlan plan;  // with pieces
    double magnitude = 1;
    double size = 0;                  // of the style as it is drawn, away from the target, metres
    std::span<const float> across{};  // factors on that, one a piece; none: 1
    float* positions = nullptr;       // the result's
    float* displacement = nullptr;    // null: not wanted
};

// About 150 ns a sample, 50 ns a point of the target. What the input refers to outlives the task.
Task<void> mitre_corners(Pace& pace, MitreInput input);

}  // namespace flg
