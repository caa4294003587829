// SPDX-License-Identifier: MIT
#include "curves/sampling_job.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t layout_chunk = 2500;  // curves, about 10 us

// What a result may have, and how a sentence says so.
struct PointLimit {
    double points;
    char text[32];

    explicit PointLimit(const Sampling& sampling)
        : points(sampling.max_points ? sampling.max_points : sampled_points_max) {
        if (sampling.max_points)
            std::snprintf(text, sizeof text, "desc.max_points is %u", sampling.max_points);
        else
            std::snprintf(text, sizeof text, "the limit is 2^31");
    }
};

// A curve's, or null if frames are not to be supplied.
const float* supplied_normals(const Sampling& sampling, uint32_t curve) {
    if (sampling.frame != FLG_FRAME_METHOD_SUPPLIED) return nullptr;
    return sampling.in.find(FLG_ATTRIBUTE_NORMAL)->values.data() + size_t{3} * sampling.in.offsets()[curve];
}

// Null if the set has none.
const float* first_orientation(const CurveSet& set, uint32_t curve) {
    const Column* orientations = set.find(FLG_ATTRIBUTE_ORIENTATION);
    return orientations ? orientations->values.data() + size_t{4} * set.offsets()[curve] : nullptr;
}

Task<void> measure_batch(Pace& pace, Sampling& sampling, uint32_t batch) {
    const CurveRange range = curves_of_batch(sampling.in, batch);
    for (uint32_t c = range.first; c < range.last; ++c) {
        const CurveView curve = curve_view(sampling.in, c);
        const CurveMeasure measure = co_await measure_curve(pace, curve);
        const double spacing = sampling.spacing_of(c);
        const float* scales = sampling.step_scales ? sampling.step_scales + sampling.in.offsets()[c] : nullptr;
        const double length = scales ? co_await measure_steps(pace, curve, scales) : measure.length;
        const double exact = sampling.exact && !curve.closed ? exact_step_count(length, spacing) : 0;
        const double steps = exact > 0 ? exact : even_step_count(length, spacing, curve.closed);
        if (const PointLimit limit(sampling); steps >= limit.points) {
            throw Failure(FLG_ERROR_LIMIT, "curve %u is %g m long and would get %.0f points %g m apart; %s", c,
                          measure.length, steps, spacing, limit.text);
        }
        std::construct_at(&sampling.plans[c], SamplingPlan{.curve = curve,
                                                           .measure = measure,
                                                           .steps = static_cast<uint32_t>(steps),
                                                           .frame = sampling.frame,
                                                           .normals = supplied_normals(sampling, c),
                                                           .orientation = first_orientation(sampling.in, c),
                                                           .exact_step = exact > 0 ? spacing : 0,
                                                           .step_scales = scales,
                                                           .scaled_length = length});
        pace.advance(curve.count);
        co_await pace;
    }
}

Task<void> lay_out_curves(Pace& pace, Sampling& sampling) {
    const CurveSet& in = sampling.in;
    CurveSet& out = sampling.out;
    const uint64_t curve_count = uint64_t{in.curve_count()} * sampling.copies;
    const PointLimit limit(sampling);
    if (static_cast<double>(curve_count) > limit.points) {
        throw Failure(FLG_ERROR_LIMIT, "%u strokes along %u curves would have more points than that; %s",
                      sampling.copies, in.curve_count(), limit.text);
    }
    out.allocate_curves(static_cast<uint32_t>(curve_count));
    uint64_t point_count = 0;
    for (uint32_t c = 0; c < curve_count; ++c) {
        out.offsets()[c] = static_cast<uint32_t>(point_count);
        out.begin_curve(c, in.flags()[c / sampling.copies]);
        point_count += sampling.plans[c / sampling.copies].sample_count();
        if (static_cast<double>(point_count) > limit.points) {
            throw Failure(FLG_ERROR_LIMIT, "the result would have more points, %g m apart, than it may; %s",
                          sampling.spacing_of(c / sampling.copies), limit.text);
        }
        if (c % layout_chunk == 0) co_await pace;
    }
    out.offsets()[curve_count] = static_cast<uint32_t>(point_count);
}

void lay_out_columns(Sampling& sampling, const std::pmr::vector<CurveSet::ColumnLayout>& added, Memory* memory) {
    CurveSet& out = sampling.out;
    std::pmr::vector<CurveSet::ColumnLayout> layout(
        {{FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_TANGENT, 3}, {FLG_ATTRIBUTE_NORMAL, 3}}, memory);
    layout.insert(layout.end(), added.begin(), added.end());
    const size_t made = layout.size();
    for (const Column& column : sampling.in.columns()) {
        const bool replaced = std::any_of(layout.begin(), layout.begin() + static_cast<ptrdiff_t>(made),
                                          [&](const auto& other) { return other.attribute == column.attribute; });
        if (replaced) continue;
        layout.push_back({column.attribute, column.components});
        sampling.carried.push_back({&column, nullptr});
    }
    out.allocate_columns(layout);
    for (size_t i = 0; i < sampling.carried.size(); ++i) sampling.carried[i].out = &out.columns()[made + i];
}

