// SPDX-License-Identifier: MIT
#include "surfaces/surface_update.h"

#include <exception>
#include <new>

#include "surfaces/geodesic_blocks_update.h"
#include "surfaces/geodesic_graph_update.h"
#include "surfaces/mesh_edit_touched.h"
#include "surfaces/solve_field.h"

namespace flg {

namespace {

constexpr uint32_t touch_chunk = 200;    // about 10 us
constexpr uint32_t growth_chunk = 4000;  // triangles, about 10 us
constexpr uint32_t mark_chunk = 4000;    // words, about 10 us
constexpr uint32_t blocks_chunk = 20;    // vertices, about 10 us
constexpr uint32_t graph_chunk = 20;     // vertices, about 10 us

// The triangles that got their vertices now.
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
        if (++done % mark_chunk == 0) co_await pace;
    }
}

Task<void> update_solvers(Pace& pace, Surface& surface, const MeshEdit& edit) {
    GeodesicSolvers& solvers = surface.solvers;
    if (!solvers.blocks && !solvers.graph) co_return;
    const Mesh& mesh = surface.mesh();
    TouchedVertices touched(pace.memory());
    TouchedVertexSearch search(mesh, edit, touched, pace.memory());
    while (!search.run(touch_chunk)) co_await pace;
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

}  // namespace

Task<void> update_after_edit(Pace& pace, Surface& surface, const MeshEdit& edit, uint32_t revision) {
    pace.stage("update");
    try {
        co_await mark_shapes(pace, surface, edit, revision);
    } catch (const std::bad_alloc&) {
        surface.shaped_at = GrowingBuffer<uint32_t>(pace.memory());
    }
    try {
        co_await update_solvers(pace, surface, edit);
    } catch (const std::exception&) {
        surface.solvers.blocks.reset();
        surface.solvers.graph.reset();
        surface.solvers.has_blocks = surface.solvers.has_graph = false;
    }
}

}  // namespace flg
