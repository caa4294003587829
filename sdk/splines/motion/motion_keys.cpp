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
      times_(input.poses.size() / pose_size + (input.closed ? 1 : 0), memory),
      barycentres_(input.poses.size() / pose_size * 3, memory),
      rotations_(input.poses.size() / pose_size * 9, memory),
      rests_(input.poses.size() / pose_size, memory),
      runs_(memory) {}

Task<MotionKeys> check_keys(Pace& pace, MotionKeyInput input, BodyInertia body) {
    const size_t count = input.poses.size() / MotionKeys::pose_size;
    if (count < 2) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "keys: there is %s, a motion needs two at least",
                      count == 0 ? "none" : "one");
    }
    MotionKeys keys(input, body, pace.memory());
    co_await each(pace, count, Cost::microseconds, [&keys](uint32_t key) {
        if (keys.input_.timing == KeyTiming::given) keys.check_time(key);
        keys.check_pose(key);
        keys.check_eases(key);
        keys.rests_[key] = 0;
    });
    co_await each(pace, keys.segments(), Cost::tens_of_ns, [&keys](uint32_t segment) { keys.compare(segment); });
    if (input.timing != KeyTiming::given)
        co_await each(pace, keys.times_.size(), Cost::tens_of_ns, [&keys](uint32_t key) { keys.find_time(key); });
    const uint32_t segments = keys.segments();
    uint32_t begin = 0, first_pause = segments;
    // A closed motion begins at a pause, if it has one: runs go on over its end.
    for (uint32_t i = 0; i < segments && input.closed && first_pause == segments; ++i) {
        if (keys.rests(i)) first_pause = i;
    }
    if (first_pause < segments) begin = first_pause + 1;
    uint32_t run = begin;
    co_await each(pace, segments, Cost::some_ns, [&, begin, segments](uint32_t i) {
        const uint32_t segment = begin + i;
        const bool last = i + 1 == segments, pause = keys.rests(segment % segments);
        if (!pause && !last) return;
        const uint32_t end = pause ? segment : segment + 1;
        if (end > run) keys.add_run(run, end, input.closed && first_pause == segments);
        run = segment + 1;
    });
    co_return keys;
}

// Of the segments from `segment` to `end`.
void MotionKeys::add_run(uint32_t segment, uint32_t end, bool closed) {
    MotionRun run{segment % segments(), end - segment + (closed ? 0 : 1), closed, {false, false}};
    run.rests[0] = !closed && (input_.closed || run.first > 0);
    run.rests[1] = !closed && (input_.closed || end < segments());
    runs_.push_back(run);
}

void MotionKeys::check_time(size_t key) {
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
    if (key + 1 < count() || !input_.closed) return;
    if (!(input_.end_time > time && input_.end_time <= largest_number)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "end_time is %.9g: a closed motion comes back to its first key after the last one's %.9g",
                      input_.end_time, time);
    }
    times_[key + 1] = input_.end_time;
}

void MotionKeys::check_eases(size_t key) const {
    if (input_.eases.empty()) return;
    for (size_t side = 0; side < 2; ++side) {
        const double ease = input_.eases[2 * key + side];
        if (ease >= 0 && ease <= 1) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "keys[%zu] has an ease %s of %.9g; they go from 0 to 1", key,
                      side == 0 ? "in" : "out", ease);
    }
}

void MotionKeys::check_pose(size_t key) {
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
    Eigen::Map<Vec3>(barycentres_.data() + 3 * key) = rotation * body_.barycentre + Vec3(p[3], p[7], p[11]);
    if (!input_.turns) rotation.setIdentity();
    Eigen::Map<Mat3>(rotations_.data() + 9 * key) = rotation * body_.axes;
}

// Whether the segment is a pause and, where times are found, how long its way is: its place in times_ is lent for that.
void MotionKeys::compare(size_t segment) {
    const size_t from = segment, to = key_after(segment);
    const Vec3 a = Eigen::Map<const Vec3>(&barycentres_[3 * from]), b = Eigen::Map<const Vec3>(&barycentres_[3 * to]);
    const double far = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
    const Mat3 turn = Eigen::Map<const Mat3>(&rotations_[9 * from]) - Eigen::Map<const Mat3>(&rotations_[9 * to]);
    const bool same = (a - b).norm() <= same_pose * far && turn.norm() <= same_pose;
    rests_[segment] = same && input_.pauses ? 1 : 0;
    if (input_.timing == KeyTiming::given) return;
    if (same) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "keys[%zu] has the pose of keys[%zu], the one before it; times are found between poses that "
                      "differ, give times for a pause",
                      to, from);
    }
    double square = (a - b).squaredNorm();
    for (int i = 0; i < 3; ++i) {
        const double f = body_.f[static_cast<size_t>(i)];
        square += 2 * f * f * turn.col(i).squaredNorm() / body_.mass;
    }
    const double way = std::sqrt(square);
    way_ += way;
    times_[segment] = input_.timing == KeyTiming::distances ? way : std::sqrt(way);
    timed_way_ += times_[segment];
}

// From where it is lent for, in turn.
void MotionKeys::find_time(size_t key) {
    const double before = key == 0 ? 0 : next_time_;
    const double own = key < segments() ? times_[key] : 0;
    times_[key] = before;
    next_time_ = before + own / timed_way_ * way_ / input_.speed;
    if (key > 0 && !(times_[key] - times_[key - 1] > min_gap * way_ / input_.speed))
        refuse(key, "is too near the one before it for a time to be found");
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
