// SPDX-License-Identifier: MIT
// One cubic of the smooth curve through a polyline's points, with its arc length.
//
// The tangent magnitude m = 2 chord / (1 + cos a), a being the angle between tangent and chord, is the one with which a
// cubic follows a circular arc to fourth order (m = 4 R tan(turn / 4)); with tangents along the chord it is the chord's
// length, and the segment is straight and run through evenly. Arc length is Gauss-Legendre quadrature with three points;
// its inverse starts from the parabola through the three speeds, and is made exact by Newton steps only where the speed
// is uneven.
// All in double: coordinates of 1e30 give squares of 1e60.
#pragma once

#include <cmath>

#include "core/vec.h"

namespace flg {

class HermiteSegment {
public:
    HermiteSegment() = default;
    // From `start`, `chord` long in the unit direction `direction` to `end`; unit tangents at both ends.
    HermiteSegment(const Vec3& start, const Vec3& end, const Vec3& direction, double chord, const Vec3& tangent_start,
                   const Vec3& tangent_end)
        : start_(start), end_(end) {
        const double cosine = 0.5 * (direction.dot(tangent_start) + direction.dot(tangent_end));
        const double magnitude = 2.0 * chord / (1.0 + cosine);
        const Vec3 d = chord * direction;
        const Vec3 m0 = magnitude * tangent_start;
        const Vec3 m1 = magnitude * tangent_end;
        c1_ = m0;
        c2_ = 3.0 * d - 2.0 * m0 - m1;
        c3_ = m0 + m1 - 2.0 * d;
        speed_low_ = derivative(0.5 - gauss_offset).norm();
        speed_middle_ = derivative(0.5).norm();
        speed_high_ = derivative(0.5 + gauss_offset).norm();
        length_ = (5.0 * (speed_low_ + speed_high_) + 8.0 * speed_middle_) / 18.0;
    }

    const Vec3& start() const { return start_; }
    const Vec3& end() const { return end_; }
    double length() const { return length_; }

    // At t in [0, 1].
    Vec3 position(double t) const { return start_ + t * (c1_ + t * (c2_ + t * c3_)); }
    Vec3 derivative(double t) const { return c1_ + t * (2.0 * c2_ + (3.0 * t) * c3_); }
    // The t with arc length s from the start, s in [0, length()].
    double parameter_at(double s) const;

private:
    static constexpr double gauss_offset = 0.3872983346207417;  // sqrt(15) / 10
    double newton_parameter(double s, double t) const;

    Vec3 start_, end_, c1_, c2_, c3_;
    double speed_low_ = 0, speed_middle_ = 0, speed_high_ = 0;  // at the Gauss points
    double length_ = 0;
};

inline double HermiteSegment::parameter_at(double s) const {
    constexpr double offset_sq = gauss_offset * gauss_offset;
    // How far the speed may vary before the parabola isn't good enough: errors stay below 1e-5 of the segment.
    constexpr double even_speed = 1e-3;
    const double slope = (speed_high_ - speed_low_) / (2.0 * gauss_offset);
    const double bend = (speed_high_ + speed_low_ - 2.0 * speed_middle_) / (2.0 * offset_sq);
    const double inverse_length = 1.0 / length_;
    double t = s * inverse_length;
    const double x = t - 0.5;
    const double x_sq = x * x;
    const double reached = speed_middle_ * t + 0.5 * slope * (x_sq - 0.25) + bend * (1.0 / 3.0) * (x_sq * x + 0.125);
    t -= (reached - s) * inverse_length;
    if (std::abs(slope) + std::abs(bend) > even_speed * length_) t = newton_parameter(s, t);
    return t < 0.0 ? 0.0 : (t > 1.0 ? 1.0 : t);
}

}  // namespace flg
