// SPDX-License-Identifier: MIT
#include "reference/literal_matching.h"

#include <algorithm>
#include <limits>

namespace flg::reference {

namespace {

struct Sample {
    Vec3 position;
    Vec3 tangent;
};

// The uniform Catmull-Rom cubic, from Hermite's four basis functions.
Sample sample(const std::vector<Vec3>& points, double length, double s) {
    const size_t last = points.size() - 1;
    const double spacing = length / static_cast<double>(last);
    const size_t i = std::min(static_cast<size_t>(std::max(s, 0.0) / spacing), last - 1);
    const double t = s / spacing - static_cast<double>(i);
    const auto slope = [&](size_t k) -> Vec3 {
        if (k == 0) return 0.5 * (-3.0 * points[0] + 4.0 * points[1] - points[2]);
        if (k == last) return 0.5 * (3.0 * points[last] - 4.0 * points[last - 1] + points[last - 2]);
        return 0.5 * (points[k + 1] - points[k - 1]);
    };
    const Vec3 m0 = slope(i);
    const Vec3 m1 = slope(i + 1);
    const double t2 = t * t;
    const double t3 = t2 * t;
    Sample result;
    result.position =
        (2 * t3 - 3 * t2 + 1) * points[i] + (t3 - 2 * t2 + t) * m0 + (3 * t2 - 2 * t3) * points[i + 1] + (t3 - t2) * m1;
    const Vec3 derivative = (6 * t2 - 6 * t) * points[i] + (3 * t2 - 4 * t + 1) * m0 +
                            (6 * t - 6 * t2) * points[i + 1] + (3 * t2 - 2 * t) * m1;
    result.tangent = derivative / spacing;
    return result;
}

}  // namespace

LiteralMatching match_discrete(const std::vector<Vec3>& style, double style_length, const std::vector<Vec3>& guide,
                               double beta, bool strict) {
    const size_t rows = guide.size();
    const size_t columns = style.size();
    const double spacing = style_length / static_cast<double>(columns - 1);
    constexpr double impossible = std::numeric_limits<double>::infinity();
    std::vector<double> before(columns, 0.0);  // least energy with the row's place at this column
    std::vector<double> now(columns);
    std::vector<uint32_t> from(rows * columns, 0);
    std::fill(before.begin() + 1, before.end(), impossible);
    for (size_t i = 1; i + 1 < rows; ++i) {
        const Vec3 point = guide[i];
        const double even = style_length * static_cast<double>(i) / static_cast<double>(rows - 1);
        double least = impossible;
        uint32_t min_column = 0;
        uint32_t* const from_row = &from[i * columns];
        for (size_t j = 0; j < columns; ++j) {
            if (!strict && before[j] < least) {
                least = before[j];
                min_column = static_cast<uint32_t>(j);
            }
            const double late = static_cast<double>(j) * spacing - even;
            now[j] = least + beta * (point - style[j]).squaredNorm() + (1.0 - beta) * late * late;
            from_row[j] = min_column;
            if (strict && before[j] < least) {
                least = before[j];
                min_column = static_cast<uint32_t>(j);
            }
        }
        before.swap(now);
    }
    LiteralMatching result;
    result.delta.assign(rows, 0.0);
    result.delta[rows - 1] = style_length;
    const auto ends = strict ? before.end() - 1 : before.end();
    const auto best = std::min_element(before.begin(), ends);
    result.energy = *best;
    size_t column = static_cast<size_t>(best - before.begin());
    for (size_t i = rows - 2; i > 0; --i) {
        result.delta[i] = static_cast<double>(column) * spacing;
        column = from[i * columns + column];
    }
    return result;
}

LiteralMatching match_by_gradient(const std::vector<Vec3>& style, double style_length, const std::vector<Vec3>& guide,
                                  double beta, uint32_t steps) {
    const size_t count = guide.size();
    std::vector<double> even(count);
    for (size_t i = 0; i < count; ++i) even[i] = style_length * static_cast<double>(i) / static_cast<double>(count - 1);
    LiteralMatching result;
    result.delta = even;
    for (uint32_t step = 0; step < steps; ++step) {
        const std::vector<double> old = result.delta;
        for (size_t i = 1; i + 1 < count; ++i) {
            const Sample at = sample(style, style_length, old[i]);
            const double separation = -2.0 * (guide[i] - at.position).dot(at.tangent);
            const double distortion = 2.0 * (old[i] - even[i]);
            const double moved = old[i] - (beta * separation + (1.0 - beta) * distortion) / 2.0;
            // Half-way to the neighbours, so that none can be passed.
            result.delta[i] = std::clamp(moved, 0.5 * (old[i - 1] + old[i]), 0.5 * (old[i] + old[i + 1]));
        }
    }
    for (size_t i = 1; i + 1 < count; ++i) {
        const double late = result.delta[i] - even[i];
        result.energy += beta * (guide[i] - sample(style, style_length, result.delta[i]).position).squaredNorm() +
                         (1.0 - beta) * late * late;
    }
    return result;
}

}  // namespace flg::reference
