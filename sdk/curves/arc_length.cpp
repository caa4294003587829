// SPDX-License-Identifier: MIT
#include "curves/arc_length.h"

#include <algorithm>
#include <limits>

namespace flg {

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

ArcLengthKernel::ArcLengthKernel(const CurveView& curve) : stream_(curve), first_(curve.point(0)) {
    measure_.extent = first_.cwiseAbs().maxCoeff();
}

bool ArcLengthKernel::run(uint32_t n) {
    while (n-- > 0 && !stream_.done()) {
        if (stream_.advance()) add(stream_.segment());
    }
    if (!stream_.done()) return false;
    if (measure_.length > 0) measure_.mean = moment_ / measure_.length;
    return true;
}

void ArcLengthKernel::add(const Segment& segment) {
    if (measure_.length == 0) measure_.tangent = segment.tangent_start();
    measure_.length += segment.length();
    const Vec3 deviation = segment.end() - first_;
    moment_ += (0.5 * segment.length()) * (segment.start() - first_ + deviation);
    measure_.extent = std::max(measure_.extent, segment.end().cwiseAbs().maxCoeff());
    const Vec3 across = deviation - deviation.dot(measure_.tangent) * measure_.tangent;
    const double across_sq = across.squaredNorm();
    // Of deviations that are equal but for rounding the first counts, however the curve is turned.
    constexpr double clearly = 1.0 + 1e-6;
    if (across_sq > farthest_sq_ * clearly) {
        farthest_sq_ = across_sq;
        measure_.farthest = across;
    }
}

}  // namespace flg
