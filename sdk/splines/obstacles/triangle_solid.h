// SPDX-License-Identifier: MIT
// A closed mesh as a solid, exactly: the distance from its triangles, and what is inside.
//
// Inside: of the rays in the three directions, two cross the mesh more often in one sense than in the other. An edge's
// side is decided once for the triangles on both sides (triangle_place.h), so closed meshes are counted exactly, where
// they overlap themselves too; holes that are small and few are outvoted, as on the grid (mesh_distance.h).
#pragma once

#include "splines/manifolds/point_tree.h"
#include "splines/obstacles/obstacle.h"
#include "splines/obstacles/triangle_place.h"
#include "surfaces/mesh/mesh.h"

namespace flg {

class TriangleSolid {
public:
    struct Nearest {
        double away;        // metres
        uint32_t triangle;  // no_index: none is nearer than `below`
        TriangleFoot foot;
    };

    // The nearest point that is nearer than `below` metres. Some 100 ns where that is little more than the distance.
    Nearest nearest(const double* x, double below) const;
    bool holds(const double* x) const;
    // Whether the straight way from a to b touches a triangle. Some 100 ns where it is short.
    bool is_met(const double* a, const double* b) const;

    // See Obstacle::part(): each plane is that of the nearest triangle that is not below those before it. Some us
    // a plane, 100 at most: then some triangle is taken that is not the nearest.
    uint32_t part(const double* a, const double* b, double reach, std::span<Obstacle::Parting> out,
                  uint32_t before) const;

    // Outwards.
    Vec3 normal(uint32_t triangle) const;
    // Of an edge, from its corner k to the next one.
    Vec3 way(uint32_t triangle, uint32_t k) const;

private:
    friend Task<TriangleSolid> triangle_solid(Pace& pace, const Mesh& mesh);
    Vec3 corner(uint32_t triangle, uint32_t k) const { return load_vec3(&corners_[size_t{9} * triangle + 3 * k]); }

    Buffer<float> corners_;  // nine numbers a triangle, along a space-filling curve
    PointTree tree_;
};

// A copy of the triangles: the mesh may change afterwards. It has one at least. About 150 ns and 44 bytes a triangle.
Task<TriangleSolid> triangle_solid(Pace& pace, const Mesh& mesh);

}  // namespace flg
