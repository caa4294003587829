// SPDX-License-Identifier: MIT
#include "stylization/guide_flow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/each.h"
#include "stylization/smooth_style_curve.h"
#include "stylization/style_waves.h"

namespace flg {

namespace {

// The flow ends when waves have been damped by exp(-this (1 - w)), w being 1/2 for even waves with alpha = 1/2.
constexpr double damping = 16.0;
// Straight lines through so many waves at the ends say where the guide ends.
constexpr double end_waves = 1.5;
constexpr uint32_t min_end_points = 4;
constexpr double rounding = 1e-9;
// Points of the flow that each of the longest waves has; those of the style, where these are fewer.
constexpr double points_per_wave = 24.0;
constexpr size_t min_flow_points = 96;
// Agreement asked of the diffusivity at the critical curvature; it is a margin, not a result.
constexpr double limit_tolerance = 0.01;
constexpr uint32_t max_limit_passes = 8;
constexpr double min_elasticity = 0.1;
// |t_i - t_(i-1)|, the Steiner curvature of a corner expanded by a line segment times the spacing, is at most this.
constexpr double max_bend = 2.0;

// Steps of a pass take about 10 ns: this makes slices of 20 us, and most passes one slice.
constexpr Cost pass_cost = Cost::some_ns;

// The curve as it flows.
struct Flow {
    Flow(size_t count, Memory* memory)
        : points(count, memory), other(count, memory), bend(count, memory), factor(count, memory) {}
    uint32_t segments() const { return static_cast<uint32_t>(points.size()) - 1; }

