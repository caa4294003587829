// SPDX-License-Identifier: MIT
#include "surfaces/mesh_repair.h"

#include "core/failure.h"
#include "surfaces/mesh_repair_distinct.h"
#include "surfaces/mesh_repair_finish.h"
#include "surfaces/mesh_repair_input.h"
#include "surfaces/mesh_repair_pairing.h"
#include "surfaces/mesh_repair_weld.h"
#include "surfaces/mesh_repair_winding.h"

namespace flg {

namespace {

constexpr uint32_t repair_chunk = 500;  // vertices, triangles or corners: 3 to 15 us
constexpr uint32_t weld_chunk = 50;     // vertices, up to 15 us

struct Repair {
    Repair(const FlgMeshView& view, RepairedMesh& result, Memory* memory)
        : input(view), out(result), mates(result.mesh.neighbours), copies(memory) {}

    uint32_t vertex_count() const { return input.vertex_count + static_cast<uint32_t>(copies.size()); }

    const FlgMeshView& input;
    RepairedMesh& out;
    Buffer<uint32_t> welded;  // empty if no vertex is
    Mates mates;
    std::pmr::deque<uint32_t> copies;  // vertices behind those of the input: of which they are copies
};

Task<void> weld_vertices(Pace& pace, Repair& repair, float distance) {
    if (!(distance >= 0 && distance <= std::numeric_limits<float>::max())) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the weld distance is %g, must be finite and not negative",
                      double{distance});
    }
    VertexWeldKernel weld(repair.out.mesh.positions, distance, pace.memory());
    while (!weld.run(weld_chunk)) co_await pace;
    repair.out.report.welded_vertices = weld.welded_count();
    if (weld.welded_count() > 0) repair.welded = weld.take();
}

Task<void> drop_triangles(Pace& pace, Repair& repair) {
    Mesh& mesh = repair.out.mesh;
    DropTrianglesKernel drop(mesh.triangles, repair.input.triangle_count, repair.out.triangles, pace.memory());
    while (!drop.run(repair_chunk)) co_await pace;
    if (mesh.triangle_count() == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "nothing is left of the mesh: each of its %u triangles names a vertex twice",
                      repair.input.triangle_count);
    }
}

Task<void> read_triangles(Pace& pace, Repair& repair) {
    ReadTrianglesKernel read(repair.input, repair.welded, repair.out.mesh, pace.memory());
    while (!read.run(repair_chunk)) co_await pace;
    repair.out.report.degenerate_triangles = read.degenerate_count();
    if (read.degenerate_count() > 0) co_await drop_triangles(pace, repair);
}

Task<Buffer<Corner>> sort_edges(Pace& pace, const Repair& repair, GrowingBuffer<Triple>& scratch) {
    EdgeSortKernel sort(repair.out.mesh.triangles, repair.vertex_count(), scratch, pace.memory());
    while (!sort.run(repair_chunk)) co_await pace;
    co_return sort.take();
}

// True if the windings of joined triangles differ.
Task<bool> join_triangles(Pace& pace, Repair& repair) {
    Mesh& mesh = repair.out.mesh;
    MeshReport& report = repair.out.report;
    for (;;) {
        mesh.neighbours = GrowingBuffer<Triple>(mesh.triangles.size(), pace.memory());
        const Buffer<Corner> sorted = co_await sort_edges(pace, repair, mesh.neighbours);
        PairingKernel pairing(mesh.positions, mesh.triangles, sorted, repair.mates, pace.memory());
        while (!pairing.run(repair_chunk)) co_await pace;
        report.crowded_edges = pairing.crowded_count();
        if (pairing.duplicates().empty()) co_return pairing.winding_differs();
        for (uint32_t triangle : pairing.duplicates()) {
            if (is_dropped(mesh.triangles[triangle])) continue;
            mark_dropped(mesh.triangles[triangle]);
            if (++report.duplicate_triangles % repair_chunk == 0) co_await pace;
        }
        co_await drop_triangles(pace, repair);
    }
}

Task<void> align_windings(Pace& pace, Repair& repair) {
    WindingKernel winding(repair.out.mesh.triangles, repair.mates, pace.memory());
    while (!winding.run(repair_chunk)) co_await pace;
    repair.out.report.flipped_triangles = winding.flipped_count();
    repair.out.report.cut_edges = winding.cut_count();
}

// True if edges were detached, so that vertices are to be split once more.
Task<bool> make_edges_distinct(Pace& pace, Repair& repair) {
    GrowingBuffer<Triple> scratch(repair.out.mesh.triangles.size(), pace.memory());
    const Buffer<Corner> sorted = co_await sort_edges(pace, repair, scratch);
    DistinctEdgesKernel distinct(repair.out.mesh.triangles, sorted, repair.mates, pace.memory());
    while (!distinct.run(repair_chunk)) co_await pace;
    repair.out.report.cut_edges += distinct.cut_count();
    co_return distinct.detached();
}

Task<void> split_vertices(Pace& pace, Repair& repair) {
    Mesh& mesh = repair.out.mesh;
    MeshReport& report = repair.out.report;
    for (;;) {
        FansKernel fans(mesh.triangles, repair.mates, repair.input.vertex_count, repair.copies, pace.memory());
        while (!fans.run(repair_chunk)) co_await pace;
        const bool opened = report.crowded_edges + report.cut_edges > 0;
        if (opened && co_await make_edges_distinct(pace, repair)) continue;

        report.split_vertices = static_cast<uint32_t>(repair.copies.size());
        report.unused_vertices = repair.input.vertex_count - report.welded_vertices - fans.used_count();
        if (fans.used_count() == repair.input.vertex_count && repair.copies.empty()) co_return;
        NumberVerticesKernel number(mesh.positions, fans, repair.welded, repair.copies, repair.out.vertices,
                                    pace.memory());
        while (!number.run(repair_chunk)) co_await pace;
        co_return;
    }
}

Task<void> finish_mesh(Pace& pace, Repair& repair) {
    RepairedMesh& out = repair.out;
    FinishMeshKernel finish(repair.input, out.vertices, out.triangles, out.report.split_vertices, out.mesh,
                            pace.memory());
    while (!finish.run(repair_chunk)) co_await pace;
    out.report.flat_triangles = finish.flat_count();
    TopologyKernel topology(out.mesh, pace.memory());
    while (!topology.run(repair_chunk)) co_await pace;
    out.report.topology = topology.topology();
}

}  // namespace

Task<void> repair_mesh(Pace& pace, const FlgMeshView& input, RepairOptions options, RepairedMesh& repaired) {
    pace.stage("read");
    Repair repair(input, repaired, pace.memory());
    ReadPositionsKernel read(input, repaired.mesh, pace.memory());
    while (!read.run(repair_chunk)) co_await pace;
    if (options.weld_distance) co_await weld_vertices(pace, repair, *options.weld_distance);
    co_await read_triangles(pace, repair);
    pace.stage("join");
    if (co_await join_triangles(pace, repair)) co_await align_windings(pace, repair);
    co_await split_vertices(pace, repair);
    pace.stage("finish");
    co_await finish_mesh(pace, repair);
}

}  // namespace flg
