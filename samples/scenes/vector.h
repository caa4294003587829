// SPDX-License-Identifier: MIT
// Vectors in double precision, for those that make scenes.
#pragma once

#include <cmath>

#include "scenes.h"

namespace flg::scenes {

struct Vector {
    double x = 0.0, y = 0.0, z = 0.0;
};

inline Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(double s, const Vector& a) {
    return {s * a.x, s * a.y, s * a.z};
}
inline double dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vector& a) {
    return std::sqrt(dot(a, a));
}
inline Vector unit(const Vector& a) {
    return (1.0 / length(a)) * a;
}
// a turned about the unit vector `axis`.
inline Vector turned(const Vector& a, const Vector& axis, double angle_rad) {
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    return c * a + s * cross(axis, a) + (1.0 - c) * dot(axis, a) * axis;
}

inline Point to_point(const Vector& a) {
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}
inline Vector to_vector(const Point& p) {
    return {p.x, p.y, p.z};
}

}  // namespace flg::scenes
