// SPDX-License-Identifier: MIT
#include "surfaces/integral_curve_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flg {

namespace {

struct Slope {
    Weights rates{};               // how the weights change uphill; the largest is 1 in size; 0 where flat
    double steepness_squared = 0;  // (value / metre)^2; infinite without area
    bool is_flat() const { return rates == Weights{}; }
};

Slope slope_of(const SlopedField& field, uint32_t triangle) {
    const Mesh& mesh = field.mesh();
    const Triple& t = mesh.triangles[triangle];
    const Vec3 edges[3] = {mesh.position(t[2]) - mesh.position(t[1]), mesh.position(t[0]) - mesh.position(t[2]),
                           mesh.position(t[1]) - mesh.position(t[0])};
    const double base = field.height(t[0]);
    const Vec3 w = (field.height(t[1]) - base) * edges[1] + (field.height(t[2]) - base) * edges[2];
    Slope slope;
    const double u = edges[1].dot(w), v = edges[2].dot(w);
    slope.rates = {-u - v, u, v};  // their sum is 0
    const double largest = std::max({std::abs(u), std::abs(v), std::abs(u + v)});
    if (largest == 0) return slope;
    for (double& rate : slope.rates) rate /= largest;
    const double area_squared = edges[1].cross(edges[2]).squaredNorm();
    slope.steepness_squared =
        area_squared > 0 ? w.squaredNorm() / area_squared : std::numeric_limits<double>::infinity();
    return slope;
}

// Where the way uphill from `weights` leaves the triangle.
SurfacePlace exit_of(const Mesh& mesh, uint32_t triangle, const Weights& weights, const Weights& rates) {
    uint32_t out = 0;
    double time = std::numeric_limits<double>::infinity();
    for (uint32_t k = 0; k < 3; ++k) {
        if (rates[k] < 0 && weights[k] < -rates[k] * time) {
            time = weights[k] / -rates[k];
            out = k;
        }
    }
    const uint32_t from = (out + 1) % 3, to = (out + 2) % 3;
    const double at_from = std::max(0.0, weights[from] + time * rates[from]);
    const double at_to = std::max(0.0, weights[to] + time * rates[to]);
    return place_on_edge(mesh, 3 * triangle + from, at_to / (at_from + at_to));
}

// Straight uphill through a triangle from a place in it; to its highest corner if rounding leaves nothing of the rise, or
// if it has no area and so no direction. Leaves the step as it is if that isn't higher either.
void cross(const SlopedField& field, const SurfacePlace& from, uint32_t triangle, const Slope& slope,
           IntegralCurveStep& step) {
    const Mesh& mesh = field.mesh();
    const double height = field.height(from);
    const Triple& t = mesh.triangles[triangle];
    SurfacePlace to = place_at_vertex(*std::max_element(
        t.begin(), t.end(), [&](uint32_t a, uint32_t b) { return field.height(a) < field.height(b); }));
    SurfacePoint point;
    if (!slope.is_flat() && find_in(mesh, from, triangle, point)) {
        const SurfacePlace exit = exit_of(mesh, triangle, weights_of(point), slope.rates);
        if (field.height(exit) > height) to = exit;
    }
    if (!(field.height(to) > height)) return;
    step.rises = true;
    step.triangle = triangle;
    step.to = to;
}

IntegralCurveStep step_from_vertex(const SlopedField& field, const SurfacePlace& from) {
    const Mesh& mesh = field.mesh();
    IntegralCurveStep step;
    const double height = field.height(from.index);
    double steepest_squared = -1;
    Slope slope_through;
    uint32_t through = no_index;
    const auto try_edge = [&](uint32_t triangle, uint32_t end) {
        const double rise = field.height(end) - height;
        if (!(rise > 0) || !std::isfinite(rise)) return;
        const double length_squared = (mesh.position(end) - mesh.position(from.index)).squaredNorm();
        const double squared =
            length_squared > 0 ? rise * rise / length_squared : std::numeric_limits<double>::infinity();
        if (squared <= steepest_squared) return;
        steepest_squared = squared;
        through = no_index;
        step.rises = true;
        step.triangle = triangle;
        step.to = place_at_vertex(end);
    };
    const auto try_edges = [&](Corner corner) {
        try_edge(triangle_of(corner), mesh.vertex_at(next_corner(corner)));
        try_edge(triangle_of(corner), mesh.vertex_at(previous_corner(corner)));
    };
    const Corner first = mesh.corner_of_vertex[from.index];
    Corner corner = first;
    step.cost = 0;
    do {
        ++step.cost;
        const uint32_t triangle = triangle_of(corner);
        if (!field.is_open(triangle)) {
            step.at_border = true;
        } else {
            try_edges(corner);
            const Slope slope = slope_of(field, triangle);
            if (slope.rates[next_corner(corner) % 3] > 0 && slope.rates[previous_corner(corner) % 3] > 0 &&
                slope.steepness_squared > steepest_squared && std::isfinite(slope.steepness_squared)) {
                steepest_squared = slope.steepness_squared;
                through = triangle;
                slope_through = slope;
            }
        }
        corner = mesh.turn(corner);
    } while (corner != first && corner != no_index);
    if (corner == no_index) step.at_border = true;
    if (through != no_index) cross(field, from, through, slope_through, step);
    if (step.rises || !step.at_border) return step;
    // A solver that stopped early may leave nothing finite beside an edge but its ends.
    corner = first;
    do {
        if (field.is_in_regions(triangle_of(corner))) try_edges(corner);
        corner = mesh.turn(corner);
    } while (corner != first && corner != no_index);
    step.leaves = step.rises;
    step.cost *= 2;
    return step;
}

IntegralCurveStep step_from_edge(const SlopedField& field, const SurfacePlace& from) {
    const Mesh& mesh = field.mesh();
    IntegralCurveStep step;
    step.cost = 2;
    const Corner sides[2] = {from.index, mesh.opposite(from.index)};
    uint32_t through = no_index, along = no_index;
    Slope slope_through;
    for (Corner side : sides) {
        if (side == no_index || !field.is_open(triangle_of(side))) {
            step.at_border = true;
            continue;
        }
        along = triangle_of(side);
        const Slope slope = slope_of(field, along);
        if (slope.rates[previous_corner(side) % 3] > 0 &&
            (through == no_index || slope.steepness_squared > slope_through.steepness_squared)) {
            through = along;
            slope_through = slope;
        }
    }
    if (through != no_index) {
        cross(field, from, through, slope_through, step);
        if (step.rises) return step;
    }
    step.leaves = step.at_border;
    if (along == no_index) return step;
    const uint32_t a = mesh.vertex_at(from.index), b = mesh.vertex_at(next_corner(from.index));
    step.triangle = along;
    step.to = place_at_vertex(field.height(a) > field.height(b) ? a : b);
    step.rises = field.height(step.to) > field.height(from);
    return step;
}

IntegralCurveStep step_from_triangle(const SlopedField& field, const SurfacePlace& from) {
    IntegralCurveStep step;
    step.at_border = !field.is_open(from.index);
    if (step.at_border) return step;
    cross(field, from, from.index, slope_of(field, from.index), step);
    return step;
}

}  // namespace

