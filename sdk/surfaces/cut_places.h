// SPDX-License-Identifier: MIT
// Where a point of a curve goes when it is cut into the mesh: a vertex that is near, else a point of an edge that is near,
// else inside its triangle. The same for all triangles that share the place.
#pragma once

#include "surfaces/cut_triangulation.h"
#include "surfaces/surface_point.h"

namespace flg {

struct CutPlace {
    enum class Kind : uint32_t { vertex, edge, inside };

    Kind kind;
    uint32_t where;                 // the vertex; the edge, as its corner in the triangle of lower index; the triangle
    CutTriangulation::Point point;  // inside: weights; on an edge: x is the weight of its end
    uint32_t vertex = no_index;     // of the mesh, once that is known
};

CutPlace place_of(const Mesh& mesh, const SurfacePoint& point);

// The corner of the triangle at the vertex, or that begins the edge; no_index if the place is not of the triangle; of a
// place inside any corner of its triangle.
Corner corner_in(const Mesh& mesh, const CutPlace& place, uint32_t triangle);

}  // namespace flg
