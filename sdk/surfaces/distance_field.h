// SPDX-License-Identifier: MIT
// What geodesic solvers are asked and what they answer. Both solvers (refined_solver.h, graph_solver.h) take the same
// question and differ in accuracy and speed only.
#pragma once

#include <limits>
#include <vector>

#include "surfaces/surface_point.h"

namespace flg {

constexpr float unreachable = std::numeric_limits<float>::infinity();

// Where distances start: every kind of source (points on faces, polylines, borders) becomes vertices that are so far from
// it, straight through a triangle that holds it. Sorted by vertex, each vertex at most once, the least distance of it.
struct Seed {
    uint32_t vertex;
    float distance;  // metres, >= 0
    uint32_t label;  // of its source
    // What is nearest of the source is the inside of a line, not a point: the wave comes straight. (The refined solver asks.)
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
};

// Copies the field that a solver has made out of it, in slices of vertices. (refined_solver.h has one of its own.)
template <class Solver>
class DistanceFieldKernel {
public:
    static constexpr uint32_t chunk = 2000;  // about 10 us

    // `field` takes memory for all vertices of the mesh; labels only if the solver keeps them and they are wanted.
    DistanceFieldKernel(const Solver& solver, uint32_t vertex_count, bool labelled, DistanceField& field,
                        Memory* memory)
        : solver_(solver), field_(field) {
        field.distances = Buffer<float>(vertex_count, memory);
        field.labels = Buffer<uint32_t>(labelled ? vertex_count : 0, memory);
    }
    bool run(uint32_t count) {
        const size_t size = field_.distances.size();
        for (; count > 0 && at_ < size; --count, ++at_) {
            field_.distances[at_] = solver_.distance(at_);
            if (!field_.labels.empty()) field_.labels[at_] = solver_.label(at_);
        }
        return at_ == size;
    }

private:
    const Solver& solver_;
    DistanceField& field_;
    uint32_t at_ = 0;
};

}  // namespace flg
