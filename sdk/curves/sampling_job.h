// SPDX-License-Identifier: MIT
// Jobs over curve sets: every curve is measured, the result is laid out, every curve is sampled into it. Resampling is
// this and nothing more; stylization has the same first half.
#pragma once

#include <span>

#include "curves/curve_set.h"
#include "curves/framed_sampler.h"
#include "curves/resample.h"
#include "runtime/fork.h"

namespace flg {

// Curves are shared out to threads in batches of about so many points.
constexpr uint32_t points_per_batch = 4096;

inline uint32_t batch_count(const CurveSet& set) {
    return (set.point_count() + points_per_batch - 1) / points_per_batch;
}

// The curves of a batch: those whose first point lies in its share of the points.
struct CurveRange {
    uint32_t first, last;  // last is not included
};
CurveRange curves_of_batch(const CurveSet& set, uint32_t batch);

CurveView curve_view(const CurveSet& set, uint32_t curve);

constexpr uint32_t sampled_points_max = uint32_t{1} << 31;

// A curve set's way into another.
struct Sampling {
    const CurveSet& in;
    CurveSet& out;
    double spacing;                      // metres
    std::span<const float> scales = {};  // factor on the spacing, one a curve of `in`; empty: 1
    FlgFrameMethod frame;
    uint32_t copies;             // how often each curve is in `out`: the copies of curve c begin at c * copies
    uint32_t max_points;         // of `out`; 0: sampled_points_max
    bool exact;                  // steps on open curves, as live strokes have them
    const float* step_scales;    // by how much steps are longer, one a point of `in`; null: by nothing
    Buffer<SamplingPlan> plans;  // one a curve of `in`
    // Columns that are carried over, of `in` and, at the same place, of `out`.
    struct Carried {
        const Column* in;
        Column* out;
    };
    std::pmr::vector<Carried> carried;

    double spacing_of(uint32_t curve) const { return scales.empty() ? spacing : spacing * double{scales[curve]}; }
};

// Stage "measure": fills in the plans and lays out the result with the columns POSITION, TANGENT, NORMAL, then the
// `added` ones, then those of `in` that are none of these. Throws FLG_ERROR_LIMIT if the result would have more points
// than it may, FLG_ERROR_INVALID_ARGUMENT if frames are to be supplied and `in` has none.
Task<void> plan_sampling(Pace& pace, Sampling& sampling, std::pmr::vector<CurveSet::ColumnLayout> added);
// The same in two parts: the plans' numbers of steps may be changed in between.
Task<void> measure_sampling(Pace& pace, Sampling& sampling);
Task<void> lay_out_sampling(Pace& pace, Sampling& sampling, std::pmr::vector<CurveSet::ColumnLayout> added);

// Where the samples of a curve of `out` go.
FrameColumns frame_columns(const Sampling& sampling, uint32_t out_curve);
void column_pairs(const Sampling& sampling, uint32_t out_curve, std::pmr::vector<ColumnPair>& pairs);

// The whole of flgCurveSetResample.
Task<void> resample_curves(Pace& pace, std::shared_ptr<const CurveSet> in, double spacing, FlgFrameMethod frame,
                           std::shared_ptr<CurveSet> out);

}  // namespace flg
