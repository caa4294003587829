// SPDX-License-Identifier: MIT
// Exact distances on a test mesh, in one call.
#pragma once

#include "runtime/run_now.h"
#include "surfaces/geodesics/exact_sources.h"
#include "surfaces/test_meshes.h"

namespace flg::test {

struct ExactField {
    std::vector<double> distances;
    std::vector<uint32_t> labels;
    DistanceField field;
};

namespace detail {

template <class Add>
Task<void> solve_exact(Pace& pace, const Mesh& mesh, const RegionSet& within, const SolveLimits& limits, const Add& add,
                       ExactField& out) {
    ExactFaces faces(mesh, pace.memory());
    co_await lay_out_faces(pace, mesh, within, faces);
    ExactSolver solver(mesh, faces, limits, pace.memory());
    co_await begin_exact(pace, solver);
    ExactSources sources(mesh, within, solver);
    co_await add(pace, sources);
    co_await spread_exact(pace, solver);
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        out.distances.push_back(solver.distance(v));
        out.labels.push_back(solver.label(v));
    }
    co_await take_exact_field(pace, solver, limits.distance, true, out.field);
}

}  // namespace detail

// add(pace, sources) is a task that gives the sources.
template <class Add>
ExactField exact_field_by(const Mesh& mesh, const RegionSet& within, const SolveLimits& limits, const Add& add,
                          bool haltingly = false) {
    ExactField field;
    run_now(
        test_memory(), [&](Pace& pace) { return detail::solve_exact(pace, mesh, within, limits, add, field); },
        haltingly);
    return field;
}

// add(sources) gives them at once.
template <class Add>
ExactField exact_field(const Mesh& mesh, const Add& add, const SolveLimits& limits = {}, bool haltingly = false) {
    const auto task = [&](Pace& pace, ExactSources& sources) {
        return each(pace, 1, Cost::microseconds, [&](uint32_t) { add(sources); });
    };
    return exact_field_by(mesh, RegionSet(test_memory()), limits, task, haltingly);
}

inline std::vector<double> window_distances(const Mesh& mesh, uint32_t source) {
    return exact_field(mesh, [=](ExactSources& sources) { sources.add_vertex(source, 0); }).distances;
}

}  // namespace flg::test
