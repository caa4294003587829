// SPDX-License-Identifier: MIT
#include "surfaces/surface_update.h"

#include <algorithm>
#include <exception>
#include <new>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t replay_chunk = 4000;  // words, about 10 us
constexpr uint32_t growth_chunk = 4000;  // triangles, about 10 us
// Of the vertices: if more than one in so many is touched, blocks are built anew, which takes a quarter of the time for
// each. Distances are the same.
constexpr uint32_t rebuilt_share = 3;

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
    const size_t before = std::min(shaped_at.size(), count);
    shaped_at.resize(count);
    co_await each(pace, count - before, Cost::some_ns, [&](uint32_t t) { shaped_at[before + t] = revision; });
    co_await each(pace, edit.words().size(), Cost::tens_of_ns, [&](uint32_t w) {
        const MeshEdit::Word& word = edit.words()[w];
        if (word.array == array_triangles) shaped_at[word.index / 3] = revision;
        if (word.array == array_positions && word.index % 3 == 0) mark_around(surface, word.index / 3, revision);
    });
}

using Vertices = std::pmr::deque<uint32_t>;

Task<Vertices> find_touched_if_used(Pace& pace, const Surface& surface, const MeshEdit& edit) {
    if (!surface.solvers.blocks) co_return Vertices(pace.memory());
    co_return co_await find_touched(pace, surface.mesh(), edit);
}

// What is kept beside the mesh follows it, or is dropped. No call that may fail outside of the callers' try blocks: the
// change stands.
Task<void> follow(Pace& pace, Surface& surface, const MeshEdit& edit, const Vertices& touched, uint32_t revision) {
    std::optional<GeodesicBlocks>& blocks = surface.solvers.blocks;
    const Mesh& mesh = surface.mesh();
    if (blocks && touched.size() > mesh.vertex_count() / rebuilt_share) {
        blocks.reset();
        GeodesicBlocks made = co_await make_blocks(pace, mesh, mesh.positions);
        made.edges.fix_mean(surface.solvers.fixed_edge);
        blocks.emplace(std::move(made));
    } else if (blocks) {
        co_await update_blocks(pace, mesh, touched, *blocks);
    }
    co_await mark_shapes(pace, surface, edit, revision);
}

void drop_what_follows(Surface& surface, Memory* memory) {
    drop_solvers(surface);
    surface.shaped_at = GrowingBuffer<uint32_t>(memory);
}

}  // namespace

void drop_solvers(Surface& surface) {
    surface.solvers.blocks.reset();
    surface.solvers.has_blocks = false;
}

Task<void> update_after_edit(Pace& pace, Surface& surface, const MeshEdit& edit, uint32_t revision) {
    pace.settle();
    pace.stage("update");
    try {
        const Vertices touched = co_await find_touched_if_used(pace, surface, edit);
        co_await follow(pace, surface, edit, touched, revision);
    } catch (const std::exception&) {
        drop_what_follows(surface, pace.memory());
    }
}

Task<void> take_back_edit(Pace& pace, Surface& surface, MeshEdit& edit, uint32_t revision) {
    pace.stage("take back");
    const Vertices touched = co_await find_touched_if_used(pace, surface, edit);
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
        const Vertices touched = co_await find_touched_if_used(pace, surface, edit);
        co_await follow(pace, surface, edit, touched, revision);
    } catch (const std::exception&) {
        drop_what_follows(surface, pace.memory());
    }
}

}  // namespace flg
