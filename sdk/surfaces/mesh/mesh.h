// SPDX-License-Identifier: MIT
// A triangle mesh in flat arrays, sec. 4.1 of Nazzaro, Puppo, Pellacini: geoTangle (2021): positions, triangles and, as
// three indices a triangle, the neighbours across its edges.
//
// Invariants of a mesh that is built (mesh_repair.h makes them, cutting keeps them)
// - Manifold: an edge has one triangle (border) or two, which name its ends in opposite order; the triangles of a
//   vertex form one fan, closed or open. No triangle names a vertex twice, every vertex has a triangle.
// - Edge k of a triangle runs from its corner k to its corner k + 1; corner k is opposite to edge k + 1.
// - corner_of_vertex of a border vertex is the first of its fan: turning counter-clockwise reaches all others from it.
// - Positions are finite. Triangles may be degenerate (without area): all code here has to take them.
#pragma once

#include <array>
#include <cstdint>

#include "core/vec.h"
#include "surfaces/mesh/growing_buffer.h"
#include "surfaces/mesh/region_blocks.h"

namespace flg {

constexpr uint32_t no_index = UINT32_MAX;

// The most corners that a mesh may have.
constexpr uint32_t max_mesh_corners = uint32_t{1} << 31;

// Three indices: the vertices of a triangle, or its neighbours.
using Triple = std::array<uint32_t, 3>;
using Position = std::array<float, 3>;

// A corner of a triangle, as 3 * triangle + k.
using Corner = uint32_t;
constexpr uint32_t triangle_of(Corner corner) {
    return corner / 3;
}
constexpr Corner next_corner(Corner corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}
constexpr Corner previous_corner(Corner corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

struct Mesh {
    explicit Mesh(Memory* memory)
        : positions(memory),
          triangles(memory),
          neighbours(memory),
          regions(memory),
          source_triangles(memory),
          corner_of_vertex(memory),
          region_blocks(memory) {}

    GrowingBuffer<Position> positions;         // metres
    GrowingBuffer<Triple> triangles;           // vertices, counter-clockwise seen from outside
    GrowingBuffer<Triple> neighbours;          // the triangle across edge k, no_index at a border
    GrowingBuffer<uint32_t> regions;           // a triangle's label
    GrowingBuffer<uint32_t> source_triangles;  // that of the input in which a triangle lies; empty if nobody asked
    GrowingBuffer<uint32_t> corner_of_vertex;  // one of its corners
    RegionBlocks region_blocks;                // where labels may be; MeshEdit keeps them

    uint32_t vertex_count() const { return static_cast<uint32_t>(positions.size()); }
    uint32_t triangle_count() const { return static_cast<uint32_t>(triangles.size()); }

    Vec3 position(uint32_t vertex) const { return load_vec3(positions[vertex].data()); }
    // Corners are also edges: the one that starts there.
    uint32_t vertex_at(Corner corner) const { return triangles[corner / 3][corner % 3]; }
    uint32_t neighbour_at(Corner corner) const { return neighbours[corner / 3][corner % 3]; }

    // The same edge seen from the other side: the corner of the neighbour where it starts; no_index at a border.
    Corner opposite(Corner corner) const {
        const uint32_t other = neighbour_at(corner);
        if (other == no_index) return no_index;
        const uint32_t start = vertex_at(next_corner(corner));
        const Triple& triangle = triangles[other];
        return 3 * other + (triangle[0] == start ? 0 : triangle[1] == start ? 1 : 2);
    }
    // The next corner of the same vertex, counter-clockwise; no_index after the last of an open fan.
    Corner turn(Corner corner) const { return opposite(previous_corner(corner)); }
    // Likewise clockwise.
    Corner turn_back(Corner corner) const {
        const Corner across = opposite(corner);
        return across == no_index ? no_index : next_corner(across);
    }
};

}  // namespace flg
