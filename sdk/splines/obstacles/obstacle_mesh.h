// SPDX-License-Identifier: MIT
// Meshes as obstacles: a closed mesh is a solid; around one with a boundary all is an obstacle that is farther than a
// little, so that a curve stays in a thin layer (Hofer, Pottmann 2004, end of sec. 5 and Fig. 1, left) and is projected
// onto the mesh in the end.
//
// Barriers see distances sampled on a grid (mesh_distance.h), which are smooth: their zero is off the mesh by the error
// that mesh_distance.h states, and they may be more than the distance by as much. A solid also knows the distance from
// its triangles, exactly. Beyond the grid both are the distance from the mesh's box, which is less.
#pragma once

#include "splines/obstacles/mesh_distance.h"
#include "splines/obstacles/obstacle.h"
#include "splines/obstacles/triangle_solid.h"

namespace flg {

class MeshObstacle final : public Obstacle {
public:
    // Of a distance with sign, which outlives it, and the triangles that it is from. core_depth() is half of its
    // greatest depth: of a solid of several lumps with thin necks between them it says too much. Throws a Failure for
    // a distance without sign.
    MeshObstacle(const SampledDistance& distance, TriangleSolid triangles);
    double evaluate(const double* x, double* gradient, double* second) const override;
    // The second derivatives are those of the distance from the nearest face, edge or corner. 1 us.
    double evaluate_exactly(const double* x, double* gradient, double* second, double exact_below = 0) const override;
    Meets meets(const double* a, const double* b) const override {
        return triangles_.is_met(a, b) ? Meets::yes : Meets::no;
    }
    uint32_t part(const double* a, const double* b, double reach, std::span<Parting> out,
                  uint32_t before) const override {
        return triangles_.part(a, b, reach, out, before);
    }

private:
    const SampledDistance& distance_;
    TriangleSolid triangles_;
};

class LayerObstacle final : public Obstacle {
public:
    // All that is farther than epsilon from what the distance, one without sign, is from. epsilon: 4 of the grid's
    // cells at least and less than the distance's reach (else a Failure). reach() is epsilon less 3 cells: a barrier's
    // radius has to be less, as does a clearance. Steps shorter than epsilon stay with the part of the mesh that they
    // are on, where others are more than 3 epsilon away.
    LayerObstacle(const SampledDistance& distance, double epsilon);
    double evaluate(const double* x, double* gradient, double* second) const override;
    double epsilon() const { return epsilon_; }

private:
    const SampledDistance& distance_;
    double epsilon_;
};

}  // namespace flg
