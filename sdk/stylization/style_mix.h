// SPDX-License-Identifier: MIT
// Several styles along one target: each is applied by itself, then their results are mixed point by point.
//
// Half of a blend (style_choice.h) is before the place where the choice changes, half behind. Where a curve's choice
// changes more than 64 times over b somewhere, b is as long as 64 changes there.
// The result has the points of the style that has most on the curve. The others' places and attributes are interpolated
// between their points that lie there along the target; what is alone is copied to the bit. Since all results are the
// target plus a displacement, the mean of their points is the target plus the mean displacement.
//
// Angles keep whole turns between styles: one that comes in is turned to where it is nearest.
#pragma once

#include <array>

#include "curves/sampling_job.h"
#include "stylization/style_choice.h"

namespace flg {

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
