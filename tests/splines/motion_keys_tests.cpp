// SPDX-License-Identifier: MIT
// Keyframes: what is split is put together again; what is no motion is refused by a sentence that names it.
#include "splines/motion/motion_keys.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "core/failure.h"

#include "runtime/run_now.h"

namespace flg::test {
namespace {

using Mat3 = Eigen::Matrix3d;

struct Keys {
    std::vector<double> times, poses;
    std::vector<double> eases;
    bool closed = false, pauses = true;
    double end_time = 0, speed = 1;
    KeyTiming timing = KeyTiming::given;

    void add(double time, const Mat3& map, const Vec3& shift) {
        times.push_back(time);
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) poses.push_back(map(i, j));
            poses.push_back(shift[i]);
        }
    }
};

Mat3 turn(double angle, const Vec3& axis) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

Keys three_keys() {
    Keys keys;
    keys.add(0, Mat3::Identity(), Vec3(0, 0, 0));
    keys.add(1, turn(1, Vec3(1, 2, 3)), Vec3(1, 0, 2));
    keys.add(2.5, turn(-2, Vec3(0, 1, 1)), Vec3(3, 1, 0));
    return keys;
}

BodyInertia body() {
    const std::vector<double> points{0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 3, 1, 1, 1};
    return inertia_of_points(points, {});
}

MotionKeys read(const Keys& keys, bool haltingly = false) {
    const MotionKeyInput input{.times = keys.times,
                               .poses = keys.poses,
                               .closed = keys.closed,
                               .end_time = keys.end_time,
                               .timing = keys.timing,
                               .speed = keys.speed,
                               .eases = keys.eases,
                               .pauses = keys.pauses};
    return run_now(
        std::pmr::get_default_resource(), [&](Pace& pace) { return check_keys(pace, input, body()); }, haltingly);
}

std::string refusal(const Keys& keys) {
    try {
        read(keys);
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.result(), FLG_ERROR_INVALID_ARGUMENT);
        return failure.what();
    }
    return "";
}

TEST(MotionKeys, SplitAndPutTogether) {
    const Keys keys = three_keys();
    const MotionKeys made = read(keys, true);
    for (size_t i = 0; i < keys.times.size(); ++i) {
        EXPECT_EQ(made.times()[i], keys.times[i]);
        double pose[12];
        const double* const c = &made.barycentres()[3 * i];
        pose_of(body(), Vec3(c[0], c[1], c[2]), made.rotation(i), pose);
        for (int j = 0; j < 12; ++j) EXPECT_NEAR(pose[j], keys.poses[12 * i + j], 1e-14);
        EXPECT_NEAR(made.rotation(i).determinant(), 1, 1e-14);
        Vec3 mean = Vec3::Zero();
        const std::vector<double> points{0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 3, 1, 1, 1};
        for (size_t k = 0; k < points.size(); k += 3) {
            for (int row = 0; row < 3; ++row) {
                const double* const p = &keys.poses[12 * i + 4 * row];
                mean[row] += (p[0] * points[k] + p[1] * points[k + 1] + p[2] * points[k + 2] + p[3]) / 5;
            }
        }
        EXPECT_LT((mean - Vec3(c[0], c[1], c[2])).norm(), 1e-14);
    }
    EXPECT_LT(made.greatest_stretch(), 1e-14);
}

TEST(MotionKeys, SmallStretchesAreTakenOffAndTold) {
    Keys keys = three_keys();
    const Mat3 exact = turn(1, Vec3(1, 2, 3));
    const Mat3 off = exact * Vec3(1.0005, 1, 0.9998).asDiagonal();
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) keys.poses[12 + 4 * i + j] = off(i, j);
    }
    const MotionKeys made = read(keys);
    EXPECT_NEAR(made.greatest_stretch(), 5e-4, 1e-12);
    EXPECT_LT((made.rotation(1) - exact * body().axes).norm(), 1e-13);
}

TEST(MotionKeys, RefusesWhatIsNoMotion) {
    Keys keys = three_keys();
    for (int i = 0; i < 3; ++i) keys.poses[12 + 4 * i] *= -1;
    EXPECT_NE(refusal(keys).find("keys[1] has a pose that is a reflection"), std::string::npos) << refusal(keys);

    keys = three_keys();
    for (int i = 0; i < 11; ++i) keys.poses[24 + i] *= i % 4 == 3 ? 1 : 1.1;
    EXPECT_NE(refusal(keys).find("keys[2] has a pose that stretches by 1.1 to 1.1"), std::string::npos);

    keys = three_keys();
    keys.poses[0] = keys.poses[5] = keys.poses[10] = 0;
    EXPECT_NE(refusal(keys).find("keys[0] has a pose that stretches by 0 to 0"), std::string::npos);

    keys = three_keys();
    keys.times[2] = 1;
    EXPECT_EQ(refusal(keys), "keys[2] has the time 1 after 1; times must rise");

    keys = three_keys();
    keys.times[1] = 1e-10;
    EXPECT_EQ(refusal(keys), "keys[1] has the time 1e-10, too soon after 0 for a motion of 2.5 s");

    keys = three_keys();
    keys.times[1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal(keys), "keys[1] has a time that is not finite");

    keys = three_keys();
    keys.poses[17] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal(keys), "keys[1] has a pose with a number that is not finite");

    keys = three_keys();
    std::copy_n(keys.poses.begin(), 12, keys.poses.begin() + 12);
    keys.times[1] = 0;
    EXPECT_EQ(refusal(keys), "keys[1] has the time 0 after 0; times must rise");

    keys = three_keys();
    keys.eases = {0, 0, 0, 1.5, 0, 0};
    EXPECT_EQ(refusal(keys), "keys[1] has an ease out of 1.5; they go from 0 to 1");

    keys = Keys();
    EXPECT_EQ(refusal(keys), "keys: there is none, a motion needs two at least");
    keys.add(0, Mat3::Identity(), Vec3::Zero());
    EXPECT_EQ(refusal(keys), "keys: there is one, a motion needs two at least");
}

