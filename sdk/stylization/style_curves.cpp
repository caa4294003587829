// SPDX-License-Identifier: MIT
#include "stylization/style_curves.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "runtime/each.h"
#include "stylization/guide_flow.h"

namespace flg {

namespace {

// Units of work that take about 10 us each.
constexpr uint32_t sample_chunk = 200;
// Even the shortest of several curves is sampled with so many points, for flow and matching.
constexpr uint32_t samples_min = 16;

Task<CurveMeasure> measure_open_curve(Pace& pace, const CurveSet& set, uint32_t curve, const char* name) {
    if (set.closed(curve)) {
        if (set.curve_count() == 1) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.%s is a closed curve, must be open", name);
        }
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "curve %u of desc.%s is closed, must be open", curve, name);
    }
    const CurveView view = curve_view(set, curve);
    const CurveMeasure measure = co_await measure_curve(pace, view);
    if (!(measure.length > 0)) {
        const char* places = view.count == 1 ? " is" : "s are";
        if (set.curve_count() == 1) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.%s has no length: its %u point%s the same place", name,
                          view.count, places);
        }
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "curve %u of desc.%s has no length: its %u point%s the same place",
                      curve, name, view.count, places);
    }
    co_return measure;
}

// The sum of the angles between consecutive edges, radians.
Task<double> total_turning(Pace& pace, const CurveView& curve) {
    double turning = 0;
    Vec3 last = Vec3::Zero();
    co_await each(pace, 1, curve.count, Cost::tens_of_ns, [&](uint32_t i) {
        const Vec3 edge = curve.point(i) - curve.point(i - 1);
        if (edge.squaredNorm() == 0) return;
        if (last.squaredNorm() > 0) turning += std::atan2(last.cross(edge).norm(), last.dot(edge));
        last = edge;
    });
    co_return turning;
}

Task<void> sample_points(Pace& pace, StyleCurve& curve, uint32_t count) {
    curve.points.resize(count);
    BlockSampler sampler(curve.example, curve.measure.length, count - 1);
    SampleBlock block;
    for (uint32_t i = 0; i < count;) {
        uint32_t units = sample_chunk;
        while (i < count && sampler.next(block, units)) {
            for (uint32_t k = 0; k < block.count; ++k) curve.points[i++] = block.position_of(k);
        }
        co_await pace;
    }
}

// A guide that was given, relative to the example's origin.
Task<void> move_guide(Pace& pace, const StyleRequest& request, StyleCurve& curve) {
    const Vec3 shift = origin_shift(request.guide->origin, request.example->origin);
    Buffer<float> moved(size_t{curve.guide.count} * 3, pace.memory());
    co_await each(pace, curve.guide.count, Cost::some_ns,
                  [&](uint32_t i) { store_vec3(curve.guide.point(i) + shift, moved.data() + size_t{i} * 3); });
    curve.placed = std::move(moved);
    curve.guide.positions = curve.placed.data();
}

// What is marked of it, unless too little is left.
void mark_caps(const FlgStyleDesc& desc, bool first, bool last, StyleCurve& curve) {
    const auto points = [&](bool own, double metres) {
        return own && metres > 0 ? std::ceil(std::min(metres, curve.measure.length) / curve.point_spacing()) : 0.0;
    };
    const double start = points(first, double{desc.start_cap}), end = points(last, double{desc.end_cap});
    curve.start_cap = curve.end_cap = {};
    if (start + end + samples_min > static_cast<double>(curve.points.size())) return;
    curve.start_cap.points = static_cast<uint32_t>(start);
    curve.end_cap.points = static_cast<uint32_t>(end);
}

// How the guide goes on at one of its ends.
struct StraightEnd {
    Vec3 from = Vec3::Zero(), step = Vec3::Zero();
    uint32_t steps = 0;

