// SPDX-License-Identifier: MIT
// Cubics of the smooth curve through a polyline's points, with their arc lengths, a block at a time.
//
// The derivative's size at both ends is m = 2 chord / (1 + cos a), a being the angle between tangent and chord: with it
// a cubic follows a circular arc to fourth order (m = 4 R tan(turn / 4)); with tangents along the chord it is the
// chord's length, and the segment is straight and run through evenly. Arc length is Gauss-Legendre quadrature with
// three points; its inverse starts from the parabola through the three speeds, and is made exact by Newton steps only
// where the speed is uneven. The two end derivatives being equally long, their sum and difference are at right angles,
// and the three speeds follow from three dot products. A block is structure of arrays, so that compilers vectorize its
// making, and the roots and divisions of one segment do not wait for those of another. All in double: coordinates of
// 1e30 give squares of 1e60.
#pragma once

#include <cmath>

#include "core/vec.h"

namespace flg {

struct SegmentBlock {
    static constexpr uint32_t capacity = 32;
    static constexpr uint32_t size = capacity + 2;  // with a segment carried over, and one more point

    struct Vectors {
        double x[size], y[size], z[size];

        Vec3 operator[](size_t i) const { return Vec3(x[i], y[i], z[i]); }
        void set(size_t i, const Vec3& v) {
            x[i] = v.x();
            y[i] = v.y();
            z[i] = v.z();
        }
        void copy(size_t to, size_t from) {
            x[to] = x[from];
            y[to] = y[from];
            z[to] = z[from];
        }
    };

    // Set by the stream: segment j runs from points[j] to points[j + 1] along the unit directions[j] for chords[j].
    Vectors points, directions, tangents_start, tangents_end;
    double chords[size];
    // Set by measure().
    double lengths[size];
    double magnitudes[size];  // of the derivative at both ends, in units of the chord
    double speeds_low[size], speeds_middle[size], speeds_high[size];  // at the Gauss points, likewise

    void measure(uint32_t count);
};

// One of a block, valid as long as the block isn't refilled.
class Segment {
public:
    Segment(const SegmentBlock& block, uint32_t j) : b_(&block), j_(j) {}

    Vec3 start() const { return b_->points[j_]; }
    Vec3 end() const { return b_->points[j_ + 1]; }
    Vec3 tangent_start() const { return b_->tangents_start[j_]; }
    Vec3 tangent_end() const { return b_->tangents_end[j_]; }
    double length() const { return b_->lengths[j_]; }

    // At t in [0, 1].
    Vec3 position(double t) const {
        const double r = 1.0 - t;
        const double along = t * t * (3.0 - 2.0 * t);
        const double first = b_->magnitudes[j_] * (t * r * r);
        const double second = b_->magnitudes[j_] * (t * t * r);
        return start() + b_->chords[j_] * (along * direction() + (first * tangent_start() - second * tangent_end()));
    }
    // Unit.
    Vec3 tangent(double t) const {
        const Vec3 d = derivative(t);
        // In units of the chord nearly all derivatives are next to 1 long. A root and a division there would be half
        // the cost of a sample; the series is exact to 1e-13.
        constexpr double near_one = 1e-2;
        const double e = d.squaredNorm() - 1.0;
        if (std::abs(e) >= near_one) return d * (1.0 / std::sqrt(1.0 + e));
        return d * (1.0 + e * (-1.0 / 2 + e * (3.0 / 8 + e * (-5.0 / 16 + e * (35.0 / 128 + e * (-63.0 / 256))))));
    }
    // The t with arc length s from the start, s in [0, length()].
    double parameter_at(double s) const;

private:
    Vec3 direction() const { return b_->directions[j_]; }
    // In units of the chord.
    Vec3 derivative(double t) const {
        const double along = 6.0 * t * (1.0 - t);
        const double first = b_->magnitudes[j_] * (1.0 + t * (3.0 * t - 4.0));
        const double second = b_->magnitudes[j_] * (t * (3.0 * t - 2.0));
        return along * direction() + (first * tangent_start() + second * tangent_end());
    }
    double newton_parameter(double s, double t) const;

    const SegmentBlock* b_;
    uint32_t j_;
};

constexpr double gauss_offset = 0.3872983346207417;  // sqrt(15) / 10: of the outer Gauss points from the middle

inline double Segment::parameter_at(double s) const {
    constexpr double offset_sq = gauss_offset * gauss_offset;
    // How far the speed may vary before the parabola isn't good enough: errors stay below 1e-5 of the segment.
    constexpr double even_speed = 1e-3;
    const double low = b_->speeds_low[j_], middle = b_->speeds_middle[j_], high = b_->speeds_high[j_];
    const double slope = (high - low) * (0.5 / gauss_offset);
    const double bend = (high + low - 2.0 * middle) * (0.5 / offset_sq);
    double t = s / b_->lengths[j_];
    const double x = t - 0.5;
    const double x_sq = x * x;
    // What a Newton step takes away, with the mean speed, which is middle + bend / 12, in the place of the speed at t.
    // It is next to 1.
    t -= 0.5 * slope * (x_sq - 0.25) + bend * ((1.0 / 3.0) * (x_sq * x + 0.125) - (1.0 / 12.0) * t);
    if (std::abs(slope) + std::abs(bend) > even_speed) t = newton_parameter(s, t);
    return t < 0.0 ? 0.0 : (t > 1.0 ? 1.0 : t);
}

}  // namespace flg
