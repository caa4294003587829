// SPDX-License-Identifier: MIT
#include "curves/segment_block.h"

#include <algorithm>

namespace flg {

void SegmentBlock::measure(uint32_t count) {
    const Vectors& u = directions;
    const Vectors& a = tangents_start;
    const Vectors& b = tangents_end;
    for (uint32_t j = 0; j < count; ++j) {
        const double cosine_start = u.x[j] * a.x[j] + u.y[j] * a.y[j] + u.z[j] * a.z[j];
        const double cosine_end = u.x[j] * b.x[j] + u.y[j] * b.y[j] + u.z[j] * b.z[j];
        const double cosine_turn = a.x[j] * b.x[j] + a.y[j] * b.y[j] + a.z[j] * b.z[j];
        const double cosines = cosine_start + cosine_end;
        const double m = 4.0 / (2.0 + cosines);
        // With d the chord, g the sum and h the difference of the end derivatives, the derivative is
        // 0.6 d + 0.2 g -+ gauss_offset h at the outer points, and 1.5 d - 0.25 g in the middle.
        const double d_g = m * cosines;
        const double g_g = 2.0 * m * m * (1.0 + cosine_turn);
        const double h_h = 2.0 * m * m * (1.0 - cosine_turn);
        const double outer = 0.36 + 0.24 * d_g + 0.04 * g_g + 0.15 * h_h;
        const double skew = (2.0 * 0.6 * gauss_offset) * m * (cosine_end - cosine_start);
        const double low = std::sqrt(outer - skew);
        const double middle = std::sqrt(2.25 - 0.75 * d_g + 0.0625 * g_g);
        const double high = std::sqrt(outer + skew);
        magnitudes[j] = m;
        speeds_low[j] = low;
        speeds_middle[j] = middle;
        speeds_high[j] = high;
        lengths[j] = chords[j] * ((5.0 / 18.0) * (low + high) + (8.0 / 18.0) * middle);
    }
}

// Newton's method on the arc length itself. Speeds of one segment differ by a factor of two at most, so it converges
// from anywhere near; the steps are a fixed number, so the cost is too.
double Segment::newton_parameter(double s, double t) const {
    constexpr int steps = 3;
    const double target = s / b_->chords[j_];
    for (int step = 0; step < steps; ++step) {
        t = std::clamp(t, 0.0, 1.0);
        const double low = derivative(t * (0.5 - gauss_offset)).norm();
        const double middle = derivative(t * 0.5).norm();
        const double high = derivative(t * (0.5 + gauss_offset)).norm();
        const double reached = t * (5.0 * (low + high) + 8.0 * middle) / 18.0;
        t -= (reached - target) / derivative(t).norm();
    }
    return t;
}

}  // namespace flg
