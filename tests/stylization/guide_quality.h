// SPDX-License-Identifier: MIT
// How right a guide is, from itself and its style alone, in parts of the style's displacement (root mean square).
#pragma once

#include <algorithm>
#include <cmath>

#include "runtime/run_now.h"
#include "stylization/guide_matching.h"
#include "stylization/test_curves.h"

namespace flg::test {

struct GuideQuality {
    double waves = 0.0;         // what still waves in the guide: its distance from parabolas over two waves
    double offset = 0.0;        // how far off the style's middle the guide lies: the mean displacement over three waves
    double displacement = 0.0;  // root mean square, metres
};

// What is left of values [first, first + count) beside the parabola through them, the mean square.
inline double rest_beside_parabola(const Curve& values, size_t first, size_t count) {
    // Orthogonal polynomials over even places.
    double line_sq = 0.0, bend_sq = 0.0, mean_sq = 0.0;
    Vec3 mean = Vec3::Zero(), line = Vec3::Zero(), bend = Vec3::Zero();
    const auto place = [&](size_t k) { return 2.0 * static_cast<double>(k) / static_cast<double>(count - 1) - 1.0; };
    for (size_t k = 0; k < count; ++k) mean_sq += place(k) * place(k) / static_cast<double>(count);
    for (size_t k = 0; k < count; ++k) {
        const double x = place(k), y = x * x - mean_sq;
        const Vec3& v = values[first + k];
        mean += v / static_cast<double>(count);
        line += x * v;
        bend += y * v;
        line_sq += x * x;
        bend_sq += y * y;
    }
    double rest = 0.0;
    for (size_t k = 0; k < count; ++k) {
        const double x = place(k);
        const Vec3 fit = mean + x / line_sq * line + (x * x - mean_sq) / bend_sq * bend;
        rest += (values[first + k] - fit).squaredNorm() / static_cast<double>(count);
    }
    return rest;
}

// `waves`: about how many the style has. Both curves have equally many points, evenly spaced.
inline GuideQuality guide_quality(const Curve& style, const Curve& guide, double waves) {
    constexpr double beta = 0.2, farthest_step = 1.4;  // those of a style
    const size_t count = style.size();
    const double length = polyline_length(style);
    const SmoothStyleCurve smooth(style.data(), static_cast<uint32_t>(count), length);
    const double step = farthest_step * length / static_cast<double>(count - 1);
    const GuideMatch match = run_now(std::pmr::new_delete_resource(),
                                     [&](Pace& pace) { return match_guide(pace, smooth, guide, beta, step); });
    Curve across(count);
    GuideQuality quality;
    for (size_t i = 0; i < count; ++i) {
        const Vec3 tangent = (guide[std::min(i + 1, count - 1)] - guide[i > 0 ? i - 1 : 0]).normalized();
        const Vec3 displacement = smooth.evaluate(match.places[i]).position - guide[i];
        quality.displacement += displacement.squaredNorm() / static_cast<double>(count);
        across[i] = displacement - tangent.dot(displacement) * tangent;
    }
    quality.displacement = std::sqrt(quality.displacement);
    const auto window = [&](double of_waves) {
        const double points = of_waves / waves * static_cast<double>(count);
        return std::clamp(static_cast<size_t>(points), size_t{5}, count);
    };
    double windows = 0.0;
    for (size_t size = window(2.0), first = 0; first + size <= count; first += std::max(size / 4, size_t{1})) {
        quality.waves += rest_beside_parabola(guide, first, size);
        windows += 1.0;
    }
    quality.waves = std::sqrt(quality.waves / windows) / quality.displacement;
    windows = 0.0;
    for (size_t size = window(3.0), first = 0; first + size <= count; first += std::max(size / 4, size_t{1})) {
        Vec3 mean = Vec3::Zero();
        double weights = 0.0;
        for (size_t k = 0; k < size; ++k) {
            const double s = std::sin(std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(size));
            mean += s * s * across[first + k];
            weights += s * s;
        }
        quality.offset += (mean / weights).squaredNorm();
        windows += 1.0;
    }
    quality.offset = std::sqrt(quality.offset / windows) / quality.displacement;
    return quality;
}

}  // namespace flg::test
