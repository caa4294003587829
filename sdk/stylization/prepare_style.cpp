// SPDX-License-Identifier: MIT
#include "stylization/prepare_style.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/failure.h"
#include "curves/sampling_job.h"
#include "stylization/guide_flow.h"
#include "stylization/guide_matching.h"
#include "stylization/smooth_style_curve.h"

namespace flg {

namespace {

// Units of work that take about 20 us each.
constexpr uint32_t measure_chunk = 800;
constexpr uint32_t sample_chunk = 400;
constexpr uint32_t turning_chunk = 500;
constexpr uint32_t flow_chunk = 2000;
constexpr uint32_t matching_chunk = 800;
constexpr uint32_t copy_chunk = 4000;
constexpr uint32_t evaluate_chunk = 800;
constexpr uint32_t displacement_chunk = 2000;
constexpr uint32_t graph_chunk = 40;

// The single open curve with length that styles and guides must be.
Task<CurveMeasure> measure_example(Pace& pace, const CurveSet& set, const char* name) {
    if (set.curve_count() != 1) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.%s has %u curves, must have one", name, set.curve_count());
    }
    if (set.closed(0)) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.%s is a closed curve, must be open", name);
    ArcLengthKernel kernel(curve_view(set, 0));
    while (!kernel.run(measure_chunk)) co_await pace;
    if (!(kernel.measure().length > 0)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.%s has no length: its %u point%s the same place", name,
                      set.point_count(), set.point_count() == 1 ? " is" : "s are");
    }
    co_return kernel.measure();
}

// The sum of the angles between consecutive edges, radians.
Task<double> total_turning(Pace& pace, const CurveView& curve) {
    double turning = 0;
    Vec3 last = Vec3::Zero();
    for (uint32_t i = 1; i < curve.count; ++i) {
        if (i % turning_chunk == 0) co_await pace;
        const Vec3 edge = curve.point(i) - curve.point(i - 1);
        if (edge.squaredNorm() == 0) continue;
        if (last.squaredNorm() > 0) turning += std::atan2(last.cross(edge).norm(), last.dot(edge));
        last = edge;
    }
    co_return turning;
}

uint32_t choose_point_count(uint32_t given_points, double turning) {
    const double wanted = std::max(static_cast<double>(given_points), turning / auto_turn_per_point);
    const double clamped =
        std::clamp(std::ceil(wanted), static_cast<double>(auto_points_min), static_cast<double>(auto_points_max));
    return static_cast<uint32_t>(clamped);
}

void check_patch(uint32_t patch, uint32_t point_count) {
    if (2 * patch + 1 >= point_count) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.patch is %u: its %u points must be fewer than the style's %u",
                      patch, 2 * patch + 1, point_count);
    }
}

// `count` even points of a curve.
Task<void> sample_points(Pace& pace, const CurveView& curve, double length, std::pmr::vector<Vec3>& points) {
    const auto count = static_cast<uint32_t>(points.size());
    EvenSampler sampler(curve, length, count - 1);
    CurveSample sample;
    for (uint32_t i = 0; i < count;) {
        uint32_t units = sample_chunk;
        while (i < count && sampler.next(sample, units)) points[i++] = sample.position;
        co_await pace;
    }
}

// The guide as a curve set: `count` even points with the frames that synthesis would give this curve as a target.
Task<double> frame_guide(Pace& pace, const CurveView& curve, uint32_t count, CurveSet& guide) {
    ArcLengthKernel measure(curve);
    while (!measure.run(measure_chunk)) co_await pace;
    if (!(measure.measure().length > 0)) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the guide has no length");
    guide.allocate_curves(1);
    guide.offsets()[0] = 0;
    guide.offsets()[1] = count;
    guide.flags()[0] = 0;
    guide.allocate_columns(std::pmr::vector<CurveSet::ColumnLayout>(
        {{FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_TANGENT, 3}, {FLG_ATTRIBUTE_NORMAL, 3}}, pace.memory()));
    const FrameColumns columns{guide.columns()[0].values.data(), guide.columns()[1].values.data(),
                               guide.columns()[2].values.data()};
    ResampleKernel kernel({.curve = curve, .measure = measure.measure(), .steps = count - 1}, columns, {});
    while (!kernel.run(sample_chunk)) co_await pace;
    co_return measure.measure().length;
}

