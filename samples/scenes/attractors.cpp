// SPDX-License-Identifier: MIT
// The Lorenz attractor (Lorenz 1963; sigma = 10, rho = 28, beta = 8/3) and Thomas' cyclically symmetric attractor
// (Thomas 1999; b = 0.208186), integrated by the classical Runge-Kutta method in double precision.
#include "attractors.h"

#include <cmath>

namespace flg::scenes {
namespace {

using State = std::array<double, 3>;

State lorenz_velocity(const State& p) {
    return {10.0 * (p[1] - p[0]), p[0] * (28.0 - p[2]) - p[1], p[0] * p[1] - 8.0 / 3.0 * p[2]};
}

State thomas_velocity(const State& p) {
    constexpr double kDamping = 0.208186;
    return {std::sin(p[1]) - kDamping * p[0], std::sin(p[2]) - kDamping * p[1], std::sin(p[0]) - kDamping * p[2]};
}

State add(const State& p, const State& v, double h) {
    return {p[0] + h * v[0], p[1] + h * v[1], p[2] + h * v[2]};
}

State runge_kutta(State (*velocity)(const State&), const State& p, double h) {
    const State a = velocity(p);
    const State b = velocity(add(p, a, 0.5 * h));
    const State c = velocity(add(p, b, 0.5 * h));
    const State d = velocity(add(p, c, h));
    return {p[0] + h / 6.0 * (a[0] + 2.0 * b[0] + 2.0 * c[0] + d[0]),
            p[1] + h / 6.0 * (a[1] + 2.0 * b[1] + 2.0 * c[1] + d[1]),
            p[2] + h / 6.0 * (a[2] + 2.0 * b[2] + 2.0 * c[2] + d[2])};
}

// Time to reach the attractor from a place near it.
constexpr double kSettlingTime = 100.0;

}  // namespace

const Attractor& lorenz() {
    static const Attractor attractor = {lorenz_velocity, {0.0, 0.0, 25.0}, 0.04, 0.004};
    return attractor;
}

const Attractor& thomas() {
    static const Attractor attractor = {thomas_velocity, {1.35, 1.35, 1.35}, 0.25, 0.05};
    return attractor;
}

std::vector<Point> follow(const Attractor& attractor, uint32_t count) {
    State p = {1.1, 1.3, -0.7};
    const auto settling = static_cast<uint32_t>(kSettlingTime / attractor.step);
    for (uint32_t i = 0; i < settling; ++i) p = runge_kutta(attractor.velocity, p, attractor.step);
    std::vector<Point> points;
    points.reserve(count);
    for (uint32_t i = 0; i < count; ++i) {
        const State& c = attractor.centre;
        const double s = attractor.metres;
        // The picture's y axis is the equations' z axis; x and z turn with it, so that handedness stays.
        points.push_back({static_cast<float>(s * (p[0] - c[0])), static_cast<float>(s * (p[2] - c[2])),
                          static_cast<float>(-s * (p[1] - c[1]))});
        p = runge_kutta(attractor.velocity, p, attractor.step);
    }
    return points;
}

}  // namespace flg::scenes
