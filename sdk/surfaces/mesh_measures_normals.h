// SPDX-License-Identifier: MIT
// Normals. Those of vertices are the mean of their triangles' normals, weighted by the triangles' angles there (Thurmer,
// Wuthrich: Computing vertex normals from polygonal facets, 1998): they do not depend on how a surface is cut into
// triangles, as those weighted by area do.
#pragma once

#include "surfaces/surface_point.h"

namespace flg {

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

// Of a point: between those of the vertices around it, of unit length or 0.
Vec3 smooth_normal(const Mesh& mesh, const SurfacePoint& point);

// Normals of all vertices: the same, in slices. A unit is a corner: about 50 ns.
class VertexNormalsKernel {
public:
    // Outlives the kernel.
    VertexNormalsKernel(const Mesh& mesh, Memory* memory);
    bool run(uint32_t count);
    // After run() returned true.
    Buffer<Position> take() { return std::move(normals_); }

private:
    const Mesh& mesh_;
    Buffer<Position> normals_;
    uint32_t at_ = 0;
    Corner corner_ = no_index;  // the next one of vertex at_; no_index before its first
    Vec3 sum_ = Vec3::Zero();
};

}  // namespace flg
