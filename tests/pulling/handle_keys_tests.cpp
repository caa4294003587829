// SPDX-License-Identifier: MIT
#include "pulling/handle_keys.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/vec.h"

namespace flg::test {
namespace {

struct Keys {
    std::vector<double> times;
    std::vector<float> positions;

    Vec3 at(double time) const {
        const std::array<float, 3> p = handle_at(times, positions.data(), time);
        return {double{p[0]}, double{p[1]}, double{p[2]}};
    }
    Vec3 key(size_t index) const {
        return {double{positions[3 * index]}, double{positions[3 * index + 1]}, double{positions[3 * index + 2]}};
    }
};

Keys wave() {
    return {{0, 0.5, 0.75, 2, 2.25, 4}, {0, 0, 0, 1, 2, 0, 1, 2.5f, 0, -1, 0, 3, -1, 0, 3, 2, 1, 1}};
}

TEST(HandleKeys, KeysAreMetExactlyAndTheEndsHold) {
    const Keys keys = wave();
    for (size_t i = 0; i < keys.times.size(); ++i) EXPECT_EQ(keys.at(keys.times[i]), keys.key(i));
    EXPECT_EQ(keys.at(-3), keys.key(0));
    EXPECT_EQ(keys.at(9), keys.key(5));
    const Keys one = {{2}, {1, 2, 3}};
    for (const double time : {0.0, 2.0, 5.0}) EXPECT_EQ(one.at(time), Vec3(1, 2, 3));
}

TEST(HandleKeys, PositionsAndVelocitiesAreContinuous) {
    const Keys keys = wave();
    constexpr double step = 1e-3;
    // Across a key the velocity changes no more than the cubics' accelerations allow.
    for (const double key : keys.times) {
        const Vec3 before = (keys.at(key) - keys.at(key - step)) / step;
        const Vec3 after = (keys.at(key + step) - keys.at(key)) / step;
        EXPECT_LT((after - before).norm(), 0.15) << key;
    }
}

TEST(HandleKeys, WhatRestsStaysAndNothingSwingsOut) {
    const Keys keys = {{0, 1, 2, 3}, {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0}};
    for (double time = 0; time <= 1; time += 0.05) EXPECT_EQ(keys.at(time), Vec3(0, 0, 0)) << time;
    for (double time = 2; time <= 3; time += 0.05) EXPECT_EQ(keys.at(time), Vec3(1, 0, 0)) << time;
    double last = 0;
    for (double time = 1; time <= 2; time += 0.05) {
        const double x = keys.at(time).x();
        EXPECT_GE(x, last - 1e-6);
        EXPECT_LE(x, 1);
        last = x;
    }
}

TEST(HandleKeys, AParabolaIsPlayedBetweenInnerKeys) {
    Keys keys;
    const std::vector<double> times = {0, 0.7, 1.5, 2.2, 3};
    for (const double t : times) {
        keys.times.push_back(t);
        for (const double value : {t, 2 + t * t, 0.5 * t * t - t}) keys.positions.push_back(static_cast<float>(value));
    }
    for (double t = 0.7; t <= 2.2; t += 0.1) {
        EXPECT_LT((keys.at(t) - Vec3(t, 2 + t * t, 0.5 * t * t - t)).norm(), 1e-5) << t;
    }
}

TEST(HandleKeys, TurnedAndStretchedKeysGiveTurnedAndStretchedMotions) {
    const Keys keys = wave();
    Keys other = keys;
    for (double& time : other.times) time = 10 + 2 * time;
    for (size_t i = 0; i < other.positions.size(); i += 3) {  // by a quarter about z
        other.positions[i] = -keys.positions[i + 1];
        other.positions[i + 1] = keys.positions[i];
    }
    for (double t = -0.5; t < 4.5; t += 0.125) {
        const Vec3 p = keys.at(t);
        EXPECT_LT((other.at(10 + 2 * t) - Vec3(-p.y(), p.x(), p.z())).norm(), 1e-5) << t;
    }
}

}  // namespace
}  // namespace flg::test