TEST(MotionKeys, ClosedMotionsComeBack) {
    Keys keys = three_keys();
    keys.closed = true;
    keys.end_time = 4;
    const MotionKeys made = read(keys);
    EXPECT_EQ(made.times().size(), 4);
    EXPECT_EQ(made.times()[3], 4);
    keys.end_time = 2.5;
    EXPECT_NE(refusal(keys).find("end_time is 2.5"), std::string::npos);
}

std::string text_of(std::span<const MotionRun> runs) {
    std::string text;
    for (const MotionRun& run : runs) {
        text += std::to_string(run.first) + "+" + std::to_string(run.keys) + (run.closed ? "c" : "") +
                (run.rests[0] ? "r" : "-") + (run.rests[1] ? "r " : "- ");
    }
    return text;
}

TEST(MotionKeys, PausesCutRuns) {
    // Keys by place; equal ones in a row are a pause.
    const auto runs = [](const std::vector<int>& places, bool closed, bool pauses = true) {
        Keys keys;
        for (const int place : places)
            keys.add(static_cast<double>(keys.times.size()), Mat3::Identity(), Vec3(place, 0, 0));
        keys.closed = closed;
        keys.end_time = static_cast<double>(places.size());
        keys.pauses = pauses;
        return text_of(read(keys).runs());
    };
    EXPECT_EQ(runs({0, 1, 2}, false), "0+3-- ");
    EXPECT_EQ(runs({0, 1, 1, 2}, false), "0+2-r 2+2r- ");
    EXPECT_EQ(runs({0, 0, 1, 1}, false), "1+2rr ");
    EXPECT_EQ(runs({0, 1, 1, 1, 2, 3}, false), "0+2-r 3+3r- ");
    EXPECT_EQ(runs({0, 0}, false), "");
    EXPECT_EQ(runs({0, 1, 2}, true), "0+3c-- ");
    EXPECT_EQ(runs({0, 1, 1, 2}, true), "2+4rr ");
    EXPECT_EQ(runs({0, 0, 1, 1}, true), "1+2rr 3+2rr ");
    EXPECT_EQ(runs({0, 1, 2, 0}, true), "0+4rr ");
    EXPECT_EQ(runs({0, 1, 1, 2}, false, false), "0+4-- ");
}

TEST(MotionKeys, TimesAreFound) {
    Keys keys;
    for (const int place : {0, 1, 5, 14}) keys.add(0, Mat3::Identity(), Vec3(place, 0, 0));
    keys.timing = KeyTiming::distances;
    keys.speed = 2;
    const auto expect_times = [&keys](const std::vector<double>& times) {
        const MotionKeys found = read(keys);
        ASSERT_EQ(found.times().size(), times.size());
        for (size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(found.times()[i], times[i], 1e-14);
    };
    expect_times({0, 0.5, 2.5, 7});
    keys.timing = KeyTiming::roots;  // 1, 2 and 3
    expect_times({0, 7.0 / 6, 3.5, 7});
    keys.closed = true;
    keys.timing = KeyTiming::distances;
    expect_times({0, 0.5, 2.5, 7, 14});
    // Turns count: a quarter about z moves points by sqrt(2) times their distance from it.
    keys = Keys();
    keys.timing = KeyTiming::distances;
    keys.add(0, Mat3::Identity(), Vec3::Zero());
    keys.add(0, turn(3.14159265358979323846 / 2, Vec3::UnitZ()), Vec3::Zero());
    const std::vector<double> points{0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 3, 1, 1, 1};
    double square = 0;
    for (size_t k = 0; k < points.size(); k += 3) square += 2 * (points[k] * points[k] + points[k + 1] * points[k + 1]);
    EXPECT_NEAR(read(keys).times()[1], std::sqrt(square / 5), 1e-14);
    keys.add(0, turn(3.14159265358979323846 / 2, Vec3::UnitZ()), Vec3::Zero());
    EXPECT_EQ(refusal(keys),
              "keys[2] has the pose of keys[1], the one before it; times are found between poses that differ, give "
              "times for a pause");
}

TEST(MotionKeys, RotationsBetweenTakeTheShorterWay) {
    const Vec3 axis = Vec3(1, -2, 0.5).normalized();
    const Mat3 from = turn(0.7, Vec3(3, 1, 1));
    for (const double angle : {0.0, 1e-9, 0.5, 3.0, -3.0}) {
        const Mat3 to = turn(angle, axis) * from;
        for (const double share : {0.0, 0.25, 1.0}) {
            EXPECT_LT((rotation_between(from, to, share) - turn(share * angle, axis) * from).norm(), 1e-14);
        }
    }
    EXPECT_LT(
        (rotation_between(from, turn(4, axis) * from, 0.5) - turn(2 - 3.14159265358979323846, axis) * from).norm(),
        1e-14);
    const Mat3 middle = rotation_between(from, turn(3.14159265358979323846, axis) * from, 0.5);
    EXPECT_NEAR(middle.determinant(), 1, 1e-14);
    EXPECT_NEAR((middle - from).norm(), std::sqrt(4.0), 1e-7);
}

}  // namespace
}  // namespace flg::test
