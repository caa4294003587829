// SPDX-License-Identifier: MIT
// What holds for every zero set: derivatives agree with differences, bases are tangent, second forms agree with those
// that come from projections alone.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/vec.h"
#include "splines/manifolds/hypersurface.h"

namespace flg::test {

inline std::vector<Vec3> random_points(size_t count, double reach, unsigned seed = 1) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> draw(-reach, reach);
    std::vector<Vec3> points(count);
    for (Vec3& point : points) point = Vec3(draw(random), draw(random), draw(random));
    return points;
}

struct SurfaceValue {
    bool defined = false;
    double value = 0;
    Vec3 gradient = Vec3::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
};

inline std::vector<double> fresh_hint(const Manifold& manifold) {
    return std::vector<double>(manifold.hint_size());
}

inline SurfaceValue evaluate_at(const Hypersurface& surface, const Vec3& x, std::vector<double>& hint) {
    SurfaceValue result;
    result.defined =
        surface.evaluate(x.data(), hint.data(), &result.value, result.gradient.data(), result.second.data());
    return result;
}
inline SurfaceValue evaluate_at(const Hypersurface& surface, const Vec3& x) {
    std::vector<double> hint = fresh_hint(surface);
    return evaluate_at(surface, x, hint);
}

// Central differences of the value and of the gradient; `scale`: how large the function's third derivatives are, about.
inline void expect_exact_derivatives(const Hypersurface& surface, const Vec3& x, double scale = 1) {
    const double step = 1e-5 * surface.size();
    const SurfaceValue at = evaluate_at(surface, x);
    ASSERT_TRUE(at.defined);
    for (int axis = 0; axis < 3; ++axis) {
        const SurfaceValue after = evaluate_at(surface, x + step * Vec3::Unit(axis));
        const SurfaceValue before = evaluate_at(surface, x - step * Vec3::Unit(axis));
        ASSERT_TRUE(after.defined && before.defined);
        EXPECT_NEAR(at.gradient[axis], (after.value - before.value) / (2 * step), 1e-7 * scale) << x.transpose();
        const Vec3 slope = (after.gradient - before.gradient) / (2 * step);
        EXPECT_LT((at.second.col(axis) - slope).norm(), 1e-7 * scale) << x.transpose();
    }
    EXPECT_EQ(at.second, at.second.transpose().eval());
}

// x lies on the surface.
inline void expect_tangent_basis(const Hypersurface& surface, const Vec3& x, std::vector<double>& hint) {
    Eigen::Matrix<double, 3, 2> basis;
    surface.tangent_basis(x.data(), hint.data(), basis.data());
    EXPECT_LT((basis.transpose() * basis - Eigen::Matrix2d::Identity()).norm(), 1e-14);
    const Vec3 normal = evaluate_at(surface, x, hint).gradient.normalized();
    EXPECT_LT((Vec3(basis.col(0)).cross(Vec3(basis.col(1))) - normal).norm(), 1e-13);
}

// Against projections of points around; `tolerance` relative to the force over the size.
inline void expect_second_form(const Hypersurface& surface, const Vec3& x, std::vector<double>& hint,
                               double tolerance = 1e-5) {
    Eigen::Matrix<double, 3, 2> basis;
    surface.tangent_basis(x.data(), hint.data(), basis.data());
    const Vec3 force(0.3, -0.8, 0.6);
    Eigen::Matrix2d exact, differences;
    surface.second_form(x.data(), hint.data(), basis.data(), force.data(), exact.data());
    surface.Manifold::second_form(x.data(), hint.data(), basis.data(), force.data(), differences.data());
    EXPECT_LT((exact - differences).norm(), tolerance * (1 / surface.size() + exact.norm())) << x.transpose();
}

}  // namespace flg::test
