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

// Chebyshev's third-order form of Newton's method on the arc length itself. Speeds of one segment differ by a factor of
// two at most, so it converges from anywhere near; a step as short as `last_step` leaves less than 1e-5 of the segment,
// and on all but the sharpest turns the first one is. Squared speeds are a polynomial of degree 4.
double Segment::newton_parameter(double s, double t) const {
    constexpr int max_steps = 3;
    constexpr double last_step = 3e-3;
    const double m = b_->magnitudes[j_];
    const Vec3 u = direction(), from = m * tangent_start(), to = m * tangent_end();
    // derivative(t) = from + t * (b + t * c)
    const Vec3 b = 6.0 * u - 4.0 * from - 2.0 * to;
    const Vec3 c = 3.0 * (from + to) - 6.0 * u;
    const double c0 = m * m, c1 = 2.0 * from.dot(b), c2 = b.squaredNorm() + 2.0 * from.dot(c), c3 = 2.0 * b.dot(c),
                 c4 = c.squaredNorm();
    const auto speed_sq = [&](double x) { return c0 + x * (c1 + x * (c2 + x * (c3 + x * c4))); };
    const auto speed = [&](double x) { return std::sqrt(speed_sq(x)); };
    const double target = s / b_->chords[j_];
    for (int step = 0; step < max_steps; ++step) {
        t = std::clamp(t, 0.0, 1.0);
        const double low = speed(t * (0.5 - gauss_offset)), middle = speed(t * 0.5),
                     high = speed(t * (0.5 + gauss_offset));
        const double reached = t * (5.0 * (low + high) + 8.0 * middle) / 18.0;
        const double here_sq = speed_sq(t);
        const double newton = (target - reached) / std::sqrt(here_sq);
        const double speed_sq_slope = c1 + t * (2.0 * c2 + t * (3.0 * c3 + t * 4.0 * c4));
        t += newton * (1.0 - newton * speed_sq_slope / (4.0 * here_sq));
        if (std::abs(newton) <= last_step) break;
    }
    return t;
}

}  // namespace flg
