// SPDX-License-Identifier: MIT
// Geodesic graphs in the form of the literal one, and fields that are run to their end.
#pragma once

#include <algorithm>

#include "reference/literal_geodesics.h"
#include "surfaces/graph_solver.h"
#include "surfaces/test_meshes.h"

namespace flg::test {

inline GeodesicGraph make_graph(const Mesh& mesh, uint32_t slice = 1000) {
    GeodesicGraph graph(test_memory());
    GeodesicGraphKernel kernel(mesh, mesh.positions, graph, test_memory());
    while (!kernel.run(slice)) {}
    return graph;
}

// Rows sorted by (vertex, length).
inline literal::GeodesicGraph sorted_rows(literal::GeodesicGraph graph) {
    for (auto& row : graph) {
        std::sort(row.begin(), row.end(), [](const literal::Arc& a, const literal::Arc& b) {
            return a.target != b.target ? a.target < b.target : a.length < b.length;
        });
    }
    return graph;
}

// Arcs between vertices instead of nodes.
inline literal::GeodesicGraph literal_form(const GeodesicGraph& graph) {
    literal::GeodesicGraph rows(graph.node_count());
    for (uint32_t node = 0; node < graph.node_count(); ++node) {
        const GeodesicGraph::Row& row = graph.rows[node];
        for (uint32_t i = row.first; i < row.first + row.count; ++i) {
            rows[graph.vertex_of(node)].push_back({graph.vertex_of(graph.arcs[i].target), graph.arcs[i].length});
        }
    }
    return sorted_rows(std::move(rows));
}

struct GraphField {
    std::vector<float> distances;
    std::vector<uint32_t> labels;
};

inline GraphField read_field(const GraphSolver& solver, const Mesh& mesh, bool labelled) {
    GraphField field;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        field.distances.push_back(solver.distance(v));
        if (labelled) field.labels.push_back(solver.label(v));
    }
    return field;
}

inline GraphField solve_graph(const Mesh& mesh, const GeodesicGraph& graph, const std::vector<Seed>& seeds,
                              const SolveLimits& limits = {}, const RegionSet& regions = RegionSet(test_memory()),
                              uint32_t slice = 1000) {
    GraphSolver solver(mesh, mesh.positions, graph, test_memory());
    solver.begin(seeds, limits, regions, true);
    while (!solver.run(slice)) {}
    return read_field(solver, mesh, true);
}

}  // namespace flg::test