    std::pmr::vector<Vec3> points;  // within a step, after the solve, the moved, not yet respaced ones
    std::pmr::vector<Vec3> other;   // right-hand side of the solve, then the respaced points
    Buffer<double> bend;            // kappa * spacing, of the point that a segment begins at
    Buffer<double> factor;          // of the tridiagonal solve, then the arc length from a point to the end
    double time = 0.0;
    double length = 0.0;
    double sum_bend_sq = 0.0;
    double critical_bend = max_bend;  // kappa_c * spacing
    uint32_t steps = 0;
};

// As many points as `to` has, even in those of `from`.
Task<void> sample(Pace& pace, std::span<const Vec3> from, std::pmr::vector<Vec3>& to) {
    const auto last = static_cast<uint32_t>(from.size()) - 1;
    const double step = static_cast<double>(last) / static_cast<double>(to.size() - 1);
    co_await each(pace, to.size() - 1, Cost::some_ns, [=, out = to.data()](uint32_t k) {
        const double along = step * k;
        const uint32_t i = std::min(static_cast<uint32_t>(along), last - 1);
        out[k] = from[i] + (along - i) * (from[i + 1] - from[i]);
    });
    to.back() = from[last];
}

// Length and curvatures of the evenly spaced curve.
Task<void> measure(Pace& pace, Flow& flow) {
    flow.length = 0.0;
    flow.sum_bend_sq = 0.0;
    Vec3 before = Vec3::Zero();
    co_await each(pace, flow.segments(), pass_cost,
                  [&flow, &before, points = flow.points.data(), bend = flow.bend.data()](uint32_t i) {
                      const Vec3 step = points[i + 1] - points[i];
                      const double step_length = step.norm();
                      const Vec3 tangent = step_length > 0.0 ? Vec3(step / step_length) : Vec3(Vec3::Zero());
                      const double bend_sq = i > 0 ? (tangent - before).squaredNorm() : 0.0;
                      bend[i] = std::sqrt(bend_sq);
                      flow.sum_bend_sq += bend_sq;
                      flow.length += step_length;
                      before = tangent;
                  });
}

Task<void> begin(Pace& pace, std::span<const Vec3> style, Flow& flow) {
    co_await sample(pace, style, flow.points);
    flow.time = 0.0;
    flow.critical_bend = max_bend;
    co_await measure(pace, flow);
}

struct ForceSums {
    double force = 0.0;  // of kappa psi
    double slope = 0.0;  // of its derivative by kappa_c
};

ForceSums add_forces(ForceSums sums, double critical_bend, const double* bends, uint32_t first, uint32_t last) {
    for (uint32_t i = first; i < last; ++i) {
        const double bend = bends[i];
        const double capped = std::min(bend, critical_bend);
        sums.force += bend * capped * (2.0 * bend - capped);
        sums.slope += 2.0 * bend * (bend - capped);
    }
    return sums;
}

// F / spacing. Finds the critical curvature kappa_c with 2 alpha F kappa_c = (1 + alpha) / 2, by Newton's method on the
// logarithms; F belongs to the kappa_c it was summed with, so the length law holds whether or not that has converged.
Task<double> find_force(Pace& pace, Flow& flow, double alpha) {
    Slice slice(Cost::some_ns);
    for (uint32_t passes = 1;; ++passes) {
        ForceSums sums;
        for (Portion part(slice, 0, flow.segments()); part.next();) {
            sums = add_forces(sums, flow.critical_bend, flow.bend.data(), part.begin, part.end);
            if (part.is_over()) co_await pace;
        }
        const double elasticity = std::max(1.0 - flow.critical_bend * sums.slope / sums.force, min_elasticity);
        const double force = flow.sum_bend_sq / sums.force;
        const double wanted = 0.5 * (1.0 + alpha);
        const double ratio = wanted / (2.0 * alpha * force * flow.critical_bend);
        const bool met =
            ratio > 1.0 - limit_tolerance && (ratio < 1.0 + limit_tolerance || flow.critical_bend == max_bend);
        if (met || passes == max_limit_passes) co_return force;
        flow.critical_bend = std::min(flow.critical_bend * std::pow(ratio, 1.0 / elasticity), max_bend);
    }
}

// Solves (I - step (1 - w) d_ss) x' = x, `ratio` being the step by the squared spacing. First and last point stay.
Task<void> move_points(Pace& pace, Flow& flow, double ratio, double force) {
    const uint32_t last = flow.segments();
    Vec3* const points = flow.points.data();
    Vec3* const other = flow.other.data();
    double* const factor = flow.factor.data();
    other[0] = points[0];
    factor[0] = 0.0;
    const auto eliminate = [=, bends = flow.bend.data(), critical_bend = flow.critical_bend](uint32_t i) {
        const double bend = bends[i];
        const double capped = std::min(bend, critical_bend);
        const double held = capped < bend ? force * capped * (2.0 - capped / bend) : force * bend;  // w
        const double weight = ratio * std::max(1.0 - held, 0.0);
        const double scale = 1.0 / (1.0 + weight * (2.0 - factor[i - 1]));
        factor[i] = weight * scale;
        other[i] = (points[i] + weight * other[i - 1]) * scale;
    };
    co_await each(pace, 1, last, pass_cost, eliminate);
    factor[last] = 0.0;
    const auto substitute = [=](uint32_t k) {
        const uint32_t i = last - 1 - k;
        if (i > 0) points[i] = other[i] + factor[i] * points[i + 1];
        factor[i] = factor[i + 1] + (points[i + 1] - points[i]).norm();
    };
    co_await each(pace, last, pass_cost, substitute);
}

// The arc lengths from the points to the end, in factor.
Task<void> measure_rests(Pace& pace, Flow& flow) {
    const uint32_t last = flow.segments();
    flow.factor[last] = 0.0;
    co_await each(pace, last, pass_cost, [last, points = flow.points.data(), rests = flow.factor.data()](uint32_t k) {
        const uint32_t i = last - 1 - k;
        rests[i] = rests[i + 1] + (points[i + 1] - points[i]).norm();
    });
}

// Spaces the points evenly along their polygon.
Task<void> respace(Pace& pace, Flow& flow) {
    const uint32_t last = flow.segments();
    uint32_t segment = 0;
    flow.other[0] = flow.points[0];
    flow.other[last] = flow.points[last];
    const auto place = [&segment, last, spacing = flow.factor[0] / last, points = flow.points.data(),
                        rests = flow.factor.data(), out = flow.other.data()](uint32_t k) {
        const uint32_t i = k + 1;
        const double rest = spacing * (last - i);
        const uint32_t before = segment;
        uint32_t at = before;
        while (at + 1 < last && rests[at + 1] > rest) ++at;
        const double length = rests[at] - rests[at + 1];
        const double t = length > 0.0 ? std::clamp((rests[at] - rest) / length, 0.0, 1.0) : 0.0;
        out[i] = points[at] + t * (points[at + 1] - points[at]);
        segment = at;
        return at - before + 1;
    };
    co_await each_by_work(pace, last - 1, pass_cost, place);
    std::swap(flow.points, flow.other);
}

// `end_time`: not to be passed; 0: none.
Task<void> step(Pace& pace, Flow& flow, const GuideFlowParams& params, double end_time) {
    const double spacing = flow.length / flow.segments();
    double step_time = params.growth * std::max(flow.time, spacing * spacing);
    if (end_time > 0.0) step_time = std::min(step_time, end_time - flow.time);
    double force = 0.0;
    if (params.alpha > 0.0 && flow.sum_bend_sq > 0.0) force = co_await find_force(pace, flow, params.alpha);
    co_await move_points(pace, flow, step_time / (spacing * spacing), params.alpha * force);
    co_await respace(pace, flow);
    flow.time = step_time == end_time - flow.time ? end_time : flow.time + step_time;  // arrives there exactly
    ++flow.steps;
    co_await measure(pace, flow);
}

// Straight lines through the points next to an end, by least squares, in its first and last points' numbers.
struct EndLine {
    void add(double along, double weight, const Vec3& point) {
        weights += weight;
        along_sum += weight * along;
        along_sq_sum += weight * along * along;
        points += weight * point;
        along_points += weight * along * point;
    }
    // Where the line is abreast of the tip, or where it ends if the tip is further out.
    Vec3 end(const Vec3& tip) const {
        const double determinant = weights * along_sq_sum - along_sum * along_sum;
        Vec3 start = (along_sq_sum * points - along_sum * along_points) / determinant;
        const Vec3 slope = (weights * along_points - along_sum * points) / determinant;
        const double slope_sq = slope.squaredNorm();
        if (!(slope_sq > 0.0)) return start;
        return start + std::max(slope.dot(tip - start), 0.0) / slope_sq * slope;
    }

