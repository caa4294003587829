// SPDX-License-Identifier: MIT
// What each manifold must hold, whatever it is: checked against what is made of projections alone.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <random>
#include <vector>

#include "splines/manifolds/manifold.h"

namespace flg::test {

// Basis orthonormal; tangent as small moves along it, projected, say; the closed second form that of the default;
// projection does not move points of the manifold. x is near the manifold and is projected first.
inline void expect_consistent(const Manifold& manifold, std::vector<double> x, double tolerance) {
    const uint32_t n = manifold.ambient(), k = manifold.dimension();
    std::vector<double> hint(manifold.hint_size());
    ASSERT_TRUE(manifold.project(x.data(), hint.data()));
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Matrix basis(k, n), form(k, k), generic(k, k);
    manifold.tangent_basis(x.data(), hint.data(), basis.data());
    EXPECT_LT((basis * basis.transpose() - Matrix::Identity(k, k)).norm(), 1e-12);
    std::vector<double> again = x;
    ASSERT_TRUE(manifold.project(again.data(), hint.data()));
    for (uint32_t i = 0; i < n; ++i) EXPECT_NEAR(again[i], x[i], 1e-13 * manifold.size());
    const double step = 1e-5 * manifold.size();
    for (uint32_t j = 0; j < k; ++j) {
        std::vector<double> moved = x, own = hint;
        for (uint32_t i = 0; i < n; ++i) moved[i] += step * basis(j, i);
        const std::vector<double> target = moved;
        ASSERT_TRUE(manifold.project(moved.data(), own.data()));
        for (uint32_t i = 0; i < n; ++i) EXPECT_NEAR(moved[i], target[i], 1e-3 * step);
    }
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<double> force(n);
    for (double& value : force) value = normal(random);
    manifold.second_form(x.data(), hint.data(), basis.data(), force.data(), form.data());
    manifold.Manifold::second_form(x.data(), hint.data(), basis.data(), force.data(), generic.data());
    EXPECT_LT((form - generic).norm(), tolerance * (1 + form.norm()));
    EXPECT_LT((form - form.transpose()).norm(), 1e-12 * (1 + form.norm()));
}

}  // namespace flg::test