bool SlopedField::is_open(uint32_t triangle) const {
    const Triple& t = mesh_.triangles[triangle];
    return regions_.contains(mesh_.regions[triangle]) && std::isfinite(values_[t[0]]) && std::isfinite(values_[t[1]]) &&
           std::isfinite(values_[t[2]]);
}

double SlopedField::height(const SurfacePlace& place) const {
    switch (place.on) {
        case SurfacePlace::On::vertex: return height(place.index);
        case SurfacePlace::On::edge: {
            // From the lower end, so that both sides of the edge agree to the bit.
            const double a = height(mesh_.vertex_at(place.index)),
                         b = height(mesh_.vertex_at(next_corner(place.index)));
            const double t = place.u;
            return a <= b ? a + t * (b - a) : b + (1 - t) * (a - b);
        }
        default: {
            const Triple& t = mesh_.triangles[place.index];
            const double base = height(t[0]);
            return base + place.u * (height(t[1]) - base) + place.v * (height(t[2]) - base);
        }
    }
}

IntegralCurveStep next_step(const SlopedField& field, const SurfacePlace& from) {
    switch (from.on) {
        case SurfacePlace::On::vertex: return step_from_vertex(field, from);
        case SurfacePlace::On::edge: return step_from_edge(field, from);
        default: return step_from_triangle(field, from);
    }
}

}  // namespace flg