    // `cap`: the cap's points. `body`: those of its guide, from that end on. `share`: length of the guide in that of
    // the example.
    static Task<StraightEnd> at(Pace& pace, std::span<const Vec3> cap, const auto& body, uint32_t count, double share,
                                double cap_length) {
        constexpr uint32_t spans = 8;  // the direction is taken over one of so many, since the flow bends the ends
        constexpr double least_share = 0.7;
        const uint32_t over = std::max(count / spans, 1U);
        const Vec3 direction = (body(0) - body(over)).normalized();
        double reach = least_share * std::min(share, 1.0) * cap_length;
        co_await each(pace, cap.size(), Cost::some_ns,
                      [&](uint32_t i) { reach = std::max(reach, direction.dot(cap[i] - body(0))); });
        const double spacing = (body(0) - body(over)).norm() / over;
        StraightEnd end;
        end.from = body(0);
        end.steps = static_cast<uint32_t>(std::clamp(std::ceil(reach / spacing), 1.0, double{style_points_max}));
        end.step = reach / end.steps * direction;
        co_return end;
    }
    double length() const { return steps * step.norm(); }
};

// The guide flow's result, in the floats that a curve set holds.
Task<uint32_t> flow_guide(Pace& pace, const StyleRequest& request, StyleCurve& curve) {
    const auto count = static_cast<uint32_t>(curve.points.size());
    GuideFlowParams params;
    params.alpha = request.desc.alpha;
    params.smoothing = request.desc.smoothing;
    const std::span<const Vec3> all = curve.points;
    const uint32_t first = curve.start_cap.points, behind = curve.end_cap.points, body = count - first - behind;
    const FlowedGuide guide = co_await guide_flow(pace, all.subspan(first, body), params);
    const double share = guide.length / (curve.point_spacing() * (body - 1));
    StraightEnd start, end;
    if (first > 0) {
        start = co_await StraightEnd::at(
            pace, all.first(first), [&](uint32_t i) { return guide.points[i]; }, body, share,
            first * curve.point_spacing());
    }
    if (behind > 0) {
        end = co_await StraightEnd::at(
            pace, all.last(behind), [&](uint32_t i) { return guide.points[body - 1 - i]; }, body, share,
            behind * curve.point_spacing());
    }
    curve.start_cap.guide_length = start.length();
    curve.end_cap.guide_length = end.length();
    const uint32_t placed = start.steps + body + end.steps;
    curve.placed = Buffer<float>(size_t{placed} * 3, pace.memory());
    co_await each(pace, placed, Cost::some_ns, [&, to = curve.placed.data()](uint32_t i) {
        Vec3 point;
        if (i < start.steps) {
            point = start.from + (start.steps - i) * start.step;
        } else if (i < start.steps + body) {
            point = guide.points[i - start.steps];
        } else {
            point = end.from + (i + 1 - start.steps - body) * end.step;
        }
        store_vec3(point, to + size_t{i} * 3);
    });
    curve.guide = {curve.placed.data(), placed, false};
    co_return guide.steps;
}

double total_length(const StyleCurves& curves, CurveMeasure StyleCurve::*measure) {
    double length = 0;
    for (const StyleCurve& curve : curves) length += (curve.*measure).length;
    return length;
}

}  // namespace

Task<void> measure_curves(Pace& pace, const StyleRequest& request, StyleCurves& curves) {
    const CurveSet& example = *request.example;
    const uint32_t count = example.curve_count();
    if (count > style_curves_max) {
        throw Failure(FLG_ERROR_LIMIT, "desc.style has %u curves, may have %u", count, style_curves_max);
    }
    if (request.guide && request.guide->curve_count() != count) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.guide has %u curves, must have one for each of desc.style's %u",
                      request.guide->curve_count(), count);
    }
    curves.reserve(count);
    for (uint32_t c = 0; c < count; ++c) {
        StyleCurve& curve = curves.emplace_back(pace.memory());
        curve.example = curve_view(example, c);
        curve.measure = co_await measure_open_curve(pace, example, c, "style");
        co_await pace;
        if (!request.guide) continue;
        curve.guide = curve_view(*request.guide, c);
        if (request.guide->origin != example.origin) co_await move_guide(pace, request, curve);
        curve.guide_measure = co_await measure_open_curve(pace, *request.guide, c, "guide");
        co_await pace;
    }
}

Task<uint32_t> choose_point_count(Pace& pace, const StyleCurves& curves) {
    double wanted = 0;
    for (const StyleCurve& curve : curves) {
        const double turning = co_await total_turning(pace, curve.example);
        co_await pace;
        wanted += std::max(static_cast<double>(curve.example.count), turning / auto_turn_per_point);
    }
    const double clamped =
        std::clamp(std::ceil(wanted), static_cast<double>(auto_points_min), static_cast<double>(auto_points_max));
    co_return static_cast<uint32_t>(clamped);
}

