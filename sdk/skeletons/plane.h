// SPDX-License-Identifier: MIT
// Measures in the plane of a drawing.
#pragma once

#include <algorithm>
#include <cmath>

#include "skeletons/point2.h"

namespace flg {

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
