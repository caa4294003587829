// SPDX-License-Identifier: MIT
// Rotations as glTF has them: quaternions x, y, z, w.
#pragma once

#include <cmath>

#include "io/gltf/gltf_scene.h"

namespace flg::io {

using Rotation = std::array<double, 4>;

inline Rotation normalized(const Rotation& q) {
    const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    return {q[0] / size, q[1] / size, q[2] / size, q[3] / size};
}

inline double dot(const Rotation& a, const Rotation& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

// Conjugate of a, times b.
inline Rotation from_to(const Rotation& a, const Rotation& b) {
    return {a[3] * b[0] - a[0] * b[3] - a[1] * b[2] + a[2] * b[1],
            a[3] * b[1] + a[0] * b[2] - a[1] * b[3] - a[2] * b[0],
            a[3] * b[2] - a[0] * b[1] + a[1] * b[0] - a[2] * b[3], dot(a, b)};
}

inline Rotation slerp(const Rotation& from, const Rotation& to, double share) {
    constexpr double nearly_one = 1 - 1e-9;
    const double cosine = dot(from, to), sign = cosine < 0 ? -1 : 1;
    double a = 1 - share, b = share;
    if (std::abs(cosine) < nearly_one) {
        const double angle = std::acos(std::abs(cosine)), sine = std::sin(angle);
        a = std::sin(a * angle) / sine;
        b = std::sin(b * angle) / sine;
    }
    Rotation q;
    for (size_t k = 0; k < 4; ++k) q[k] = a * from[k] + sign * b * to[k];
    return normalized(q);
}

// Of the linear part, which must be a rotation. Shepperd, Quaternion from rotation matrix, 1978.
inline Rotation rotation_of(const Transform& m) {
    const double trace = m[0] + m[4] + m[8];
    if (trace > 0) return normalized({m[5] - m[7], m[6] - m[2], m[1] - m[3], 1 + trace});
    if (m[0] >= m[4] && m[0] >= m[8])
        return normalized({1 + m[0] - m[4] - m[8], m[1] + m[3], m[2] + m[6], m[5] - m[7]});
    if (m[4] >= m[8]) return normalized({m[1] + m[3], 1 - m[0] + m[4] - m[8], m[5] + m[7], m[6] - m[2]});
    return normalized({m[2] + m[6], m[5] + m[7], 1 - m[0] - m[4] + m[8], m[1] - m[3]});
}

// Whether a motion keeps lengths and turns nothing inside out, within a share of `tolerance`.
inline bool is_rigid(const Transform& m, double tolerance) {
    for (size_t a = 0; a < 3; ++a) {
        for (size_t b = a; b < 3; ++b) {
            const double product = m[3 * a] * m[3 * b] + m[3 * a + 1] * m[3 * b + 1] + m[3 * a + 2] * m[3 * b + 2];
            if (!(std::abs(product - (a == b)) <= 2 * tolerance)) return false;
        }
    }
    return determinant(m) > 0;
}

}  // namespace flg::io