Task<void> sample_curves(Pace& pace, StyleCurves& curves, uint32_t count) {
    const double length = total_length(curves, &StyleCurve::measure);
    for (StyleCurve& curve : curves) {
        const double share = std::round(count * (curve.measure.length / length));
        co_await sample_points(pace, curve, std::max(static_cast<uint32_t>(share), samples_min));
    }
}

Task<uint32_t> make_guides(Pace& pace, const StyleRequest& request, StyleCurves& curves) {
    uint32_t steps = 0;
    for (StyleCurve& curve : curves) {
        if (request.guide) continue;
        mark_caps(request.desc, &curve == &curves.front(), &curve == &curves.back(), curve);
        steps += co_await flow_guide(pace, request, curve);
        curve.guide_measure = co_await measure_curve(pace, curve.guide);
        co_await pace;
        if (!(curve.guide_measure.length > 0)) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the guide has no length");
    }
    co_return steps;
}

void share_points(StyleCurves& curves, uint32_t count, uint32_t patch, Memory* memory) {
    const auto curve_count = static_cast<uint32_t>(curves.size());
    if (count < 2 * curve_count) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.point_count is %u, too few for the %u curves of desc.style",
                      count, curve_count);
    }
    const uint32_t steps = count - curve_count;
    const double length = total_length(curves, &StyleCurve::guide_measure);
    std::pmr::vector<double> remainders(curve_count, memory);
    std::pmr::vector<uint32_t> by_remainder(curve_count, memory);
    uint32_t given = 0;
    for (uint32_t c = 0; c < curve_count; ++c) {
        const double share = steps * (curves[c].guide_measure.length / length);
        const double whole = std::floor(share);
        curves[c].steps = static_cast<uint32_t>(whole);
        remainders[c] = share - whole;
        by_remainder[c] = c;
        given += curves[c].steps;
    }
    std::sort(by_remainder.begin(), by_remainder.end(), [&](uint32_t a, uint32_t b) {
        return remainders[a] != remainders[b] ? remainders[a] > remainders[b] : a < b;
    });
    for (uint32_t k = 0; given < steps; ++k, ++given) ++curves[by_remainder[k % curve_count]].steps;
    uint32_t longest = 0, total = 0;
    for (StyleCurve& curve : curves) {
        curve.steps = std::max(curve.steps, 1U);
        longest = std::max(longest, curve.steps + 1);
        total += curve.steps + 1;
    }
    if (total > style_points_max) {
        throw Failure(FLG_ERROR_LIMIT, "desc.style's curves need %u points, two at least each; a style may have %u",
                      total, style_points_max);
    }
    if (longest <= 2 * patch + 1) {
        const char* whose = curve_count == 1 ? "style's" : "style's longest curve's";
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.patch is %u: its %u points must be fewer than the %s %u", patch,
                      2 * patch + 1, whose, longest);
    }
}

Task<void> frame_guides(Pace& pace, const StyleCurves& curves, CurveSet& guide) {
    const auto curve_count = static_cast<uint32_t>(curves.size());
    guide.allocate_curves(curve_count);
    guide.offsets()[0] = 0;
    for (uint32_t c = 0; c < curve_count; ++c) {
        guide.offsets()[c + 1] = guide.offsets()[c] + curves[c].steps + 1;
        guide.begin_curve(c, 0);
    }
    guide.allocate_columns(std::pmr::vector<CurveSet::ColumnLayout>(
        {{FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_TANGENT, 3}, {FLG_ATTRIBUTE_NORMAL, 3}}, pace.memory()));
    for (uint32_t c = 0; c < curve_count; ++c) {
        const size_t first = size_t{guide.offsets()[c]} * 3;
        const FrameColumns columns{guide.columns()[0].values.data() + first, guide.columns()[1].values.data() + first,
                                   guide.columns()[2].values.data() + first};
        const SamplingPlan plan{.curve = curves[c].guide, .measure = curves[c].guide_measure, .steps = curves[c].steps};
        const std::span<const ColumnPair> carried;
        co_await resample_curve(pace, plan, columns, carried, 0);
        co_await pace;
    }
}

}  // namespace flg
