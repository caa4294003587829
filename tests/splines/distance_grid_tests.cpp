// SPDX-License-Identifier: MIT
#include "splines/obstacles/distance_grid.h"

#include <functional>

#include "core/failure.h"
#include "runtime/run_now.h"
#include "splines/manifolds/implicit_surfaces.h"
#include "splines/surface_checks.h"

namespace flg::test {
namespace {

struct Grid {
    GridInput input;
    std::vector<float> values;

    Grid(std::array<uint32_t, 3> counts, double spacing, const Vec3& origin,
         const std::function<double(const Vec3&)>& f) {
        input.counts = counts;
        input.origin = {origin.x(), origin.y(), origin.z()};
        input.spacing = spacing;
        for (uint32_t k = 0; k < counts[2]; ++k) {
            for (uint32_t j = 0; j < counts[1]; ++j) {
                for (uint32_t i = 0; i < counts[0]; ++i) values.push_back(static_cast<float>(f(place(i, j, k))));
            }
        }
        input.values = values.data();
    }
    Grid(const Grid&) = delete;
    Vec3 place(uint32_t i, uint32_t j, uint32_t k) const {
        return Vec3(input.origin.data()) + input.spacing * Vec3(i, j, k);
    }
    DistanceGrid build(bool haltingly = false) const {
        return run_now(
            std::pmr::new_delete_resource(), [&](Pace& pace) { return interpolate(pace, input); }, haltingly);
    }
};

double waves(const Vec3& x) {
    return std::sin(3 * x.x()) + std::cos(2 * x.y()) * x.z() - 0.3;
}

TEST(DistanceGrid, PassesThroughItsSamples) {
    for (const auto& counts : {std::array<uint32_t, 3>{20, 13, 9}, {2, 2, 2}, {3, 40, 2}, {17, 16, 5}}) {
        const auto rough = [](const Vec3& x) { return std::sin(97 * x.x() + 31 * x.y() + 57 * x.z()); };
        const Grid grid(counts, 0.13, Vec3(-0.7, -0.4, -0.3), rough);
        const DistanceGrid surface = grid.build();
        const Vec3 middle = 0.5 * (grid.place(0, 0, 0) + grid.place(counts[0] - 1, counts[1] - 1, counts[2] - 1));
        size_t at = 0;
        for (uint32_t k = 0; k < counts[2]; ++k) {
            for (uint32_t j = 0; j < counts[1]; ++j) {
                for (uint32_t i = 0; i < counts[0]; ++i, ++at) {
                    // A little to the inside: rounding may put the last ones outside.
                    const Vec3 x = grid.place(i, j, k);
                    const SurfaceValue here = evaluate_at(surface, x + 1e-12 * (middle - x));
                    ASSERT_TRUE(here.defined);
                    EXPECT_NEAR(here.value, grid.values[at], 1e-6);
                }
            }
        }
    }
}

TEST(DistanceGrid, HasExactAndContinuousDerivatives) {
    const Grid grid({20, 21, 22}, 0.1, Vec3(-1, -1, -1), waves);
    const DistanceGrid surface = grid.build();
    for (const Vec3& x : random_points(100, 0.8)) {
        expect_exact_derivatives(surface, x, 100);
        EXPECT_NEAR(evaluate_at(surface, x).value, waves(x), 1e-3);
        // From cell to cell.
        const Vec3 knot(-1 + 0.1 * std::round((x.x() + 1) / 0.1), x.y(), x.z());
        const SurfaceValue before = evaluate_at(surface, knot - Vec3(1e-9, 0, 0));
        const SurfaceValue after = evaluate_at(surface, knot + Vec3(1e-9, 0, 0));
        EXPECT_LT((before.second - after.second).norm(), 1e-5);
    }
}

TEST(DistanceGrid, KeepsWhatIsLinear) {
    const Grid grid({7, 2, 5}, 0.5, Vec3(1, 2, 3), [](const Vec3& x) { return 2 * x.x() - x.y() + 0.5 * x.z() - 2; });
    const DistanceGrid surface = grid.build();
    for (const Vec3& x : random_points(100, 0.25)) {
        const SurfaceValue here = evaluate_at(surface, Vec3(2.5 + 5 * x.x(), 2.25 + x.y(), 4 + 3 * x.z()));
        ASSERT_TRUE(here.defined);
        EXPECT_LT((here.gradient - Vec3(2, -1, 0.5)).norm(), 1e-5);
        EXPECT_LT(here.second.norm(), 1e-4);
    }
}

// The fourth order of cubic splines.
TEST(DistanceGrid, OfATorusComesNearItQuickly) {
    const TorusSurface exact(1, 0.4);
    const auto f = [&](const Vec3& x) { return evaluate_at(exact, x).value; };
    double errors[2] = {}, forms[2] = {};
    for (int level = 0; level < 2; ++level) {
        const double spacing = level == 0 ? 0.1 : 0.05;
        const uint32_t wide = level == 0 ? 33 : 65, high = level == 0 ? 15 : 29;
        const Grid grid({wide, wide, high}, spacing, Vec3(-1.6, -1.6, -0.7), f);
        const DistanceGrid surface = grid.build();
        std::vector<double> none;
        for (const Vec3& start : random_points(200, 1.4)) {
            Vec3 x = start;
            ASSERT_TRUE(exact.project(x.data(), none.data()));
            ASSERT_TRUE(surface.project(x.data(), none.data()));
            errors[level] = std::max(errors[level], std::abs(f(x)));
            EXPECT_NEAR(evaluate_at(surface, x).value, 0, 1e-12);
            Eigen::Matrix<double, 3, 2> basis;
            exact.tangent_basis(x.data(), none.data(), basis.data());
            const Vec3 normal = evaluate_at(exact, x).gradient;
            Eigen::Matrix2d form, right;
            surface.second_form(x.data(), none.data(), basis.data(), normal.data(), form.data());
            exact.second_form(x.data(), none.data(), basis.data(), normal.data(), right.data());
            forms[level] = std::max(forms[level], (form - right).norm());
            if (level == 0) {
                expect_tangent_basis(surface, x, none);
                expect_second_form(surface, x, none, 1e-3);
            }
        }
    }
    EXPECT_LT(errors[0], 2e-3);
    EXPECT_LT(errors[1], errors[0] / 8);
    EXPECT_LT(forms[1], forms[0] / 2.5);
}

TEST(DistanceGrid, ComesBackFromOutside) {
    const Grid grid({21, 21, 21}, 0.1, Vec3(-1, -1, -1), [](const Vec3& x) { return x.norm() - 0.7; });
    const DistanceGrid surface = grid.build();
    EXPECT_FALSE(evaluate_at(surface, Vec3(1.01, 0, 0)).defined);
    EXPECT_FALSE(evaluate_at(surface, Vec3(0, 0, -1e300)).defined);
    std::vector<double> none;
    for (const Vec3& start : random_points(100, 3)) {
        Vec3 x = start;
        ASSERT_TRUE(surface.project(x.data(), none.data()));
        EXPECT_NEAR(x.norm(), 0.7, 1e-3);
        EXPECT_GT(x.dot(start), 0);
    }
}

// A surface that leaves the box ends at its sides: beyond them nothing is found, and the point stays.
TEST(DistanceGrid, EndsAtTheSidesOfItsBox) {
    const Grid grid({21, 21, 21}, 0.1, Vec3(-1, -1, -1), [](const Vec3& x) { return x.norm() - 1.3; });
    const DistanceGrid surface = grid.build();
    std::vector<double> none;
    Vec3 x(0.9, 0.8, 1);
    ASSERT_TRUE(surface.project(x.data(), none.data()));
    EXPECT_NEAR(x.norm(), 1.3, 1e-3);
    for (const Vec3& start : {Vec3(3, 0, 0), Vec3(0, 0.9, 0)}) {
        Vec3 lost = start;
        EXPECT_FALSE(surface.project(lost.data(), none.data()));
        EXPECT_EQ(lost, start);
    }
}

TEST(DistanceGrid, TakesTheSameBitsInAnySlices) {
    const Grid grid({20, 33, 18}, 0.1, Vec3(-1, -1, -1), waves);
    const DistanceGrid whole = grid.build(), sliced = grid.build(true);
    for (const Vec3& x : random_points(100, 0.6)) {
        const SurfaceValue a = evaluate_at(whole, x), b = evaluate_at(sliced, x);
        EXPECT_EQ(a.value, b.value);
        EXPECT_EQ(a.second, b.second);
    }
}

TEST(DistanceGrid, BadGridsFail) {
    const auto f = [](const Vec3& x) { return x.x() - 0.1; };
    EXPECT_THROW(Grid({1, 4, 4}, 0.1, Vec3::Zero(), f).build(), Failure) << "a layer";
    EXPECT_THROW(Grid({0, 4, 4}, 0.1, Vec3::Zero(), f).build(), Failure) << "nothing";
    EXPECT_THROW(Grid({4, 4, 4}, 0.1, Vec3(1, 0, 0), f).build(), Failure) << "all positive";
    EXPECT_THROW(Grid({4, 4, 4}, 0.1, Vec3(-1, 0, 0), f).build(), Failure) << "all negative";
    GridInput huge;
    huge.counts = {65536, 65536, 65536};
    EXPECT_THROW(run_now(std::pmr::new_delete_resource(), [&](Pace& pace) { return interpolate(pace, huge); }),
                 Failure);
}

}  // namespace
}  // namespace flg::test
