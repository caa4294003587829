// SPDX-License-Identifier: MIT
#include "splines/obstacles/barrier_surface.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t max_near = BarrierSurface::max_near;
constexpr uint32_t max_d = Obstacle::max_dimension;
// Of the size: so far a step of Newton's method goes at most. f is a distance nearly everywhere, so most are exact.
constexpr double max_step = 0.25;

struct Near {
    uint32_t obstacle;
    double q;  // r - d, positive
};

// The obstacles within r, nearest first; if some are inside of which the point is, the one that it is deepest in alone.
// `distance`: the least one of all, if none is within r.
uint32_t find_near(const ObstacleSet& obstacles, double r, const double* x, Near* near, double* distance) {
    uint32_t count = 0;
    *distance = std::numeric_limits<double>::infinity();
    for (uint32_t i = 0; i < obstacles.count(); ++i) {
        if (obstacles.at_least(i, x) >= std::max(*distance, r)) continue;
        const double d = obstacles.evaluate(i, x, nullptr, nullptr);
        *distance = std::min(*distance, d);
        const double q = r - d;
        if (!(q > 0)) continue;
        uint32_t place = std::min(count, max_near - 1);
        if (count == max_near && q <= near[place].q) continue;
        while (place > 0 && near[place - 1].q < q) {
            near[place] = near[place - 1];
            --place;
        }
        near[place] = {i, q};
        if (count < max_near) ++count;
    }
    return count > 0 && near[0].q >= r ? 1 : count;
}

// The product of 1 - a^2 over all but `i` and `j`.
double others(const Near* near, uint32_t count, double r, uint32_t i, uint32_t j) {
    double product = 1;
    for (uint32_t k = 0; k < count; ++k) {
        const double a = near[k].q / r;
        if (k != i && k != j) product *= 1 - a * a;
    }
    return product;
}

double checked_radius(const ObstacleSet& obstacles, double radius) {
    if (!(radius > 0) || !std::isfinite(radius)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a barrier's radius is %g, it must be finite and positive", radius);
    }
    if (!(radius < obstacles.reach())) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a barrier's radius is %g, but the distance is known up to %g only",
                      radius, obstacles.reach());
    }
    return radius;
}

}  // namespace

BarrierSurface::BarrierSurface(const ObstacleSet& obstacles, double radius, double size)
    : Hypersurface(obstacles.dimension() + 1, 0, size, max_step * size),
      obstacles_(obstacles),
      radius_(checked_radius(obstacles, radius)) {}

void BarrierSurface::set_radius(double radius) {
    radius_ = checked_radius(obstacles_, radius);
}

bool BarrierSurface::height(const ObstacleSet& obstacles, double r, const double* point, double* z) {
    Near near[max_near];
    double distance = 0;
    const uint32_t count = find_near(obstacles, r, point, near, &distance);
    const double product = others(near, count, r, count, count);
    if (product < 0) return false;
    // r - r sqrt(1 - a^2), without cancellation.
    *z = r * (1 - product) / (1 + std::sqrt(product));
    return true;
}

bool BarrierSurface::lift(const double* point, double* x) const {
    const uint32_t d = obstacles_.dimension();
    std::copy_n(point, d, x);
    x[d] = 0;
    if (height(obstacles_, radius_, point, x + d)) return true;
    project(x, nullptr);
    return false;
}

bool BarrierSurface::evaluate(const double* x, double*, double* value, double* gradient, double* second) const {
    *value = evaluate(obstacles_, radius_, x, gradient, second);
    return std::isfinite(*value);
}

// f = r - sqrt(S), S = r^2 (1 - product) + q_z^2; far from the surface on its upper side, where S = 0, the lesser
// distance.
double BarrierSurface::evaluate(const ObstacleSet& obstacles, double r, const double* x, double* gradient,
                                double* second) {
    const uint32_t d = obstacles.dimension(), n = d + 1;
    Near near[max_near];
    double least = 0;
    const uint32_t count = find_near(obstacles, r, x, near, &least);
    const double q_z = std::max(r - x[d], 0.0);
    double g[max_near][max_d], h[max_near][max_d * max_d];
    std::fill_n(gradient, n, 0.0);
    if (second != nullptr) std::fill_n(second, n * n, 0.0);
    if (count == 0) {
        const bool wall = least < x[d];
        if (!wall) gradient[d] = 1;
        if (wall) {
            uint32_t which = 0;
            obstacles.distance(x, &which, gradient);
            if (second != nullptr) obstacles.evaluate(which, x, nullptr, h[0]);
        }
        for (uint32_t i = 0; i < d && wall && second != nullptr; ++i) {
            for (uint32_t j = 0; j < d; ++j) second[i * n + j] = h[0][i * d + j];
        }
        return std::min(least, x[d]);
    }
    for (uint32_t k = 0; k < count; ++k) {
        obstacles.evaluate(near[k].obstacle, x, g[k], second != nullptr ? h[k] : nullptr);
    }
    const bool single = count == 1;
    const double sum =
        (single ? near[0].q * near[0].q : r * r * (1 - others(near, count, r, count, count))) + q_z * q_z;
    const double root = std::sqrt(sum);
    // Half of the derivatives of S.
    double slope[max_d + 1] = {};
    double product[max_near];
    for (uint32_t k = 0; k < count; ++k) {
        product[k] = single ? 1 : others(near, count, r, k, k);
        for (uint32_t i = 0; i < d; ++i) slope[i] -= near[k].q * product[k] * g[k][i];
    }
    slope[d] = -q_z;
    for (uint32_t i = 0; i < n; ++i) gradient[i] = -slope[i] / root;
    if (second == nullptr) return r - root;
    for (uint32_t k = 0; k < count; ++k) {
        for (uint32_t i = 0; i < d; ++i) {
            for (uint32_t j = 0; j < d; ++j) {
                second[i * n + j] += product[k] * (g[k][i] * g[k][j] - near[k].q * h[k][i * d + j]);
            }
        }
        for (uint32_t l = 0; l < count; ++l) {
            if (l == k) continue;
            const double both = 2 * near[k].q * near[l].q / (r * r) * others(near, count, r, k, l);
            for (uint32_t i = 0; i < d; ++i) {
                for (uint32_t j = 0; j < d; ++j) second[i * n + j] -= both * g[k][i] * g[l][j];
            }
        }
    }
    if (q_z > 0) second[d * n + d] = 1;
    for (uint32_t i = 0; i < n; ++i) {
        for (uint32_t j = 0; j < n; ++j) {
            second[i * n + j] = (-second[i * n + j] + slope[i] * slope[j] / sum) / root;
        }
    }
    return r - root;
}

}  // namespace flg
