// SPDX-License-Identifier: MIT
// Derivatives of obstacles and barriers held against differences, and turned copies of shapes.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory_resource>
#include <vector>

#include "core/random.h"
#include "runtime/run_now.h"
#include "splines/manifolds/hypersurface.h"
#include "splines/obstacles/obstacle.h"

namespace flg::test {

inline Memory* heap() {
    return std::pmr::new_delete_resource();
}

using Numbers = std::array<double, 4>;

// Numbers from -half to half.
inline Numbers random_numbers(uint64_t item, double half = 1) {
    Numbers x{};
    for (uint32_t k = 0; k < 4; ++k) x[k] = half * (2 * random_unit(7, item, k) - 1);
    return x;
}

inline std::array<double, 3> place_of(const Numbers& x) {
    return {x[0], x[1], x[2]};
}

// The derivatives of `function(x, gradient, second)` in n variables at x; nothing if the second ones differ between the
// places of the differences by more than a smooth function's do (a crease between them).
template <class Function>
void expect_derivatives(const Function& function, uint32_t n, const Numbers& x, double tolerance) {
    constexpr double step = 1e-5;
    double gradient[4], second[16], above[4], below[4], second_above[16], second_below[16];
    function(x.data(), gradient, second);
    for (uint32_t j = 0; j < n; ++j) {
        Numbers up = x, down = x;
        up[j] += step;
        down[j] -= step;
        const double high = function(up.data(), above, second_above), low = function(down.data(), below, second_below);
        double jump = 0;
        for (uint32_t i = 0; i < n * n; ++i) jump = std::max(jump, std::abs(second_above[i] - second_below[i]));
        if (jump > 1e-2) continue;
        EXPECT_NEAR(gradient[j], (high - low) / (2 * step), tolerance);
        for (uint32_t i = 0; i < n; ++i) EXPECT_NEAR(second[i * n + j], (above[i] - below[i]) / (2 * step), tolerance);
    }
}

// Rows of a rotation of the plane or of space.
inline std::array<std::array<double, 3>, 3> rotation(uint32_t dimension) {
    if (dimension == 2) return {{{0.8, -0.6, 0}, {0.6, 0.8, 0}, {0, 0, 1}}};
    const double s = 1.0 / 3;
    return {{{2 * s, -s, 2 * s}, {2 * s, 2 * s, -s}, {-s, 2 * s, 2 * s}}};
}

inline std::array<double, 3> moved(uint32_t dimension, const std::array<double, 3>& x) {
    const auto turn = rotation(dimension);
    const double shift[3] = {0.3, -1.1, 0.7};
    std::array<double, 3> y{};
    for (uint32_t i = 0; i < dimension; ++i) {
        y[i] = shift[i];
        for (uint32_t k = 0; k < dimension; ++k) y[i] += turn[i][k] * x[k];
    }
    return y;
}

}  // namespace flg::test
