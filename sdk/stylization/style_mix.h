// SPDX-License-Identifier: MIT
// Several styles along one target: each is applied by itself, then their results are mixed point by point.
//
// Which style is chosen changes from place to place of the target (the value that a drive gives goes evenly from point
// to point, and the nearest style counts). Over the length b, half before such a place and half behind, one style turns
// into the next: a style's weight at arc length s is the share of the places x that choose it,
//   w(s) = int over them of K((x - s) / b) dx / b,   K(y) = 3/2 - 6 y^2 within 1/2 of 0,
// so that weights add up to 1, change without steps or bends, and are 1 where a style is alone for longer than b. Where
// a curve's choice changes more than 64 times over b somewhere, b is as long as 64 changes there.
// The result has the points of the style that has most on the curve. The others' places and attributes are interpolated
// between their points that lie there along the target; what is alone is copied to the bit. Since all results are the
// target plus a displacement, the mean of their points is the target plus the mean displacement.
//
// Angles keep whole turns between styles: one that comes in is turned to where it is nearest.
#pragma once

#include <array>

#include "curves/sampling_job.h"
#include "stylization/style.h"

namespace flg {

constexpr uint32_t styles_max = 8;

// One style's part.
struct MixedStyle {
    const PreparedStyle* style = nullptr;
    const CurveSet* result = nullptr;
    const Sampling* sampling = nullptr;  // whose plans the result was made by
};

struct MixInput {
    std::array<MixedStyle, styles_max> styles{};
    uint32_t count = 0;
    const CurveSet& target;
    const Buffer<float>& chosen;  // the driven value, one a point of the target
    double blend = 0;             // metres
    CurveSet& out;
    bool unfinished = false;  // curves of `out` still change when all are mixed
};

// Throws FLG_ERROR_INVALID_ARGUMENT if a style transfers other attributes than the first one.
void check_same_attributes(const PreparedStyle& first, const PreparedStyle& other, uint32_t index);

// Stage "mixing": lays `out` out and fills it. About 0.2 us a point. What the input refers to outlives the task.
Task<void> mix_styles(Pace& pace, const MixInput& input);

}  // namespace flg
