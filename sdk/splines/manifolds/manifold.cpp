// SPDX-License-Identifier: MIT
#include "splines/manifolds/manifold.h"

#include <array>

namespace flg {

namespace {

// Differences of second order: their error is the step's square, their noise rounding over the square.
constexpr double relative_step = 1e-4;

}  // namespace

// The way x + t v leads, projected, has the second derivative II(v, v) at x, beside what is tangent. II(u, v) by
// polarization.
void Manifold::second_form(const double* x, double* hint, const double* basis, const double* force,
                           double* form) const {
    const uint32_t n = ambient_, k = dimension_;
    std::array<double, max_ambient> normal{};
    for (uint32_t i = 0; i < n; ++i) normal[i] = force[i];
    for (uint32_t b = 0; b < k; ++b) {
        double along = 0;
        for (uint32_t i = 0; i < n; ++i) along += force[i] * basis[b * n + i];
        for (uint32_t i = 0; i < n; ++i) normal[i] -= along * basis[b * n + i];
    }
    const double step = relative_step * size_;
    const auto bend = [&](const double* first, const double* second) {
        double sum = 0;
        for (const double sign : {1.0, -1.0}) {
            std::array<double, max_ambient> moved{};
            std::array<double, max_hint> own{};
            for (uint32_t i = 0; i < hint_size_; ++i) own[i] = hint[i];
            for (uint32_t i = 0; i < n; ++i) moved[i] = x[i] + sign * step * (first[i] + (second ? second[i] : 0));
            if (!project(moved.data(), own.data())) return 0.0;
            for (uint32_t i = 0; i < n; ++i) sum += normal[i] * (moved[i] - x[i]);
        }
        return sum / (step * step);
    };
    for (uint32_t i = 0; i < k; ++i) form[i * k + i] = bend(basis + i * n, nullptr);
    for (uint32_t i = 0; i < k; ++i) {
        for (uint32_t j = 0; j < i; ++j) {
            const double both = bend(basis + i * n, basis + j * n);
            form[i * k + j] = form[j * k + i] = 0.5 * (both - form[i * k + i] - form[j * k + j]);
        }
    }
}

}  // namespace flg
