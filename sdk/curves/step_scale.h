// SPDX-License-Identifier: MIT
// Steps that get longer and shorter along a curve: within a segment of length L the length of a step goes evenly, by
// arc length, from `start` to `end` times the usual one. Then both ways are closed forms:
//   steps(s) = int_0^s dr / scale(r) = (L / (end - start)) ln(1 + (end - start) s / (start L))
#pragma once

#include <algorithm>
#include <cmath>

#include "curves/segment_stream.h"

namespace flg {

struct StepScale {
    double start = 1, end = 1;  // > 0

    // What a segment of this length is worth in usual lengths.
    double steps(double length) const {
        // It is the same from either end.
        const double least = std::min(start, end), x = (std::max(start, end) - least) / least;
        return x == 0 ? length / least : length / least * (std::log1p(x) / x);
    }
    // How far along the segment so many of them reach.
    double length(double segment_length, double steps) const {
        const double y = (end - start) / segment_length * steps;
        return y == 0 ? start * steps : start * steps * (std::expm1(y) / y);
    }
    // The same, but for rounding, which could have it beyond the end.
    float place(double segment_length, float steps) const {
        return static_cast<float>(std::min(length(segment_length, double{steps}), segment_length));
    }
};

// Of the segment that begins at point `index`; `scales` are the points'.
inline StepScale step_scale(const CurveView& curve, const float* scales, uint32_t index) {
    return {scales[index], scales[curve.following(index)]};
}

}  // namespace flg
