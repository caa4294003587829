// SPDX-License-Identifier: MIT
#include "stylization/synthesis.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <thread>

#include "reference/literal_synthesis.h"
#include "stylization/synthesis_inputs.h"

namespace flg {
namespace {

using test::Points;
using test::points_of;
using test::stylize;
using Style = test::TestStyle;
using Result = test::StylizedCurve;
using Options = test::StylizeOptions;

Points long_target() {
    return test::sampled(test::helix, 800);
}

TEST(Synthesis, EqualsTheLiteralVersion) {
    const Style style(test::wiggles(300));
    const Points target = long_target();
    const uint32_t steps = 4000;
    const SamplingPlan plan = test::plan_of(target, steps);
    const auto frames = literal::resample(target.vectors(), false, steps, plan.measure.initial_normal());
    for (double tau : {0.0, 0.05, 1.0}) {
        for (bool from_start : {true, false}) {
            PathTrees trees = style.trees(tau);
            const Options options{.magnitude = 0.7, .scale = 0.5, .from_start = from_start, .seed = 9, .key = 4};
            const Result fast = stylize(style, trees, plan, options);
            literal::Walk walk;
            for (uint32_t k = 0; k < trees.destination_count(); ++k) {
                walk.destinations.push_back(static_cast<int>(trees.destination(k)));
            }
            walk.from_start = from_start;
            walk.patch = 10;
            walk.node_count = 300;
            walk.draw = [](int index, int count) {
                return static_cast<int>(random_below(9, 4, static_cast<uint64_t>(index), static_cast<uint32_t>(count)));
            };
            const std::vector<int> indices =
                literal::style_indices(test::edges_of(style.prepared.graph, trees.temperature()), walk, steps + 1);
            const std::vector<Vec3> positions =
                literal::displace(frames, literal::copied_displacement(style.vectors, indices, 10), 0.7 * 0.5);
            for (uint32_t i = 0; i <= steps; ++i) {
                ASSERT_EQ(fast.indices[i], indices[i]) << i;
                ASSERT_LT((fast.curve.position(i) - positions[i]).norm(), 1e-4) << i;
            }
        }
    }
}

// A style drawn about a gently bent guide, prepared the way the SDK does.
struct Example {
    static constexpr uint32_t count = 500;
    Points guide = test::sampled([](double u) { return Vec3(std::sin(u), 3 * u, std::cos(1.3 * u)); }, count - 1);
    SamplingPlan plan = test::plan_of(guide, count - 1);
    test::Resampled points = test::resample(plan);
    std::vector<Vec3> drawn;
    double rms = 0;

