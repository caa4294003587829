// SPDX-License-Identifier: MIT
// Time laws: closed forms of profiles within limits, and that laws rise.
#include "splines/motion/time_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "runtime/run_now.h"
#include "splines/nan_memory.h"

namespace flg::test {
namespace {

constexpr double pi = 3.14159265358979323846;

// A path at equal times.
struct Path {
    std::vector<double> times, moved, turned;
    bool closed = false;

    Path(
        uint32_t steps, double duration, const std::function<Vec3(double)>& place,
        const std::function<double(double)>& angle = [](double) { return 0.0; }) {
        for (uint32_t i = 0; i <= steps; ++i) times.push_back(duration * i / steps);
        for (uint32_t i = 0; i < steps; ++i) {
            const Vec3 move = place(times[i + 1]) - place(times[i]);
            const Vec3 turn(0, angle(times[i + 1]) - angle(times[i]), 0);
            moved.insert(moved.end(), move.data(), move.data() + 3);
            turned.insert(turned.end(), turn.data(), turn.data() + 3);
        }
    }
    MotionSteps steps() const {
        return {.times = times, .moved = moved, .turned = turned, .closed = closed, .kinks = {}};
    }
};

TimeLaw limit(const Path& path, const MotionLimits& limits, bool haltingly = false) {
    return run_now(
        nan_memory(), [&](Pace& pace) { return limited_law(pace, path.steps(), limits); }, haltingly);
}

double duration(const TimeLaw& law) {
    return law.times[law.times.size() - 1] - law.times[0];
}

TEST(TimeLaw, AStraightWayGetsATrapezoid) {
    // 10 m, far too fast.
    const Path path(1000, 0.1, [](double t) { return Vec3(100 * t, 0, 0); });
    const TimeLaw law = limit(path, {.speed = 2, .acceleration = 1});
    // 2 s up, 2 s down on 2 m each, and 6 m at 2 m/s.
    EXPECT_NEAR(duration(law), 7, 2e-3);
    LawWalk walk(law);
    for (const auto& [time, way] : std::vector<std::pair<double, double>>{
             {0, 0}, {0.5, 0.125}, {1, 0.5}, {2, 2}, {3.5, 5}, {5, 8}, {6, 9.5}, {7, 10}})
        EXPECT_NEAR(100 * walk.parameter_at(time), way, 4e-3) << time;
}

TEST(TimeLaw, AShortWayGetsATriangle) {
    const Path path(1000, 0.1, [](double t) { return Vec3(0, 0, 10 * t); });
    EXPECT_NEAR(duration(limit(path, {.speed = 20, .acceleration = 1})), 2, 2e-3);
    // Turns likewise: 1 rad at 4 rad/s^2.
    const Path turn(
        1000, 0.1, [](double) { return Vec3::Zero(); }, [](double t) { return 10 * t; });
    EXPECT_NEAR(duration(limit(turn, {.turn_acceleration = 4})), 1, 2e-3);
    EXPECT_NEAR(duration(limit(turn, {.turn = 0.25})), 4, 1e-9);
}

// x = t^2 is at rest at its begin: with twice the acceleration allowed it stays as it is.
TEST(TimeLaw, WhatIsAtRestAtAnEndIsNotHeldThere) {
    const auto place = [](double t) { return Vec3(t * t, 0, 0); };
    const Path path(100, 1, place);
    const TimeLaw law = limit(path, {.acceleration = 0.5});
    LawWalk walk(law);
    std::vector<double> places;
    const int count = 1000;
    const double step = duration(law) / count;
    for (int i = 0; i <= count; ++i) places.push_back(place(walk.parameter_at(i * step)).x());
    for (size_t i = 1; i < count; ++i)
        EXPECT_LT(std::abs(places[i + 1] - 2 * places[i] + places[i - 1]) / (step * step), 0.6) << i;
    EXPECT_NEAR(law.rates[1], 0.5, 1e-6);
    EXPECT_EQ(law.rates[200], 0);
}

// Around a circle of radius 2 the acceleration is v^2 / 2.
TEST(TimeLaw, ACircleIsPassedAsFastAsItsBendAllows) {
    Path path(2000, 1, [](double t) -> Vec3 { return 2 * Vec3(std::cos(2 * pi * t), std::sin(2 * pi * t), 0); });
    path.closed = true;
    const TimeLaw law = limit(path, {.acceleration = 0.5});
    EXPECT_NEAR(duration(law), 4 * pi, 1e-4);
    for (size_t i = 0; i < law.rates.size(); ++i) EXPECT_NEAR(law.rates[i], 1 / (4 * pi), 1e-6);
}

TEST(TimeLaw, WhatIsWithinItsLimitsStays) {
    const Path path(50, 3, [](double t) { return Vec3(t, t * t, 0); });
    const TimeLaw law = limit(path, {.speed = 7, .turn = 1});
    for (size_t i = 0; i < law.times.size(); ++i) EXPECT_NEAR(law.times[i], path.times[i], 1e-14);
    LawWalk walk(law);
    EXPECT_NEAR(walk.parameter_at(1.234), 1.234, 1e-14);
}

TEST(TimeLaw, AccelerationsStayWithinTheLimitOnABendingWay) {
    const auto place = [](double t) { return Vec3(3 * t, std::sin(5 * t), std::cos(3 * t)); };
    const Path path(4000, 2, place);
    const MotionLimits limits{.speed = 1.5, .acceleration = 2};
    const TimeLaw law = limit(path, limits);
    LawWalk walk(law);
    std::vector<Vec3> places;
    constexpr int count = 1000;
    const double step = duration(law) / count;
    for (int i = 0; i <= count; ++i) places.push_back(place(walk.parameter_at(i * step)));
    double fastest = 0, most = 0;
    for (size_t i = 1; i < count; ++i) {
        fastest = std::max(fastest, (places[i + 1] - places[i]).norm() / step);
        most = std::max(most, (places[i + 1] - 2 * places[i] + places[i - 1]).norm() / (step * step));
    }
    EXPECT_LT(fastest, 1.5 * 1.001);
    EXPECT_LT(most, 2 * 1.02);
    EXPECT_GT(most, 2 * 0.98);
}

// Where the acceleration jumps each side has its own, and where the velocity does the motion nearly stops.
TEST(TimeLaw, JumpsAtKinksAreSeenFromBothSides) {
    const auto bent = [](double t) {
        return Vec3(t < 1 ? 4 * (t - 1) * (t - 1) * (t - 1) + t : t + 2 * (t - 1) * (t - 1), 0, 0);
    };
    Path path(400, 2, bent);
    const std::vector<uint32_t> kinks{0, 200, 400};
    MotionSteps steps = path.steps();
    steps.kinks = kinks;
    EXPECT_NEAR(motion_at(steps, 200, NodeSide::before).acceleration.x(), 0, 0.2);
    EXPECT_NEAR(motion_at(steps, 200, NodeSide::after).acceleration.x(), 4, 1e-6);
    EXPECT_NEAR(motion_at(steps, 200, NodeSide::after).velocity.x(), 1, 1e-6);
    const auto law = [&](const MotionSteps& of) {
        return run_now(nan_memory(), [&](Pace& pace) { return limited_law(pace, of, {.acceleration = 1}); });
    };
    const TimeLaw limited = law(steps);
    LawWalk walk(limited);
    const int count = 2000;
    const double step = duration(limited) / count;
    std::vector<double> places;
    for (int i = 0; i <= count; ++i) places.push_back(bent(walk.parameter_at(i * step)).x());
    for (size_t i = 1; i < count; ++i)
        EXPECT_LT(std::abs(places[i + 1] - 2 * places[i] + places[i - 1]) / (step * step), 1.1) << i;

    const auto corner = [](double t) { return Vec3(std::min(t, 1.0), std::max(t - 1, 0.0), 0); };
    const Path turned(400, 2, corner);
    steps = turned.steps();
    steps.kinks = kinks;
    const TimeLaw slow = law(steps);
    EXPECT_LT(slow.rates[400], 0.08);
    EXPECT_GT(slow.rates[200], 0.5);
}

TEST(TimeLaw, EasesKeepTheTimesOfKeysAndRise) {
    const std::vector<double> times{0, 1, 3}, eases{0, 1, 1, 0.5, 0.25, 0};
    const TimeLaw law = run_now(nan_memory(), [&](Pace& pace) { return eased_law(pace, times, eases); });
    LawWalk walk(law), again(law);
    for (const double time : times) EXPECT_EQ(walk.parameter_at(time), time);
    EXPECT_NEAR(again.parameter_at(0.5), 0.5, 1e-15);
    double before = again.parameter_at(0.5);
    for (double time = 0.5; time < 3; time += 1e-3) {
        const double at = again.parameter_at(time);
        EXPECT_GE(at, before);
        before = at;
    }
    LawWalk slow(law);
    // From rest: 3 u^2 - 2 u^3.
    EXPECT_NEAR(slow.parameter_at(0.1), 0.03 - 0.002, 1e-15);
    // Half as fast after the second key.
    const double first = slow.parameter_at(1), second = slow.parameter_at(1 + 1e-6);
    EXPECT_NEAR((second - first) / 1e-6, 0.5, 1e-4);
}

TEST(TimeLaw, SameBitsWhereverItPauses) {
    Path path(300, 1, [](double t) -> Vec3 {
        return 2 * Vec3(std::cos(2 * pi * t), std::sin(2 * pi * t), std::sin(4 * pi * t));
    });
    path.closed = true;
    const MotionLimits limits{.speed = 3, .acceleration = 1, .turn = 2, .turn_acceleration = 1};
    const TimeLaw whole = limit(path, limits), halting = limit(path, limits, true);
    for (size_t i = 0; i < whole.times.size(); ++i) EXPECT_EQ(whole.times[i], halting.times[i]);
}

}  // namespace
}  // namespace flg::test
