// SPDX-License-Identifier: MIT
// The distance from a triangle mesh on the nodes of a grid, with a sign for what is inside (Tsai: Rapid and accurate
// computation of the distance function using grids, 2002, as Hofer and Pottmann 2004, sec. 5, use it): exact at the
// nodes next to triangles, and further out by sweeping, where a node tries the triangles that are nearest to its
// neighbours, and then walks across the mesh while that leads nearer. A value is the exact distance from a triangle, as
// a rule from the nearest one.
//
// Inside: along the lines of nodes in each of the three directions, triangles that are crossed count by their sense; a
// node is inside if two of the three counts are not 0. An edge's side is decided once for the triangles on both sides,
// so closed meshes are counted exactly, whatever lies on an edge; holes that are small and few are outvoted. Of an open
// mesh take no sign.
//
// What is between the nodes is the cubic B-spline through them (distance_grid.h). Where the distance is smooth the
// error falls with the fourth power of the spacing h; at its creases (edges, the middle between walls) it is rounded
// off by up to 0.1 h, and waves by half of that two cells around.
#pragma once

#include <optional>

#include "splines/obstacles/distance_grid.h"
#include "splines/obstacles/sweep_distance.h"
#include "surfaces/mesh/mesh.h"

namespace flg {

struct SampledDistance {
    SweepGrid grid;                      // dimension 3
    std::optional<DistanceGrid> spline;  // through the distance less `shift`
    double shift = 0;                    // such that there are values of both signs
    Obstacle::Box box;                   // of what the distance is from
    double reach = 0;                    // up to which it is sampled all around the box
    double deepest = 0;  // the greatest depth of a node; 0 if none is inside or the distance has no sign

    // False outside of the grid. gradient and second may be null. 0.2 us.
    bool evaluate(const double* x, double* value, double* gradient, double* second) const {
        double own[3];
        if (!spline->evaluate(x, nullptr, value, gradient != nullptr ? gradient : own, second)) return false;
        *value += shift;
        return true;
    }
};

inline constexpr uint32_t min_distance_cells = 8, max_distance_cells = 192;

// reach: metres > 0, how far around the mesh's box the distance is needed. cells: along the longest side of the box,
// reach included; min_distance_cells to max_distance_cells. has_sign: negative inside. Throws a Failure for values out
// of their range, and for a mesh that is to have an inside and holds no node. The mesh does not change meanwhile. About
// 2 us a node; 9 bytes a node besides the result's 4, 15 with sign.
Task<SampledDistance> mesh_distance(Pace& pace, const Mesh& mesh, double reach, uint32_t cells, bool has_sign);

}  // namespace flg
