// SPDX-License-Identifier: MIT
#include "reference/literal_bounded_dp.h"

#include <cmath>

namespace flg::reference {
namespace {

double perpendicular_distance(const Point2& p, const Point2& a, const Point2& b) {
    const double length = std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
    return std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
}

struct Shape {
    const std::vector<AxisSample>& samples;
    std::vector<double> along;  // the axis, stretched out
    double shape_weight;

    Point2 upper(size_t i) const { return {along[i], samples[i].left}; }
    Point2 lower(size_t i) const { return {along[i], -samples[i].right}; }
    double error(size_t i, size_t start, size_t end) const {
        const double axis = perpendicular_distance(samples[i].at, samples[start].at, samples[end].at);
        return axis + shape_weight * (perpendicular_distance(upper(i), upper(start), upper(end)) +
                                      perpendicular_distance(lower(i), lower(start), lower(end)));
    }
};

void select(const Shape& shape, size_t start, size_t end, double threshold, std::vector<bool>& kept) {
    if (end <= start + 1) return;
    size_t farthest = start;
    double most = 0;
    for (size_t i = start + 1; i < end; ++i) {
        const double error = shape.error(i, start, end);
        if (error > most) {
            farthest = i;
            most = error;
        }
    }
    if (most > threshold) {
        kept[farthest] = true;
        select(shape, start, farthest, threshold, kept);
        select(shape, farthest, end, threshold, kept);
    }
}

}  // namespace

std::vector<bool> bounded_dp(const std::vector<AxisSample>& samples, double threshold, double shape_weight,
                             const std::function<bool(size_t, size_t)>& is_inside) {
    Shape shape{samples, {0}, shape_weight};
    for (size_t i = 1; i < samples.size(); ++i) {
        const Point2 &a = samples[i - 1].at, &b = samples[i].at;
        shape.along.push_back(shape.along.back() + std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)));
    }
    for (int round = 0;; ++round, threshold *= 0.8) {
        std::vector<bool> kept(samples.size(), round >= 64);
        kept.front() = kept.back() = true;
        select(shape, 0, samples.size() - 1, threshold, kept);
        bool all_inside = true;
        for (size_t i = 1, before = 0; i < samples.size(); ++i) {
            if (!kept[i]) continue;
            all_inside = all_inside && (i == before + 1 || is_inside(before, i));
            before = i;
        }
        if (all_inside || round >= 64) return kept;
    }
}

}  // namespace flg::reference
