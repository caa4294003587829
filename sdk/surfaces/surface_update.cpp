// SPDX-License-Identifier: MIT
#include "surfaces/surface_update.h"

#include <exception>
#include <new>

#include "surfaces/geodesic_blocks_update.h"
#include "surfaces/geodesic_graph_update.h"
#include "surfaces/mesh_edit_replay.h"
#include "surfaces/mesh_edit_touched.h"
#include "surfaces/solve_field.h"

namespace flg {

namespace {

constexpr uint32_t touch_chunk = 200;    // about 10 us
constexpr uint32_t replay_chunk = 4000;  // words, about 10 us
constexpr uint32_t growth_chunk = 4000;  // triangles, about 10 us
constexpr uint32_t mark_chunk = 1000;    // words, about 10 us
constexpr uint32_t blocks_chunk = 20;    // vertices, about 10 us
constexpr uint32_t graph_chunk = 20;     // vertices, about 10 us

void mark_around(Surface& surface, uint32_t vertex, uint32_t revision) {
    const Mesh& mesh = surface.mesh();
    const Corner first = mesh.corner_of_vertex[vertex];
    Corner corner = first;
    do {
        surface.shaped_at[triangle_of(corner)] = revision;
        corner = mesh.turn(corner);
    } while (corner != first && corner != no_index);
}

// The triangles that got their vertices now, or whose vertices moved.
Task<void> mark_shapes(Pace& pace, Surface& surface, const MeshEdit& edit, uint32_t revision) {
    GrowingBuffer<uint32_t>& shaped_at = surface.shaped_at;
    const size_t count = surface.mesh().triangles.size();
    if (shaped_at.capacity() < count) {
        shaped_at.begin_growth(count + count / 4);
        while (!shaped_at.grow(growth_chunk)) co_await pace;
    }
    for (size_t t = shaped_at.size(); t < count; ++t) {
        shaped_at[t] = revision;
        if (t % mark_chunk == 0) co_await pace;
    }
    shaped_at.resize(count);
    uint32_t done = 0;
    for (const MeshEdit::Word& word : edit.words()) {
        if (word.array == array_triangles) shaped_at[word.index / 3] = revision;
        if (word.array == array_positions && word.index % 3 == 0) mark_around(surface, word.index / 3, revision);
        if (++done % mark_chunk == 0) co_await pace;
    }
}

Task<void> find_touched(Pace& pace, const Surface& surface, const MeshEdit& edit, TouchedVertices& touched) {
    if (!surface.solvers.blocks && !surface.solvers.graph) co_return;
    TouchedVertexSearch search(surface.mesh(), edit, touched, pace.memory());
    while (!search.run(touch_chunk)) co_await pace;
}

Task<void> update_solvers(Pace& pace, Surface& surface, const TouchedVertices& touched) {
    GeodesicSolvers& solvers = surface.solvers;
    const Mesh& mesh = surface.mesh();
    if (solvers.blocks) {
        const Buffer<uint32_t> changed = co_await flatten(pace, touched.changed);
        GeodesicBlocksUpdateKernel update(mesh, {changed.data(), changed.size()}, *solvers.blocks);
        while (!update.run(blocks_chunk)) co_await pace;
    }
    if (solvers.graph) {
        GeodesicGraphUpdateKernel update(mesh, mesh.positions, touched, *solvers.graph, pace.memory());
        while (!update.run(graph_chunk)) co_await pace;
    }
}

// What is kept beside the mesh follows it, or is dropped. No call that may fail outside of the callers' try blocks: the change
// stands.
Task<void> follow(Pace& pace, Surface& surface, const MeshEdit& edit, const TouchedVertices& touched,
                  uint32_t revision) {
    co_await update_solvers(pace, surface, touched);
    co_await mark_shapes(pace, surface, edit, revision);
}

void drop_what_follows(Surface& surface, Memory* memory) {
    drop_solvers(surface);
    surface.shaped_at = GrowingBuffer<uint32_t>(memory);
}

}  // namespace

void drop_solvers(Surface& surface) {
    surface.solvers.blocks.reset();
    surface.solvers.graph.reset();
    surface.solvers.has_blocks = surface.solvers.has_graph = false;
}

Task<void> update_after_edit(Pace& pace, Surface& surface, const MeshEdit& edit, uint32_t revision) {
    pace.stage("update");
    try {
        TouchedVertices touched(pace.memory());
        co_await find_touched(pace, surface, edit, touched);
        co_await follow(pace, surface, edit, touched, revision);
    } catch (const std::exception&) {
        drop_what_follows(surface, pace.memory());
    }
}

Task<void> take_back_edit(Pace& pace, Surface& surface, MeshEdit& edit, uint32_t revision) {
    pace.stage("take back");
    TouchedVertices touched(pace.memory());
    co_await find_touched(pace, surface, edit, touched);
    MeshEditReplay back(surface.mesh(), surface.columns, edit, MeshEditReplay::Direction::undo);
    while (!back.run(replay_chunk)) co_await pace;
    try {
        co_await follow(pace, surface, edit, touched, revision);
    } catch (const std::exception&) {
        drop_what_follows(surface, pace.memory());
    }
}

Task<void> make_edit_again(Pace& pace, Surface& surface, MeshEdit& edit, uint32_t revision) {
    pace.stage("make again");
    MeshEditReplay again(surface.mesh(), surface.columns, edit, MeshEditReplay::Direction::redo);
    while (!again.run(replay_chunk)) co_await pace;
    try {
        TouchedVertices touched(pace.memory());
        co_await find_touched(pace, surface, edit, touched);
        co_await follow(pace, surface, edit, touched, revision);
    } catch (const std::exception&) {
        drop_what_follows(surface, pace.memory());
    }
}

}  // namespace flg
