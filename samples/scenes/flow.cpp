// SPDX-License-Identifier: MIT
// Laminar flow around a ball: streamlines of the potential flow with the velocity
//     u = U (1 - a^3 (3 cos^2 t - 1) / (2 r^3))  along the stream,
//         -U 3 a^3 cos t sin t / (2 r^3)         away from its axis,
// (Milne-Thomson, Theoretical Hydrodynamics, 15.30), integrated by the classical Runge-Kutta method.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "noise.h"
#include "scene_makers.h"
#include "vector.h"

namespace flg::scenes {
namespace {

// Metres.
constexpr double kBall = 0.13, kFrom = -0.75, kTo = 1.65, kStep = 0.008, kOuter = 0.40;

// Along the stream and away from the axis, at unit speed far away.
struct Flat {
    double along, away;
};

Flat velocity(const Flat& p) {
    const double r_sq = std::max(p.along * p.along + p.away * p.away, kBall * kBall);
    const double c = kBall * kBall * kBall / (2.0 * r_sq * std::sqrt(r_sq));
    return {1.0 - c * (3.0 * p.along * p.along / r_sq - 1.0), -3.0 * c * p.along * p.away / r_sq};
}

Flat ahead(const Flat& p, const Flat& v, double t) {
    return {p.along + t * v.along, p.away + t * v.away};
}

Flat stepped(const Flat& p, double h) {
    const Flat a = velocity(p), b = velocity(ahead(p, a, 0.5 * h)), c = velocity(ahead(p, b, 0.5 * h)),
               d = velocity(ahead(p, c, h));
    return {p.along + h / 6.0 * (a.along + 2.0 * (b.along + c.along) + d.along),
            p.away + h / 6.0 * (a.away + 2.0 * (b.away + c.away) + d.away)};
}

}  // namespace

std::vector<Curve> make_flow(uint32_t count) {
    constexpr double kGoldenAngle = 2.399963229728653;
    std::vector<Curve> lines;
    for (uint32_t i = 0; i < count; ++i) {
        // Sunflower: evenly spread over a disk.
        const double share = std::sqrt((i + 0.5) / count), heading = kGoldenAngle * i;
        Curve line;
        for (Flat p = {kFrom, kOuter * share}; p.along < kTo; p = stepped(p, kStep)) {
            line.points.push_back(to_point({p.along, p.away * std::cos(heading), p.away * std::sin(heading)}));
            line.radii.push_back(0.0020f);
        }
        const auto outer = static_cast<float>(share);
        line.color = {0.75f - 0.70f * outer, 0.10f + 0.20f * outer, 0.06f + 0.38f * outer, 1.0f};
        lines.push_back(std::move(line));
    }
    return lines;
}

Curve make_ball() {
    constexpr uint32_t kRings = 65;
    Curve ball;
    for (uint32_t i = 0; i < kRings; ++i) {
        const double a = std::numbers::pi * (i + 0.02) / (kRings - 0.96);
        ball.points.push_back(to_point({-0.985 * kBall * std::cos(a), 0.0, 0.0}));
        ball.radii.push_back(static_cast<float>(0.985 * kBall * std::sin(a)));
    }
    ball.color = {0.80f, 0.78f, 0.74f, 1.0f};
    return ball;
}

}  // namespace flg::scenes
