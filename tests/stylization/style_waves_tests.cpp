// SPDX-License-Identifier: MIT
#include "stylization/style_waves.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/run_now.h"
#include "test_curves.h"

namespace flg {
namespace {

using test::Curve;

constexpr double tau = 2.0 * std::numbers::pi;
// The low edge of a pure wave's spectrum, of the wave.
constexpr double edge = 0.61;

double waves_of(const Curve& style, bool haltingly = false) {
    return run_now(
        std::pmr::new_delete_resource(), [&](Pace& pace) { return count_waves(pace, style); }, haltingly);
}

Curve sine(double waves, double height, int count, double bend = 0.0) {
    return test::even_curve(
        [=](double u) {
            return Vec3(u, height / waves * std::sin(tau * waves * u) + bend * std::sin(std::numbers::pi * u), 0.0);
        },
        count);
}

TEST(StyleWaves, AreCounted) {
    for (const double waves : {4.0, 7.0, 16.0, 40.0}) {
        for (const double height : {0.03, 0.3, 1.0}) {
            EXPECT_NEAR(waves_of(sine(waves, height, 1200)), edge * waves, 0.12 * waves) << waves << ' ' << height;
        }
    }
}

TEST(StyleWaves, AreCountedOnABend) {
    for (const double waves : {7.0, 16.0, 40.0}) {
        EXPECT_NEAR(waves_of(sine(waves, 0.3, 1200, 0.4)), edge * waves, 0.15 * waves) << waves;
    }
}

TEST(StyleWaves, OvertonesBelongToTheirWaves) {
    const Curve corners = test::even_curve(
        [](double u) { return Vec3(u, 0.2 * std::abs(2.0 * (8.0 * u - std::floor(8.0 * u)) - 1.0), 0.0); }, 600);
    EXPECT_NEAR(waves_of(corners), edge * 8.0, 1.0);
    const Curve eights = test::even_curve(
        [](double u) { return Vec3(u - 0.03 * std::sin(2.0 * tau * 8.0 * u), 0.04 * std::sin(tau * 8.0 * u), 0.0); },
        600);
    EXPECT_NEAR(waves_of(eights), edge * 8.0, 1.5);
}

TEST(StyleWaves, OfTwoKindsFarApartTheShorterCount) {
    const Curve both = test::even_curve(
        [](double u) { return Vec3(u, 0.12 * std::sin(tau * 3.0 * u) + 0.01 * std::sin(tau * 40.0 * u), 0.0); }, 1200);
    EXPECT_NEAR(waves_of(both), edge * 40.0, 6.0);
}

TEST(StyleWaves, PlainBendsHaveNone) {
    for (const double angle : {0.0, 0.5, 1.5, 3.0, 4.5, 6.2}) {
        const Curve arc = test::even_curve(
            [angle](double u) {
                return angle > 0.0 ? Vec3(std::sin(angle * u), std::cos(angle * u), 0.1 * u) : Vec3(u, 2.0 * u, 0.0);
            },
            300);
        EXPECT_EQ(waves_of(arc), 0.0) << angle;
    }
    EXPECT_EQ(waves_of(sine(1.0, 0.3, 300)), 0.0) << "an S";
    EXPECT_EQ(waves_of({Vec3(0, 0, 0), Vec3(1, 0, 0)}), 0.0);
    EXPECT_EQ(waves_of({Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(2, 0, 0)}), 0.0);
    EXPECT_EQ(waves_of(Curve(300, Vec3(1, 2, 3))), 0.0) << "no length";
}

TEST(StyleWaves, DoNotDependOnPlaceSizeDirectionAndSampling) {
    for (const int count : {500, 600, 1000}) {
        for (const test::NamedCurve& style : test::styles(count)) {
            const double waves = waves_of(style.points);
            EXPECT_NEAR(waves_of(test::moved(style.points)), waves, 1e-6 * waves) << style.name;
            Curve backwards = style.points;
            std::reverse(backwards.begin(), backwards.end());
            EXPECT_NEAR(waves_of(backwards), waves, 1e-6 * waves) << style.name;
        }
    }
    const auto coarse = test::styles(500), fine = test::styles(1000);
    for (size_t i = 0; i < fine.size(); ++i) {
        const double waves = waves_of(fine[i].points);
        EXPECT_NEAR(waves_of(coarse[i].points), waves, 0.03 * waves) << fine[i].name;
    }
}

TEST(StyleWaves, SlicingDoesNotChangeTheResult) {
    EXPECT_EQ(waves_of(test::tremor(400), true), waves_of(test::tremor(400)));
}

}  // namespace
}  // namespace flg
