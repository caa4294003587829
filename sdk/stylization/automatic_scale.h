// SPDX-License-Identifier: MIT
// How large a style is drawn on a curve when the host leaves it to the SDK (scale 0).
//
// A style is learnt from an example, whose guide has a size; a target gets the style in the proportion that the example
// shows. The size of a curve is D (D / L)^(1/3), with L its length and D = sqrt(12) times the root mean square distance
// of its points from their centre: its length if it is straight, the less the more it is wound up. So a style has the
// scale 1 on its own guide.
// A stroke that was painted has a radius, which says how wide it is meant: the style swings swing_per_radius times as
// far, as long as that is no less than 1 / finest and no more than `coarsest` of the example's proportion: dabs are
// filled by some turns that can be seen, not by all of the style.
//
// Invariants. Lengths alone count, and only in proportion, so that a similarity of target or style changes the scale as
// it must, and of both alike nothing. A curve's scale does not depend on the other curves.
#pragma once

#include "core/memory.h"
#include "runtime/task.h"
#include "stylization/style.h"

namespace flg {

// Of each curve.
struct ChosenScales {
    Buffer<float> scale;     // above 0 and at most 1e30
    Buffer<float> thinning;  // factor on the target's radius, at most 1: the style's turns stay apart
};

// About 10 ns a point of the target and of the guide. Stage "size".
Task<ChosenScales> choose_scales(Pace& pace, const PreparedStyle& style, const CurveSet& target);

// Of a stroke whose length nobody knows yet; `radius` is that of the line that is drawn, metres: its turns stay apart.
double live_scale(const PreparedStyle& style, double radius);

}  // namespace flg
