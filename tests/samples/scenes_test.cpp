// SPDX-License-Identifier: MIT
// The built-in scene: what benchmarks and pictures rest on.
#include "scenes/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace flg::scenes {
namespace {

using State = std::array<double, 3>;

bool same_bits(const Curve& a, const Curve& b) {
    return a.points.size() == b.points.size() && a.radii == b.radii &&
           std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(Point)) == 0;
}

double distance(const Point& a, const Point& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

void expect_usable(const Curve& curve, const std::string& name) {
    for (const Point& p : curve.points) {
        ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) << name;
    }
    for (size_t i = 1; i < curve.points.size(); ++i) {
        ASSERT_GT(distance(curve.points[i - 1], curve.points[i]), 0.0) << name << " repeats point " << i;
    }
    if (!curve.radii.empty()) {
        ASSERT_EQ(curve.radii.size(), curve.points.size()) << name;
        EXPECT_GT(*std::min_element(curve.radii.begin(), curve.radii.end()), 0.0f) << name;
    }
}

State add(const State& p, const State& v, double h) {
    return {p[0] + h * v[0], p[1] + h * v[1], p[2] + h * v[2]};
}

// A method of another kind than the generator's: Heun's, in many small steps.
State integrate(const Attractor& attractor, State p, double time) {
    constexpr int kSteps = 400;
    const double h = time / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const State a = attractor.velocity(p);
        const State b = attractor.velocity(add(p, a, h));
        p = {p[0] + 0.5 * h * (a[0] + b[0]), p[1] + 0.5 * h * (a[1] + b[1]), p[2] + 0.5 * h * (a[2] + b[2])};
    }
    return p;
}

// Undoes the picture's turn, scale and shift.
State state_of(const Attractor& attractor, const Point& p) {
    const double s = attractor.metres;
    return {p.x / s + attractor.centre[0], -p.z / s + attractor.centre[1], p.y / s + attractor.centre[2]};
}

void expect_trajectory(const Attractor& attractor, const Curve& curve) {
    for (size_t i = 0; i + 1 < curve.points.size(); i += 37) {
        const State predicted = integrate(attractor, state_of(attractor, curve.points[i]), attractor.step);
        const State actual = state_of(attractor, curve.points[i + 1]);
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(predicted[c], actual[c], 2e-5) << "after point " << i;
    }
}

TEST(Scenes, StylesHaveTheirCountsAndNoRepeatedPoints) {
    ASSERT_GE(style_names().size(), 6u);
    for (const std::string& name : style_names()) {
        const Curve style = make_style(name);
        EXPECT_GE(style.points.size(), 150u) << name;
        EXPECT_LE(style.points.size(), 600u) << name;
        EXPECT_FALSE(style.closed) << name;
        EXPECT_EQ(style.radii.size(), style.points.size()) << name;
        expect_usable(style, name);
    }
}

TEST(Scenes, StylesDifferFromEachOtherAndFromTheirMirrorImage) {
    for (const std::string& name : style_names()) {
        for (const std::string& other : style_names()) {
            EXPECT_EQ(same_bits(make_style(name), make_style(other)), name == other);
        }
        // Drawn by hand: the second half is not the first half again.
        const Curve style = make_style(name);
        const size_t half = style.points.size() / 2;
        double difference = 0.0;
        for (size_t i = 0; i < half; ++i) {
            difference += std::abs(style.points[i].y - style.points[half + i].y) / static_cast<double>(half);
        }
        EXPECT_GT(difference, 1e-3) << name;
    }
}

TEST(Scenes, TargetsHaveTheCountAskedFor) {
    for (const std::string& name : target_names()) {
        for (uint32_t count : {2u, 3u, 500u, 12345u}) {
            const Curve target = make_target(name, count);
            EXPECT_EQ(target.points.size(), count) << name;
            expect_usable(target, name);
        }
        EXPECT_GE(make_target(name).points.size(), 200u) << name;
    }
    EXPECT_EQ(make_target("thomas").points.size(), 369400u);
}

TEST(Scenes, UnknownNamesGiveNothing) {
    EXPECT_TRUE(make_style("nosuch").points.empty());
    EXPECT_TRUE(make_target("nosuch").points.empty());
    EXPECT_TRUE(make_target("").points.empty());
}

TEST(Scenes, SameNameSameBits) {
    for (const std::string& name : style_names()) EXPECT_TRUE(same_bits(make_style(name), make_style(name))) << name;
    for (const std::string& name : target_names()) {
        EXPECT_TRUE(same_bits(make_target(name, 5000), make_target(name, 5000))) << name;
    }
}

TEST(Scenes, LongerAttractorsContinueShorterOnes) {
    for (const char* name : {"lorenz", "thomas"}) {
        const Curve longer = make_target(name, 4000);
        Curve head = longer;
        head.points.resize(1500);
        EXPECT_TRUE(same_bits(head, make_target(name, 1500))) << name;
    }
}

TEST(Scenes, LorenzIsATrajectoryOfItsEquations) {
    expect_trajectory(lorenz(), make_target("lorenz", 8000));
}

TEST(Scenes, ThomasIsATrajectoryOfItsEquations) {
    expect_trajectory(thomas(), make_target("thomas", 8000));
}

TEST(Scenes, AttractorsStayInTheirTrappingRegions) {
    // rho x^2 + sigma y^2 + sigma (z - 2 rho)^2 can't grow where it is above sigma rho^2 beta^2 / (beta - 1).
    const double rho = 28.0, sigma = 10.0, beta = 8.0 / 3.0;
    const double most = sigma * rho * rho * beta * beta / (beta - 1.0);
    for (const Point& p : make_target("lorenz", 50000).points) {
        const State s = state_of(lorenz(), p);
        const double height = s[2] - 2.0 * rho;
        EXPECT_LE(rho * s[0] * s[0] + sigma * (s[1] * s[1] + height * height), most);
    }
    // |sin| <= 1, so |x| can't grow where it is above 1 / b.
    for (const Point& p : make_target("thomas", 50000).points) {
        for (double c : state_of(thomas(), p)) EXPECT_LE(std::abs(c), 1.0 / 0.208186);
    }
}

TEST(Scenes, BouquetIsUsable) {
    const std::vector<Curve> bouquet = make_bouquet();
    EXPECT_GE(bouquet.size(), 10u);
    for (const Curve& curve : bouquet) {
        expect_usable(curve, "bouquet");
        EXPECT_FALSE(curve.radii.empty());
    }
}

}  // namespace
}  // namespace flg::scenes
