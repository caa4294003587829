// SPDX-License-Identifier: MIT
#include "splines/obstacles/obstacle.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr double deep = 0.5;                          // of the core's depth
constexpr uint32_t max_looks = 64, most_looks = 512;  // the latter along a hair, which is grazed then

// How often the way from a to b turns around p, beside what its ends and others' cancel: its crossings of the ray from
// p along x.
int crossing(const Obstacle::Place& p, const double* a, const double* b) {
    if ((a[1] <= p[1]) == (b[1] <= p[1])) return 0;
    const double side = (b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1]);
    const bool up = a[1] <= p[1];
    return (side > 0) == up ? (up ? 1 : -1) : 0;
}

}  // namespace

void Obstacle::draw(double clearance, Wires& wires) const {
    Place centre{}, half{};
    std::array<Place, max_dimension> axes{};
    for (uint32_t k = 0; k < dimension_; ++k) {
        centre[k] = 0.5 * (box_.lower[k] + box_.upper[k]);
        half[k] = 0.5 * (box_.upper[k] - box_.lower[k]) + clearance;
        axes[k][k] = 1;
    }
    draw_box(centre, half, axes, wires);
}

void Obstacle::draw_box(const Place& centre, const Place& half, const std::array<Place, max_dimension>& axes,
                        Wires& wires) const {
    const auto corner = [&](uint32_t signs) {
        Place at = centre;
        for (uint32_t i = 0; i < dimension_; ++i) {
            const double along = (signs >> i & 1) != 0 ? half[i] : -half[i];
            for (uint32_t k = 0; k < dimension_; ++k) at[k] += along * axes[i][k];
        }
        return at;
    };
    for (uint32_t signs = 0; signs < 1u << dimension_; ++signs) {
        for (uint32_t i = 0; i < dimension_; ++i) {
            if ((signs >> i & 1) == 0) wires.line(corner(signs), corner(signs | 1u << i));
        }
    }
}

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
        const double d = obstacles_[i]->evaluate_exactly(x, nullptr, nullptr, clearance_) - clearance_;
        if (d < least) least = d, found = i;
    }
    if (which != nullptr) *which = found;
    if (gradient != nullptr && found < count()) obstacles_[found]->evaluate_exactly(x, gradient, nullptr);
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

// In steps to where it may get so deep, looks of a sixty-fourth of the way at least, but no longer than what is so deep
// is wide.
bool ObstacleSet::pierces(uint32_t i, const double* a, const double* b) const {
    const double depth = deep * obstacles_[i]->core_depth();
    double square = 0;
    Obstacle::Place at{};
    for (uint32_t k = 0; k < dimension_; ++k) {
        square += (b[k] - a[k]) * (b[k] - a[k]);
        at[k] = 0.5 * (a[k] + b[k]);
    }
    const double length = std::sqrt(square);
    if (obstacles_[i]->bounded() && at_least(i, at.data()) + clearance_ > 0.5 * length) return false;
    if (obstacles_[i]->evaluate(at.data(), nullptr, nullptr) + depth > 0.5 * length) return false;
    const double least = std::min(length / max_looks, depth);
    double done = 0;
    for (uint32_t look = 0; look < most_looks && done <= length; ++look) {
        const double t = length > 0 ? done / length : 0;
        for (uint32_t k = 0; k < dimension_; ++k) at[k] = a[k] + t * (b[k] - a[k]);
        const double above = obstacles_[i]->evaluate(at.data(), nullptr, nullptr) + depth;
        if (above < 0) return true;
        done += std::max(above, least);
        if (length == 0) break;
    }
    return false;
}

bool ObstacleSet::keeps_sides(const double* a, const double* b, const double* c, const double* e) const {
    for (uint32_t i = 0; i < count(); ++i) {
        if (dimension_ == 2) {
            const Obstacle::Place& core = obstacles_[i]->core();
            if (crossing(core, a, b) + crossing(core, b, e) + crossing(core, e, c) + crossing(core, c, a) != 0)
                return false;
        } else if (pierces(i, a, c) || pierces(i, b, e)) {
            return false;
        }
        if (pierces(i, c, e) && !pierces(i, a, b)) return false;
    }
    return true;
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
