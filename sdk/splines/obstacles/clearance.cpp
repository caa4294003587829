// SPDX-License-Identifier: MIT
#include "splines/obstacles/clearance.h"

#include <algorithm>
#include <cmath>

#include "splines/manifolds/coordinates.h"

namespace flg {

namespace {

constexpr uint32_t look_steps = 64;    // of a way, between two pauses
constexpr double min_step = 1.0 / 64;  // of the interval, where it is not clear: to see how deep it goes

}  // namespace

Task<uint64_t> find_trespasses(Pace& pace, const ObstacleSet& obstacles, CurvePieces curve,
                               std::pmr::vector<Trespass>& out) {
    const uint32_t d = obstacles.dimension(), nodes = static_cast<uint32_t>(curve.nodes.size() / d);
    Slice slice(Cost::microseconds);
    uint64_t looks = 0;
    for (uint32_t i = 0; i + (curve.closed ? 0 : 1) < nodes; ++i) {
        const uint32_t next = (i + 1) % nodes;
        const double* const a = &curve.nodes[size_t{i} * d];
        const double* const b = &curve.nodes[size_t{next} * d];
        const double length = distance_between(a, b, d);
        double bulge = 0;  // t (1 - t) times this
        if (!curve.moments.empty()) {
            const double *m = &curve.moments[size_t{i} * d], *n = &curve.moments[size_t{next} * d];
            bulge = 0.5 * curve.steps[i] * curve.steps[i] *
                    std::sqrt(std::max(inner_product(m, m, d), inner_product(n, n, d)));
        }
        Trespass worst{i, 0, 0, 0};
        for (double t = 0;;) {
            Obstacle::Place at{};
            for (uint32_t c = 0; c < d; ++c) at[c] = (1 - t) * a[c] + t * b[c];
            uint32_t which = 0;
            const double left = obstacles.distance(at.data(), &which) - t * (1 - t) * bulge + curve.allowed[i],
                         lacking = curve.spare[i] - left;
            if (lacking > worst.depth) worst = {i, which, lacking, t};
            ++looks;
            if (slice.is_over()) co_await pace;
            if (t >= 1) break;
            // What is left falls by no more than 1 a metre of the chord, and the bulge's slope a unit of t.
            const double fall = length + bulge;
            const double step = fall > 0 ? left / fall : 1;
            t = std::min(t + (lacking > 0 ? min_step : step), 1.0);
        }
        if (worst.depth > 0) out.push_back(worst);
    }
    co_return looks;
}

Task<bool> is_clear(Pace& pace, const ObstacleSet& obstacles, Obstacle::Place a, Obstacle::Place b, double margin) {
    for (double done = 0;;) {
        const ObstacleSet::Way way = obstacles.follow(a.data(), b.data(), margin, look_steps, &done);
        co_await pace;
        if (way != ObstacleSet::Way::unfinished) co_return way == ObstacleSet::Way::clear;
    }
}

}  // namespace flg
