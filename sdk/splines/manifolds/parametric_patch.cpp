// SPDX-License-Identifier: MIT
#include "splines/manifolds/parametric_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flg {

namespace {

constexpr int grid_size = 33;  // points along each parameter
constexpr int max_rounds = 40;
constexpr int max_halvings = 12;
// Of the size. A step of Newton's method this long leads to the footpoint up to its square.
constexpr double last_step = 1e-9;
constexpr double blind_step = 1e-6;
constexpr double far_away = 0.02;

// The direction that solves h step = -gradient; h is symmetric. False unless h is positive definite.
bool solve(double huu, double huv, double hvv, double gu, double gv, std::array<double, 2>& step) {
    constexpr double min_share = 1e-3;  // of the product of the diagonal: beyond it the matrix is as good as singular
    const double determinant = huu * hvv - huv * huv;
    if (!(huu > 0 && hvv > 0 && determinant > min_share * huu * hvv)) return false;
    step = {(huv * gv - hvv * gu) / determinant, (huv * gu - huu * gv) / determinant};
    return true;
}

}  // namespace

void ParametricPatch::prepare() {
    grid_.clear();
    grid_.reserve(grid_size * grid_size);
    for (int j = 0; j < grid_size; ++j) {
        for (int i = 0; i < grid_size; ++i) {
            const double u = domain_.low[0] + (domain_.high[0] - domain_.low[0]) * i / (grid_size - 1);
            const double v = domain_.low[1] + (domain_.high[1] - domain_.low[1]) * j / (grid_size - 1);
            grid_.push_back(evaluate(u, v).at);
        }
    }
}

double ParametricPatch::nearest_on_grid(const Vec3& x, std::array<double, 2>& parameters) const {
    double least = std::numeric_limits<double>::infinity();
    size_t best = 0;
    for (size_t i = 0; i < grid_.size(); ++i) {
        const double square = (grid_[i] - x).squaredNorm();
        if (square < least) {
            least = square;
            best = i;
        }
    }
    const size_t place[] = {best % grid_size, best / grid_size};
    for (size_t k = 0; k < 2; ++k) {
        const double share = static_cast<double>(place[k]) / (grid_size - 1);
        parameters[k] = domain_.low[k] + (domain_.high[k] - domain_.low[k]) * share;
    }
    return least;
}

// Back into the period, or to where functions are defined still. Whether the domain was left by no more than its
// margin.
bool ParametricPatch::keep_inside(std::array<double, 2>& parameters) const {
    bool inside = true;
    for (size_t k = 0; k < 2; ++k) {
        const double low = domain_.low[k], extent = domain_.high[k] - low;
        if (domain_.periodic[k]) {
            parameters[k] -= extent * std::floor((parameters[k] - low) / extent);
            continue;
        }
        const double room = domain_.margin * extent, beyond = 2 * room;
        inside = inside && parameters[k] >= low - room && parameters[k] <= domain_.high[k] + room;
        parameters[k] = std::min(std::max(parameters[k], low - beyond), domain_.high[k] + beyond);
    }
    return inside;
}

// Newton's method where the squared distance is convex, Gauss's elsewhere; a step is halved until it comes nearer.
bool ParametricPatch::find_footpoint(const Vec3& target, std::array<double, 2>& at, Vec3& foot) const {
    PatchPoint point = evaluate(at[0], at[1]);
    double distance = (point.at - target).squaredNorm();
    for (int round = 0; round < max_rounds; ++round) {
        const Vec3 off = point.at - target;
        const double e = point.u.squaredNorm(), f = point.u.dot(point.v), g = point.v.squaredNorm();
        const double gu = point.u.dot(off), gv = point.v.dot(off);
        std::array<double, 2> step;
        if (!solve(e + off.dot(point.uu), f + off.dot(point.uv), g + off.dot(point.vv), gu, gv, step) &&
            !solve(e, f, g, gu, gv, step)) {
            return false;
        }
        const double length = (step[0] * point.u + step[1] * point.v).norm();
        if (length <= last_step * size()) {
            at = {at[0] + step[0], at[1] + step[1]};
            const bool inside = keep_inside(at);
            foot = evaluate(at[0], at[1]).at;
            return inside && foot.allFinite();
        }
        for (int halving = 0;; ++halving) {
            // Held by the end of the domain.
            if (halving == max_halvings) return false;
            std::array<double, 2> next{at[0] + step[0], at[1] + step[1]};
            keep_inside(next);
            point = evaluate(next[0], next[1]);
            const double now = (point.at - target).squaredNorm();
            // Near its least value the distance is blind to steps: rounding must not refuse them.
            if (now < distance || length <= blind_step * size()) {
                distance = now;
                at = next;
                break;
            }
            step = {0.5 * step[0], 0.5 * step[1]};
        }
    }
    return false;
}

// What is remembered may have become a footpoint that is nearest no more: that is asked only where it is far away.
bool ParametricPatch::project(double* x, double* hint) const {
    const Vec3 target(x[0], x[1], x[2]);
    if (!target.allFinite()) return false;
    std::array<double, 2> at{hint[0], hint[1]}, start;
    Vec3 foot = Vec3::Zero();
    bool found = hint[2] != 0 && find_footpoint(target, at, foot);
    if (!found || (foot - target).norm() > far_away * size()) {
        const double nearest = nearest_on_grid(target, start);
        if (!found || nearest < (foot - target).squaredNorm()) {
            at = start;
            found = find_footpoint(target, at, foot);
        }
    }
    if (!found) return false;
    for (int i = 0; i < 3; ++i) x[i] = foot[i];
    hint[0] = at[0], hint[1] = at[1], hint[2] = 1;
    return true;
}

void ParametricPatch::tangent_basis(const double*, double* hint, double* basis) const {
    const PatchPoint point = evaluate(hint[0], hint[1]);
    const Vec3 first = point.u.normalized();
    const Vec3 second = (point.v - point.v.dot(first) * first).normalized();
    for (int i = 0; i < 3; ++i) basis[i] = first[i], basis[3 + i] = second[i];
}

void ParametricPatch::second_form(const double*, double* hint, const double* basis, const double* force,
                                  double* form) const {
    const PatchPoint point = evaluate(hint[0], hint[1]);
    const Vec3 first(basis[0], basis[1], basis[2]), second(basis[3], basis[4], basis[5]);
    const Vec3 normal = first.cross(second);
    const double along = normal.dot(Vec3(force[0], force[1], force[2]));
    const double uu = along * normal.dot(point.uu), uv = along * normal.dot(point.uv),
                 vv = along * normal.dot(point.vv);
    // The basis in terms of u and v, whatever basis of the tangents it is: the inverse of these dot products.
    const double a = first.dot(point.u), b = second.dot(point.u), c = first.dot(point.v), d = second.dot(point.v);
    const double determinant = a * d - b * c;
    const double t[2][2] = {{d / determinant, -b / determinant}, {-c / determinant, a / determinant}};
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
            form[2 * i + j] =
                t[i][0] * t[j][0] * uu + (t[i][0] * t[j][1] + t[i][1] * t[j][0]) * uv + t[i][1] * t[j][1] * vv;
        }
    }
}

}  // namespace flg
