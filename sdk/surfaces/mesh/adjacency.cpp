// SPDX-License-Identifier: MIT
#include "surfaces/mesh/adjacency.h"

#include <utility>

namespace flg {

// By counting, first by the greater vertex, then by the lesser. Not by group_by: one pass counts for both, and what is
// half sorted needs no memory of its own.
Task<Buffer<Corner>> sort_by_edge(Pace& pace, const GrowingBuffer<Triple>& triangles, uint32_t vertex_count,
                                  GrowingBuffer<Triple>& scratch) {
    // Where the next corner goes whose edge has this vertex as its lesser or greater one; before: how many there are.
    Buffer<uint32_t> by_lesser(vertex_count, pace.memory()), by_greater(vertex_count, pace.memory());
    Buffer<Corner> by_edge(3 * triangles.size(), pace.memory());
    uint32_t* const lesser = by_lesser.data();
    uint32_t* const greater = by_greater.data();
    auto* const half_sorted = reinterpret_cast<Corner*>(scratch.data());
    Corner* const sorted = by_edge.data();
    co_await each(pace, vertex_count, Cost::some_ns, [=](uint32_t v) { lesser[v] = greater[v] = 0; });
    co_await each(pace, triangles.size(), Cost::tens_of_ns, [=, &triangles](uint32_t t) {
        for (uint32_t k = 0; k < 3; ++k) {
            const Edge edge = edge_at(triangles, 3 * t + k);
            ++lesser[edge.lesser];
            ++greater[edge.greater];
        }
    });
    uint32_t lesser_sum = 0, greater_sum = 0;
    co_await each(pace, vertex_count, Cost::some_ns, [=, &lesser_sum, &greater_sum](uint32_t v) {
        lesser_sum += std::exchange(lesser[v], lesser_sum);
        greater_sum += std::exchange(greater[v], greater_sum);
    });
    co_await each(pace, triangles.size(), Cost::tens_of_ns, [=, &triangles](uint32_t t) {
        for (uint32_t k = 0; k < 3; ++k) half_sorted[greater[edge_at(triangles, 3 * t + k).greater]++] = 3 * t + k;
    });
    co_await each(pace, by_edge.size(), Cost::tens_of_ns, [=, &triangles](uint32_t i) {
        const Corner corner = half_sorted[i];
        sorted[lesser[edge_at(triangles, corner).lesser]++] = corner;
    });
    by_lesser = {};
    co_await pace;
    co_return by_edge;
}

Task<void> find_neighbours(Pace& pace, Mesh& mesh) {
    mesh.neighbours = GrowingBuffer<Triple>(mesh.triangles.size(), pace.memory());
    mesh.corner_of_vertex = GrowingBuffer<uint32_t>(mesh.vertex_count(), pace.memory());
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns, [&](uint32_t t) {
        for (uint32_t k = 0; k < 3; ++k) mesh.corner_of_vertex[mesh.triangles[t][k]] = 3 * t + k;
    });
    const Buffer<Corner> sorted = co_await sort_by_edge(pace, mesh.triangles, mesh.vertex_count(), mesh.neighbours);
    co_await each_edge(pace, mesh.triangles, sorted, [&](uint32_t begin, uint32_t end) -> uint32_t {
        const Corner corner = sorted[begin];
        if (end - begin == 1) {
            mesh.neighbours[corner / 3][corner % 3] = no_index;
            // At a border the vertex is given the first corner of its fan.
            mesh.corner_of_vertex[mesh.vertex_at(corner)] = corner;
        } else {
            const Corner other = sorted[begin + 1];
            mesh.neighbours[corner / 3][corner % 3] = triangle_of(other);
            mesh.neighbours[other / 3][other % 3] = triangle_of(corner);
        }
        return 1;
    });
}

}  // namespace flg
