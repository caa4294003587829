// SPDX-License-Identifier: MIT
#include "curves/arc_length.h"

#include <algorithm>
#include <limits>

#include "curves/even_sampler.h"
#include "runtime/pace.h"

namespace flg {

namespace {

constexpr uint32_t points_at_once = 400;  // about 10 us

struct CurveMeasuring {
    explicit CurveMeasuring(const CurveView& curve) : stream(curve), first(curve.point(0)) {
        measure.extent = first.cwiseAbs().maxCoeff();
    }
    // Up to `points` points; true at the end.
    bool run(uint32_t points) {
        for (; points > 0 && !stream.done(); --points)
            if (stream.advance()) add(stream.segment());
        if (!stream.done()) return false;
        if (measure.length > 0) measure.mean = moment / measure.length;
        return true;
    }
    void add(const Segment& segment) {
        if (measure.length == 0) measure.tangent = segment.tangent_start();
        measure.length += segment.length();
        const Vec3 deviation = segment.end() - first;
        moment += (0.5 * segment.length()) * (segment.start() - first + deviation);
        measure.extent = std::max(measure.extent, segment.end().cwiseAbs().maxCoeff());
        const Vec3 across = deviation - deviation.dot(measure.tangent) * measure.tangent;
        const double across_sq = across.squaredNorm();
        // Of deviations that are equal but for rounding the first counts, however the curve is turned.
        constexpr double clearly = 1.0 + 1e-6;
        if (across_sq > farthest_sq * clearly) {
            farthest_sq = across_sq;
            measure.farthest = across;
        }
    }

    SegmentStream stream;
    CurveMeasure measure;
    Vec3 first;
    Vec3 moment = Vec3::Zero();
    double farthest_sq = 0;
};

}  // namespace

double CurveMeasure::resolution() const {
    constexpr double float_steps = 4.0;
    return float_steps * std::numeric_limits<float>::epsilon() * extent;
}

Vec3 CurveMeasure::initial_normal() const {
    // A mean this much smaller than the farthest deviation is one that cancels out, as in an S.
    constexpr double cancelled = 1e-3;
    // Deviations below this part of the length are none.
    constexpr double straight = 1e-6;
    const double deviation = farthest.norm();
    if (deviation > std::max(straight * length, resolution())) {
        const Vec3 across = mean - mean.dot(tangent) * tangent;
        Vec3 normal = across.norm() > cancelled * deviation ? across : farthest;
        normal.normalize();
        normal -= normal.dot(tangent) * tangent;
        return normal.normalized();
    }
    int axis = 0;
    tangent.cwiseAbs().minCoeff(&axis);
    const Vec3 unit = Vec3::Unit(axis);
    return (unit - tangent[axis] * tangent).normalized();
}

double even_step_count(double length, double spacing, bool closed) {
    if (length <= 0) return 0;
    const double most = 0x1.0p53;
    return std::clamp(std::floor(length / spacing + 0.5), closed ? 3.0 : 1.0, most);
}

double exact_step_count(double length, double step) {
    const double steps = std::min(std::floor(length / step), 0x1.0p53);
    if (steps * step > length) return steps - 1;
    return (steps + 1) * step <= length ? steps + 1 : steps;
}

Task<CurveMeasure> measure_curve(Pace& pace, CurveView curve) {
    CurveMeasuring measuring(curve);
    while (!measuring.run(points_at_once)) co_await pace;
    co_return measuring.measure;
}

Task<double> measure_steps(Pace& pace, CurveView curve, const float* scales) {
    double length = 0;
    uint32_t points = 0;
    for (SegmentStream stream(curve); !stream.done();) {
        if (stream.advance()) length += step_scale(curve, scales, stream.index()).steps(stream.segment().length());
        if (++points % points_at_once == 0) co_await pace;
    }
    co_return length;
}

}  // namespace flg
