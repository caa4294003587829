// SPDX-License-Identifier: MIT
// Ways over a mesh between two points that lie in a plane: that through both and the surface's normal there.
//
// Invariants
// - Each vertex is on one side of the plane, none on it. So a way enters a triangle by one edge and leaves it by the
//   one other whose ends are on different sides: whatever the rounding, it neither branches nor ends within the mesh.
// - Points on edges are rounded as those of geodesic paths are: to 2^-24 of the edge, and onto a vertex nearer than
//   1e-6.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/surface_curves.h"

namespace flg {

// Ways so many times longer than the straight line are given up: the ends lie on different sides of something.
constexpr double max_walk_detour = 4;

struct SurfaceWalk {
    bool found = false;  // false: the way comes to a border, or passes the end by
    double length = 0;   // metres
};

// Both points are moved by less than 1e-6 of their triangle onto an edge or a vertex that is so near. Appends to `out`
// as add_geodesic_path() does; a way that isn't found leaves it as it was. About 100 ns a triangle.
Task<SurfaceWalk> add_surface_walk(Pace& pace, const Mesh& mesh, SurfacePoint from, SurfacePoint to,
                                   SurfaceCurves& out);

}  // namespace flg
