// SPDX-License-Identifier: MIT
#include "surfaces/tracing/straight_walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/each.h"
#include "surfaces/mesh/mesh_measures.h"

namespace flg {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;
constexpr double least_share = 1e-5;   // of an edge: walks cross it so far from its ends
constexpr double border_angle = 1e-3;  // radians: how directions along a border lead into the surface
constexpr uint32_t no_edge = 3;

Vec3 edge_vector(const Mesh& mesh, Corner corner) {
    return mesh.position(mesh.vertex_at(next_corner(corner))) - mesh.position(mesh.vertex_at(corner));
}

}  // namespace

void DirectionFrame::add(const Mesh& mesh, Corner corner, const Vec3& along, double size) {
    const Vec3 normal = triangle_normal(mesh, triangle_of(corner));
    if (!(along.squaredNorm() > 0) || normal.isZero(0)) size = 0;
    const Vec3 unit = along.stableNormalized();
    wedges_.push_back({triangle_of(corner), turn_, size, unit, normal.cross(unit)});
    turn_ += size;
}

Task<void> set_frame(Pace& pace, DirectionFrame& frame, const Mesh& mesh, SurfacePlace place) {
    frame.wedges_.clear();
    frame.turn_ = 0;
    frame.scale_ = 1;
    frame.place_ = place;
    frame.closed_ = true;
    if (place.on == SurfacePlace::On::triangle) {
        frame.add(mesh, 3 * place.index, edge_vector(mesh, 3 * place.index), full_turn);
        co_return;
    }
    if (place.on == SurfacePlace::On::edge) {
        frame.add(mesh, place.index, edge_vector(mesh, place.index), std::numbers::pi);
        const Corner other = mesh.opposite(place.index);
        frame.closed_ = other != no_index;
        if (frame.closed_) frame.add(mesh, other, edge_vector(mesh, other), std::numbers::pi);
        co_return;
    }
    Slice slice(Cost::hundreds_of_ns);
    const Corner first = mesh.corner_of_vertex[place.index];
    Corner corner = first;
    do {
        const Vec3 begin = edge_vector(mesh, corner), end = -edge_vector(mesh, previous_corner(corner));
        frame.add(mesh, corner, begin, std::atan2(begin.cross(end).norm(), begin.dot(end)));
        corner = mesh.turn(corner);
        if (slice.is_over()) co_await pace;
    } while (corner != first && corner != no_index);
    frame.closed_ = corner == first;
    if (frame.closed_ && frame.turn_ > 0) frame.scale_ = full_turn / frame.turn_;
}

double DirectionFrame::angle_of(uint32_t triangle, const Vec3& direction) const {
    for (const Wedge& wedge : wedges_) {
        if (wedge.triangle != triangle) continue;
        double angle = std::atan2(direction.dot(wedge.across), direction.dot(wedge.along));
        if (wedge.size < full_turn) angle = std::clamp(angle, 0.0, wedge.size);
        return scale_ * (wedge.begin + angle);
    }
    return 0;
}

// From the middle of what there is, -pi to pi.
double DirectionFrame::from_middle(double angle) const {
    const double off = angle - 0.5 * turn_;
    return off - full_turn * std::round(off / full_turn);
}

double DirectionFrame::half_tangent(double forward, bool is_forward) const {
    const double back = forward + std::numbers::pi, half = 0.5 * turn_;
    if (closed_ || (std::abs(from_middle(forward)) <= half && std::abs(from_middle(back)) <= half))
        return is_forward ? forward : back;
    return is_forward == (from_middle(forward) > 0) ? turn_ : 0;
}

SurfaceRay DirectionFrame::ray(const Mesh& mesh, double angle) const {
    double at = angle / scale_;
    if (closed_) {
        at -= turn_ * std::floor(at / turn_);
    } else {
        const double most = 0.5 * turn_ - std::min(border_angle, 0.1 * turn_);
        at = 0.5 * turn_ + std::clamp(from_middle(at), -most, most);
    }
    auto wedge = std::upper_bound(wedges_.begin() + 1, wedges_.end(), at,
                                  [](double value, const Wedge& w) { return value < w.begin; }) -
                 1;
    while (wedge->size == 0 && wedge != wedges_.begin()) --wedge;
    while (wedge->size == 0) ++wedge;
    const double angle_in = std::clamp(at - wedge->begin, 0.0, wedge->size);
    SurfaceRay out;
    find_in(mesh, place_, wedge->triangle, out.from);
    out.direction = std::cos(angle_in) * wedge->along + std::sin(angle_in) * wedge->across;
    return out;
}

Task<void> walk_straight(Pace& pace, const Mesh& mesh, SurfaceRay ray, double length, SurfacePath& out) {
    out.clear();
    out.add(mesh, ray.from);
    Weights weights = weights_of(ray.from);
    uint32_t triangle = ray.from.triangle, entry = no_edge;
    Vec3 direction = ray.direction;
    Slice slice(Cost::tens_of_ns);
    uint32_t crossings = 0;
    for (double left = length; left > 0 && crossings < 3 * mesh.triangle_count(); ++crossings) {
        const Vec3 area = vector_area(mesh, triangle);
        if (!(area.squaredNorm() > 0)) break;
        // How the weights change along the way: that of corner k is 0 on the edge after it.
        Weights rates{};
        double until = left;
        uint32_t exit = no_edge;
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t edge = (k + 1) % 3;
            rates[k] = area.cross(edge_vector(mesh, 3 * triangle + edge)).dot(direction) / (2 * area.squaredNorm());
            if (edge == entry || !(rates[k] < 0)) continue;
            const double away = std::max(weights[k], 0.0) / -rates[k];
            if (away >= until) continue;
            until = away;
            exit = edge;
        }
        for (uint32_t k = 0; k < 3; ++k) weights[k] += until * rates[k];
        left -= until;
        if (exit == no_edge) break;
        const Corner corner = 3 * triangle + exit, across = mesh.opposite(corner);
        if (across == no_index) break;
        const uint32_t from = exit, to = (exit + 1) % 3;
        const double sum = weights[from] + weights[to];
        const float share = round_on_edge(std::clamp(weights[to] / sum, least_share, 1 - least_share));
        const SurfacePoint point = point_on_edge(across, 1 - share);
        out.add(mesh, point);
        // Straight on: what it has along the edge stays.
        const Vec3 edge = edge_vector(mesh, across).stableNormalized();
        const double along = direction.dot(edge);
        triangle = triangle_of(across);
        direction =
            along * edge + std::sqrt(std::max(0.0, 1 - along * along)) * triangle_normal(mesh, triangle).cross(edge);
        entry = across % 3;
        weights = weights_of(point);
        if (slice.is_over(2)) co_await pace;
    }
    out.add(mesh, moved_inside(triangle, weights[1], weights[2]));
}

}  // namespace flg
