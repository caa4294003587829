// SPDX-License-Identifier: MIT
// Straight over a surface of R^3, step by step: along the circle that osculates the geodesic, and back onto the
// surface. Off the geodesic by the square of a step's length.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec.h"
#include "splines/manifolds/manifold.h"

namespace flg {

class ManifoldWalk {
public:
    ManifoldWalk(const Manifold& manifold, Memory* memory) : manifold_(manifold), hint_(manifold.hint_size(), memory) {}

    // At the surface's point near a place, in the direction of `way`. False where there is none.
    bool begin(const Vec3& place, const Vec3& way) {
        place_ = place;
        std::fill(hint_.begin(), hint_.end(), 0.0);
        if (!manifold_.project(place_.data(), hint_.data())) return false;
        return turn(way);
    }
    // False where the surface ends: then it stays. Some us.
    bool step(double length) {
        const double along[2] = {way_.dot(Vec3(basis_)), way_.dot(Vec3(basis_ + 3))};
        double form[4] = {};
        manifold_.second_form(place_.data(), hint_.data(), basis_, up_.data(), form);
        const double bend = along[0] * along[0] * form[0] + 2 * along[0] * along[1] * form[1] +
                            along[1] * along[1] * form[3],
                     angle = bend * length, half = 0.5 * angle;
        const double share = std::abs(half) > 1e-4 ? std::sin(half) / half : 1 - half * half / 6;
        const Vec3 before = place_, way = way_, up = up_;
        place_ += length * share * (std::cos(half) * way + std::sin(half) * up);
        if (!manifold_.project(place_.data(), hint_.data())) {
            place_ = before;
            return false;
        }
        return turn(std::cos(angle) * way + std::sin(angle) * up);
    }
    const Vec3& place() const { return place_; }
    const Vec3& up() const { return up_; }

private:
    bool turn(const Vec3& way) {
        manifold_.tangent_basis(place_.data(), hint_.data(), basis_);
        up_ = Vec3(basis_).cross(Vec3(basis_ + 3));
        const Vec3 own = way - way.dot(up_) * up_;
        const double length = own.norm();
        if (!(length > least_way)) return false;
        way_ = own / length;
        return true;
    }

    static constexpr double least_way = 1e-6;  // of a direction along the surface: less is none

    const Manifold& manifold_;
    Buffer<double> hint_;
    Vec3 place_, way_, up_;
    double basis_[6] = {};  // two rows
};

}  // namespace flg
