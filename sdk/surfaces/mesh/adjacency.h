// SPDX-License-Identifier: MIT
// Which triangles meet at which edges, from the triangles alone and without a hash map: the corners are sorted by the
// edges that start there, so that those of an edge, in whichever direction, lie side by side. Linear in the triangles
// whatever the mesh, also for vertices and edges of many triangles.
#pragma once

#include <algorithm>

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/mesh/mesh.h"

namespace flg {

// An edge without its direction.
struct Edge {
    uint32_t lesser, greater;
    bool operator==(const Edge&) const = default;
};

inline Edge edge_at(const GrowingBuffer<Triple>& triangles, Corner corner) {
    const Triple& triangle = triangles[corner / 3];
    const auto [lesser, greater] = std::minmax(triangle[corner % 3], triangle[(corner + 1) % 3]);
    return {lesser, greater};
}

// The corners by lesser vertex, then greater vertex, then corner. Needs triangles whose vertices are below
// vertex_count. `scratch` has as many triples, which are overwritten: those that take the neighbours afterwards. Some
// 30 ns a triangle. Memory: 12 bytes a triangle, and 8 a vertex while it runs.
Task<Buffer<Corner>> sort_by_edge(Pace& pace, const GrowingBuffer<Triple>& triangles, uint32_t vertex_count,
                                  GrowingBuffer<Triple>& scratch);

// An edge of more triangles than this is refused: it would take more than a slice.
constexpr uint32_t max_edge_triangles = 1000;

namespace detail {

// A slice of each_edge(), from the edge that begins at `begin`; returns where the next one begins.
template <class Body>
[[gnu::noinline]] uint32_t run_edges(const GrowingBuffer<Triple>& triangles, const Buffer<Corner>& sorted, Body body,
                                     uint32_t begin) {
    const auto count = static_cast<uint32_t>(sorted.size());
    Edge edge = edge_at(triangles, sorted[begin]);
    for (uint32_t work = 0; begin < count && work < static_cast<uint32_t>(Cost::tens_of_ns);) {
        uint32_t end = begin + 1;
        Edge next = edge;
        for (; end < count; ++end) {
            next = edge_at(triangles, sorted[end]);
            if (next != edge) break;
            if (end - begin == max_edge_triangles)
                throw Failure(FLG_ERROR_LIMIT, "more than %u triangles share the edge from vertex %u to vertex %u",
                              max_edge_triangles, edge.lesser, edge.greater);
        }
        work += body(begin, end);
        begin = end;
        edge = next;
    }
    return begin;
}

}  // namespace detail

// body(begin, end) for the corners of each edge: those of `sorted` from begin to end - 1. It returns what it did, in
// units of some 30 ns.
template <class Body>
Task<void> each_edge(Pace& pace, const GrowingBuffer<Triple>& triangles, const Buffer<Corner>& sorted, Body body) {
    for (uint32_t begin = 0; begin < sorted.size();) {
        begin = detail::run_edges(triangles, sorted, body, begin);
        co_await pace;
    }
}

// The neighbours of each triangle and a corner of each vertex. Needs a manifold mesh whose winding is consistent
// (mesh_repair.h makes it so). Memory: as sort_by_edge.
Task<void> find_neighbours(Pace& pace, Mesh& mesh);

}  // namespace flg
