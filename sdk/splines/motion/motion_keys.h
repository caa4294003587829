// SPDX-License-Identifier: MIT
// Keyframes of a rigid body, checked and split: the path of its barycentre, and its rotation (Hofer, Pottmann 2004,
// sec. 4.2: the two do not know of each other).
//
// A pose is three rows of four numbers, (A | a): points p of the body are at A p + a. In body coordinates
// (body_inertia.h) it is the barycentre's place A s + a and the rotation A times the principal axes.
//
// Refused: numbers that are not finite; times that do not rise by 1e-9 of the whole motion; reflections; stretches by
// more than 1e-3; two keys in a row with one pose, which no energy can tell from a body at rest; fewer than two keys.
// Smaller stretches are taken off: the nearest rotation stands for A, and the greatest one is told.
#pragma once

#include <span>

#include "runtime/each.h"
#include "splines/motion/body_inertia.h"

namespace flg {

// Arrays live as long as the keys.
struct MotionKeyInput {
    std::span<const double> times;  // seconds
    std::span<const double> poses;  // 12 a key
    bool closed = false;            // after the last key the motion comes back to the first
    double end_time = 0;            // of closed motions: when, after the last key
};

class MotionKeys {
public:
    static constexpr size_t pose_size = 12;
    static constexpr double max_stretch = 1e-3;  // by how much a singular value may be off 1

    size_t count() const { return input_.times.size(); }
    // One a key, and of closed motions the end.
    std::span<const double> times() const { return {times_.data(), times_.size()}; }
    std::span<const double> barycentres() const { return {barycentres_.data(), barycentres_.size()}; }  // 3 a key
    Eigen::Matrix3d rotation(size_t key) const;  // of the principal axes
    double greatest_stretch() const { return greatest_stretch_; }

private:
    friend Task<MotionKeys> check_keys(Pace& pace, MotionKeyInput input, BodyInertia body);
    MotionKeys(const MotionKeyInput& input, const BodyInertia& body, Memory* memory);
    void check(size_t key);

    MotionKeyInput input_;
    BodyInertia body_;
    Buffer<double> times_, barycentres_, rotations_;
    double greatest_stretch_ = 0;
};

// About 1 us a key. Throws a Failure that names the key.
Task<MotionKeys> check_keys(Pace& pace, MotionKeyInput input, BodyInertia body);

// The pose that a barycentre's place and a rotation of the principal axes mean, 12 numbers.
void pose_of(const BodyInertia& body, const Vec3& barycentre, const Eigen::Matrix3d& rotation, double* pose);

// On the shorter way at constant speed; `share` 0 to 1. Where both ways are half a turn, one of them.
Eigen::Matrix3d rotation_between(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to, double share);

}  // namespace flg
