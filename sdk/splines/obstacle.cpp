// SPDX-License-Identifier: MIT
#include "splines/obstacle.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

ObstacleSet::ObstacleSet(std::span<const Obstacle* const> obstacles, double clearance, Memory* memory)
    : obstacles_(obstacles.begin(), obstacles.end(), memory), clearance_(clearance) {
    if (obstacles_.empty() || obstacles_.size() > max_count) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%zu obstacles: there must be 1 to %u", obstacles_.size(), max_count);
    }
    if (!(clearance >= 0) || !std::isfinite(clearance)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the clearance is %g, it must be finite and not negative", clearance);
    }
    for (size_t i = 0; i < obstacles_.size(); ++i) {
        if (obstacles_[i] == nullptr) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "obstacles[%zu] is null", i);
        if (obstacles_[i]->dimension() != obstacles_[0]->dimension()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "obstacles[%zu] has dimension %u, obstacles[0] %u", i,
                          obstacles_[i]->dimension(), obstacles_[0]->dimension());
        }
        if (!(clearance < obstacles_[i]->reach())) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "the clearance is %g, but the distance from obstacles[%zu] is known up to %g only", clearance,
                          i, obstacles_[i]->reach());
        }
    }
    dimension_ = obstacles_[0]->dimension();
}

double ObstacleSet::at_least(uint32_t i, const double* x) const {
    const Obstacle& obstacle = *obstacles_[i];
    if (!obstacle.bounded()) return -std::numeric_limits<double>::infinity();
    const Obstacle::Box& box = obstacle.box();
    double square = 0;
    for (uint32_t k = 0; k < dimension_; ++k) {
        const double away = std::max({box.lower[k] - x[k], x[k] - box.upper[k], 0.0});
        square += away * away;
    }
    // Inside of the box nothing is known.
    return square > 0 ? std::sqrt(square) - clearance_ : -std::numeric_limits<double>::infinity();
}

double ObstacleSet::distance(const double* x, uint32_t* which, double* gradient, double below) const {
    double least = below;
    uint32_t found = count();
    for (uint32_t i = 0; i < count(); ++i) {
        if (at_least(i, x) >= least) continue;
        const double d = evaluate(i, x, nullptr, nullptr);
        if (d < least) least = d, found = i;
    }
    if (which != nullptr) *which = found;
    if (gradient != nullptr && found < count()) evaluate(found, x, gradient, nullptr);
    return least;
}

// Between two places that are t apart, one of them t away from all obstacles, all is free.
ObstacleSet::Way ObstacleSet::follow(const double* a, const double* b, double margin, uint32_t steps,
                                     double* done) const {
    Obstacle::Place along{}, at{};
    double square = 0;
    for (uint32_t k = 0; k < dimension_; ++k) {
        along[k] = b[k] - a[k];
        square += along[k] * along[k];
    }
    const double length = std::sqrt(square);
    for (uint32_t step = 0; step < steps; ++step) {
        const double t = length > 0 ? std::min(*done / length, 1.0) : 1;
        for (uint32_t k = 0; k < dimension_; ++k) at[k] = a[k] + t * along[k];
        const double d = distance(at.data());
        if (!(d >= margin)) return Way::blocked;
        if (t >= 1) return Way::clear;
        *done += d;
    }
    return Way::unfinished;
}

bool ObstacleSet::clear(const double* a, const double* b, double margin) const {
    double done = 0;
    for (;;) {
        const Way way = follow(a, b, margin, UINT32_MAX, &done);
        if (way != Way::unfinished) return way == Way::clear;
    }
}

double ObstacleSet::step_limit() const {
    double limit = std::numeric_limits<double>::infinity();
    for (const Obstacle* obstacle : obstacles_) limit = std::min(limit, obstacle->core_depth());
    return limit;
}

double ObstacleSet::reach() const {
    double reach = std::numeric_limits<double>::infinity();
    for (const Obstacle* obstacle : obstacles_) reach = std::min(reach, obstacle->reach() - clearance_);
    return reach;
}

bool ObstacleSet::box(Obstacle::Box& box) const {
    bool any = false;
    for (const Obstacle* obstacle : obstacles_) {
        Obstacle::Box other = obstacle->box();
        bool finite = true;
        for (uint32_t k = 0; k < dimension_; ++k) {
            finite = finite && std::isfinite(other.lower[k]) && std::isfinite(other.upper[k]);
            if (!obstacle->bounded()) continue;
            other.lower[k] -= clearance_;
            other.upper[k] += clearance_;
        }
        if (!finite) continue;
        for (uint32_t k = 0; k < dimension_; ++k) {
            box.lower[k] = any ? std::min(box.lower[k], other.lower[k]) : other.lower[k];
            box.upper[k] = any ? std::max(box.upper[k], other.upper[k]) : other.upper[k];
        }
        any = true;
    }
    return any;
}

}  // namespace flg
