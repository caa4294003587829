// SPDX-License-Identifier: MIT
// Points of drawings, measures between them, and on which side of a line they are: the sign is exact, whatever the
// rounding.
#pragma once

#include <algorithm>
#include <cmath>

namespace flg {

struct Point2 {
    double x, y;
    bool operator==(const Point2&) const = default;
};

// 1 if a, b, c turn left, -1 if right, 0 if they are on one line. Coordinates from 1e-150 to 1e150, or 0. Mostly a few
// nanoseconds; about 50 where rounding could hide the sign.
int orientation(const Point2& a, const Point2& b, const Point2& c);

inline double distance(const Point2& a, const Point2& b) {
    return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

inline Point2 mix(const Point2& a, const Point2& b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

// Whether the stretches from a to b and from c to d have a point in common. Exact.
inline bool stretches_meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const int ab = orientation(a, b, c) * orientation(a, b, d), cd = orientation(c, d, a) * orientation(c, d, b);
    if (ab > 0 || cd > 0) return false;
    if (ab < 0 || cd < 0) return true;
    return std::max(std::min(a.x, b.x), std::min(c.x, d.x)) <= std::min(std::max(a.x, b.x), std::max(c.x, d.x)) &&
           std::max(std::min(a.y, b.y), std::min(c.y, d.y)) <= std::min(std::max(a.y, b.y), std::max(c.y, d.y));
}

}  // namespace flg
