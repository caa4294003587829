// SPDX-License-Identifier: MIT
// Style curves with known axes for the tests of guide flow and matching.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "core/random.h"
#include "core/vec.h"

namespace flg::test {

using Curve = std::vector<Vec3>;

inline double polyline_length(const Curve& curve) {
    double length = 0.0;
    for (size_t i = 1; i < curve.size(); ++i) length += (curve[i] - curve[i - 1]).norm();
    return length;
}

// `count` points of f(0..1), even in arc length.
inline Curve even_curve(const std::function<Vec3(double)>& f, int count) {
    constexpr int fine = 20000;
    std::vector<double> along(fine + 1, 0.0);
    Curve dense(fine + 1);
    for (int i = 0; i <= fine; ++i) {
        dense[i] = f(static_cast<double>(i) / fine);
        if (i > 0) along[i] = along[i - 1] + (dense[i] - dense[i - 1]).norm();
    }
    Curve out;
    int j = 0;
    for (int k = 0; k < count; ++k) {
        const double s = along[fine] * k / (count - 1);
        while (j + 2 <= fine && along[j + 1] < s) ++j;
        const double t = (s - along[j]) / (along[j + 1] - along[j]);
        out.push_back(dense[j] + t * (dense[j + 1] - dense[j]));
    }
    out.back() = dense.back();
    return out;
}

constexpr double axis_radius = 10.0;
constexpr double detail_size = 0.6;

// An arc of radius 10 around the origin in the plane z = 0, 1.2 rad long: the axis of the next two.
inline Vec3 axis(double u) {
    const double a = 1.2 * (u - 0.5);
    return {axis_radius * std::sin(a), axis_radius * std::cos(a), 0.0};
}

inline Curve coil(int count) {
    return even_curve(
        [](double u) -> Vec3 {
            const double turn = 32.0 * std::numbers::pi * u;
            return axis(u) * (1.0 + detail_size / axis_radius * std::cos(turn)) +
                   Vec3(0.0, 0.0, detail_size * std::sin(turn));
        },
        count);
}

inline Curve sine(int count) {
    return even_curve(
        [](double u) -> Vec3 {
            return axis(u) * (1.0 + detail_size / axis_radius * std::sin(24.0 * std::numbers::pi * u));
        },
        count);
}

inline Curve zigzag(int count) {
    return even_curve(
        [](double u) {
            const double x = 20.0 * u;
            const int leg = static_cast<int>(x);
            const double t = x - leg;
            return Vec3(10.0 * u, leg % 2 ? 1.0 - t : t, 0.1 * std::sin(9.0 * u));
        },
        count);
}

inline Curve loops(int count) {
    return even_curve(
        [](double u) {
            const double a = 8.0 * std::numbers::pi * u;
            return Vec3(8.0 * u + std::sin(a), std::cos(a) + 0.5 * std::sin(std::numbers::pi * u),
                        0.2 * std::sin(a / 2));
        },
        count);
}

inline Curve tremor(int count) {
    return even_curve(
        [](double u) -> Vec3 {
            Vec3 out = axis(u) * (1.0 + 0.05 * std::sin(30.0 * u));
            for (int k = 0; k < 30; ++k) {
                for (int c = 0; c < 3; ++c) {
                    out[c] += 0.01 * random_unit(7, k, c) * std::sin((60 + 9 * k) * u + 6.0 * random_unit(8, k, c));
                }
            }
            return out;
        },
        count);
}

struct NamedCurve {
    std::string name;
    Curve points;
};

inline std::vector<NamedCurve> styles(int count) {
    return {{"coil", coil(count)},
            {"sine", sine(count)},
            {"zigzag", zigzag(count)},
            {"loops", loops(count)},
            {"tremor", tremor(count)}};
}

// The same shape elsewhere: turned by 1 rad about a skew axis, 100 times larger, moved.
inline Vec3 moved(const Vec3& p) {
    const Vec3 k = Vec3(1.0, -2.0, 0.5).normalized();
    const double c = std::cos(1.0);
    const Vec3 turned = c * p + std::sin(1.0) * k.cross(p) + (1.0 - c) * k.dot(p) * k;
    return 100.0 * turned + Vec3(300.0, -50.0, 20.0);
}
constexpr double moved_scale = 100.0;

inline Curve moved(const Curve& curve) {
    Curve out;
    for (const Vec3& p : curve) out.push_back(moved(p));
    return out;
}

}  // namespace flg::test
