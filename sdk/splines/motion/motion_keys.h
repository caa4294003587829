// SPDX-License-Identifier: MIT
// Keyframes of a rigid body, checked and split: the path of its barycentre, and its rotation (Hofer, Pottmann 2004,
// sec. 4.2: the two do not know of each other).
//
// A pose is three rows of four numbers, (A | a): points p of the body are at A p + a. In body coordinates
// (body_inertia.h) it is the barycentre's place A s + a and the rotation A times the principal axes.
//
// Two keys in a row with one pose are a pause: the body stands still from one to the other. Pauses cut a motion into
// runs, which do not know of each other.
//
// Times are given, or found from how far keys are from each other: the root mean square of the ways of the body's
// points, in straight lines.
//
// Refused: numbers that are not finite; times that do not rise by 1e-9 of the whole motion; reflections; stretches by
// more than 1e-3; times to be found between two keys with one pose; eases outside of 0 to 1; fewer than two keys.
// Smaller stretches are taken off: the nearest rotation stands for A, and the greatest one is told.
#pragma once

#include <span>
#include <vector>

#include "runtime/each.h"
#include "splines/motion/body_inertia.h"

namespace flg {

// How times of keys come about: in proportion to distances, or to their square roots.
enum class KeyTiming { given, distances, roots };

// Arrays live as long as the keys.
struct MotionKeyInput {
    std::span<const double> times;  // seconds; unless they are found
    std::span<const double> poses;  // 12 a key
    bool closed = false;            // after the last key the motion comes back to the first
    double end_time = 0;            // of closed motions whose times are given: when, after the last key
    KeyTiming timing = KeyTiming::given;
    double speed = 1;               // m/s: where times are found, all distances over their sum
    std::span<const double> eases;  // none, or two a key: by how much it is slower before it, and after it; 0 to 1
    bool turns = true;              // else all rotations are those of the world's axes
    bool pauses = true;             // else keys with one pose are two places to pass near
};

// Keys between two pauses, or of a whole motion.
struct MotionRun {
    uint32_t first, keys;  // at least 2; counted on beyond the last key where a closed motion goes on
    bool closed;           // without a pause, back to the first
    bool rests[2];         // stands still at its begin, its end
};

class MotionKeys {
public:
    static constexpr size_t pose_size = 12;
    static constexpr double max_stretch = 1e-3;  // by how much a singular value may be off 1

    size_t count() const { return rests_.size(); }
    // From key to key.
    uint32_t segments() const { return static_cast<uint32_t>(times_.size()) - 1; }
    // One a key, and of closed motions the end.
    std::span<const double> times() const { return {times_.data(), times_.size()}; }
    std::span<const double> barycentres() const { return {barycentres_.data(), barycentres_.size()}; }  // 3 a key
    Eigen::Matrix3d rotation(size_t key) const;  // of the principal axes
    double greatest_stretch() const { return greatest_stretch_; }
    // Of the segment after a key: whether it is a pause.
    bool rests(size_t segment) const { return rests_[segment] != 0; }
    std::span<const MotionRun> runs() const { return runs_; }

private:
    friend Task<MotionKeys> check_keys(Pace& pace, MotionKeyInput input, BodyInertia body);
    MotionKeys(const MotionKeyInput& input, const BodyInertia& body, Memory* memory);
    void check_pose(size_t key);
    void check_time(size_t key);
    void find_time(size_t key);
    void check_eases(size_t key) const;
    void compare(size_t segment);
    void add_run(uint32_t segment, uint32_t end, bool closed);

    size_t key_after(size_t segment) const { return segment + 1 == count() ? 0 : segment + 1; }

    MotionKeyInput input_;
    BodyInertia body_;
    Buffer<double> times_, barycentres_, rotations_;
    Buffer<uint8_t> rests_;
    std::pmr::vector<MotionRun> runs_;
    double way_ = 0, timed_way_ = 0;  // of all segments; the same, as their times count them
    double next_time_ = 0;            // while times are found
    double greatest_stretch_ = 0;
};

// About 1 us a key. Throws a Failure that names the key.
Task<MotionKeys> check_keys(Pace& pace, MotionKeyInput input, BodyInertia body);

// The pose that a barycentre's place and a rotation of the principal axes mean, 12 numbers.
void pose_of(const BodyInertia& body, const Vec3& barycentre, const Eigen::Matrix3d& rotation, double* pose);

// On the shorter way at constant speed; `share` 0 to 1. Where both ways are half a turn, one of them.
Eigen::Matrix3d rotation_between(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to, double share);

}  // namespace flg
