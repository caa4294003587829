// SPDX-License-Identifier: MIT
// The unit sphere as the host's functions, as points, as a grid.
#pragma once

#include <cmath>
#include <vector>

namespace flg::test {

inline int project_on_sphere(void*, double* point, double*) {
    const double size = std::sqrt(point[0] * point[0] + point[1] * point[1] + point[2] * point[2]);
    if (size == 0) return 0;
    for (int i = 0; i < 3; ++i) point[i] /= size;
    return 1;
}

inline void basis_on_sphere(void*, const double* point, double*, double* basis) {
    const int least = std::abs(point[0]) < std::abs(point[1]) ? (std::abs(point[0]) < std::abs(point[2]) ? 0 : 2)
                                                              : (std::abs(point[1]) < std::abs(point[2]) ? 1 : 2);
    double along[3] = {}, size = 0;
    along[least] = 1;
    for (int i = 0; i < 3; ++i) {
        basis[i] = along[i] - point[least] * point[i];
        size += basis[i] * basis[i];
    }
    for (int i = 0; i < 3; ++i) basis[i] /= std::sqrt(size);
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        basis[3 + i] = point[j] * basis[k] - point[k] * basis[j];
    }
}

// By longitude and latitude.
inline void sphere_patch(void*, double u, double v, double* out) {
    const double cu = std::cos(u), su = std::sin(u), cv = std::cos(v), sv = std::sin(v);
    const double numbers[18] = {cv * cu,  cv * su,  sv, -cv * su, cv * cu,  0, -sv * cu, -sv * su, cv,
                                -cv * cu, -cv * su, 0,  sv * su,  -sv * cu, 0, -cv * cu, -cv * su, -sv};
    for (int i = 0; i < 18; ++i) out[i] = numbers[i];
}

// Evenly, along a spiral.
inline std::vector<float> points_on_sphere(int count) {
    std::vector<float> points;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2.0 * i + 1) / count, r = std::sqrt(1 - z * z), angle = 2.399963229728653 * i;
        for (const double x : {r * std::cos(angle), r * std::sin(angle), z}) points.push_back(static_cast<float>(x));
    }
    return points;
}

// At count^3 samples about the origin.
inline std::vector<float> distances_from_sphere(int count, double spacing) {
    std::vector<float> values;
    const auto at = [&](int i) { return spacing * (i - 0.5 * (count - 1)); };
    for (int k = 0; k < count; ++k) {
        for (int j = 0; j < count; ++j) {
            for (int i = 0; i < count; ++i) {
                values.push_back(static_cast<float>(std::hypot(at(i), at(j), at(k)) - 1));
            }
        }
    }
    return values;
}

}  // namespace flg::test