// The guide flow's result, in the floats that a curve set holds.
Task<void> flow_guide(Pace& pace, const StyleRequest& request, const std::pmr::vector<Vec3>& style,
                      Buffer<float>& positions) {
    PreparedStyle& prepared = request.style->prepared;
    const auto count = static_cast<uint32_t>(style.size());
    GuideFlow::Params params;
    params.alpha = request.alpha;
    params.smoothing = request.smoothing;
    GuideFlow flow(style.data(), count, params, pace.memory());
    while (!flow.run(flow_chunk)) co_await pace;
    prepared.flow_steps = flow.steps();
    positions = Buffer<float>(size_t{count} * 3, pace.memory());
    for (uint32_t i = 0; i < count; ++i) {
        store_vec3(flow.guide()[i], positions.data() + size_t{i} * 3);
        if (i % copy_chunk == 0) co_await pace;
    }
}

// The points of the style that belong to the guide's.
Task<void> match_guide(Pace& pace, const StyleRequest& request, const SmoothStyleCurve& style,
                       std::pmr::vector<Vec3>& matched) {
    PreparedStyle& prepared = request.style->prepared;
    const auto count = static_cast<uint32_t>(matched.size());
    std::pmr::vector<Vec3> guide(count, pace.memory());
    for (uint32_t i = 0; i < count; ++i) {
        guide[i] = load_vec3(prepared.guide->positions() + size_t{i} * 3);
        if (i % copy_chunk == 0) co_await pace;
    }
    GuideMatching matching(style, guide.data(), count, request.beta, pace.memory());
    while (!matching.run(matching_chunk)) co_await pace;
    prepared.matching_energy = matching.energy() / count;
    prepared.matching = Buffer<float>(count, pace.memory());
    for (uint32_t i = 0; i < count; ++i) {
        const double s = matching.matching()[i];
        prepared.matching[i] = static_cast<float>(s);
        matched[i] = style.evaluate(s).position;
        if (i % evaluate_chunk == 0) co_await pace;
    }
}

}  // namespace

Task<void> prepare_style(Pace& pace, StyleRequest request) {
    PreparedStyle& prepared = request.style->prepared;
    const CurveView example = curve_view(*request.example, 0);

    pace.stage("resample");
    const CurveMeasure measure = co_await measure_example(pace, *request.example, "style");
    if (request.guide) co_await measure_example(pace, *request.guide, "guide");
    uint32_t count = request.point_count;
    if (count == 0) {
        const double turning = co_await total_turning(pace, example);
        count = choose_point_count(example.count, turning);
    }
    check_patch(request.patch, count);
    std::pmr::vector<Vec3> points(count, pace.memory());
    co_await sample_points(pace, example, measure.length, points);
    prepared.style_length = measure.length;

    pace.stage("guide_flow");
    constexpr uint64_t progress_parts = 4;
    pace.expect(progress_parts);
    Buffer<float> flowed;
    CurveView guide;
    if (request.guide) {
        guide = curve_view(*request.guide, 0);
    } else {
        co_await flow_guide(pace, request, points, flowed);
        guide = {flowed.data(), count, false};
    }
    prepared.guide =
        std::allocate_shared<CurveSet>(std::pmr::polymorphic_allocator<CurveSet>(pace.memory()), pace.memory());
    prepared.guide_length = co_await frame_guide(pace, guide, count, *prepared.guide);
    pace.advance(1);

    pace.stage("matching");
    std::pmr::vector<Vec3> matched(count, pace.memory());
    const SmoothStyleCurve style(points.data(), count, measure.length);
    co_await match_guide(pace, request, style, matched);
    pace.advance(1);

    pace.stage("displacement");
    const auto& columns = prepared.guide->columns();
    DisplacementKernel displacement(
        {columns[0].values.data(), columns[1].values.data(), columns[2].values.data(), matched}, pace.memory());
    while (!displacement.run(displacement_chunk)) co_await pace;
    prepared.displacement_rms = displacement.rms();
    prepared.displacement = displacement.take();
    pace.advance(1);

    pace.stage("patch_graph");
    const std::array<uint32_t, 2> boundaries{0, count};
    PatchGraphKernel graph({&prepared.displacement, boundaries, request.patch}, pace.memory());
    while (!graph.run(graph_chunk)) co_await pace;
    prepared.graph = graph.take();
    pace.advance(1);
}

}  // namespace flg
