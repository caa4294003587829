// SPDX-License-Identifier: MIT
#include "splines/manifolds/hypersurface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "splines/manifolds/coordinates.h"

namespace flg {

namespace {

constexpr uint32_t max_rounds = 60;
// Of the size. The step that was this long led to the surface up to its square times the curvature.
constexpr double last_step = 1e-9;

using Point = std::array<double, Manifold::max_ambient>;

}  // namespace

bool Hypersurface::project(double* x, double* hint) const {
    const uint32_t n = ambient();
    Point at{}, gradient{};
    std::copy_n(x, n, at.begin());
    for (uint32_t round = 0; round < max_rounds; ++round) {
        double value = 0;
        if (!evaluate(at.data(), hint, &value, gradient.data(), nullptr)) return false;
        const double square = inner_product(gradient.data(), gradient.data(), n);
        if (!(square > 0) || !std::isfinite(value)) return false;
        const double length = std::abs(value) / std::sqrt(square);
        const double share = length > max_step_ ? max_step_ / length : 1;
        for (uint32_t i = 0; i < n; ++i) at[i] -= share * value / square * gradient[i];
        if (length <= last_step * size()) {
            std::copy_n(at.begin(), n, x);
            return true;
        }
    }
    return false;
}

// Householder's reflection that takes a unit vector along an axis to the normal takes the other axes to the tangent
// space.
void Hypersurface::tangent_basis(const double* x, double* hint, double* basis) const {
    const uint32_t n = ambient();
    Point normal{};
    double value = 0;
    if (!evaluate(x, hint, &value, normal.data(), nullptr)) normal[n - 1] = 1;
    const double length = std::sqrt(inner_product(normal.data(), normal.data(), n));
    for (uint32_t i = 0; i < n; ++i) normal[i] /= length;
    uint32_t axis = 0;
    for (uint32_t i = 1; i < n; ++i) {
        if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    }
    const double sign = normal[axis] < 0 ? -1 : 1;
    Point mirror = normal;
    mirror[axis] += sign;
    const double scale = 2 / inner_product(mirror.data(), mirror.data(), n);
    uint32_t row = 0;
    for (uint32_t a = 0; a < n; ++a) {
        if (a == axis) continue;
        for (uint32_t i = 0; i < n; ++i) basis[row * n + i] = (i == a ? 1 : 0) - scale * mirror[a] * mirror[i];
        ++row;
    }
    if (n != 3) return;
    // The reflection turns space over, and leaving out the middle axis does so once more.
    const double* b = basis;
    const double* c = basis + 3;
    const Point cross{b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]};
    if (inner_product(cross.data(), normal.data(), 3) < 0) {
        for (uint32_t i = 0; i < 3; ++i) basis[3 + i] = -basis[3 + i];
    }
}

// Where F = 0, F'' (u, v) + F' II(u, v) = 0.
void Hypersurface::second_form(const double* x, double* hint, const double* basis, const double* force,
                               double* form) const {
    const uint32_t n = ambient(), k = n - 1;
    Point gradient{};
    std::array<double, max_ambient * max_ambient> second{};
    double value = 0;
    std::fill_n(form, k * k, 0.0);
    if (!evaluate(x, hint, &value, gradient.data(), second.data())) return;
    const double along = -inner_product(force, gradient.data(), n) / inner_product(gradient.data(), gradient.data(), n);
    for (uint32_t j = 0; j < k; ++j) {
        Point image{};
        for (uint32_t i = 0; i < n; ++i) image[i] = inner_product(&second[i * n], basis + j * n, n);
        for (uint32_t i = 0; i < k; ++i) form[i * k + j] = along * inner_product(basis + i * n, image.data(), n);
    }
}

}  // namespace flg
