// SPDX-License-Identifier: MIT
#include "bones/wide_part.h"

#include <algorithm>
#include <cmath>

#include "runtime/each.h"

namespace flg {
namespace {

struct Nearest {
    double distance2 = 1e300;
    bool is_inside = false;
};

void look_at_edges(const Contour& outline, const Point2& at, uint32_t begin, uint32_t end, Nearest& nearest) {
    for (; begin < end; ++begin) {
        const Point2 &a = outline.points[begin], &b = outline.points[outline.next(begin)];
        const double x = b.x - a.x, y = b.y - a.y, length2 = x * x + y * y;
        const double share = length2 > 0 ? std::clamp(((at.x - a.x) * x + (at.y - a.y) * y) / length2, 0.0, 1.0) : 0;
        const double dx = at.x - a.x - share * x, dy = at.y - a.y - share * y;
        nearest.distance2 = std::min(nearest.distance2, dx * dx + dy * dy);
        if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / y * x) nearest.is_inside = !nearest.is_inside;
    }
}

}  // namespace

Task<double> depth_in(Pace& pace, const Contour& outline, Point2 at) {
    Nearest nearest;
    Slice slice(Cost::tens_of_ns);
    for (Portion part(slice, 0, outline.size()); part.next();) {
        look_at_edges(outline, at, part.begin, part.end, nearest);
        if (part.is_over()) co_await pace;
    }
    co_return nearest.is_inside ? std::sqrt(nearest.distance2) : -std::sqrt(nearest.distance2);
}

double height_over(double depth, double widest, double thickness) {
    const double within = std::clamp(depth, 0.0, widest);
    return thickness * std::sqrt(within * (2 * widest - within));
}

Task<bool> meets_ball(Pace& pace, const WidePart& part, Vec3 centre, double radius) {
    const Vec3 offset = (centre - part.placement.col(3)) / (part.scale * part.scale);
    const double height = std::abs(offset.dot(part.placement.col(2)));
    const double reach = radius / part.scale;
    if (height > reach + part.thickness * part.widest) co_return false;
    const Point2 at{offset.dot(part.placement.col(0)), offset.dot(part.placement.col(1))};
    const double depth = co_await depth_in(pace, *part.outline, at);
    co_return depth >= -reach&& height <= reach + height_over(depth, part.widest, part.thickness);
}

}  // namespace flg
