// SPDX-License-Identifier: MIT
// What the solver (refined_solver.h) is asked and what it answers.
#pragma once

#include <limits>
#include <vector>

#include "runtime/each.h"
#include "surfaces/mesh/surface_point.h"

namespace flg {

constexpr float unreachable = std::numeric_limits<float>::infinity();

// Where distances start: every kind of source (points on faces, polylines, borders) becomes vertices that are so far
// from it, straight through a triangle that holds it. Sorted by vertex, each vertex at most once, the least distance of
// it.
struct Seed {
    uint32_t vertex;
    float distance;  // metres, >= 0
    uint32_t label;  // of its source
    // What is nearest of the source is the inside of a line, not a point: the wave comes straight.
    bool straight = false;
};

// When a solver may stop, and what it may enter.
struct SolveLimits {
    float distance = unreachable;  // vertices further away are left unreachable
    // Stop once all of these have their final distance; none: go on to the end. Vertices further away than the last of
    // them may be left unreachable or too far.
    std::pmr::vector<uint32_t> targets;
};

// A value a vertex, linear in each triangle.
struct DistanceField {
    Buffer<float> distances;  // metres; `unreachable` where no path leads, or none within the limits
    Buffer<uint32_t> labels;  // of the nearest source, no_index where unreachable; empty unless asked for
    // The vertices that have a value, rising; all others have none. If it is not `local`, all have one.
    Buffer<uint32_t> vertices;
    bool local = false;
};

// body(vertex) for all that have a value.
template <class Body>
Task<void> each_value(Pace& pace, const DistanceField& field, Cost cost, Body body) {
    if (!field.local) return each(pace, field.distances.size(), cost, body);
    return each(pace, field.vertices.size(), cost,
                [body, vertices = field.vertices.data()](uint32_t i) { body(vertices[i]); });
}

// The blend of two distance fields, sec. 3.2 of Nazzaro, Puppo, Pellacini: geoTangle (2021): from / (from + to), 0 at
// the first's sources and 1 at the second's. In the middle where both are 0, `unreachable` where both are; else where
// one of them is unreachable it is the other's end. Values below 0 count as 0.
inline float blend(float from, float to) {
    if (from == unreachable) return to == unreachable ? unreachable : 1.0f;
    if (to == unreachable) return 0.0f;
    const double a = from > 0 ? from : 0, b = to > 0 ? to : 0;
    return a + b > 0 ? static_cast<float>(a / (a + b)) : 0.5f;
}

}  // namespace flg