    Displacement displacement() {
        for (uint32_t i = 0; i < count; ++i) {
            const double u = 0.11 * i;
            drawn.push_back(points.position(i) +
                            0.1 * Vec3(std::sin(3 * u), std::cos(2.2 * u) + 0.2 * std::sin(9 * u), u / 50));
        }
        const GuideAndStyle input{points.positions.data(), points.tangents.data(), points.normals.data(), drawn};
        Displacement d(count, test::memory());
        rms = run_haltingly(test::memory(), [&](Pace& pace) { return displace(pace, input, d); });
        return d;
    }
};

TEST(Synthesis, AStyleOnItsOwnGuideIsTheStyle) {
    Example example;
    Style style{std::vector<Vec3>(Example::count)};
    style.prepared.displacement = example.displacement();
    style.prepared.graph = test::graph_of(style.prepared.displacement, 10);
    std::vector<float> radius, user;
    for (uint32_t i = 0; i < Example::count; ++i) {
        radius.push_back(0.1f + 0.01f * static_cast<float>(i % 17));
        user.insert(user.end(), {static_cast<float>(i), -0.5f * static_cast<float>(i)});
    }
    style.add(FLG_ATTRIBUTE_RADIUS, 1, radius);
    style.add(FLG_ATTRIBUTE_USER, 2, user);
    const Result r = stylize(style, 0, example.plan);
    for (uint32_t i = 0; i < Example::count; ++i) {
        EXPECT_EQ(r.indices[i], static_cast<float>(i));  // to the very end
        EXPECT_LT((r.curve.position(i) - example.drawn[i]).norm(), 1e-4 * example.rms) << i;
    }
    EXPECT_EQ(r.attributes[0], radius);
    EXPECT_EQ(r.attributes[1], user);
}

TEST(Synthesis, RigidMotionOfTheTargetMovesTheResult) {
    const Style style(test::wiggles(300));
    const Eigen::Quaterniond rotation = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
    const Vec3 shift(0.3, -1.2, 2.1);
    const Points target = test::sampled(test::wild, 200);
    const Points moved = test::sampled([&](double u) -> Vec3 { return rotation * test::wild(u) + shift; }, 200);
    const Result a = stylize(style, 0.1, test::plan_of(target, 700));
    const Result b = stylize(style, 0.1, test::plan_of(moved, 700));
    EXPECT_EQ(a.indices, b.indices);
    for (size_t i = 0; i <= 700; ++i) {
        EXPECT_LT((b.curve.position(i) - (rotation * a.curve.position(i) + shift)).norm(), 1e-3);
    }
}

TEST(Synthesis, CopiedRunsGetShorterAsTheTemperatureRises) {
    const Style style(test::wiggles(600));
    const Points target = long_target();
    const SamplingPlan plan = test::plan_of(target, 20000);
    double before = INFINITY;
    for (double tau : {0.0, 0.5, 1.0, 2.0, 5.0}) {
        const double mean = stylize(style, tau, plan).mean_run();
        EXPECT_LT(mean, before) << tau;
        before = mean;
    }
}

TEST(Synthesis, MagnitudeScalesTheDisplacement) {
    const Style style(test::wiggles(300));
    const Points target = long_target();
    const SamplingPlan plan = test::plan_of(target, 900);
    const test::Resampled plain = test::resample(plan);
    PathTrees trees = style.trees(0.1);
    const Result none = stylize(style, trees, plan, {.magnitude = 0});
    EXPECT_EQ(none.curve.positions, plain.positions);
    EXPECT_EQ(none.curve.normals, plain.normals);
    const Result once = stylize(style, trees, plan);
    const Result reversed = stylize(style, trees, plan, {.magnitude = -2});
    const Result small = stylize(style, trees, plan, {.scale = 0.5});
    EXPECT_EQ(once.indices, reversed.indices);
    for (size_t i = 0; i <= 900; ++i) {
        const Vec3 d = once.curve.position(i) - plain.position(i);
        EXPECT_LT((reversed.curve.position(i) - plain.position(i) + 2 * d).norm(), 1e-5);
        EXPECT_LT((small.curve.position(i) - plain.position(i) - 0.5 * d).norm(), 1e-5);
    }
}

TEST(Synthesis, RandomChoicesAreKeyedBySeedAndCurve) {
    const Style style(test::wiggles(300));
    const Points target = long_target();
    const SamplingPlan plan = test::plan_of(target, 2000);
    PathTrees trees = style.trees(0.0);
    const auto indices = [&](uint64_t seed, uint64_t curve, bool from_start) {
        return stylize(style, trees, plan, {.from_start = from_start, .seed = seed, .key = curve}).indices;
    };
    EXPECT_EQ(indices(1, 0, false), indices(1, 0, false));
    EXPECT_NE(indices(1, 0, false), indices(2, 0, false));
    EXPECT_NE(indices(1, 0, false), indices(1, 1, false));
    EXPECT_NE(indices(1, 0, true), indices(2, 0, true));
    EXPECT_EQ(indices(1, 0, true)[0], 0);
    EXPECT_GE(indices(1, 0, false)[0], 11);
}

TEST(Synthesis, DegenerateTargets) {
    const Style style(test::wiggles(300));
    // One point, and no length: one sample, not displaced.
    for (const Points& target : {points_of({{3, 4, 5}}), points_of(std::vector<Vec3>(7, Vec3(3, 4, 5))),
                                 points_of(std::vector<Vec3>(7, Vec3(3, 4, 5)), true)}) {
        const Result r = stylize(style, 0, test::plan_of(target, 0));
        ASSERT_EQ(r.indices.size(), 1u);
        EXPECT_EQ(r.curve.position(0), Vec3(3, 4, 5));
    }
    // Shorter than a step: two points.
    const Points pair = points_of({{0, 0, 0}, {1e-3, 0, 0}});
    const Result two = stylize(style, 0, test::plan_of(pair, 1));
    EXPECT_EQ(two.indices, (std::vector<float>{0, 1}));
    for (float v : two.curve.positions) EXPECT_TRUE(std::isfinite(v));
    // Repeated points, shorter than the style.
    const Points repeated = points_of({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 1, 0}});
    const Result part = stylize(style, 0, test::plan_of(repeated, 50));
    for (size_t i = 0; i <= 50; ++i) EXPECT_EQ(part.indices[i], static_cast<float>(i));
    // Large coordinates.
    const Points far = test::sampled([](double u) -> Vec3 { return 1e12 * test::wild(u); }, 100);
    const Result large = stylize(style, 0, test::plan_of(far, 500));
    for (float v : large.curve.positions) EXPECT_TRUE(std::isfinite(v));
}

TEST(Synthesis, TheSmallestStyleIsRepeated) {
    const Style style(test::wiggles(16), 7);  // a single destination
    const Points target = long_target();
    const Result r = stylize(style, 0.5, test::plan_of(target, 500), {.from_start = false});
    for (float index : r.indices) EXPECT_LT(index, 16);
    EXPECT_GT(r.mean_run(), 1.0);
}

TEST(Synthesis, StylesWithoutDisplacementLeaveTheTarget) {
    const Style style(std::vector<Vec3>(100, Vec3(0, 0, 0)));
    const Points target = long_target();
    const SamplingPlan plan = test::plan_of(target, 500);
    EXPECT_EQ(stylize(style, 1, plan).curve.positions, test::resample(plan).positions);
}

TEST(Synthesis, ResultsDoNotDependOnTheSlices) {
    const Style style(test::wiggles(300));
    for (bool closed : {false, true}) {
        const Points target = test::sampled(test::wild, 500, closed);
        const SamplingPlan plan = test::plan_of(target, 1500);
        const Result whole = stylize(style, 0.2, plan, {.slice = 1000000});
        for (uint32_t slice : {1u, 7u, 256u}) {
            const Result sliced = stylize(style, 0.2, plan, {.slice = slice});
            EXPECT_EQ(sliced.curve.positions, whole.curve.positions);
            EXPECT_EQ(sliced.indices, whole.indices);
        }
    }
}

TEST(Synthesis, ThreadsShareTheTrees) {
    const Style style(test::wiggles(300));
    const Points target = long_target();
    const SamplingPlan plan = test::plan_of(target, 3000);
    constexpr uint64_t curves = 8;
    std::vector<Result> alone(curves), together(curves);
    for (uint64_t c = 0; c < curves; ++c) alone[c] = stylize(style, 0.1, plan, {.from_start = false, .key = c});
    PathTrees trees = style.trees(0.1);
    std::vector<std::thread> threads;
    for (uint64_t c = 0; c < curves; ++c) {
        threads.emplace_back(
            [&, c] { together[c] = stylize(style, trees, plan, {.from_start = false, .key = c, .slice = 50}); });
    }
    for (std::thread& thread : threads) thread.join();
    for (uint64_t c = 0; c < curves; ++c) EXPECT_EQ(together[c].curve.positions, alone[c].curve.positions);
}

TEST(Synthesis, OtherColumnsAreCarriedOver) {
    const Style style(test::wiggles(300));
    const Points line = points_of({{0, 0, 0}, {1, 0, 0}, {4, 0, 0}});
    const float radius[] = {1, 2, 5};
    std::vector<float> out(401);
    const ColumnPair column{radius, out.data(), 1, false};
    PathTrees trees = style.trees(0);
    const Result r = stylize(style, trees, test::plan_of(line, 400), {.magnitude = 0, .slice = 11}, {&column, 1});
    for (size_t i = 0; i <= 400; ++i) EXPECT_NEAR(out[i], 1 + r.curve.positions[3 * i], 1e-5);
}

}  // namespace
}  // namespace flg
