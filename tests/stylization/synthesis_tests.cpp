// SPDX-License-Identifier: MIT
#include "stylization/synthesis.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <thread>

#include "curves/curve_inputs.h"
#include "reference/literal_synthesis.h"
#include "stylization/style_inputs.h"

namespace flg {
namespace {

using test::Points;
using test::points_of;

// A prepared style, and one way to apply it.
struct Style {
    std::vector<Vec3> vectors;
    Displacement displacement;
    PatchGraph graph;

    explicit Style(std::vector<Vec3> v, uint32_t patch = 10)
        : vectors(std::move(v)),
          displacement(test::displacement_of(vectors)),
          graph(test::graph_of(displacement, patch)) {}
    PathTrees trees(double tau) const {
        return PathTrees(graph, static_cast<float>(tau * graph.temperature_unit), test::memory());
    }
};

struct Result {
    test::Resampled curve;
    std::vector<float> indices;

    double mean_run() const {
        double runs = 1;
        for (size_t i = 1; i < indices.size(); ++i) runs += indices[i] != indices[i - 1] + 1;
        return static_cast<double>(indices.size()) / runs;
    }
};

struct Options {
    double magnitude = 1;
    double scale = 1;
    bool from_start = true;
    uint64_t seed = 1;
    uint64_t curve_index = 0;
    uint32_t slice = 1u << 30;
};

Result stylize(const Style& style, PathTrees& trees, SamplingPlan plan, const Options& options = {}) {
    Result result;
    plan.repeat_first = plan.curve.closed;
    const size_t count = plan.sample_count();
    for (auto* column : {&result.curve.positions, &result.curve.tangents, &result.curve.normals}) {
        column->resize(3 * count);
    }
    result.indices.resize(count);
    SynthesisKernel kernel(
        {&style.displacement, &trees, options.magnitude, options.scale, options.from_start, options.seed},
        test::memory());
    const StylizedColumns columns{
        {result.curve.positions.data(), result.curve.tangents.data(), result.curve.normals.data()},
        result.indices.data()};
    kernel.begin(plan, options.curve_index, columns, {});
    while (!kernel.run(options.slice)) {}
    EXPECT_EQ(kernel.written(), count);
    return result;
}

Result stylize(const Style& style, double tau, const SamplingPlan& plan, const Options& options = {}) {
    PathTrees trees = style.trees(tau);
    return stylize(style, trees, plan, options);
}

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
            const Options options{
                .magnitude = 0.7, .scale = 0.5, .from_start = from_start, .seed = 9, .curve_index = 4};
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
                literal::style_indices(test::edges_of(style.graph, trees.temperature()), walk, steps + 1);
            const std::vector<Vec3> positions = literal::displace(frames, style.vectors, indices, 0.7 * 0.5);
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
        DisplacementKernel kernel({points.positions.data(), points.tangents.data(), points.normals.data(), drawn},
                                  test::memory());
        while (!kernel.run(100)) {}
        rms = kernel.rms();
        return kernel.take();
    }
};

TEST(Synthesis, AStyleOnItsOwnGuideIsTheStyle) {
    Example example;
    const Displacement displacement = example.displacement();
    const PatchGraph graph = test::graph_of(displacement, 10);
    PathTrees trees(graph, 0, test::memory());
    test::Resampled out = example.points;
    std::vector<float> indices(Example::count);
    SynthesisKernel kernel({&displacement, &trees, 1, 1, true, 1}, test::memory());
    kernel.begin(example.plan, 0, {{out.positions.data(), out.tangents.data(), out.normals.data()}, indices.data()},
                 {});
    while (!kernel.run(1000)) {}
    for (uint32_t i = 0; i < Example::count; ++i) {
        EXPECT_EQ(indices[i], static_cast<float>(i));  // to the very end
        EXPECT_LT((out.position(i) - example.drawn[i]).norm(), 1e-4 * example.rms) << i;
    }
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
        return stylize(style, trees, plan, {.from_start = from_start, .seed = seed, .curve_index = curve}).indices;
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

TEST(Synthesis, ClosedTargetsAreFollowedOnceAround) {
    const Style style(test::wiggles(300));
    const Points ring = test::sampled(
        [](double u) {
            return Vec3(std::cos(test::two_pi * u), std::sin(test::two_pi * u), std::sin(2 * test::two_pi * u));
        },
        100, true);
    const Result r = stylize(style, 0, test::plan_of(ring, 400), {.magnitude = 0});
    ASSERT_EQ(r.indices.size(), 401u);
    EXPECT_EQ(r.curve.position(400), r.curve.position(0));
    EXPECT_LT((r.curve.normal(400) - r.curve.normal(0)).norm(), 1e-5);
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
    for (uint64_t c = 0; c < curves; ++c) alone[c] = stylize(style, 0.1, plan, {.from_start = false, .curve_index = c});
    PathTrees trees = style.trees(0.1);
    std::vector<std::thread> threads;
    for (uint64_t c = 0; c < curves; ++c) {
        threads.emplace_back([&, c] {
            together[c] = stylize(style, trees, plan, {.from_start = false, .curve_index = c, .slice = 50});
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (uint64_t c = 0; c < curves; ++c) EXPECT_EQ(together[c].curve.positions, alone[c].curve.positions);
}

TEST(Synthesis, OtherColumnsAreCarriedOver) {
    const Style style(test::wiggles(300));
    const Points line = points_of({{0, 0, 0}, {1, 0, 0}, {4, 0, 0}});
    const float radius[] = {1, 2, 5};
    SamplingPlan plan = test::plan_of(line, 400);
    std::vector<float> out(401), positions(3 * 401), tangents(3 * 401), normals(3 * 401), indices(401);
    PathTrees trees = style.trees(0);
    SynthesisKernel kernel({&style.displacement, &trees, 0, 1, true, 1}, test::memory());
    const ColumnPair column{radius, out.data(), 1, false};
    kernel.begin(plan, 0, {{positions.data(), tangents.data(), normals.data()}, indices.data()}, {&column, 1});
    while (!kernel.run(11)) {}
    for (size_t i = 0; i <= 400; ++i) EXPECT_NEAR(out[i], 1 + positions[3 * i], 1e-5);
}

}  // namespace
}  // namespace flg
