// SPDX-License-Identifier: MIT
// Points of drawings, and on which side of a line they are: the sign is exact, whatever the rounding.
#pragma once

namespace flg {

struct Point2 {
    double x, y;
    bool operator==(const Point2&) const = default;
};

// 1 if a, b, c turn left, -1 if right, 0 if they are on one line. Coordinates from 1e-150 to 1e150, or 0. Mostly a few
// nanoseconds; about 50 where rounding could hide the sign.
int orientation(const Point2& a, const Point2& b, const Point2& c);

}  // namespace flg
