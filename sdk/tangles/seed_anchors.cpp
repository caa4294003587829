// SPDX-License-Identifier: MIT
#include "tangles/seed_anchors.h"

#include <algorithm>
#include <limits>

namespace flg {

namespace {

// Each about 10 us.
constexpr uint32_t copy_chunk = 1000;
constexpr uint32_t edge_chunk = 500;

struct Beginning {
    uint32_t loop = no_index;
    uint32_t edge = 0;  // of all edges
};

// The vertex of a loop that is not taken which is nearest to a place.
Task<Beginning> find_beginning(Pace& pace, const Mesh& mesh, const RegionLoops& loops, const Buffer<uint8_t>& taken,
                               const Position& place) {
    const Vec3 wanted = load_vec3(place.data());
    Beginning best;
    double least = std::numeric_limits<double>::infinity();
    for (uint32_t l = 0; l < loops.count(); ++l) {
        if (taken[l] != 0) continue;
        for (uint32_t i = loops.offsets[l]; i < loops.offsets[l + 1]; ++i) {
            const double square = (mesh.position(mesh.vertex_at(loops.edges[i])) - wanted).squaredNorm();
            if (square < least) {
                least = square;
                best = {l, i};
            }
            if (i % edge_chunk == 0) co_await pace;
        }
    }
    co_return best;
}

Task<void> add_loop(Pace& pace, const RegionLoops& from, Beginning beginning, RegionLoops& to) {
    const uint32_t first = from.offsets[beginning.loop], count = from.offsets[beginning.loop + 1] - first;
    for (uint32_t i = 0; i < count; ++i) {
        to.edges.push_back(from.edges[first + (beginning.edge - first + i) % count]);
        if (i % edge_chunk == 0) co_await pace;
    }
    to.offsets.push_back(static_cast<uint32_t>(to.edges.size()));
    to.lengths.push_back(from.lengths[beginning.loop]);
}

Task<void> reorder_loops(Pace& pace, const Mesh& mesh, RegionLoops& loops, const Buffer<Position>& anchors) {
    Buffer<uint8_t> taken(loops.count(), pace.memory());
    std::fill(taken.begin(), taken.end(), uint8_t{0});
    RegionLoops ordered(pace.memory());
    for (const Position& anchor : anchors) {
        const Beginning beginning = co_await find_beginning(pace, mesh, loops, taken, anchor);
        if (beginning.loop == no_index) break;
        taken[beginning.loop] = 1;
        co_await add_loop(pace, loops, beginning, ordered);
    }
    for (uint32_t l = 0; l < loops.count(); ++l) {
        if (taken[l] == 0) co_await add_loop(pace, loops, {l, loops.offsets[l]}, ordered);
    }
    loops = std::move(ordered);
}

}  // namespace

Task<Buffer<Position>> positions_of(Pace& pace, const Mesh& mesh, const Buffer<SurfacePoint>& points) {
    Buffer<Position> positions(points.size(), pace.memory());
    for (size_t i = 0; i < points.size(); ++i) {
        store_vec3(position_of(mesh, points[i]), positions[i].data());
        if (i % copy_chunk == 0) co_await pace;
    }
    co_return positions;
}

Task<Buffer<Position>> positions_of(Pace& pace, const Mesh& mesh, const Buffer<uint32_t>& vertices) {
    Buffer<Position> positions(vertices.size(), pace.memory());
    for (size_t i = 0; i < vertices.size(); ++i) {
        positions[i] = mesh.positions[vertices[i]];
        if (i % copy_chunk == 0) co_await pace;
    }
    co_return positions;
}

Task<void> anchor_loops(Pace& pace, const Mesh& mesh, RegionLoops& loops, SeedAnchors& anchors) {
    if (anchors.given) {
        co_await reorder_loops(pace, mesh, loops, anchors.loops);
        co_return;
    }
    Buffer<Position> found(loops.count(), pace.memory());
    for (uint32_t l = 0; l < loops.count(); ++l) {
        found[l] = mesh.positions[mesh.vertex_at(loops.edges[loops.offsets[l]])];
        if (l % copy_chunk == 0) co_await pace;
    }
    anchors.loops = std::move(found);
}

}  // namespace flg