    double weights = 0.0, along_sum = 0.0, along_sq_sum = 0.0;
    Vec3 points = Vec3::Zero(), along_points = Vec3::Zero();
};

// Of the style's first point, or with `step` -1 of its last: where the middle line of the waves ends. Points count less
// the further they are from the end.
Task<Vec3> find_end(Pace& pace, std::span<const Vec3> style, int step, double reach) {
    const auto last = static_cast<uint32_t>(style.size()) - 1;
    const double points = std::clamp(reach * last, static_cast<double>(min_end_points), static_cast<double>(last + 1));
    const Vec3* const tip = step > 0 ? style.data() : style.data() + last;
    EndLine line;
    co_await each(pace, static_cast<size_t>(points), Cost::some_ns, [=, &line](uint32_t i) {
        const double part = i / points;
        const double near = 1.0 - part * part;
        line.add(i, near * near, tip[static_cast<ptrdiff_t>(i) * step]);
    });
    co_return line.end(*tip);
}

// The style between ends on the middle line of its waves, in place of its tips, spaced evenly.
Task<void> begin_between_ends(Pace& pace, std::span<const Vec3> style, double reach, Flow& flow) {
    const uint32_t last = flow.segments();
    co_await begin(pace, style, flow);
    if (style.size() < min_end_points) co_return;
    flow.points[0] = co_await find_end(pace, style, 1, reach);
    flow.points[last] = co_await find_end(pace, style, -1, reach);
    co_await measure_rests(pace, flow);
    co_await respace(pace, flow);
    co_await measure(pace, flow);
}

// Until the waves, shorter as the curve gets shorter, are damped.
Task<void> damp_waves(Pace& pace, double waves, Flow& flow, const GuideFlowParams& params) {
    for (double damped = 0.0; damped < damping && flow.length > 0.0;) {
        const double wave_number = 2.0 * std::numbers::pi * waves / flow.length;
        const double speed = wave_number * wave_number;
        const double begin_time = flow.time;
        co_await step(pace, flow, params, begin_time + (damping - damped) / speed);
        damped += speed * (flow.time - begin_time);
        if (damped > damping * (1.0 - rounding)) co_return;
    }
}

Task<void> flow_to(Pace& pace, double end_time, Flow& flow, const GuideFlowParams& params) {
    while (flow.time < end_time) co_await step(pace, flow, params, end_time);
}

// 2 G(t) - G(2 t), evenly spaced: what exp(-x) is for a bend becomes 1 - (1 - exp(-x))^2.
Task<void> give_bends_back(Pace& pace, Flow& flow, const GuideFlowParams& params) {
    const double time = flow.time;
    std::pmr::vector<Vec3> once(flow.points.size(), pace.memory());
    co_await sample(pace, flow.points, once);
    co_await flow_to(pace, 2.0 * time, flow, params);
    flow.time = time;
    co_await each(pace, 1, flow.segments(), pass_cost,
                  [from = once.data(), out = flow.points.data()](uint32_t i) { out[i] = 2.0 * from[i] - out[i]; });
    co_await measure_rests(pace, flow);
    co_await respace(pace, flow);
    co_await measure(pace, flow);
}

// As many points as `guide` has, on the smooth curve through the flow's.
Task<void> refine(Pace& pace, const Flow& flow, std::pmr::vector<Vec3>& guide) {
    const SmoothStyleCurve curve(flow.points.data(), flow.segments() + 1, flow.length);
    const double step = flow.length / static_cast<double>(guide.size() - 1);
    co_await each(pace, guide.size() - 1, Cost::tens_of_ns,
                  [=, out = guide.data()](uint32_t i) { out[i] = curve.evaluate(step * i).position; });
    guide.back() = flow.points.back();
}

// Points that the flow of a style needs.
size_t flow_points(double waves, size_t style_points) {
    const double wanted = std::ceil(points_per_wave * waves);
    return std::min(std::max(static_cast<size_t>(wanted), min_flow_points), style_points);
}

}  // namespace

Task<FlowedGuide> guide_flow(Pace& pace, std::span<const Vec3> style, GuideFlowParams params) {
    FlowedGuide guide{std::pmr::vector<Vec3>(pace.memory())};
    const double waves = params.time > 0.0 || params.alpha == 1.0 ? 0.0 : co_await count_waves(pace, style);
    Flow flow(waves > 0.0 ? flow_points(waves, style.size()) : style.size(), pace.memory());
    if (waves == 0.0) {
        co_await begin(pace, style, flow);
        co_await flow_to(pace, params.time, flow, params);
    } else {
        co_await begin_between_ends(pace, style, end_waves / waves, flow);
        co_await damp_waves(pace, waves, flow, params);
        if (params.smoothing != 1.0) {
            const double end_time = params.smoothing * flow.time;
            co_await begin_between_ends(pace, style, end_waves * std::sqrt(params.smoothing) / waves, flow);
            co_await flow_to(pace, end_time, flow, params);
        }
        co_await give_bends_back(pace, flow, params);
    }
    guide.time = flow.time;
    guide.length = flow.length;
    guide.steps = flow.steps;
    if (flow.points.size() == style.size()) {
        guide.points = std::move(flow.points);
    } else {
        guide.points.resize(style.size());
        co_await refine(pace, flow, guide.points);
    }
    co_return guide;
}

}  // namespace flg
