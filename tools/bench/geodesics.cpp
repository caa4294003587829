// SPDX-License-Identifier: MIT
// Geodesic distances on a bumpy torus, against the visit of geoTangle's own graph, literally: lists of arcs a vertex, a
// deque, SLF and LLL (Nazzaro, Puppo, Pellacini: geoTangle (2021), algorithm 1).
#include <cmath>
#include <cstdio>
#include <deque>
#include <numbers>

#include "bench/groups.h"
#include "reference/literal_geodesics.h"
#include "surfaces/adjacency.h"
#include "surfaces/geodesic_blocks_update.h"
#include "surfaces/refined_solver.h"

namespace flg::bench {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Memory* memory() {
    return std::pmr::new_delete_resource();
}

Mesh bumpy_torus(uint32_t around, uint32_t tube) {
    Mesh mesh(memory());
    mesh.positions = GrowingBuffer<Position>(size_t{around} * tube, memory());
    mesh.triangles = GrowingBuffer<Triple>(2 * size_t{around} * tube, memory());
    mesh.regions = GrowingBuffer<uint32_t>(2 * size_t{around} * tube, memory());
    const auto index = [&](uint32_t i, uint32_t j) { return (i % around) * tube + j % tube; };
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < tube; ++j) {
            const double u = kTurn * i / around, v = kTurn * j / tube;
            const double bump = 1 + 0.08 * std::sin(7 * u) * std::sin(3 * v) + 0.02 * std::sin(23 * u + 11 * v);
            const double radius = 1 + 0.4 * bump * std::cos(v);
            const uint32_t vertex = index(i, j);
            mesh.positions[vertex] = {static_cast<float>(radius * std::cos(u)),
                                      static_cast<float>(radius * std::sin(u)),
                                      static_cast<float>(0.4 * bump * std::sin(v))};
            mesh.triangles[2 * vertex] = {vertex, index(i + 1, j), index(i + 1, j + 1)};
            mesh.triangles[2 * vertex + 1] = {vertex, index(i + 1, j + 1), index(i, j + 1)};
        }
    }
    std::fill(mesh.regions.begin(), mesh.regions.end(), 0u);
    return mesh;
}

std::vector<float> visit_graph(const literal::GeodesicGraph& graph, uint32_t source) {
    std::vector<float> distances(graph.size(), unreachable);
    std::vector<bool> waits(graph.size(), false);
    std::deque<uint32_t> queue = {source};
    double weight = 0;
    distances[source] = 0;
    waits[source] = true;
    while (!queue.empty()) {
        const double mean = weight / static_cast<double>(queue.size());
        for (size_t turns = queue.size(); distances[queue.front()] > mean && turns > 0; --turns) {
            queue.push_back(queue.front());
            queue.pop_front();
        }
        const uint32_t node = queue.front();
        queue.pop_front();
        waits[node] = false;
        weight -= distances[node];
        for (const literal::Arc& arc : graph[node]) {
            const float found = distances[node] + arc.length, old = distances[arc.target];
            if (found >= old) continue;
            if (waits[arc.target]) {
                weight -= old;
            } else {
                waits[arc.target] = true;
                if (queue.empty() || found < distances[queue.front()]) {
                    queue.push_front(arc.target);
                } else {
                    queue.push_back(arc.target);
                }
            }
            weight += found;
            distances[arc.target] = found;
        }
    }
    return distances;
}

template <class Kernel>
void finish(Kernel&& kernel) {
    while (!kernel.run(1000)) {}
}

void add_rows(std::vector<Row>& rows, const char* size, uint32_t around, uint32_t tube, double build_bar_ms) {
    Mesh mesh = bumpy_torus(around, tube);
    GeodesicBlocks blocks(memory());
    const double build_ms = median_ms(3, [&] {
        return time_ms([&] {
            finish(AdjacencyKernel(mesh, memory()));
            finish(GeodesicBlocksKernel(mesh, blocks, memory()));
        });
    });
    const literal::GeodesicGraph graph = literal::geodesic_graph(mesh);
    RefinedSolver solver(blocks, memory());
    const SolveLimits limits;
    std::vector<double> visits, solves;
    for (uint32_t source : {0u, mesh.vertex_count() / 3, mesh.vertex_count() / 2, 7u, 99u}) {
        visits.push_back(time_ms([&] { visit_graph(graph, source); }));
        solves.push_back(time_ms([&] {
            const Seed seed = {source, 0, 0};
            solver.begin({&seed, 1}, limits, false);
            finish(solver);
            DistanceField field;
            finish(DistanceFieldKernel(solver, mesh.vertex_count(), false, field, memory()));
        }));
    }
    // What a long slice touches: a strip of triangles around the torus and across it.
    std::vector<uint32_t> touched;
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < 2; ++j) touched.push_back(i * tube + j);
    }
    const double update_ms =
        median_ms(5, [&] { return time_ms([&] { finish(GeodesicBlocksUpdateKernel(mesh, touched, blocks)); }); });
    char note[96];
    std::snprintf(note, sizeof note, "%.1f ms, the graph's visit %.1f ms", median(solves), median(visits));
    const std::string mesh_name = std::string(" (") + size + " triangles)";
    rows.push_back(at_least("refined distances over the graph's visit" + mesh_name, median(visits) / median(solves),
                            "x", 2, note));
    rows.push_back(below("adjacency and blocks built" + mesh_name, build_ms, "ms", build_bar_ms));
    rows.push_back(below("blocks updated along a slice" + mesh_name, update_ms, "ms", 60));
}

}  // namespace

std::vector<Row> run_geodesics() {
    std::vector<Row> rows;
    add_rows(rows, "278k", 527, 264, 50);
    add_rows(rows, "2M", 1414, 708, 400);
    return rows;
}

}  // namespace flg::bench
