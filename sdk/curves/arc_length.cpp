// SPDX-License-Identifier: MIT
#include "curves/arc_length.h"

#include <algorithm>
#include <array>
#include <limits>

#include "curves/step_scale.h"
#include "runtime/pace.h"

namespace flg {

namespace {

constexpr uint32_t points_at_once = 400;  // about 10 us

struct CurveMeasuring {
    explicit CurveMeasuring(const CurveView& curve) : stream(curve), first(curve.point(0)) {
        measure.extent = first.cwiseAbs().maxCoeff();
    }
    // About `points` points; true at the end.
    bool run(uint32_t points) {
        while (points > 0 && !stream.done()) {
            const SegmentStream::Range range = stream.take();
            points -= std::min(points, range.last - range.first + 1);
            if (range.first < range.last) add(stream.block(), range);
        }
        if (!stream.done()) return false;
        if (measure.length > 0) measure.mean = Vec3(moment[0], moment[1], moment[2]) / measure.length;
        return true;
    }
    void add(const SegmentBlock& block, SegmentStream::Range range) {
        if (measure.length == 0) measure.tangent = block.tangents_start[range.first];
        SegmentBlock::Deviations deviations;
        block.deviate(range.first, range.last, first, measure.tangent, deviations);
        double length = measure.length;
        std::array<double, 3> sum = moment;
        for (uint32_t j = range.first; j < range.last; ++j) {
            length += block.lengths[j];
            for (size_t c = 0; c < 3; ++c) sum[c] += 0.5 * deviations.moments[c][j];
            // Of deviations that are equal but for rounding the first counts, however the curve is turned.
            constexpr double clearly = 1.0 + 1e-6;
            if (deviations.across_sq[j] > farthest_sq * clearly) {
                farthest_sq = deviations.across_sq[j];
                const Vec3 deviation = block.points[j + 1] - first;
                measure.farthest = deviation - deviation.dot(measure.tangent) * measure.tangent;
            }
        }
        measure.length = length;
        moment = sum;
        measure.extent = std::max(measure.extent, double{deviations.largest});
    }

    SegmentStream stream;
    CurveMeasure measure;
    Vec3 first;
    std::array<double, 3> moment{};
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
    for (SegmentStream stream(curve); !stream.done();) {
        const SegmentStream::Range range = stream.take();
        for (uint32_t j = range.first; j < range.last; ++j) {
            length += step_scale(curve, scales, stream.index_of(j)).steps(stream.block().lengths[j]);
        }
        co_await pace;
    }
    co_return length;
}

}  // namespace flg
