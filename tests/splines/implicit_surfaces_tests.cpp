// SPDX-License-Identifier: MIT
#include "splines/manifolds/implicit_surfaces.h"

#include <set>

#include "splines/manifolds/space_jet.h"
#include "splines/surface_checks.h"

namespace flg::test {
namespace {

TEST(ImplicitSurfaces, DistancesAreDistances) {
    const SphereSurface sphere(1.5);
    const TorusSurface torus(1, 0.3);
    const PlaneSurface plane(2);
    std::vector<double> none;
    for (const Vec3& x : random_points(200, 2)) {
        EXPECT_DOUBLE_EQ(evaluate_at(sphere, x).value, x.norm() - 1.5);
        const Vec3 circle = Vec3(x.x(), x.y(), 0).normalized();
        EXPECT_NEAR(evaluate_at(torus, x).value, (x - circle).norm() - 0.3, 1e-15);
        for (const Hypersurface* surface :
             {static_cast<const Hypersurface*>(&sphere), static_cast<const Hypersurface*>(&torus),
              static_cast<const Hypersurface*>(&plane)}) {
            EXPECT_NEAR(evaluate_at(*surface, x).gradient.norm(), 1, 1e-14);
            Vec3 foot = x;
            ASSERT_TRUE(surface->project(foot.data(), none.data()));
            const SurfaceValue there = evaluate_at(*surface, foot);
            EXPECT_NEAR(there.value, 0, 1e-15);
            EXPECT_LT((x - foot).cross(there.gradient).norm(), 1e-14) << "straight down";
            EXPECT_NEAR((x - foot).norm(), std::abs(evaluate_at(*surface, x).value), 1e-14);
            expect_exact_derivatives(*surface, foot);
            expect_tangent_basis(*surface, foot, none);
            expect_second_form(*surface, foot, none);
        }
    }
}

TEST(ImplicitSurfaces, WhereTheyAreNotDefinedAPointStaysWhereItIs) {
    std::vector<double> none;
    const SphereSurface sphere(1.5);
    Vec3 middle = Vec3::Zero();
    EXPECT_FALSE(sphere.project(middle.data(), none.data()));
    EXPECT_EQ(middle, Vec3::Zero());
    const TorusSurface torus(1, 0.3);
    for (const Vec3& place : {Vec3(0, 0, 0.5), Vec3(0, 1, 0)}) {
        Vec3 x = place;
        EXPECT_FALSE(torus.project(x.data(), none.data()));
        EXPECT_EQ(x, place);
    }
}

TEST(ImplicitSurfaces, SecondFormsAreThoseOfTheTextbook) {
    std::vector<double> none;
    Eigen::Matrix<double, 3, 2> basis;
    Eigen::Matrix2d form;
    const SphereSurface sphere(2);
    const Vec3 x(0, 0, 2);
    sphere.tangent_basis(x.data(), none.data(), basis.data());
    sphere.second_form(x.data(), none.data(), basis.data(), Vec3(5, 7, 1).eval().data(), form.data());
    EXPECT_LT((form + 0.5 * Eigen::Matrix2d::Identity()).norm(), 1e-15) << "towards the middle, 1 / R";
    const TorusSurface torus(1, 0.25);
    const Vec3 inner(0.75, 0, 0);
    torus.tangent_basis(inner.data(), none.data(), basis.data());
    torus.second_form(inner.data(), none.data(), basis.data(), Vec3(-1, 0, 0).eval().data(), form.data());
    EXPECT_NEAR(form.determinant(), -4 / 0.75, 1e-12) << "Gauss's curvature cos v / (r (R + r cos v))";
    EXPECT_NEAR(form.trace(), -4 + 1 / 0.75, 1e-12);
}

TEST(ImplicitSurfaces, NamesAreFound) {
    std::set<std::string> names;
    for (const ImplicitFormula& formula : implicit_formulas()) {
        EXPECT_EQ(find_implicit_formula(formula.name), &formula);
        EXPECT_TRUE(names.empty() || *names.rbegin() < formula.name) << "in order";
        names.insert(formula.name);
    }
    EXPECT_GE(names.size(), 6u);
    EXPECT_EQ(find_implicit_formula("genus"), nullptr);
    EXPECT_EQ(find_implicit_formula(""), nullptr);
}

class NamedSurfaces : public testing::TestWithParam<ImplicitFormula> {};

TEST_P(NamedSurfaces, AreSmoothAndReached) {
    const NamedSurface surface(GetParam());
    std::vector<double> none;
    size_t reached = 0, compared = 0;
    const std::vector<Vec3> points = random_points(300, 0.6 * surface.size());
    for (const Vec3& x : points) {
        Vec3 foot = x;
        if (!surface.project(foot.data(), none.data())) {
            EXPECT_EQ(foot, x);
            continue;
        }
        ++reached;
        const SurfaceValue there = evaluate_at(surface, foot);
        const double slope = there.gradient.norm();
        EXPECT_LT(std::abs(there.value), 1e-12 * slope);
        EXPECT_GT(slope, 0.01) << foot.transpose();
        if (GetParam().bounded) {
            EXPECT_LT(foot.cwiseAbs().maxCoeff(), 0.6 * surface.size());
        }
        expect_exact_derivatives(surface, foot, 1000);
        expect_tangent_basis(surface, foot, none);
        // Differences hold where the surface bends little over their step.
        if (there.second.norm() > 100 * slope / surface.size()) continue;
        ++compared;
        expect_second_form(surface, foot, none, 1e-3);
    }
    EXPECT_GT(reached, points.size() * 95 / 100);
    EXPECT_GT(compared, points.size() / 4);
}

// What lies outside is positive: normals point outwards.
TEST_P(NamedSurfaces, ArePositiveOutside) {
    const NamedSurface surface(GetParam());
    if (!GetParam().bounded) return;
    for (const Vec3& x : random_points(100, 1)) {
        EXPECT_GT(evaluate_at(surface, 2 * surface.size() * x.normalized()).value, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(All, NamedSurfaces, testing::ValuesIn(implicit_formulas().begin(), implicit_formulas().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

// Formulas whose derivatives are known.
TEST(SpaceJets, DifferentiateExactly) {
    const SpaceJet x = SpaceJet::coordinate(0, 0.3), y = SpaceJet::coordinate(1, -0.7),
                   z = SpaceJet::coordinate(2, 1.1);
    const SpaceJet product = x * y * z;
    EXPECT_NEAR(product.second[1], 1.1, 1e-15);   // xy: z
    EXPECT_NEAR(product.second[2], -0.7, 1e-15);  // xz: y
    EXPECT_NEAR(product.second[0], 0, 1e-15);
    const SpaceJet power = log(exp(square(x) - 2.0 * y)) + 4;
    EXPECT_NEAR(power.value, 0.09 + 1.4 + 4, 1e-15);
    EXPECT_NEAR(power.gradient[0], 0.6, 1e-15);
    EXPECT_NEAR(power.gradient[1], -2, 1e-15);
    EXPECT_NEAR(power.second[0], 2, 1e-14);
    EXPECT_NEAR(power.second[3], 0, 1e-14);
    const SpaceJet one = square(sin(z)) + square(cos(z));
    EXPECT_NEAR(one.gradient[2], 0, 1e-15);
    EXPECT_NEAR(one.second[5], 0, 1e-15);
    EXPECT_NEAR(sin(z).second[5], -std::sin(1.1), 1e-15);
}

}  // namespace
}  // namespace flg::test
