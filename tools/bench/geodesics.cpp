// SPDX-License-Identifier: MIT
// Geodesic distances on a bumpy torus, against the visit of geoTangle's own graph, literally: lists of arcs a vertex, a
// deque, SLF and LLL (tests/reference/literal_geodesics.h); and against exact distances.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <thread>

#include "bench/groups.h"
#include "reference/literal_geodesics.h"
#include "runtime/run_now.h"
#include "surfaces/geodesics/refined_solver.h"
#include "surfaces/mesh/adjacency.h"

namespace flg::bench {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

class CountingMemory : public Memory {
public:
    double held_mb() const { return static_cast<double>(held_) * 1e-6; }

private:
    void* do_allocate(size_t bytes, size_t alignment) override {
        held_ += bytes;
        return std::pmr::new_delete_resource()->allocate(bytes, alignment);
    }
    void do_deallocate(void* place, size_t bytes, size_t alignment) override {
        held_ -= bytes;
        std::pmr::new_delete_resource()->deallocate(place, bytes, alignment);
    }
    bool do_is_equal(const Memory& other) const noexcept override { return this == &other; }

    size_t held_ = 0;
};

Mesh bumpy_torus(uint32_t around, uint32_t tube, Memory* memory) {
    Mesh mesh(memory);
    mesh.positions = GrowingBuffer<Position>(size_t{around} * tube, memory);
    mesh.triangles = GrowingBuffer<Triple>(2 * size_t{around} * tube, memory);
    mesh.regions = GrowingBuffer<uint32_t>(2 * size_t{around} * tube, memory);
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

template <class Kernel>
void finish(Kernel&& kernel) {
    while (!kernel.run(1000)) {}
}

double wall_ms(const std::function<void()>& call) {
    const auto begin = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

// A field from one vertex, copied out.
void solve(RefinedSolver& solver, uint32_t source, Memory* memory, DistanceField& field) {
    const SolveLimits limits;
    const Seed seed = {source, 0, 0};
    const std::span<const Seed> seeds(&seed, 1);
    run_now(memory, [&](Pace& pace) { return solve_distances(pace, solver, seeds, limits, false); });
    run_now(memory, [&](Pace& pace) { return take_field(pace, solver, false, field); });
}

GeodesicBlocks blocks_of(const Mesh& mesh, Memory* memory) {
    return run_now(memory, [&](Pace& pace) { return make_blocks(pace, mesh, mesh.positions); });
}

// In turn with the visit, source by source: what else the machine does meets both.
void add_solves(std::vector<Row>& rows, const std::string& mesh_name, const Mesh& mesh, const GeodesicBlocks& blocks,
                Memory* memory) {
    const literal::GeodesicGraph graph = literal::geodesic_graph(mesh);
    RefinedSolver solver(blocks, memory);
    std::vector<double> visits, solves;
    for (uint32_t source : {0u, mesh.vertex_count() / 3, mesh.vertex_count() / 2, 7u, 99u}) {
        visits.push_back(time_ms([&] { literal::visit_graph(graph, source); }));
        DistanceField field;
        solves.push_back(time_ms([&] { solve(solver, source, memory, field); }));
    }
    char note[96];
    std::snprintf(note, sizeof note, "%.1f ms, the graph's visit %.1f ms", median(solves), median(visits));
    rows.push_back(at_least("refined distances over the graph's visit" + mesh_name, median(visits) / median(solves),
                            "x", 2, note));
}

void add_threads(std::vector<Row>& rows, const std::string& mesh_name, const GeodesicBlocks& blocks) {
    Memory* memory = std::pmr::new_delete_resource();
    RefinedSolver one(blocks, memory), other(blocks, memory);
    const auto run = [&](RefinedSolver& solver, uint32_t first) {
        for (uint32_t i = 0; i < 4; ++i) {
            DistanceField field;
            solve(solver, (first + i) * 1000, memory, field);
        }
    };
    double alone = HUGE_VAL, together = HUGE_VAL;
    for (int i = 0; i < 3; ++i) {
        alone = std::min(alone, wall_ms([&] { run(one, 0); }));
        together = std::min(together, wall_ms([&] {
                                std::thread thread([&] { run(other, 4); });
                                run(one, 0);
                                thread.join();
                            }));
    }
    rows.push_back(at_least("fields a second of two threads over one's" + mesh_name, 2 * alone / together, "x", 1.8,
                            "wall time; needs two idle cores"));
}

void add_rows(std::vector<Row>& rows, const char* size, uint32_t around, uint32_t tube, double build_bar_ms,
              double memory_bar_mb) {
    CountingMemory memory;
    Mesh mesh = bumpy_torus(around, tube, &memory);
    const std::string mesh_name = std::string(" (") + size + " triangles)";
    std::optional<GeodesicBlocks> built;
    const double build_ms = median_ms(3, [&] {
        return time_ms([&] {
            run_now(&memory, [&](Pace& pace) { return find_neighbours(pace, mesh); });
            built.reset();
            built.emplace(blocks_of(mesh, &memory));
        });
    });
    GeodesicBlocks& blocks = *built;
    rows.push_back(below("adjacency and blocks built" + mesh_name, build_ms, "ms", build_bar_ms));
    {
        RefinedSolver solver(blocks, &memory);
        DistanceField field;
        solve(solver, 0, &memory, field);
        rows.push_back(below("mesh, blocks, solver and field" + mesh_name, memory.held_mb(), "MB", memory_bar_mb));
    }
    add_solves(rows, mesh_name, mesh, blocks, &memory);
    add_threads(rows, mesh_name, blocks);
    // What a long slice touches: a strip of triangles around the torus and across it.
    std::pmr::deque<uint32_t> touched;
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < 2; ++j) touched.push_back(i * tube + j);
    }
    const double update_ms = median_ms(5, [&] {
        return time_ms(
            [&] { run_now(&memory, [&](Pace& pace) { return update_blocks(pace, mesh, touched, blocks); }); });
    });
    rows.push_back(below("blocks updated along a slice" + mesh_name, update_ms, "ms", 60));
}

// Against the polyhedron's own distances, from three sources; on the mesh stretched along its axes, too.
void add_error(std::vector<Row>& rows, const std::string& name, const Vec3& stretch) {
    Memory* memory = std::pmr::new_delete_resource();
    Mesh mesh = bumpy_torus(140, 70, memory);
    for (Position& p : mesh.positions) {
        for (int axis = 0; axis < 3; ++axis) p[axis] *= static_cast<float>(stretch[axis]);
    }
    run_now(memory, [&](Pace& pace) { return find_neighbours(pace, mesh); });
    const GeodesicBlocks blocks = blocks_of(mesh, memory);
    RefinedSolver solver(blocks, memory);
    double squares = 0;
    uint64_t count = 0;
    for (uint32_t source : {0u, mesh.vertex_count() / 3, mesh.vertex_count() / 2}) {
        const std::vector<double> exact = literal::exact_distances(mesh, source);
        DistanceField field;
        solve(solver, source, memory, field);
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            if (v == source) continue;
            const double error = field.distances[v] / exact[v] - 1;
            squares += error * error;
            ++count;
        }
    }
    rows.push_back(below("refined distances, RMS error (20k triangles" + name + ")",
                         100 * std::sqrt(squares / static_cast<double>(count)), "%", 0.2));
}

}  // namespace

std::vector<Row> run_geodesics() {
    std::vector<Row> rows;
    add_rows(rows, "278k", 527, 264, 50, 50);
    add_rows(rows, "2M", 1414, 708, 400, 300);
    add_error(rows, "", {1, 1, 1});
    add_error(rows, ", 1 x 20 x 1", {1, 20, 1});
    add_error(rows, ", 10 x 1 x 0.2", {10, 1, 0.2});
    return rows;
}

}  // namespace flg::bench
