// SPDX-License-Identifier: MIT
// Surfaces by functions of two parameters: footpoints against closed forms and brute force, periods, ends of the
// domain.
#include "splines/manifolds/parametric_patch.h"

#include <memory>
#include <numbers>

#include "splines/manifold_checks.h"
#include "splines/standard_patches.h"

namespace flg::test {
namespace {

Memory* memory() {
    return std::pmr::get_default_resource();
}

std::vector<std::unique_ptr<ParametricPatch>> patches() {
    std::vector<std::unique_ptr<ParametricPatch>> all;
    all.push_back(std::make_unique<TorusPatch>(2.0, 0.7, memory()));
    all.push_back(std::make_unique<WavePatch>(0.3, 2.5, 2.0, memory()));
    all.push_back(std::make_unique<MonkeySaddlePatch>(1.5, 1.2, memory()));
    return all;
}

TEST(ParametricPatch, IsConsistent) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0.1, 0.9);
    for (const auto& patch : patches()) {
        for (int i = 0; i < 20; ++i) {
            double at[2];
            for (int k = 0; k < 2; ++k) {
                const PatchDomain& d = patch->domain();
                at[k] = d.low[k] + (d.high[k] - d.low[k]) * share(random);
            }
            const PatchPoint p = patch->evaluate(at[0], at[1]);
            const Vec3 x = p.at + 0.05 * p.u.cross(p.v).normalized();
            expect_consistent(*patch, {x.x(), x.y(), x.z()}, 3e-6);
        }
    }
}

TEST(ParametricPatch, DerivativesAreThoseOfThePoints) {
    constexpr double h = 1e-5;
    for (const auto& patch : patches()) {
        const PatchPoint p = patch->evaluate(0.4, 0.7), e = patch->evaluate(0.4 + h, 0.7),
                         w = patch->evaluate(0.4 - h, 0.7);
        const PatchPoint n = patch->evaluate(0.4, 0.7 + h), s = patch->evaluate(0.4, 0.7 - h);
        EXPECT_LT(((e.at - w.at) / (2 * h) - p.u).norm(), 1e-8);
        EXPECT_LT(((n.at - s.at) / (2 * h) - p.v).norm(), 1e-8);
        EXPECT_LT(((e.u - w.u) / (2 * h) - p.uu).norm(), 1e-8);
        EXPECT_LT(((e.v - w.v) / (2 * h) - p.uv).norm(), 1e-8);
        EXPECT_LT(((n.u - s.u) / (2 * h) - p.uv).norm(), 1e-8);
        EXPECT_LT(((n.v - s.v) / (2 * h) - p.vv).norm(), 1e-8);
    }
}

// The nearest point of a torus lies in the plane through its axis, on the way to the middle of the tube.
TEST(ParametricPatch, FootpointOfTheTorusInClosedForm) {
    const TorusPatch torus(2.0, 0.7, memory());
    std::mt19937 random(9);
    std::uniform_real_distribution<double> place(-3, 3);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 x(place(random), place(random), place(random));
        const Vec3 middle = 2.0 * Vec3(x.x(), x.y(), 0).normalized();
        if ((x - middle).norm() < 0.05 || std::hypot(x.x(), x.y()) < 0.05) continue;
        const Vec3 foot = middle + 0.7 * (x - middle).normalized();
        Vec3 found = x;
        std::vector<double> own(3);
        ASSERT_TRUE(torus.project(found.data(), own.data())) << i;
        EXPECT_LT((found - foot).norm(), 1e-12) << i;
        EXPECT_LT((torus.evaluate(own[0], own[1]).at - found).norm(), 1e-14);
    }
}

TEST(ParametricPatch, NothingOfAFineGridIsNearer) {
    const auto all = patches();
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-0.9, 0.9);
    for (const auto& patch : all) {
        for (int i = 0; i < 30; ++i) {
            const Vec3 x(place(random), place(random), 0.3 * place(random));
            Vec3 found = x;
            std::vector<double> own(3);
            ASSERT_TRUE(patch->project(found.data(), own.data()));
            double least = 1e9;
            const PatchDomain& d = patch->domain();
            for (int j = 0; j <= 150 * 150; ++j) {
                const double u = d.low[0] + (d.high[0] - d.low[0]) * (j % 150) / 150.0;
                const double v = d.low[1] + (d.high[1] - d.low[1]) * (j / 150) / 150.0;
                least = std::min(least, (patch->evaluate(u, v).at - x).norm());
            }
            EXPECT_LE((found - x).norm(), least + 1e-12);
        }
    }
}

// Small steps through the seams of both periods come home, and never see an end.
TEST(ParametricPatch, PeriodsHaveNoSeam) {
    const TorusPatch torus(2.0, 0.7, memory());
    std::vector<double> own(3);
    Vec3 x = torus.evaluate(0.1, 0.1).at;
    ASSERT_TRUE(torus.project(x.data(), own.data()));
    constexpr int steps = 400;
    for (int i = 1; i <= steps; ++i) {
        const double turn = 2 * std::numbers::pi * i / steps;
        const Vec3 target = torus.evaluate(0.1 + 2 * turn, 0.1 - turn).at;
        x = target;
        ASSERT_TRUE(torus.project(x.data(), own.data()));
        EXPECT_LT((x - target).norm(), 1e-13);
        EXPECT_GE(own[0], 0);
        EXPECT_LT(own[0], 2 * std::numbers::pi + 1e-12);
    }
    EXPECT_NEAR(own[0], 0.1, 1e-12);
    EXPECT_NEAR(own[1], 0.1, 1e-12);
}

TEST(ParametricPatch, DomainsEndBeyondTheirMargin) {
    const MonkeySaddlePatch saddle(1.5, 1.0, memory());
    std::vector<double> own(3);
    Vec3 inside = saddle.evaluate(1.09, 0.2).at, outside = saddle.evaluate(1.15, 0.2).at, far(5, 5, 0);
    EXPECT_TRUE(saddle.project(inside.data(), own.data()));
    for (Vec3 x : {outside, far, Vec3(0, std::numeric_limits<double>::quiet_NaN(), 0)}) {
        const Vec3 before = x;
        const std::vector<double> remembered = own;
        EXPECT_FALSE(saddle.project(x.data(), own.data()));
        EXPECT_EQ(own, remembered);
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(x[i] == before[i] || std::isnan(x[i]));
    }
}

// Memory disambiguates but does not decide: from near parameters and from none the same point is found.
TEST(ParametricPatch, MemoryDoesNotChangeWhatIsFound) {
    for (const auto& patch : patches()) {
        std::vector<double> own{0.5, 0.4, 1}, none(3);
        Vec3 x = patch->evaluate(0.6, 0.35).at + Vec3(0.01, -0.02, 0.05), y = x;
        ASSERT_TRUE(patch->project(x.data(), own.data()));
        ASSERT_TRUE(patch->project(y.data(), none.data()));
        EXPECT_LT((x - y).norm(), 1e-13);
    }
}

}  // namespace
}  // namespace flg::test
