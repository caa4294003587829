// SPDX-License-Identifier: MIT
// A curve resampled into the columns of a result.
#pragma once

#include <span>

#include "curves/framed_sampler.h"
#include "runtime/task.h"

namespace flg {

// A column that follows the points, interpolated linearly. `in` is at the curve's first point, `out` at its first
// sample; both tightly packed.
struct ColumnPair {
    const float* in = nullptr;
    float* out = nullptr;
    uint32_t components = 0;
    bool orientation = false;  // unit quaternions: the shorter way, and normalized
};

// Where the samples of one curve go: three floats each, tightly packed.
struct FrameColumns {
    float* positions = nullptr;
    float* tangents = nullptr;
    float* normals = nullptr;
};

// Where a sample lies between the points of the input.
struct SamplePlace {
    uint32_t segment = 0;
    float t = 0;
};

// Values number `first`, `first` + 1, ... of a column, for the given samples.
void interpolate_column(const ColumnPair& column, const CurveView& curve, std::span<const SamplePlace> places,
                        uint32_t first);

// About 50 ns a sample and a point of the input; twice that on closed curves with a rotation-minimizing frame. The
// columns outlive the task. Reports `progress` units a sample.
Task<void> resample_curve(Pace& pace, SamplingPlan plan, FrameColumns out, std::span<const ColumnPair> columns,
                          uint32_t progress);

}  // namespace flg
