// SPDX-License-Identifier: MIT
#include "splines/motion/motion_keys.h"

#include <Eigen/SVD>
#include <cmath>

#include "core/failure.h"
#include "splines/manifolds/rotation_manifold.h"

namespace flg {

namespace {

using Mat3 = Eigen::Matrix3d;

// Of the body's size, or of how far it is off: nearer to each other two poses are one.
constexpr double same_pose = 1e-12;
constexpr double largest_number = 1e100;
constexpr double min_gap = 1e-9;  // between two keys, of the whole motion: differences would drown in rounding

[[noreturn]] void refuse(size_t key, const char* what) {
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "keys[%zu] %s", key, what);
}

}  // namespace

MotionKeys::MotionKeys(const MotionKeyInput& input, const BodyInertia& body, Memory* memory)
    : input_(input),
      body_(body),
      times_(input.times.size() + (input.closed ? 1 : 0), memory),
      barycentres_(3 * input.times.size(), memory),
      rotations_(9 * input.times.size(), memory) {}

Task<MotionKeys> check_keys(Pace& pace, MotionKeyInput input, BodyInertia body) {
    if (input.times.size() < 2) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "keys: there is %s, a motion needs two at least",
                      input.times.empty() ? "none" : "one");
    }
    MotionKeys keys(input, body, pace.memory());
    co_await each(pace, keys.count(), Cost::microseconds, [&keys](uint32_t key) { keys.check(key); });
    co_return keys;
}

void MotionKeys::check(size_t key) {
    const double time = input_.times[key];
    if (!(std::abs(time) <= largest_number)) refuse(key, "has a time that is not finite");
    if (key > 0 && !(time > times_[key - 1])) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "keys[%zu] has the time %.9g after %.9g; times must rise", key, time,
                      times_[key - 1]);
    }
    const double span = input_.times.back() - input_.times.front();
    if (key > 0 && time - times_[key - 1] <= min_gap * span) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "keys[%zu] has the time %.9g, too soon after %.9g for a motion of %.3g s", key, time,
                      times_[key - 1], span);
    }
    times_[key] = time;
    const double* const p = &input_.poses[pose_size * key];
    for (size_t i = 0; i < pose_size; ++i) {
        if (!(std::abs(p[i]) <= largest_number)) refuse(key, "has a pose with a number that is not finite");
    }
    Mat3 map;
    map << p[0], p[1], p[2], p[4], p[5], p[6], p[8], p[9], p[10];
    const Vec3 singular = Eigen::JacobiSVD<Mat3>(map).singularValues();
    const double stretch = std::max(std::abs(singular[0] - 1), std::abs(singular[2] - 1));
    if (!(stretch <= max_stretch)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "keys[%zu] has a pose that stretches by %.6g to %.6g; a rigid body's are 1 within 0.001", key,
                      singular[2], singular[0]);
    }
    if (map.determinant() < 0) refuse(key, "has a pose that is a reflection: its determinant is negative");
    greatest_stretch_ = std::max(greatest_stretch_, stretch);
    Mat3 rotation;
    nearest_rotation(map, Mat3::Identity(), rotation);
    Eigen::Map<Mat3>(rotations_.data() + 9 * key) = rotation * body_.axes;
    Eigen::Map<Vec3>(barycentres_.data() + 3 * key) = rotation * body_.barycentre + Vec3(p[3], p[7], p[11]);

    const bool last = key + 1 == input_.times.size();
    if (last && input_.closed) {
        if (!(input_.end_time > time && input_.end_time <= largest_number)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "end_time is %.9g: a closed motion comes back to its first key after the last one's %.9g",
                          input_.end_time, time);
        }
        times_[key + 1] = input_.end_time;
    }
    const auto check_differs = [&](size_t from, size_t to) {
        const Vec3 a = Eigen::Map<const Vec3>(&barycentres_[3 * from]),
                   b = Eigen::Map<const Vec3>(&barycentres_[3 * to]);
        const double far = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
        const Mat3 turn = Eigen::Map<const Mat3>(&rotations_[9 * from]) - Eigen::Map<const Mat3>(&rotations_[9 * to]);
        if ((a - b).norm() > same_pose * far || turn.norm() > same_pose) return;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "keys[%zu] has the pose of keys[%zu], the one before it", to, from);
    };
    if (key > 0) check_differs(key - 1, key);
    if (last && input_.closed) check_differs(key, 0);
}

Mat3 MotionKeys::rotation(size_t key) const {
    return Eigen::Map<const Mat3>(&rotations_[9 * key]);
}

void pose_of(const BodyInertia& body, const Vec3& barycentre, const Mat3& rotation, double* pose) {
    const Mat3 map = rotation * body.axes.transpose();
    const Vec3 shift = barycentre - map * body.barycentre;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) pose[4 * i + j] = map(i, j);
        pose[4 * i + 3] = shift[i];
    }
}

Mat3 rotation_between(const Mat3& from, const Mat3& to, double share) {
    const Eigen::Quaterniond a(from), b(to);
    return a.slerp(share, b).normalized().toRotationMatrix();
}

}  // namespace flg
