// SPDX-License-Identifier: MIT
// Symmetric matrices made more positive: negative eigenvalues become a share of themselves. By Jacobi's rotations.
#pragma once

#include <cmath>

#include "splines/manifold.h"

namespace flg {

// k x k numbers, in place; k at most Manifold::max_dimension; share: 0 to 1. Some k^3 multiplications, ten times.
inline void scale_negative_part(double* matrix, uint32_t k, double share) {
    constexpr uint32_t rounds = 12;
    constexpr double negligible = 1e-14;  // of the whole, squared below
    double axes[Manifold::max_dimension * Manifold::max_dimension] = {};
    for (uint32_t i = 0; i < k; ++i) axes[i * k + i] = 1;
    for (uint32_t round = 0; round < rounds; ++round) {
        double off = 0, whole = 0;
        for (uint32_t i = 0; i < k; ++i) {
            for (uint32_t j = 0; j < k; ++j) (i == j ? whole : off) += matrix[i * k + j] * matrix[i * k + j];
        }
        if (off <= negligible * negligible * whole) break;
        for (uint32_t p = 0; p < k; ++p) {
            for (uint32_t q = p + 1; q < k; ++q) {
                if (matrix[p * k + q] == 0) continue;
                const double slope = (matrix[q * k + q] - matrix[p * k + p]) / (2 * matrix[p * k + q]);
                const double t = (slope < 0 ? -1 : 1) / (std::abs(slope) + std::hypot(slope, 1.0));
                const double cosine = 1 / std::hypot(t, 1.0), sine = t * cosine;
                for (uint32_t i = 0; i < k; ++i) {
                    const double a = matrix[i * k + p], b = matrix[i * k + q];
                    matrix[i * k + p] = cosine * a - sine * b;
                    matrix[i * k + q] = sine * a + cosine * b;
                    const double u = axes[i * k + p], v = axes[i * k + q];
                    axes[i * k + p] = cosine * u - sine * v;
                    axes[i * k + q] = sine * u + cosine * v;
                }
                for (uint32_t i = 0; i < k; ++i) {
                    const double a = matrix[p * k + i], b = matrix[q * k + i];
                    matrix[p * k + i] = cosine * a - sine * b;
                    matrix[q * k + i] = sine * a + cosine * b;
                }
            }
        }
    }
    double values[Manifold::max_dimension];
    for (uint32_t i = 0; i < k; ++i) values[i] = (matrix[i * k + i] > 0 ? 1 : share) * matrix[i * k + i];
    for (uint32_t i = 0; i < k; ++i) {
        for (uint32_t j = 0; j < k; ++j) {
            double sum = 0;
            for (uint32_t e = 0; e < k; ++e) sum += axes[i * k + e] * values[e] * axes[j * k + e];
            matrix[i * k + j] = sum;
        }
    }
}

}  // namespace flg
