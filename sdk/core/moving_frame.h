// SPDX-License-Identifier: MIT
// Moving frames, carried from sample to sample.
//
// Double reflection (Wang, Juettler, Zheng, Liu: Computation of Rotation Minimizing Frames, 2008): fourth order, and
// needs the past only. The two reflections are put together into r' = r - a v1 - b v2, with both dot products of r
// taken at once, so that the chain from one normal to the next is short. Departure: where the step has no length or
// runs across the tangent (a corner, a reversal), the chord is replaced by the sum of the tangents, which gives the
// smallest rotation from one to the other; on an exact reversal the normal stays.
#pragma once

#include <cmath>

#include "core/vec.h"

namespace flg {

// The two reflections of a step, r' = r - a first - b second, without what the frame's normal has to do with it.
struct Reflections {
    Vec3 first, second;
    double first_factor = 0, second_factor = 0;  // 2 over their squared norms
    double both = 0;                             // second dot first
};

class RotationMinimizingFrame {
public:
    RotationMinimizingFrame() = default;
    // Unit tangent and unit normal, at right angles. `steps`: what an earlier frame has taken that this one continues.
    RotationMinimizingFrame(const Vec3& position, const Vec3& tangent, const Vec3& normal, uint32_t steps = 0)
        : position_(position), tangent_(tangent), normal_(normal), steps_(steps) {}

    const Vec3& position() const { return position_; }
    const Vec3& tangent() const { return tangent_; }
    const Vec3& normal() const { return normal_; }
    uint32_t steps() const { return steps_; }

    // Takes another normal for this place, such as a Frenet one.
    void set_normal(const Vec3& normal) { normal_ = normal; }

    void step(const Vec3& position, const Vec3& tangent) {
        Vec3 v1 = position - position_;
        double v1_sq = v1.squaredNorm();
        const double ahead = v1.dot(tangent_);
        Vec3 v2 = tangent - tangent_ + (v1_sq > 0 ? 2.0 * ahead / v1_sq : 0.0) * v1;
        double v2_sq = v2.squaredNorm();
        if (!(v1_sq > 0) || v2_sq < across_sq) {
            v1 = tangent + tangent_;
            v1_sq = v1.squaredNorm();
            if (v1_sq < reversal_sq) {
                turn_back(position, tangent);
                return;
            }
            v2 = 2.0 * tangent;
            v2_sq = 4.0;
        }
        step(position, tangent, {v1, v2, 2.0 / v1_sq, 2.0 / v2_sq, v2.dot(v1)});
    }
    // By reflections that were worked out before. The second one's vector must be no shorter than `across_sq` says.
    void step(const Vec3& position, const Vec3& tangent, const Reflections& by) {
        const double a = by.first_factor * by.first.dot(normal_);
        const double b = by.second_factor * (by.second.dot(normal_) - a * by.both);
        normal_ -= a * by.first + b * by.second;
        position_ = position;
        tangent_ = tangent;
        if (++steps_ % steps_between_repairs == 0) repair();
    }

    static constexpr double across_sq = 1e-4;  // of the second reflection's vector, which is 2 long on smooth curves

private:
    static constexpr double reversal_sq = 1e-16;           // of the sum of the tangents
    static constexpr uint32_t steps_between_repairs = 64;  // rounding errors grow with the steps, by 1e-16 each

    void turn_back(const Vec3& position, const Vec3& tangent) {
        position_ = position;
        tangent_ = tangent;
        repair();
    }
    void repair() {
        normal_ -= normal_.dot(tangent_) * tangent_;
        normal_.normalize();
    }

    Vec3 position_, tangent_, normal_;
    uint32_t steps_ = 0;
};

// The signed angle about unit `axis` that turns `from` into `to`, both across it; radians, -pi to pi.
inline double angle_about(const Vec3& axis, const Vec3& from, const Vec3& to) {
    return std::atan2(axis.dot(from.cross(to)), from.dot(to));
}

// `vector`, which is across unit `axis`, turned about it.
inline Vec3 turned_about(const Vec3& axis, const Vec3& vector, double angle_rad) {
    return std::cos(angle_rad) * vector + std::sin(angle_rad) * axis.cross(vector);
}

}  // namespace flg
