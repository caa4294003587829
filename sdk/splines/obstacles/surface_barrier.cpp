// SPDX-License-Identifier: MIT
#include "splines/obstacles/surface_barrier.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t max_rounds = 60;
constexpr double last_step = 1e-9;  // of the size, as of Hypersurface
// A step is no longer than so many times what the two functions are off. Normals that are nearly the same ask for more.
constexpr double max_step = 4;
// Of the product of squares: less is no tangent plane.
constexpr double min_determinant = 1e-10;

using Vec4 = std::array<double, 4>;

double dot(const Vec4& a, const Vec4& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

}  // namespace

// Values and gradients of both functions, and the inverse of the gradients' Gram matrix.
struct SurfaceBarrier::Constraints {
    double value[2];
    Vec4 gradient[2]{};
    double gram[2][2], determinant;

    bool evaluate(const SurfaceBarrier& of, const double* x, double* hint, double* seconds0 = nullptr,
                  double* seconds1 = nullptr) {
        if (!of.surface_.evaluate(x, hint, &value[0], gradient[0].data(), seconds0)) return false;
        if (!of.barrier_.evaluate(x, nullptr, &value[1], gradient[1].data(), seconds1)) return false;
        for (uint32_t i = 0; i < 2; ++i) {
            for (uint32_t j = 0; j < 2; ++j) gram[i][j] = dot(gradient[i], gradient[j]);
        }
        determinant = gram[0][0] * gram[1][1] - gram[0][1] * gram[1][0];
        return determinant > min_determinant * gram[0][0] * gram[1][1];
    }
    // The combination of gradients that has these products with them.
    std::array<double, 2> solve(double a, double b) const {
        return {(gram[1][1] * a - gram[0][1] * b) / determinant, (gram[0][0] * b - gram[0][1] * a) / determinant};
    }
};

SurfaceBarrier::SurfaceBarrier(const Hypersurface& surface, const ObstacleSet& obstacles, double radius)
    : Manifold(4, 2, surface.hint_size(), surface.size()),
      surface_(surface),
      obstacles_(obstacles),
      barrier_(obstacles, radius, surface.size()) {
    if (surface.ambient() != 3 || obstacles.dimension() != 3) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "a surface of R^%u with obstacles of R^%u: both must be of R^3 for a barrier on a surface",
                      surface.ambient(), obstacles.dimension());
    }
}

bool SurfaceBarrier::lift(const double* point, double* hint, double* x) const {
    std::copy_n(point, 3, x);
    x[3] = 0;
    if (!surface_.project(x, hint)) return false;
    if (BarrierSurface::height(obstacles_, radius(), x, x + 3)) return true;
    project(x, hint);
    return false;
}

// Newton's method with the shortest step that makes both functions 0 to first order.
bool SurfaceBarrier::project(double* x, double* hint) const {
    Vec4 at{};
    std::copy_n(x, 4, at.begin());
    Constraints c;
    for (uint32_t round = 0; round < max_rounds; ++round) {
        if (!c.evaluate(*this, at.data(), hint)) return false;
        const std::array<double, 2> by = c.solve(c.value[0], c.value[1]);
        Vec4 step{};
        for (uint32_t i = 0; i < 4; ++i) step[i] = by[0] * c.gradient[0][i] + by[1] * c.gradient[1][i];
        const double length = std::sqrt(dot(step, step));
        if (!std::isfinite(length)) return false;
        const double off =
            std::abs(c.value[0]) / std::sqrt(c.gram[0][0]) + std::abs(c.value[1]) / std::sqrt(c.gram[1][1]);
        const double share = length > max_step * off ? max_step * off / length : 1;
        for (uint32_t i = 0; i < 4; ++i) at[i] -= share * step[i];
        if (length <= last_step * size()) {
            std::copy_n(at.begin(), 4, x);
            return true;
        }
    }
    return false;
}

// The two axes that are least normal, made orthonormal.
void SurfaceBarrier::tangent_basis(const double* x, double* hint, double* basis) const {
    Constraints c;
    if (!c.evaluate(*this, x, hint)) c.gradient[0] = {0, 0, 1, 0}, c.gradient[1] = {0, 0, 0, 1};
    Vec4 normals[4] = {c.gradient[0], c.gradient[1]};
    for (uint32_t k = 0; k < 4; ++k) {
        if (k >= 2) {
            uint32_t axis = 0;
            double most = -1;
            for (uint32_t i = 0; i < 4; ++i) {
                double rest = 1;
                for (uint32_t j = 0; j < k; ++j) rest -= normals[j][i] * normals[j][i];
                if (rest > most) most = rest, axis = i;
            }
            normals[k] = {};
            normals[k][axis] = 1;
        }
        // Twice is enough for rounding.
        for (uint32_t twice = 0; twice < 2; ++twice) {
            for (uint32_t j = 0; j < k; ++j) {
                const double along = dot(normals[k], normals[j]);
                for (uint32_t i = 0; i < 4; ++i) normals[k][i] -= along * normals[j][i];
            }
            const double length = std::sqrt(dot(normals[k], normals[k]));
            for (double& v : normals[k]) v /= length;
        }
    }
    std::copy_n(normals[2].begin(), 4, basis);
    std::copy_n(normals[3].begin(), 4, basis + 4);
}

// Where both functions are 0, F_k'' (u, v) + F_k' II(u, v) = 0; the force's normal part is a combination of F_1' and
// F_2'.
void SurfaceBarrier::second_form(const double* x, double* hint, const double* basis, const double* force,
                                 double* form) const {
    std::fill_n(form, 4, 0.0);
    Constraints c;
    double second0[9], second1[16];
    if (!c.evaluate(*this, x, hint, second0, second1)) return;
    Vec4 f;
    std::copy_n(force, 4, f.begin());
    const std::array<double, 2> by = c.solve(dot(f, c.gradient[0]), dot(f, c.gradient[1]));
    for (uint32_t i = 0; i < 2; ++i) {
        for (uint32_t j = 0; j < 2; ++j) {
            const double *u = basis + 4 * i, *v = basis + 4 * j;
            double sum = 0;
            for (uint32_t k = 0; k < 4; ++k) {
                for (uint32_t l = 0; l < 4; ++l) {
                    const double on_surface = k < 3 && l < 3 ? by[0] * second0[k * 3 + l] : 0;
                    sum += (on_surface + by[1] * second1[k * 4 + l]) * u[k] * v[l];
                }
            }
            form[i * 2 + j] = -sum;
        }
    }
}

}  // namespace flg
