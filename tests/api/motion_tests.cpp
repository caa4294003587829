// SPDX-License-Identifier: MIT
// Motions behind the C ABI.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "api/host.h"
#include "filigree/filigree_motion.h"

namespace flg::test {
namespace {

// Turns by a quarter about one axis after another, on a way that bends.
struct Keys {
    std::vector<double> times{0, 1, 2.5, 3};
    std::vector<double> poses{1, 0, 0, 0, 0, 1, 0,  0, 0,  0, 1, 0,  //
                              1, 0, 0, 1, 0, 0, -1, 0, 0,  1, 0, 0,  //
                              0, 0, 1, 1, 1, 0, 0,  2, 0,  1, 0, 0,  //
                              0, 0, 1, 0, 0, 1, 0,  2, -1, 0, 0, 1};
    FlgMotionDesc desc = flgMotionDefaults();
    Keys() {
        desc.key_count = 4;
        desc.times = times.data();
        desc.poses = poses.data();
    }
    Keys(const Keys&) = delete;
    Keys& operator=(const Keys&) = delete;
};

FlgMotionView made(const Host& host, const FlgMotionDesc& desc) {
    FlgMotion motion{};
    EXPECT_EQ(flgMotionCreate(host.context, &desc, &motion, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgMotionView view = flgMotionViewDefaults();
    EXPECT_EQ(flgMotionGetView(host.context, motion, &view), FLG_OK) << flgErrorGetMessage();
    return view;
}

std::string bits(const FlgMotionView& view) {
    std::string all(reinterpret_cast<const char*>(view.poses), sizeof(double) * 12 * view.position_count);
    all.append(reinterpret_cast<const char*>(view.quaternions), sizeof(double) * 4 * view.position_count);
    return all.append(reinterpret_cast<const char*>(view.times), sizeof(double) * view.position_count);
}

TEST(MotionApi, KeysBecomeAMotion) {
    const Host host;
    const Keys keys;
    FlgMotion motion{};
    FlgJob job{};
    ASSERT_EQ(flgMotionCreate(host.context, &keys.desc, &motion, &job), FLG_OK) << flgErrorGetMessage();
    FlgMotionView view = flgMotionViewDefaults();
    EXPECT_EQ(flgMotionGetView(host.context, motion, &view), FLG_NOT_READY);
    EXPECT_EQ(view.poses, nullptr);
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_OK);
    ASSERT_EQ(flgMotionGetView(host.context, motion, &view), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(view.position_count, 97u);
    EXPECT_EQ(view.key_count, 4u);
    EXPECT_EQ(view.ending, FLG_SPLINE_ENDING_CONVERGED);
    EXPECT_LE(view.residual, 1e-6);
    EXPECT_EQ(view.mass, 6);
    EXPECT_EQ(view.inertia[0], 1);
    EXPECT_EQ(view.energy, view.barycentre_energy + view.rotation_energy);
    EXPECT_GT(view.barycentre_energy, 0);
    EXPECT_GT(view.rotation_energy, 0);
    for (uint32_t k = 0; k < 4; ++k) {
        const uint32_t at = view.key_positions[k];
        EXPECT_EQ(view.times[at], keys.times[k]);
        for (uint32_t c = 0; c < 12; ++c) EXPECT_NEAR(view.poses[12 * at + c], keys.poses[12 * k + c], 1e-14);
    }
    EXPECT_EQ(flgMotionRelease(host.context, motion), FLG_OK);
    EXPECT_EQ(flgMotionGetView(host.context, motion, &view), FLG_ERROR_INVALID_HANDLE);
    EXPECT_EQ(flgMotionRelease(host.context, motion), FLG_ERROR_INVALID_HANDLE);
}

TEST(MotionApi, ClosedMotionsEndAsLongAfterTheLastKeyAsKeysAreApart) {
    const Host host;
    Keys keys;
    keys.desc.closed = 1;
    const FlgMotionView view = made(host, keys.desc);
    EXPECT_EQ(view.position_count, 128u);
    EXPECT_EQ(view.closed, 1u);
    EXPECT_EQ(view.times[128], 4);
    keys.desc.end_time = 7;
    EXPECT_EQ(made(host, keys.desc).times[128], 7);
    // Two keys, there and back.
    keys.desc.key_count = 2;
    keys.desc.end_time = 0;
    const FlgMotionView two = made(host, keys.desc);
    EXPECT_EQ(two.times[two.position_count], 2);
    EXPECT_EQ(two.ending, FLG_SPLINE_ENDING_CONVERGED);
}

TEST(MotionApi, TheBodyCounts) {
    const Host host;
    Keys keys;
    const FlgMotionView ball = made(host, keys.desc);
    // A ball's feature points.
    const std::vector<double> points{1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    keys.desc.body_points = points.data();
    keys.desc.body_point_count = 6;
    const FlgMotionView same = made(host, keys.desc);
    EXPECT_NEAR(same.energy, ball.energy, 1e-10 * ball.energy);
    for (uint32_t i = 0; i < 12 * ball.position_count; ++i) EXPECT_NEAR(same.poses[i], ball.poses[i], 1e-7);
    const std::vector<double> masses{1, 1, 1, 1, 20, 20};
    keys.desc.body_masses = masses.data();
    const FlgMotionView rod = made(host, keys.desc);
    EXPECT_EQ(rod.mass, 44);
    EXPECT_NEAR(rod.inertia[0], std::sqrt(20), 1e-12);
    EXPECT_NEAR(rod.inertia[2], 1, 1e-12);
    double change = 0;
    for (uint32_t i = 0; i < 12 * ball.position_count; ++i)
        change = std::max(change, std::abs(rod.poses[i] - ball.poses[i]));
    EXPECT_GT(change, 0.01);
}

TEST(MotionApi, SameBitsWithWorkersAndBudgets) {
    Keys keys;
    keys.desc.closed = 1;
    const Host alone, many(2), hurried;
    const std::string expected = bits(made(alone, keys.desc));
    EXPECT_EQ(bits(made(many, keys.desc)), expected);
    FlgMotion motion{};
    ASSERT_EQ(flgMotionCreate(hurried.context, &keys.desc, &motion, nullptr), FLG_OK);
    hurried.finish(50);
    FlgMotionView view = flgMotionViewDefaults();
    ASSERT_EQ(flgMotionGetView(hurried.context, motion, &view), FLG_OK);
    EXPECT_EQ(bits(view), expected);
}

TEST(MotionApi, RoundsCanBeSeen) {
    const Host host;
    Keys keys;
    FlgJobOptions options = flgJobOptionsDefaults();
    options.partial_results = 1;
    keys.desc.job = &options;
    keys.desc.position_count = 5000;
    FlgMotion motion{};
    FlgJob job{};
    ASSERT_EQ(flgMotionCreate(host.context, &keys.desc, &motion, &job), FLG_OK) << flgErrorGetMessage();
    FlgMotionView view = flgMotionViewDefaults();
    bool seen = false;
    while (host.status_of(job).state != FLG_JOB_STATE_FINISHED) {
        ASSERT_EQ(flgContextTick(host.context, 2000, nullptr), FLG_OK);
        if (flgMotionGetView(host.context, motion, &view) != FLG_OK || view.ending != FLG_SPLINE_ENDING_RUNNING)
            continue;
        seen = true;
        EXPECT_GE(view.rounds, 1u);
        EXPECT_EQ(view.times[view.key_positions[2]], keys.times[2]);
        EXPECT_NEAR(view.poses[12 * view.key_positions[1] + 3], 1, 1e-12);
    }
    EXPECT_TRUE(seen);
    EXPECT_EQ(host.result_of(job), FLG_OK);
}

TEST(MotionApi, BadDescriptorsAreRefused) {
    const Host host;
    const auto refusal = [&](const std::function<void(FlgMotionDesc&)>& change) {
        Keys keys;
        change(keys.desc);
        FlgMotion motion{7};
        EXPECT_EQ(flgMotionCreate(host.context, &keys.desc, &motion, nullptr), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(motion.id, 0u);
        return std::string(flgErrorGetMessage());
    };
    using Desc = FlgMotionDesc;
    static constexpr double spot[] = {1, 2, HUGE_VAL}, masses[] = {0}, negative[] = {-1};
    EXPECT_EQ(refusal([](Desc& d) { d.key_count = 1; }), "desc.key_count is 1, must be 2 to 65536");
    EXPECT_EQ(refusal([](Desc& d) { d.times = nullptr; }), "desc.times is null");
    EXPECT_EQ(refusal([](Desc& d) { d.poses = nullptr; }), "desc.poses is null");
    EXPECT_EQ(refusal([](Desc& d) { d.energy = static_cast<FlgSplineEnergy>(3); }),
              "desc.energy is 3, must be one of FLG_SPLINE_...");
    EXPECT_EQ(refusal([](Desc& d) {
                  d.energy = FLG_SPLINE_ENERGY_ET;
                  d.tension = 0;
              }),
              "desc.tension is 0, must be above 0, to 1e12");
    EXPECT_EQ(refusal([](Desc& d) { d.smoothing = -1; }), "desc.smoothing is -1, must be from 0 to 1e9");
    EXPECT_EQ(refusal([](Desc& d) { d.end_time = 9; }),
              "desc.end_time is 9, must be 0 for motions that are not closed");
    EXPECT_EQ(refusal([](Desc& d) {
                  d.timing = FLG_MOTION_TIMING_CHORD;
                  d.closed = 1;
                  d.end_time = 9;
              }),
              "desc.end_time is 9, must be 0 where times are found");
    EXPECT_EQ(refusal([](Desc& d) { d.timing = static_cast<FlgMotionTiming>(3); }),
              "desc.timing is 3, must be one of FLG_MOTION_TIMING_...");
    EXPECT_EQ(refusal([](Desc& d) { d.pacing = static_cast<FlgMotionPacing>(3); }),
              "desc.pacing is 3, must be one of FLG_MOTION_PACING_...");
    EXPECT_EQ(refusal([](Desc& d) { d.look = static_cast<FlgMotionLook>(3); }),
              "desc.look is 3, must be one of FLG_MOTION_LOOK_...");
    EXPECT_EQ(refusal([](Desc& d) { d.speed = -1; }), "desc.speed is -1, must be from 0 to 1e30");
    EXPECT_EQ(refusal([](Desc& d) { d.max_speed = -1; }), "desc.max_speed is -1, must be from 0 to 1e30");
    EXPECT_EQ(refusal([](Desc& d) { d.max_turn = -1; }), "desc.max_turn is -1, must be from 0 to 1e30");
    EXPECT_EQ(refusal([](Desc& d) { d.max_acceleration = -1; }), "desc.max_acceleration is -1, must be from 0 to 1e30");
    EXPECT_EQ(refusal([](Desc& d) { d.max_turn_acceleration = std::nan(""); }),
              "desc.max_turn_acceleration is nan, must be from 0 to 1e30");
    EXPECT_EQ(refusal([](Desc& d) { d.clearance = -1; }), "desc.clearance is -1, must be from 0 to 1e30");
    EXPECT_EQ(refusal([](Desc& d) { d.bank = 101; }), "desc.bank is 101, must be from 0 to 100");
    EXPECT_EQ(refusal([](Desc& d) { d.bank_time = -1; }), "desc.bank_time is -1, must be from 0 to 1e6");
    EXPECT_EQ(refusal([](Desc& d) { d.look = FLG_MOTION_LOOK_TARGET; }), "desc.look_count is 0, must be 1 to 65536");
    EXPECT_EQ(refusal([](Desc& d) {
                  d.look = FLG_MOTION_LOOK_TARGET;
                  d.look_count = 1;
              }),
              "desc.look_points is null");
    EXPECT_EQ(refusal([](Desc& d) {
                  d.look = FLG_MOTION_LOOK_PATH;
                  d.look_up[1] = 0;
              }),
              "desc.look_up is 0, must be not 0");
    EXPECT_EQ(refusal([](Desc& d) { d.position_count = 3; }),
              "desc.position_count is 3, must be key_count to 2^20, closed 3 at least");
    EXPECT_EQ(refusal([](Desc& d) { d.max_rounds = 0; }), "desc.max_rounds is 0, must be 1 to 10000");
    EXPECT_EQ(refusal([](Desc& d) { d.tolerance = std::nan(""); }), "desc.tolerance is nan, must be 1e-12 to 1");
    EXPECT_EQ(refusal([](Desc& d) { d.body_box[1] = -1; }), "desc.body_box is -1, must be from 0 to 1e30");
    EXPECT_EQ(refusal([](Desc& d) { d.body_point_count = 1; }),
              "desc.body_point_count is 1, must be 0 without body_points");
    EXPECT_EQ(refusal([](Desc& d) { d.body_points = spot; }), "desc.body_point_count is 0, must be 1 to 2^20");
    const auto with_body = [&](const double* points, const double* weights) {
        return refusal([&](Desc& d) {
            d.body_points = points;
            d.body_masses = weights;
            d.body_point_count = 1;
        });
    };
    EXPECT_EQ(with_body(spot, nullptr), "desc.body_points is inf, must be finite and at most 1e30 in size");
    static constexpr double origin[] = {0, 0, 0};
    EXPECT_EQ(with_body(origin, masses), "the sum of desc.body_masses is 0, must be above 0");
    EXPECT_EQ(with_body(origin, negative), "desc.body_masses is -1, must be from 0 to 1e30");
    EXPECT_NE(refusal([](Desc& d) { d.struct_size = 3; }).find("desc: struct_size is 3"), std::string::npos);
    EXPECT_EQ(flgMotionCreate(host.context, nullptr, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
}

TEST(MotionApi, ObstaclesAreThoseOfSplines) {
    const Host host;
    Keys keys;
    FlgObstacle ball = flgObstacleDefaults();
    ball.centre[0] = 0.6;
    ball.centre[1] = 0.1;
    ball.radius = 0.2;
    FlgObstaclesDesc desc = {};
    ASSERT_EQ(flgObstaclesDescInit(&desc, sizeof desc), FLG_OK);
    desc.obstacles = &ball;
    desc.obstacle_count = 1;
    ASSERT_EQ(flgObstaclesCreate(host.context, &desc, &keys.desc.obstacles, nullptr), FLG_OK) << flgErrorGetMessage();
    const FlgMotionView view = made(host, keys.desc);
    double least = 1e9;
    for (uint32_t i = 0; i < view.position_count; ++i) {
        const double* const p = view.poses + 12 * i;
        least = std::min(least, std::hypot(p[3] - 0.6, p[7] - 0.1, p[11]));
    }
    EXPECT_GT(least, 0.199);
    EXPECT_NEAR(view.radius, std::sqrt(3), 1e-15);
    const auto refusal = [&](const char* words) {
        FlgMotion motion{};
        EXPECT_EQ(flgMotionCreate(host.context, &keys.desc, &motion, nullptr), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(std::string(flgErrorGetMessage()), words);
    };
    keys.desc.obstacle_radius = 1;
    refusal("desc.obstacle_radius is 1, must be 1e-5 to 0.1");
    keys.desc.obstacle_radius = 1e-3;
    keys.desc.side_count = 1;
    refusal("desc.sides is null");
    keys.desc.smoothing = 1;
    refusal("desc.smoothing is 1, must be 0 with obstacles");
    keys.desc.obstacles.id = 77;
    FlgMotion motion{};
    EXPECT_EQ(flgMotionCreate(host.context, &keys.desc, &motion, nullptr), FLG_ERROR_INVALID_HANDLE);
}

TEST(MotionApi, BadKeysFailTheJob) {
    const Host host;
    const auto failure = [&](const std::function<void(Keys&)>& change) {
        Keys keys;
        change(keys);
        FlgMotion motion{};
        EXPECT_EQ(flgMotionCreate(host.context, &keys.desc, &motion, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        FlgMotionView view = flgMotionViewDefaults();
        EXPECT_EQ(flgMotionGetView(host.context, motion, &view), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(view.poses, nullptr);
        return std::string(flgErrorGetMessage());
    };
    EXPECT_EQ(failure([](Keys& k) { k.times[2] = 0.5; }), "keys[2] has the time 0.5 after 1; times must rise");
    EXPECT_EQ(failure([](Keys& k) { k.poses[12] = -1; }),
              "keys[1] has a pose that is a reflection: its determinant is negative");
    EXPECT_EQ(failure([](Keys& k) { k.poses[0] = 2; }),
              "keys[0] has a pose that stretches by 1 to 2; a rigid body's are 1 within 0.001");
    static constexpr double eases[8] = {0, 0, 0, 2};
    EXPECT_EQ(failure([](Keys& k) { k.desc.eases = eases; }), "keys[1] has an ease out of 2; they go from 0 to 1");
    EXPECT_EQ(failure([](Keys& k) {
                  std::copy_n(k.poses.begin(), 12, k.poses.begin() + 12);
                  k.desc.timing = FLG_MOTION_TIMING_CHORD;
              }),
              "keys[1] has the pose of keys[0], the one before it; times are found between poses that differ, give "
              "times for a pause");
    EXPECT_EQ(failure([](Keys& k) {
                  k.desc.closed = 1;
                  k.desc.end_time = 3;
              }),
              "end_time is 3: a closed motion comes back to its first key after the last one's 3");
}

TEST(MotionApi, APauseAndFoundTimes) {
    const Host host;
    Keys keys;
    std::copy_n(keys.poses.begin() + 12, 12, keys.poses.begin() + 24);
    const FlgMotionView paused = made(host, keys.desc);
    EXPECT_EQ(paused.ending, FLG_SPLINE_ENDING_CONVERGED);
    for (uint32_t i = paused.key_positions[1]; i < paused.key_positions[2]; ++i)
        EXPECT_EQ(paused.poses[12 * i + 3], paused.poses[12 * i + 15]);
    Keys found;
    found.desc.times = nullptr;
    found.desc.timing = FLG_MOTION_TIMING_CENTRIPETAL;
    found.desc.speed = 3;
    const FlgMotionView timed = made(host, found.desc);
    EXPECT_EQ(timed.times[0], 0);
    EXPECT_GT(timed.times[96], 0.5);
    EXPECT_LT(timed.times[96], 5);
    EXPECT_GT(timed.length, 3);
}

TEST(MotionApi, LawsOfTimeAndLooking) {
    Keys keys;
    const double target[3] = {1, 1, -5}, eases[8] = {0, 1, 0.5, 0.5, 0, 0, 1, 0};
    keys.desc.look = FLG_MOTION_LOOK_TARGET;
    keys.desc.look_points = target;
    keys.desc.look_count = 1;
    keys.desc.bank = 1;
    keys.desc.pacing = FLG_MOTION_PACING_PATH;
    keys.desc.eases = eases;
    keys.desc.max_speed = 1.5;
    keys.desc.max_turn = 2;
    keys.desc.max_acceleration = 1;
    keys.desc.position_count = 2000;
    const Host alone, many(2);
    const FlgMotionView view = made(alone, keys.desc);
    EXPECT_EQ(bits(made(many, keys.desc)), bits(view));
    EXPECT_EQ(view.rotation_energy, 0);
    EXPECT_GT(view.greatest_speed, 0.5);
    EXPECT_LE(view.greatest_speed, 1.51);
    EXPECT_LE(view.greatest_acceleration, 1.1);
    EXPECT_GT(view.greatest_bank, 0.01);
    EXPECT_GT(view.times[1999], 3);
    for (uint32_t i = 0; i < 2000; ++i) {
        const double* const p = view.poses + 12 * i;
        const double d[3] = {target[0] - p[3], target[1] - p[7], target[2] - p[11]};
        EXPECT_NEAR(-(p[2] * d[0] + p[6] * d[1] + p[10] * d[2]), std::hypot(d[0], d[1], d[2]), 1e-9);
    }
}

TEST(MotionApi, RunningOutOfMemoryIsAnError) {
    Keys keys;
    keys.desc.smoothing = 0.01;
    keys.desc.position_count = 12;
    int refused = 0;
    for (int64_t fail_at = 0;; ++fail_at) {
        Host host;
        const int64_t before = host.allocator.calls;
        host.allocator.fail_at = before + fail_at;
        FlgMotion motion{};
        FlgJob job{};
        FlgResult result = flgMotionCreate(host.context, &keys.desc, &motion, &job);
        if (result == FLG_OK) {
            host.finish();
            result = host.result_of(job);
        }
        const bool hit = host.allocator.calls > before + fail_at;
        EXPECT_EQ(result, hit ? FLG_ERROR_OUT_OF_MEMORY : FLG_OK) << fail_at;
        refused += result != FLG_OK;
        if (!hit) break;
        ASSERT_LT(fail_at, 1000);
    }
    EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace flg::test
