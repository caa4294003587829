// SPDX-License-Identifier: MIT
#include "stylization/guide_flow.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/literal_guide_flow.h"
#include "runtime/run_now.h"
#include "test_curves.h"

namespace flg {
namespace {

using test::Curve;

struct Flowed {
    Curve guide;
    double time = 0.0;
    double length = 0.0;
    uint32_t steps = 0;
};

Flowed flow(const Curve& style, const GuideFlowParams& params = {}, bool haltingly = false) {
    const FlowedGuide guide = run_now(
        std::pmr::new_delete_resource(), [&](Pace& pace) { return guide_flow(pace, style, params); }, haltingly);
    return {Curve(guide.points.begin(), guide.points.end()), guide.time, guide.length, guide.steps};
}

double unevenness(const Curve& curve) {
    double least = (curve[1] - curve[0]).norm();
    double most = least;
    for (size_t i = 2; i < curve.size(); ++i) {
        least = std::min(least, (curve[i] - curve[i - 1]).norm());
        most = std::max(most, (curve[i] - curve[i - 1]).norm());
    }
    return most / least;
}

double largest_distance(const Curve& a, const Curve& b) {
    double largest = 0.0;
    for (size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
    return largest;
}

// int kappa^2 by turning angles.
double bending(const Curve& curve) {
    const double spacing = test::polyline_length(curve) / static_cast<double>(curve.size() - 1);
    double sum = 0.0;
    for (size_t i = 1; i + 1 < curve.size(); ++i) {
        const Vec3 before = curve[i] - curve[i - 1];
        const Vec3 after = curve[i + 1] - curve[i];
        const double angle = std::atan2(before.cross(after).norm(), before.dot(after));
        sum += angle * angle / spacing;
    }
    return sum;
}

// Curvature between about 0.3 and 1.2 of its greatest: well-posed in the paper's form for alpha = 0.25.
Curve gentle(int count) {
    return test::even_curve([](double u) { return Vec3(3.0 * u, 0.8 * std::sin(std::numbers::pi * u), 0.3 * u * u); },
                            count);
}

TEST(LiteralGuideFlow, ObeysTheLengthLawAndKeepsPointsEven) {
    const Curve style = gentle(80);
    const reference::LiteralFlow flowed = reference::literal_guide_flow(style, 0.25, 1e-4, 2000);
    const double lost = test::polyline_length(style) - test::polyline_length(flowed.points);
    EXPECT_GT(lost, 0.05);
    EXPECT_NEAR(test::polyline_length(flowed.points), flowed.predicted_length, 0.02 * lost);
    EXPECT_LT(unevenness(flowed.points), 1.02);
}

// Fig. 13 of the paper.
TEST(LiteralGuideFlow, LetsPointsGatherWithoutRedistribution) {
    const Curve style = gentle(80);
    const reference::LiteralFlow even = reference::literal_guide_flow(style, 0.25, 1e-4, 2000);
    const reference::LiteralFlow uneven = reference::literal_guide_flow(style, 0.25, 1e-4, 2000, false);
    EXPECT_GT(unevenness(uneven.points) - 1.0, 4.0 * (unevenness(even.points) - 1.0));
    EXPECT_NEAR(test::polyline_length(uneven.points), test::polyline_length(even.points), 1e-3);
}

TEST(GuideFlow, AgreesWithTheLiteralFlowWhereThatIsWellPosed) {
    for (const double alpha : {0.0, 0.25}) {
        const Curve style = gentle(80);
        const reference::LiteralFlow expected = reference::literal_guide_flow(style, alpha, 1e-4, 2000);
        GuideFlowParams params;
        params.alpha = alpha;
        params.time = expected.time;
        params.growth = 0.02;
        const Flowed actual = flow(style, params);
        const double way = largest_distance(style, expected.points);
        EXPECT_GT(way, 0.05);
        EXPECT_LT(largest_distance(actual.guide, expected.points), 0.02 * way) << "alpha " << alpha;
    }
}

TEST(GuideFlow, FollowsTheLengthLaw) {
    for (const Curve& style : {test::coil(600), test::loops(400)}) {
        for (const double alpha : {0.0, 0.5, 0.8}) {
            double expected = test::polyline_length(style);
            const double first = expected;
            double before = bending(style);
            constexpr double step = 0.01;  // detail of size 0.6 vanishes at about 0.36 / (2 (1 - alpha))
            for (int k = 1; k <= 12; ++k) {
                GuideFlowParams params;
                params.alpha = alpha;
                params.time = k * step;
                params.growth = 0.02;
                const Flowed now = flow(style, params);
                const double after = bending(now.guide);
                expected += (alpha - 1.0) * step * 0.5 * (before + after);
                before = after;
                EXPECT_NEAR(now.length, expected, 0.04 * (first - expected))
                    << "alpha " << alpha << " time " << params.time;
                EXPECT_NEAR(now.length, test::polyline_length(now.guide), 1e-9 * first);
            }
            EXPECT_LT(expected, first);
        }
    }
}

TEST(GuideFlow, AlphaOneKeepsTheLength) {
    for (const test::NamedCurve& style : test::styles(300)) {
        GuideFlowParams params;
        params.alpha = 1.0;
        const Flowed flowed = flow(style.points, params);
        EXPECT_NEAR(flowed.length, test::polyline_length(style.points), 1e-3 * flowed.length) << style.name;
    }
}

TEST(GuideFlow, MoreAlphaKeepsMoreLength) {
    const Curve style = test::coil(400);
    double before = 0.0;
    for (const double alpha : {0.0, 0.3, 0.6, 0.9, 0.99}) {
        GuideFlowParams params;
        params.alpha = alpha;
        params.time = 0.1;
        const double length = flow(style, params).length;
        EXPECT_GT(length, before) << "alpha " << alpha;
        before = length;
    }
    EXPECT_GT(before, 0.99 * test::polyline_length(style));
}

TEST(GuideFlow, PointsAreEven) {
    for (const test::NamedCurve& style : test::styles(600)) {
        EXPECT_LT(unevenness(flow(style.points).guide), 1.05) << style.name;
    }
}

TEST(GuideFlow, EndsOfTheBareFlowStay) {
    for (const test::NamedCurve& style : test::styles(600)) {
        for (const double time : {1e-3, 1e-2, 0.1, 1.0}) {
            GuideFlowParams params;
            params.time = time;
            params.growth = 0.1;
            const Flowed flowed = flow(style.points, params);
            EXPECT_EQ(flowed.guide.front(), style.points.front()) << style.name;
            EXPECT_EQ(flowed.guide.back(), style.points.back()) << style.name;
            EXPECT_LT(unevenness(flowed.guide), 1.05) << style.name << " time " << time;
        }
    }
}

TEST(GuideFlow, StraightLineStays) {
    Curve line;
    for (int i = 0; i < 100; ++i) line.push_back(Vec3(1.0, 2.0, 3.0) + 0.03 * i * Vec3(1.0, -2.0, 0.5));
    EXPECT_LT(largest_distance(flow(line).guide, line), 1e-12);
}

TEST(GuideFlow, PlainBendsAreLeftAlone) {
    for (const double angle : {0.5, 1.5, 3.0}) {
        const Curve arc = test::even_curve(
            [angle](double u) { return Vec3(std::sin(angle * u), std::cos(angle * u), 0.1 * u); }, 300);
        const Flowed flowed = flow(arc);
        EXPECT_EQ(flowed.time, 0.0) << angle;
        EXPECT_EQ(largest_distance(flowed.guide, arc), 0.0) << angle;
    }
}

TEST(GuideFlow, DetailVanishesAndTheBendStays) {
    for (const Curve& style : {test::coil(600), test::sine(600)}) {
        const Flowed flowed = flow(style);
        const auto count = static_cast<int>(flowed.guide.size());
        for (int i = count / 5; i < count - count / 5; ++i) {
            const Vec3& p = flowed.guide[i];
            EXPECT_NEAR(p.head<2>().norm(), test::axis_radius, 0.5 * test::detail_size) << i;
            EXPECT_NEAR(p.z(), 0.0, 0.1 * test::detail_size) << i;
        }
        // The axis' bend has a height of 10 (1 - cos 0.6) = 1.75 over its chord, of which two thirds must be left.
        const double height = flowed.guide[count / 2].y() - test::axis(0.0).y();
        EXPECT_GT(height, 0.66 * 1.75);
        EXPECT_LT(flowed.length, 1.05 * 12.0);
    }
}

TEST(GuideFlow, LoopsAndZigzagsUnwind) {
    for (const test::NamedCurve& style : test::styles(500)) {
        const Flowed flowed = flow(style.points);
        const double chord = (style.points.back() - style.points.front()).norm();
        EXPECT_LT(flowed.length, 1.25 * chord) << style.name;
        EXPECT_GT(flowed.time, 0.0) << style.name;
    }
}

TEST(GuideFlow, MovesWithTheStyle) {
    for (const test::NamedCurve& style : test::styles(300)) {
        const Flowed here = flow(style.points);
        const Flowed there = flow(test::moved(style.points));
        EXPECT_EQ(here.steps, there.steps) << style.name;
        EXPECT_LT(largest_distance(test::moved(here.guide), there.guide), 1e-7 * there.length) << style.name;
    }
}

TEST(GuideFlow, SmoothingMultipliesTheTime) {
    const Curve style = test::sine(300);
    const Flowed usual = flow(style);
    double waving = bending(style);
    for (const double smoothing : {0.01, 0.1, 0.999999, 1.000001, 3.0}) {
        GuideFlowParams params;
        params.smoothing = smoothing;
        const Flowed flowed = flow(style, params);
        EXPECT_DOUBLE_EQ(flowed.time, smoothing * usual.time);
        EXPECT_LT(bending(flowed.guide), waving) << smoothing;
        waving = bending(flowed.guide);
    }
    GuideFlowParams params;
    params.smoothing = 1.0 + 1e-12;  // the flow starts anew then: it must arrive at the same curve
    EXPECT_LT(largest_distance(flow(style, params).guide, usual.guide), 1e-6);
}

TEST(GuideFlow, SlicingDoesNotChangeTheResult) {
    const Curve style = test::tremor(200);
    for (const double smoothing : {1.0, 0.7}) {
        GuideFlowParams params;
        params.smoothing = smoothing;
        const Flowed whole = flow(style, params);
        const Flowed sliced = flow(style, params, true);
        EXPECT_EQ(sliced.guide, whole.guide);
        EXPECT_EQ(sliced.steps, whole.steps);
    }
}

std::vector<test::NamedCurve> nasty() {
    std::vector<test::NamedCurve> out;
    const auto add = [&](const char* name, auto&& f) {
        Curve curve;
        for (int i = 0; i < 300; ++i) curve.push_back(f(i));
        out.push_back({name, curve});
    };
    add("turning back and forth", [](int i) { return Vec3(std::abs(i % 20 - 10), 0.0, 0.001 * i); });
    add("back and forth on itself", [](int i) { return Vec3(std::abs(i % 20 - 10), 0.0, 0.0); });
    add("reversing at each point", [](int i) { return Vec3(i % 2, 1e-3 * i, 0.0); });
    add("noise", [](int i) { return Vec3(random_unit(1, i, 0), random_unit(1, i, 1), random_unit(1, i, 2)); });
    add("closed circle", [](int i) {
        return Vec3(std::cos(2.0 * std::numbers::pi * i / 299), std::sin(2.0 * std::numbers::pi * i / 299), 0.0);
    });
    add("repeated points", [](int i) { return Vec3(i / 10, (i / 10) % 3, 0.0); });
    add("one place", [](int) { return Vec3(1.0, 2.0, 3.0); });
    add("tiny", [](int i) { return Vec3(1e-30 * i, 1e-30 * std::sin(i), 0.0); });
    add("huge", [](int i) { return Vec3(1e30 * i, 1e32 * std::sin(i), 0.0); });
    add("far away", [](int i) { return Vec3(1e6 + 0.01 * i, 1e6 + std::sin(0.3 * i), -1e6); });
    return out;
}

// How far a guide leaves its style's box, in parts of that.
double outside(const Curve& style, const Curve& guide) {
    Vec3 low = style[0], high = style[0];
    for (const Vec3& p : style) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double size = (high - low).norm(), rounding = 1e-9 * (low.cwiseAbs().maxCoeff() + high.cwiseAbs().maxCoeff());
    double most = 0.0;
    for (const Vec3& p : guide) {
        const double out = std::max((low - p).maxCoeff(), (p - high).maxCoeff());
        // True for what is not a number, too.
        if (!(out <= rounding)) most = std::max(most, size > 0.0 ? out / size : HUGE_VAL);
        if (!p.allFinite()) most = HUGE_VAL;
    }
    return most;
}

TEST(GuideFlow, NastyStylesStayInsideTheirBox) {
    for (const test::NamedCurve& style : nasty()) {
        const double length = test::polyline_length(style.points);
        for (const double alpha : {0.0, 0.5, 0.95, 1.0}) {
            for (const double time : {1e-6, 1e-3}) {
                if (length == 0.0) continue;
                GuideFlowParams params;
                params.alpha = alpha;
                params.time = time * length * length;
                const Flowed flowed = flow(style.points, params);
                EXPECT_LT(flowed.steps, 400u) << style.name;
                EXPECT_EQ(outside(style.points, flowed.guide), 0.0) << style.name;
                EXPECT_EQ(flowed.guide.front(), style.points.front()) << style.name;
                EXPECT_EQ(flowed.guide.back(), style.points.back()) << style.name;
            }
        }
    }
}

// Its ends and what it gives back to bends may lie a little outside.
TEST(GuideFlow, GuidesOfNastyStylesStayNearby) {
    for (const test::NamedCurve& style : nasty()) {
        for (const double alpha : {0.0, 0.5, 0.95, 1.0}) {
            for (const double smoothing : {0.1, 1.0, 30.0}) {
                GuideFlowParams params;
                params.alpha = alpha;
                params.smoothing = smoothing;
                const Flowed flowed = flow(style.points, params);
                EXPECT_LT(flowed.steps, 400u) << style.name;
                EXPECT_LE(outside(style.points, flowed.guide), 0.5) << style.name << ' ' << alpha << ' ' << smoothing;
            }
        }
    }
}

TEST(GuideFlow, TwoAndThreePoints) {
    const Curve two = {Vec3(0, 0, 0), Vec3(1, 0, 0)};
    EXPECT_EQ(flow(two).guide, two);
    const Curve three = {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(2, 0, 0)};
    const Flowed flowed = flow(three);
    EXPECT_EQ(flowed.guide.front(), three.front());
    EXPECT_EQ(flowed.guide.back(), three.back());
    EXPECT_NEAR(flowed.guide[1].x(), 1.0, 1e-12);
}

}  // namespace
}  // namespace flg
