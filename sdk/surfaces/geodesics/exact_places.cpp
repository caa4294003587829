// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/exact_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flg {

namespace {

// A corner counts only where it is nearer than the windows by this, of the longest edge: on the curve itself it does
// not know which side is which.
constexpr double corner_slack = 1e-7;

// By way of the stretch of the edge that the window lights, in the edge's coordinates.
double distance_through(const Window& window, const Vec2& place) {
    double crossed = place.x();
    if (window.is_straight()) {
        crossed -= window.x / window.y * place.y();
    } else if (place.y() > window.y) {
        crossed += (window.x - place.x()) * place.y() / (place.y() - window.y);
    }
    if (crossed >= window.begin && crossed <= window.end) return window.distance_at(place);
    const Vec2 end(crossed < window.begin ? window.begin : window.end, 0);
    return window.distance_at(end) + (place - end).norm();
}

}  // namespace

Task<void> sort_lights(Pace& pace, ExactPlaces& places) {
    const size_t triangles = places.solver_.faces().faces.size();
    places.windows_of_ = co_await group_by(pace, places.windows_.size(), triangles,
                                           [&places](uint32_t i) { return triangle_of(places.windows_[i].edge); });
    places.pieces_of_ = co_await group_by(pace, places.pieces_.size(), triangles,
                                          [&places](uint32_t i) { return places.pieces_[i].triangle; });
}

Vec2 ExactPlaces::place(uint32_t triangle, const Weights& weights) const {
    const ExactFace& face = solver_.faces().faces[triangle];
    return {weights[1] * face.lengths[0] + weights[2] * face.along[0], weights[2] * face.above[0]};
}

Weights ExactPlaces::weights_of_way(uint32_t triangle, const Vec2& way) const {
    const ExactFace& face = solver_.faces().faces[triangle];
    const double third = way.y() / face.above[0], second = (way.x() - third * face.along[0]) / face.lengths[0];
    return {-second - third, second, third};
}

ExactPlaces::Found ExactPlaces::at(uint32_t triangle, const Weights& weights) const {
    const ExactFace& face = solver_.faces().faces[triangle];
    const Vec2 at = place(triangle, weights);
    Found found{std::numeric_limits<double>::infinity(), no_index};
    for (const uint32_t i : pieces_of_.of(triangle)) {
        const double distance = (at - pieces_[i].foot_of(at)).norm();
        if (distance < found.distance) found = {distance, pieces_[i].label_of(at)};
    }
    // From each edge: the place above it, and how far along.
    std::array<Vec2, 3> seen;
    for (uint32_t k = 0; k < 3; ++k) {
        const double length = face.lengths[k];
        seen[k] = {weights[(k + 1) % 3] * length + weights[(k + 2) % 3] * face.along[k],
                   weights[(k + 2) % 3] * face.above[k]};
    }
    for (const uint32_t i : windows_of_.of(triangle)) {
        const Window& window = windows_[i];
        const double distance = distance_through(window, seen[window.edge % 3]);
        if (distance < found.distance) found = {distance, window.label};
    }
    const double slack = corner_slack * *std::max_element(face.lengths.begin(), face.lengths.end());
    for (uint32_t k = 0; k < 3; ++k) {
        const double distance = solver_.distance(face.vertices[k]) + seen[k].norm();
        if (distance + slack < found.distance) found = {distance, solver_.label(face.vertices[k])};
    }
    return found;
}

}  // namespace flg
