// SPDX-License-Identifier: MIT
// Around a vertex, triangle by triangle.
#pragma once

#include <algorithm>
#include <array>

#include "surfaces/mesh/mesh.h"

namespace flg {

constexpr uint32_t following_corner(uint32_t k) {
    return k == 2 ? 0 : k + 1;
}

// The vertex's place in a triangle of it, without a branch that would be as often wrong as right.
inline uint32_t place_in(const Triple& triangle, uint32_t vertex) {
    return uint32_t{triangle[1] == vertex} + 2 * uint32_t{triangle[2] == vertex};
}

// take(neighbour, edge) for the neighbours of a vertex counter-clockwise, of a closed fan the first again at the end;
// `edge`: from the neighbour before to this one, no_index at first.
template <class Take>
void visit_fan(const Mesh& mesh, uint32_t vertex, Take take) {
    const uint32_t first = triangle_of(mesh.corner_of_vertex[vertex]);
    uint32_t triangle = first, last;
    Corner edge = no_index;
    do {
        const Triple& vertices = mesh.triangles[triangle];
        const uint32_t next = following_corner(place_in(vertices, vertex)), previous = following_corner(next);
        take(vertices[next], edge);
        last = vertices[previous];
        edge = 3 * triangle + next;
        triangle = mesh.neighbours[triangle][previous];
    } while (triangle != first && triangle != no_index);
    take(last, edge);
}

// Each triangle of a fan is found through the one before, and memory is slow: so of `count` fans that will be visited
// the next ones are first gone around side by side, and none waits for another's memory. fetch(neighbour) asks for what
// they need besides. (Inlined: GCC drops calls of functions that do nothing but prefetch.)
constexpr uint32_t fans_fetched = 8;  // at a time
template <class VertexAt, class Fetch>
[[gnu::always_inline]] inline void fetch_fans(const Mesh& mesh, VertexAt vertex_at, uint32_t count, Fetch fetch) {
    constexpr uint32_t max_triangles = 8;
    const uint32_t now = std::min(count, fans_fetched);
    std::array<uint32_t, fans_fetched> firsts, triangles;
    for (uint32_t i = 0; i < now; ++i) {
        firsts[i] = triangles[i] = triangle_of(mesh.corner_of_vertex[vertex_at(i)]);
    }
    for (uint32_t i = now; i < std::min(count, 2 * fans_fetched); ++i) {
        const uint32_t triangle = triangle_of(mesh.corner_of_vertex[vertex_at(i)]);
        __builtin_prefetch(&mesh.triangles[triangle]);
        __builtin_prefetch(&mesh.neighbours[triangle]);
    }
    for (uint32_t i = 2 * now; i < std::min(count, 3 * fans_fetched); ++i) {
        __builtin_prefetch(&mesh.corner_of_vertex[vertex_at(i)]);
    }
    for (uint32_t turn = 0; turn < max_triangles; ++turn) {
        for (uint32_t i = 0; i < now; ++i) {
            if (triangles[i] == no_index) continue;
            const Triple& vertices = mesh.triangles[triangles[i]];
            const uint32_t next = following_corner(place_in(vertices, vertex_at(i)));
            fetch(vertices[next]);
            const uint32_t triangle = mesh.neighbours[triangles[i]][following_corner(next)];
            triangles[i] = triangle == firsts[i] ? no_index : triangle;
        }
    }
}

}  // namespace flg
