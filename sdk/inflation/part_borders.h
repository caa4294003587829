// SPDX-License-Identifier: MIT
// The surface of a union of parts, cut where it goes from one part to the next: borders become chains of edges.
//
// A border is where both parts have the same value on the surface. Vertices near one are moved onto it, along an edge
// that crosses it; edges that still cross it get a vertex there. Triangles with such edges are cut, those of three
// parts around a point in their middle. Vertices near enough move first, so no sliver is left beside a border (Labelle,
// Shewchuk: Isosurface stuffing, 2007, in the plane). What was closed and a manifold stays so.
//
// Vertices of borders lie within `border_tolerance` of both zeros, but for points where three parts meet, and a few (1
// in 10 of 2,000 vertices' in tests) where a part's own edge lies in the other's surface, which has a kink there.
#pragma once

#include <array>
#include <span>

#include "inflation/implicit_parts.h"
#include "runtime/task.h"

namespace flg {

inline constexpr double border_tolerance = 0.05;  // by the spacing of the mesh

// The triangle across each side of a triangle: side k is opposite to corner k.
using Across = std::array<uint32_t, 3>;

struct UnionMesh {
    double spacing;  // about the length of its edges
    std::span<Vec3> positions;
    std::span<const TriangleVertices> triangles;  // closed, a manifold
    std::span<const Across> across;
    std::span<PartUnion::Sample> samples;  // by vertex
    std::span<const uint8_t> is_fixed;     // by vertex: stays where it is
};

// Where a vertex lies in the mesh as it was: between these of its vertices, and how much of each.
struct BorderOrigin {
    std::array<uint32_t, 3> vertices;
    std::array<double, 3> shares;  // their sum is 1; the first is the largest
};

struct BorderedMesh {
    Buffer<Vec3> positions;        // first those of the mesh, some of them moved
    Buffer<BorderOrigin> origins;  // what a vertex carries over is that of where it is now
    Buffer<PartUnion::Sample> samples;
    Buffer<TriangleVertices> triangles;
    Buffer<uint32_t> triangle_parts;
};

// What is referred to outlives the task. Takes about 50 ns a triangle and 5 us for each that borders cross.
Task<BorderedMesh> cut_at_borders(Pace& pace, const PartUnion& parts, UnionMesh mesh);

}  // namespace flg
