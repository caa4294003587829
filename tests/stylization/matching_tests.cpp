// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/literal_matching.h"
#include "runtime/run_now.h"
#include "stylization/guide_flow.h"
#include "stylization/guide_matching.h"
#include "test_curves.h"

namespace flg {
namespace {

using test::Curve;

struct Matched {
    std::vector<double> delta;
    double energy = 0.0;
};

Matched match(const SmoothStyleCurve& style, const Curve& guide, double beta, double farthest_step,
              bool haltingly = false) {
    const GuideMatch found = run_now(
        std::pmr::new_delete_resource(),
        [&](Pace& pace) { return match_guide(pace, style, guide, beta, farthest_step); }, haltingly);
    return {{found.places.begin(), found.places.end()}, found.energy};
}

// As in the paper: a step may be of any length.
Matched match(const SmoothStyleCurve& style, const Curve& guide, double beta) {
    return match(style, guide, beta, style.length());
}

SmoothStyleCurve smooth(const Curve& points) {
    return {points.data(), static_cast<uint32_t>(points.size()), test::polyline_length(points)};
}

Curve guide_of(const Curve& style) {
    const FlowedGuide guide = run_now(std::pmr::new_delete_resource(),
                                      [&](Pace& pace) { return guide_flow(pace, style, GuideFlowParams{}); });
    return {guide.points.begin(), guide.points.end()};
}

double point_energy(const SmoothStyleCurve& style, const Curve& guide, double beta, size_t i, double place) {
    const double even = style.length() * static_cast<double>(i) / static_cast<double>(guide.size() - 1);
    return beta * (guide[i] - style.evaluate(place).position).squaredNorm() +
           (1.0 - beta) * (place - even) * (place - even);
}

TEST(SmoothStyleCurve, PassesThroughItsPoints) {
    const Curve points = test::loops(50);
    const SmoothStyleCurve style = smooth(points);
    for (uint32_t i = 0; i < 50; ++i) {
        EXPECT_LT((style.evaluate(i * style.spacing()).position - points[i]).norm(), 1e-12);
        EXPECT_EQ(style.at_point(i).position, points[i]);
        EXPECT_LT((style.at_point(i).derivative - style.evaluate(i * style.spacing()).derivative).norm(), 1e-9);
    }
}

TEST(SmoothStyleCurve, DerivativesAreThoseOfThePosition) {
    const Curve points = test::loops(50);
    const SmoothStyleCurve style = smooth(points);
    const double e = 1e-5 * style.spacing();
    for (double s = 0.305 * style.spacing(); s < style.length() - e; s += 0.37 * style.spacing()) {
        const SmoothStyleCurve::Jet jet = style.evaluate(s);
        const SmoothStyleCurve::Jet before = style.evaluate(s - e);
        const SmoothStyleCurve::Jet after = style.evaluate(s + e);
        EXPECT_LT(((after.position - before.position) / (2 * e) - jet.derivative).norm(), 1e-6);
        EXPECT_LT(((after.derivative - before.derivative) / (2 * e) - jet.second_derivative).norm(), 1e-4);
    }
}

TEST(SmoothStyleCurve, CirclesAreRound) {
    double before = 0.0;
    for (const int count : {40, 80, 160}) {
        const Curve points =
            test::even_curve([](double u) { return Vec3(std::cos(5.0 * u), std::sin(5.0 * u), 0.0); }, count);
        const SmoothStyleCurve style(points.data(), static_cast<uint32_t>(count), 5.0);
        double error = 0.0;
        for (double s = 3.0 * style.spacing(); s < 5.0 - 3.0 * style.spacing(); s += 0.013) {
            error = std::max(error, (style.evaluate(s).position - Vec3(std::cos(s), std::sin(s), 0.0)).norm());
        }
        EXPECT_LT(error, 1e-4);
        if (before > 0.0) {
            EXPECT_LT(error, before / 6.0);  // third order
        }
        before = error;
    }
}

TEST(LiteralMatching, DiscreteOneFindsTheOptimumOfASmallProblem) {
    const Curve style = test::loops(7);
    const Curve guide = {style[0], Vec3(3, 1, 0), Vec3(5, 0.5, 0), style[6]};
    const double length = test::polyline_length(style);
    for (const bool strict : {false, true}) {
        double least = 1e300;
        for (int a = strict ? 1 : 0; a < 7; ++a) {
            for (int b = strict ? a + 1 : a; b < (strict ? 6 : 7); ++b) {
                double energy = 0.0;
                for (int i = 1; i <= 2; ++i) {
                    const int at = i == 1 ? a : b;
                    const double late = length * at / 6 - length * i / 3;
                    energy += 0.7 * (guide[i] - style[at]).squaredNorm() + 0.3 * late * late;
                }
                least = std::min(least, energy);
            }
        }
        EXPECT_NEAR(reference::match_discrete(style, length, guide, 0.7, strict).energy, least, 1e-12);
    }
}

TEST(GuideMatching, NoWorseThanDynamicProgramming) {
    for (const test::NamedCurve& named : test::styles(600)) {
        const SmoothStyleCurve style = smooth(named.points);
        const Curve guide = guide_of(named.points);
        for (const double beta : {0.3, 0.5, 0.9}) {
            const Matched found = match(style, guide, beta);
            const double discrete = reference::match_discrete(named.points, style.length(), guide, beta, false).energy;
            EXPECT_LE(found.energy, discrete) << named.name << " beta " << beta;
            double energy = 0.0;
            for (size_t i = 1; i + 1 < guide.size(); ++i) energy += point_energy(style, guide, beta, i, found.delta[i]);
            EXPECT_NEAR(found.energy, energy, 1e-4 * energy) << named.name << " beta " << beta;
        }
    }
}

TEST(GuideMatching, NoWorseThanTheGradientDescent) {
    // The descent stops in the minimum next to the even matching; it may be the best one, then both find it.
    for (const test::NamedCurve& named : test::styles(300)) {
        const SmoothStyleCurve style = smooth(named.points);
        const Curve guide = guide_of(named.points);
        const double literal = reference::match_by_gradient(named.points, style.length(), guide, 0.5, 300).energy;
        EXPECT_LE(match(style, guide, 0.5).energy, literal * 1.001) << named.name;
    }
}

TEST(GuideMatching, FewerGuidePointsThanStylePoints) {
    for (const test::NamedCurve& named : test::styles(600)) {
        const SmoothStyleCurve style = smooth(named.points);
        const Curve fine = guide_of(named.points);
        Curve guide;
        for (size_t i = 0; i < 100; ++i) guide.push_back(fine[i * 599 / 99]);
        const double discrete = reference::match_discrete(named.points, style.length(), guide, 0.5, true).energy;
        EXPECT_LE(match(style, guide, 0.5).energy, discrete) << named.name;
    }
}

TEST(GuideMatching, IsInOrderBetweenFixedEnds) {
    for (const test::NamedCurve& named : test::styles(400)) {
        const SmoothStyleCurve style = smooth(named.points);
        for (const double beta : {0.01, 0.5, 0.99, 0.999999}) {
            const std::vector<double> delta = match(style, guide_of(named.points), beta).delta;
            EXPECT_EQ(delta.front(), 0.0);
            EXPECT_EQ(delta.back(), style.length());
            EXPECT_TRUE(std::is_sorted(delta.begin(), delta.end())) << named.name << " beta " << beta;
        }
    }
}

TEST(GuideMatching, NoPointAloneCanDoBetterNearby) {
    for (const test::NamedCurve& named : test::styles(400)) {
        const SmoothStyleCurve style = smooth(named.points);
        const Curve guide = guide_of(named.points);
        const std::vector<double> delta = match(style, guide, 0.5).delta;
        const double step = 0.05 * style.spacing();
        for (size_t i = 1; i + 1 < guide.size(); ++i) {
            const double here = point_energy(style, guide, 0.5, i, delta[i]);
            for (const double there :
                 {std::max(delta[i] - step, delta[i - 1]), std::min(delta[i] + step, delta[i + 1])}) {
                EXPECT_LE(here, point_energy(style, guide, 0.5, i, there) + 1e-12) << named.name << " point " << i;
            }
        }
    }
}

TEST(GuideMatching, StyleMatchesItselfEvenly) {
    for (const test::NamedCurve& named : test::styles(300)) {
        const SmoothStyleCurve style = smooth(named.points);
        const Matched found = match(style, named.points, 0.9);
        for (size_t i = 0; i < 300; ++i) {
            EXPECT_NEAR(found.delta[i], style.spacing() * static_cast<double>(i), 1e-9 * style.length()) << named.name;
        }
        EXPECT_LT(found.energy, 1e-18 * style.length() * style.length());
    }
}

TEST(GuideMatching, StraightStyleHasAClosedForm) {
    // Style s -> (s, 0, 0), guide g_i = (x_i, 1, 0): delta_i = beta x_i + (1 - beta) e_i, wherever that is in order.
    const int count = 101;
    Curve points;
    Curve guide;
    for (int i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / (count - 1);
        points.push_back(Vec3(10.0 * u, 0.0, 0.0));
        guide.push_back(Vec3(10.0 * u * u, 1.0, 0.0));
    }
    const std::vector<double> delta = match(smooth(points), guide, 0.7).delta;
    for (int i = 1; i + 1 < count; ++i) {
        const double u = static_cast<double>(i) / (count - 1);
        EXPECT_NEAR(delta[i], 10.0 * (0.7 * u * u + 0.3 * u), 1e-9) << i;
    }
}

TEST(GuideMatching, PointsThatWouldPassEachOtherShareTheirMean) {
    // The same with a guide that runs backwards: every pair is out of order, so all meet at the mean.
    const int count = 51;
    Curve points;
    Curve guide;
    for (int i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / (count - 1);
        points.push_back(Vec3(10.0 * u, 0.0, 0.0));
        guide.push_back(Vec3(10.0 * (1.0 - u), 1.0, 0.0));
    }
    const std::vector<double> delta = match(smooth(points), guide, 0.9).delta;
    for (int i = 1; i + 1 < count; ++i) EXPECT_NEAR(delta[i], 5.0, 1e-9) << i;
}

// Steps of floats that are differences of sums.
constexpr double rounding = 1e-12;

TEST(GuideMatching, NoStepIsLongerThanTheBound) {
    for (const test::NamedCurve& named : test::styles(400)) {
        const SmoothStyleCurve style = smooth(named.points);
        const Curve guide = guide_of(named.points);
        for (const double beta : {0.01, 0.5, 0.99, 0.999999}) {
            for (const double bound : {1.0, 1.1, 2.0}) {
                const std::vector<double> delta = match(style, guide, beta, bound * style.spacing()).delta;
                EXPECT_EQ(delta.front(), 0.0);
                EXPECT_EQ(delta.back(), style.length());
                EXPECT_TRUE(std::is_sorted(delta.begin(), delta.end())) << named.name << " beta " << beta;
                for (size_t i = 1; i < delta.size(); ++i) {
                    ASSERT_LE(delta[i] - delta[i - 1], bound * style.spacing() + rounding * style.length())
                        << named.name << " beta " << beta << " point " << i;
                }
            }
        }
    }
}

// A straight style and a guide that jumps half way: places go up to the jump as they would alone, over it by the
// longest steps, and the places of these are off their own minima by as much ahead as behind.
TEST(GuideMatching, BoundedStepsHaveAClosedForm) {
    const int count = 101;
    Curve points, guide;
    for (int i = 0; i < count; ++i) {
        const double x = 10.0 * i / (count - 1);
        points.push_back(Vec3(x, 0, 0));
        guide.push_back(Vec3(0.5 * x + (i < 60 ? 0 : 5), 1, 0));
    }
    const double bound = 0.3;
    const auto alone = [&](int i) { return 0.8 * guide[i].x() + 0.2 * points[i].x(); };
    const std::vector<double> delta = match(smooth(points), guide, 0.8, bound).delta;
    double off = 0;
    int held = 0;
    for (int i = 1; i + 1 < count; ++i) {
        if (std::abs(delta[i] - alone(i)) < 1e-9) continue;
        ++held;
        off += delta[i] - alone(i);
        EXPECT_TRUE(std::abs(delta[i] - delta[i - 1] - bound) < 1e-9 ||
                    std::abs(delta[i + 1] - delta[i] - bound) < 1e-9)
            << i;
        EXPECT_EQ(delta[i] > alone(i), i < 60) << i;
    }
    EXPECT_GE(held, 16);  // 4 m less 0.06 a point, at 0.3 a step
    EXPECT_LE(held, 19);
    EXPECT_NEAR(off, 0, 1e-8);
}

// Convex, where the style is straight: nowhere towards any other places within order and bound does the energy fall.
TEST(GuideMatching, BoundedPlacesAreTheBest) {
    const int count = 60;
    Curve points, guide;
    for (int i = 0; i < count; ++i) {
        points.push_back(Vec3(10.0 * i / (count - 1), 0, 0));
        guide.push_back(Vec3(10.0 * random_unit(3, 0, static_cast<uint64_t>(i)), 1, 0));
    }
    const SmoothStyleCurve style = smooth(points);
    for (const double bound : {1.05, 1.4, 3.0}) {
        const double step = bound * style.spacing();
        const std::vector<double> delta = match(style, guide, 0.9, step).delta;
        for (uint64_t trial = 0; trial < 300; ++trial) {
            // Steps between 0 and the bound that sum to the length: mixed from even ones and some that are shared out.
            std::vector<double> other(count, 0.0);
            double left = style.length();
            for (int i = 1; i < count; ++i) {
                const double least = std::max(0.0, left - step * (count - 1 - i)), most = std::min(step, left);
                const double drawn = random_unit(100 + trial, 0, static_cast<uint64_t>(i)) < 0.5 ? least : most;
                other[i] = other[i - 1] + drawn;
                left -= drawn;
            }
            double slope = 0;
            for (int i = 1; i + 1 < count; ++i) {
                const double alone = 0.9 * guide[i].x() + 0.1 * points[i].x();
                slope += (delta[i] - alone) * (other[i] - delta[i]);
            }
            ASSERT_GE(slope, -1e-7) << bound << " trial " << trial;
        }
    }
}

TEST(GuideMatching, MovesWithTheCurves) {
    for (const test::NamedCurve& named : test::styles(300)) {
        const Curve guide = guide_of(named.points);
        const Curve other = test::moved(named.points);
        const SmoothStyleCurve style = smooth(named.points);
        const std::vector<double> here = match(style, guide, 0.5).delta;
        const std::vector<double> there = match(smooth(other), test::moved(guide), 0.5).delta;
        for (size_t i = 0; i < here.size(); ++i) {
            EXPECT_NEAR(test::moved_scale * here[i], there[i], 1e-7 * test::moved_scale * style.length()) << named.name;
        }
    }
}

TEST(GuideMatching, SlicingDoesNotChangeTheResult) {
    const Curve points = test::loops(300);
    const Curve guide = guide_of(points);
    const SmoothStyleCurve style = smooth(points);
    for (const double beta : {0.5, 0.95}) {
        for (const double step : {1.4 * style.spacing(), style.length()}) {
            EXPECT_EQ(match(style, guide, beta, step, true).delta, match(style, guide, beta, step).delta);
        }
    }
}

TEST(GuideMatching, FewPoints) {
    const Curve two = {Vec3(0, 0, 0), Vec3(2, 0, 0)};
    EXPECT_EQ(match(smooth(two), two, 0.5).delta, (std::vector<double>{0.0, 2.0}));
    const Curve three = {Vec3(0, 0, 0), Vec3(1.5, 1, 0), Vec3(2, 0, 0)};
    EXPECT_NEAR(match(smooth(two), three, 0.5).delta[1], 1.25, 1e-9);
    EXPECT_EQ(match(smooth(three), two, 0.5).delta.size(), 2u);
}

}  // namespace
}  // namespace flg
