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
// Likewise what a window does not light: around its end ways are as long as those of the light that goes on there.
constexpr double unlit_slack = 1e-12;

// By way of the stretch of the edge that the window lights, in the edge's coordinates.
double distance_through(const Window& window, const Vec2& place, double longest_edge) {
    double crossed = place.x();
    if (window.is_straight()) {
        crossed -= window.x / window.y * place.y();
    } else if (place.y() > window.y) {
        crossed += (window.x - place.x()) * place.y() / (place.y() - window.y);
    }
    if (crossed >= window.begin && crossed <= window.end) return window.distance_at(place);
    const Vec2 end(crossed < window.begin ? window.begin : window.end, 0);
    return window.distance_at(end) + (place - end).norm() + unlit_slack * longest_edge;
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
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Found found{infinity, no_index, {infinity, infinity}};
    const auto take = [&found](double distance, uint32_t label) {
        if (distance < found.distance) found.distance = distance, found.label = label;
        if (label < SidedSegment::beyond_end) found.of_sides[label % 2] = std::min(found.of_sides[label % 2], distance);
    };
    for (const uint32_t i : pieces_of_.of(triangle)) {
        take((at - pieces_[i].foot_of(at)).norm(), pieces_[i].label_of(at));
    }
    // From each edge: the place above it, and how far along.
    std::array<Vec2, 3> seen;
    for (uint32_t k = 0; k < 3; ++k) {
        const double length = face.lengths[k];
        seen[k] = {weights[(k + 1) % 3] * length + weights[(k + 2) % 3] * face.along[k],
                   weights[(k + 2) % 3] * face.above[k]};
    }
    const double longest_edge = *std::max_element(face.lengths.begin(), face.lengths.end());
    for (const uint32_t i : windows_of_.of(triangle)) {
        const Window& window = windows_[i];
        take(distance_through(window, seen[window.edge % 3], longest_edge), window.label);
    }
    const double slack = corner_slack * longest_edge;
    for (uint32_t k = 0; k < 3; ++k) {
        const double distance = solver_.distance(face.vertices[k]) + seen[k].norm();
        if (distance + slack < found.distance) take(distance, solver_.label(face.vertices[k]));
    }
    return found;
}

}  // namespace flg
