// SPDX-License-Identifier: MIT
// What a mesh is as a whole: components, borders, Euler number and genus; bounding box and area; a number that tells it
// from others; normals.
#pragma once

#include <deque>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/surface_point.h"

namespace flg {

struct MeshComponents {
    uint32_t count = 0;
    Buffer<uint32_t> of_vertex;  // 0 for that of vertex 0, and on by their least vertices
};

// Vertices that triangles join. About 20 ns a triangle.
Task<MeshComponents> find_components(Pace& pace, const Mesh& mesh);

// Loop l has the vertices offsets[l] to offsets[l + 1] - 1, in the direction of the triangles' edges (the surface lies
// to the left); the last is joined to the first. Each loop begins at its least vertex; loops are ordered by these.
struct BorderLoops {
    explicit BorderLoops(Memory* memory) : vertices(memory), offsets(memory) { offsets.push_back(0); }

    uint32_t loop_count() const { return static_cast<uint32_t>(offsets.size()) - 1; }
    // As many as there are border vertices, and border edges.
    uint32_t vertex_count() const { return static_cast<uint32_t>(vertices.size()); }

    std::pmr::deque<uint32_t> vertices;
    std::pmr::deque<uint32_t> offsets;
};

// A few nanoseconds a vertex, tens at a border. Memory: a bit a vertex beside the result.
Task<BorderLoops> find_borders(Pace& pace, const Mesh& mesh);

struct MeshTopology {
    uint32_t components = 0;
    uint32_t border_loops = 0;
    uint32_t border_edges = 0;
    int64_t euler_number = 0;  // vertices - edges + triangles
    uint32_t genus = 0;        // handles, of all components together
};

// From components and borders.
Task<MeshTopology> find_topology(Pace& pace, const Mesh& mesh);

struct MeshExtent {
    Vec3 lower, upper;  // metres, corners of the bounding box
    double area = 0;    // square metres
};

// Of a mesh with one vertex at least. About 10 ns a vertex and a triangle. Sums have a fixed order.
Task<MeshExtent> measure_extent(Pace& pace, const Mesh& mesh);

struct MeshFingerprint {
    uint64_t number = 0;        // of positions and triangles, in their order, to the bit
    Position lower{}, upper{};  // the bounding box, metres
};

// Of a mesh with one vertex at least. About 3 ns a vertex and a triangle.
Task<MeshFingerprint> take_fingerprint(Pace& pace, const Mesh& mesh);

// ---- Normals. Those of vertices are the mean of their triangles' normals, weighted by the triangles' angles there
// (Thurmer, Wuthrich: Computing vertex normals from polygonal facets, 1998): they do not depend on how a surface is cut
// into triangles, as those weighted by area do.

// Of a triangle: its normal, as long as its area is large (square metres).
inline Vec3 vector_area(const Mesh& mesh, uint32_t triangle) {
    const Triple& corners = mesh.triangles[triangle];
    const Vec3 origin = mesh.position(corners[0]);
    return 0.5 * (mesh.position(corners[1]) - origin).cross(mesh.position(corners[2]) - origin);
}

// Unit length; 0 for triangles without area.
inline Vec3 triangle_normal(const Mesh& mesh, uint32_t triangle) {
    return vector_area(mesh, triangle).stableNormalized();
}

// Of one vertex: unit length, 0 where no triangle around has an area or all cancel out. About 50 ns a triangle there.
Vec3 vertex_normal(const Mesh& mesh, uint32_t vertex);

// Of all vertices.
Task<Buffer<Position>> find_vertex_normals(Pace& pace, const Mesh& mesh);

// Of a point: between those of the vertices around it, of unit length or 0.
Vec3 smooth_normal(const Mesh& mesh, const SurfacePoint& point);

}  // namespace flg