Task<void> resample_batch(Pace& pace, Sampling& sampling, uint32_t batch) {
    const CurveRange range = curves_of_batch(sampling.in, batch);
    std::pmr::vector<ColumnPair> pairs(pace.memory());
    for (uint32_t c = range.first; c < range.last; ++c) {
        column_pairs(sampling, c, pairs);
        co_await resample_curve(pace, sampling.plans[c], frame_columns(sampling, c), pairs, 1);
        sampling.out.complete_curve(c);
        co_await pace;
    }
}

}  // namespace

CurveRange curves_of_batch(const CurveSet& set, uint32_t batch) {
    const Buffer<uint32_t>& offsets = set.offsets();
    const auto curve_at = [&](uint64_t point) {
        const auto place = std::lower_bound(offsets.begin(), offsets.begin() + set.curve_count(), point);
        return static_cast<uint32_t>(place - offsets.begin());
    };
    const uint64_t first_point = uint64_t{batch} * points_per_batch;
    return {curve_at(first_point), curve_at(first_point + points_per_batch)};
}

CurveView curve_view(const CurveSet& set, uint32_t curve) {
    const uint32_t first = set.offsets()[curve];
    return {set.positions() + size_t{first} * 3, set.offsets()[curve + 1] - first, set.closed(curve)};
}

Task<void> plan_sampling(Pace& pace, Sampling& sampling, std::pmr::vector<CurveSet::ColumnLayout> added) {
    co_await measure_sampling(pace, sampling);
    co_await lay_out_sampling(pace, sampling, std::move(added));
}

Task<void> measure_sampling(Pace& pace, Sampling& sampling) {
    pace.stage("measure");
    const CurveSet& in = sampling.in;
    if (sampling.frame == FLG_FRAME_METHOD_SUPPLIED && !in.find(FLG_ATTRIBUTE_NORMAL)) {
        throw Failure(
            FLG_ERROR_INVALID_ARGUMENT,
            "the curves have no FLG_ATTRIBUTE_NORMAL column, from which FLG_FRAME_METHOD_SUPPLIED takes its frames");
    }
    sampling.plans = Buffer<SamplingPlan>(in.curve_count(), pace.memory());
    co_await fork(pace, batch_count(in), &measure_batch, sampling);
}

Task<void> lay_out_sampling(Pace& pace, Sampling& sampling, std::pmr::vector<CurveSet::ColumnLayout> added) {
    co_await lay_out_curves(pace, sampling);
    lay_out_columns(sampling, added, pace.memory());
    pace.expect(uint64_t{sampling.in.point_count()} + sampling.out.point_count());
}

FrameColumns frame_columns(const Sampling& sampling, uint32_t out_curve) {
    const size_t at = size_t{sampling.out.offsets()[out_curve]} * 3;
    std::pmr::vector<Column>& columns = sampling.out.columns();
    return {columns[0].values.data() + at, columns[1].values.data() + at, columns[2].values.data() + at};
}

void column_pairs(const Sampling& sampling, uint32_t out_curve, std::pmr::vector<ColumnPair>& pairs) {
    pairs.clear();
    const size_t from = sampling.in.offsets()[out_curve / sampling.copies];
    const size_t to = sampling.out.offsets()[out_curve];
    for (const Sampling::Carried& carried : sampling.carried) {
        const uint32_t width = carried.in->components;
        pairs.push_back({carried.in->values.data() + from * width, carried.out->values.data() + to * width, width,
                         carried.in->attribute == FLG_ATTRIBUTE_ORIENTATION});
    }
}

Task<void> resample_curves(Pace& pace, std::shared_ptr<const CurveSet> in, double spacing, FlgFrameMethod frame,
                           std::shared_ptr<CurveSet> out) {
    Sampling sampling{.in = *in,
                      .out = *out,
                      .spacing = spacing,
                      .frame = frame,
                      .copies = 1,
                      .max_points = 0,
                      .exact = false,
                      .step_scales = nullptr,
                      .plans = {},
                      .carried = std::pmr::vector<Sampling::Carried>(pace.memory())};
    co_await plan_sampling(pace, sampling, std::pmr::vector<CurveSet::ColumnLayout>(pace.memory()));
    pace.stage("resample");
    co_await fork(pace, batch_count(sampling.in), &resample_batch, sampling);
}

}  // namespace flg
