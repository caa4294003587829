// SPDX-License-Identifier: MIT
// A style as the continuous curve gamma_S(s) that the matching of sec. 4.2 slides along: the Catmull-Rom cubic through
// points that are even in arc length, so that a position along it is found in constant time. Its parameter is arc
// length up to the sampling's third order.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/vec.h"

namespace flg {

class SmoothStyleCurve {
public:
    // `points`: `count` >= 2 points at the arc lengths length * i / (count - 1), not copied. `length` > 0.
    SmoothStyleCurve(const Vec3* points, uint32_t count, double length)
        : points_(points),
          count_(count),
          length_(length),
          spacing_(length / (count - 1)),
          per_length_((count - 1) / length) {}

    const Vec3* points() const { return points_; }
    uint32_t count() const { return count_; }
    double length() const { return length_; }
    double spacing() const { return spacing_; }

    struct Jet {
        Vec3 position;
        Vec3 derivative;         // by arc length; about a unit vector
        Vec3 second_derivative;  // jumps at the points
    };

    // `s` in [0, length].
    Jet evaluate(double s) const {
        const double along = s * per_length_;
        const uint32_t i = std::min(static_cast<uint32_t>(std::max(along, 0.0)), count_ - 2);
        const double t = along - i;
        const Vec3& p0 = points_[i];
        const Vec3 chord = points_[i + 1] - p0;
        const Vec3 m0 = tangent(i);
        const Vec3 m1 = tangent(i + 1);
        const Vec3 c2 = 3.0 * chord - 2.0 * m0 - m1;
        const Vec3 c3 = m0 + m1 - 2.0 * chord;
        return {p0 + t * (m0 + t * (c2 + t * c3)), per_length_ * (m0 + t * (2.0 * c2 + (3.0 * t) * c3)),
                per_length_ * per_length_ * (2.0 * c2 + (6.0 * t) * c3)};
    }

    // The same at point i, with the second difference of the points for the second derivative.
    Jet at_point(uint32_t i) const {
        const uint32_t inner = std::clamp(i, 1U, std::max(count_, 3U) - 2);
        const Vec3 second = inner + 1 < count_ ? Vec3(points_[inner + 1] - 2.0 * points_[inner] + points_[inner - 1])
                                               : Vec3(Vec3::Zero());
        return {points_[i], per_length_ * tangent(i), per_length_ * per_length_ * second};
    }

private:
    // By parameter; parabolas end the curve.
    Vec3 tangent(uint32_t i) const {
        if (count_ == 2) return points_[1] - points_[0];
        if (i == 0) return 2.0 * points_[1] - 1.5 * points_[0] - 0.5 * points_[2];
        if (i == count_ - 1) return 1.5 * points_[i] - 2.0 * points_[i - 1] + 0.5 * points_[i - 2];
        return 0.5 * (points_[i + 1] - points_[i - 1]);
    }

    const Vec3* points_;
    uint32_t count_;
    double length_;
    double spacing_;
    double per_length_;
};

}  // namespace flg
