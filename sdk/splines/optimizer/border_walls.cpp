// SPDX-License-Identifier: MIT
#include "splines/optimizer/border_walls.h"

#include <cmath>

#include "core/vec.h"
#include "splines/manifolds/coordinates.h"

namespace flg {

namespace {

// Of the size: what is not farther from the border is at it.
constexpr double at_border = 1e-8, least_step = 1e-11;
constexpr double min_rate = 0.1;        // less, and the border is no wall for the manifold
constexpr uint32_t confine_rounds = 8;  // of going to the border and onto the manifold

// With the basis of a place near it: of the border of parts that face the same way.
bool look_at_border(const MeshBorder& border, const double* x, const double* basis, uint32_t n, BorderView& out) {
    if (!basis || n != 3) return border.look(Vec3(x), nullptr, out);
    const Vec3 normal = Vec3(basis).cross(Vec3(basis + 3));
    return border.look(Vec3(x), &normal, out);
}

}  // namespace

void BorderWalls::find(uint32_t node, const double* x, const double* gradient, double* basis) {
    const uint32_t n = manifold_.ambient();
    Wall& wall = walls_[node];
    BorderView view;
    if (!look_at_border(*border_, x, basis, n, view)) return;
    wall.away = view.inside - within_;
    const bool is_there = wall.away <= at_border * manifold_.size();
    if (is_there && view.at_vertex) {
        const Vec3 force = -Vec3(gradient);
        const double in_first = force.dot(view.inwards_of[0]), in_second = force.dot(view.inwards_of[1]);
        // Inwards, of both edges at a corner that points out, of one at another.
        if (view.points_in ? in_first > 0 || in_second > 0 : in_first > 0 && in_second > 0) return;
        const double along_first = force.dot(view.ways[0]), along_second = force.dot(view.ways[1]);
        if (along_first <= 0 && along_second <= 0) {
            wall.pressed = wall.began = 2;
            return;
        }
        view.inwards = view.inwards_of[along_first < along_second];
    }
    face(wall, view, basis);
    if (!wall.is_near || !is_there || !(inner_product(gradient, basis + n, n) > 0)) return;
    wall.pressed = wall.began = 1;
}

// Turns the basis until its second vector points inwards.
void BorderWalls::face(Wall& wall, const BorderView& view, double* basis) const {
    const uint32_t n = manifold_.ambient();
    const double u = view.inwards.dot(Vec3(basis)), v = view.inwards.dot(Vec3(basis + n)), rate = std::hypot(u, v);
    if (!(rate > min_rate)) return;
    wall.is_near = true;
    wall.rate = rate;
    wall.curvature = view.curvature;
    for (uint32_t c = 0; c < n; ++c) {
        const double first = basis[c], second = basis[n + c];
        basis[c] = (v * first - u * second) / rate;
        basis[n + c] = (u * first + v * second) / rate;
    }
}

bool BorderWalls::confine(double* x, double* hint, const double* basis) const {
    if (border_ == nullptr) return true;
    const uint32_t n = manifold_.ambient();
    BorderView view;
    for (uint32_t round = 0; round < confine_rounds; ++round) {
        if (!look_at_border(*border_, x, basis, n, view)) return true;
        const double by = within_ - view.inside;
        if (by <= least_step * manifold_.size()) return true;
        // Along the manifold, until it is there.
        double own[Manifold::max_dimension * Manifold::max_ambient];
        manifold_.tangent_basis(x, hint, own);
        const double u = view.inwards.dot(Vec3(own)), v = view.inwards.dot(Vec3(own + n)), square = u * u + v * v;
        if (!(square > min_rate * min_rate)) return true;
        for (uint32_t c = 0; c < n; ++c) x[c] += by / square * (u * own[c] + v * own[n + c]);
        if (!manifold_.project(x, hint)) return false;
    }
    return true;
}

double BorderWalls::push(uint32_t node) const {
    const Wall& wall = walls_[node];
    return wall.pressed == 1 ? -wall.away / wall.rate : 0;
}

bool BorderWalls::is_passed(uint32_t node, double step) const {
    const Wall& wall = walls_[node];
    return !(wall.away + wall.rate * step >= -at_border * manifold_.size());
}

}  // namespace flg
