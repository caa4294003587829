// SPDX-License-Identifier: MIT
#include "curves/hermite_segment.h"

#include <algorithm>

namespace flg {

// Newton's method on the arc length itself. Speeds of one segment differ by a factor of two at most, so it converges
// from anywhere near; the steps are a fixed number, so the cost is too.
double HermiteSegment::newton_parameter(double s, double t) const {
    constexpr int steps = 3;
    for (int step = 0; step < steps; ++step) {
        t = std::clamp(t, 0.0, 1.0);
        const double low = derivative(t * (0.5 - gauss_offset)).norm();
        const double middle = derivative(t * 0.5).norm();
        const double high = derivative(t * (0.5 + gauss_offset)).norm();
        const double reached = t * (5.0 * (low + high) + 8.0 * middle) / 18.0;
        t -= (reached - s) / derivative(t).norm();
    }
    return t;
}

}  // namespace flg
