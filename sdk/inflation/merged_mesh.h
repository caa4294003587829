// SPDX-License-Identifier: MIT
// The surface of all parts in one piece.
#pragma once

#include <array>

#include "core/vec.h"
#include "inflation/mesh_laplacian.h"

namespace flg {

// Closed: each side belongs to two triangles, which go along it in opposite directions; and a manifold: the triangles of a vertex
// form one ring. As many components as there are groups of parts that meet.
struct MergedMesh {
    Buffer<Vec3> positions;
    Buffer<Vec3> normals;                // outwards, of length 1
    Buffer<TriangleVertices> triangles;  // counter-clockwise seen from outside
    Buffer<uint32_t> parts;              // by vertex, the one whose surface it is on
    double spacing = 0;                  // of the lattice it was made on: about the length of edges
};

}  // namespace flg
