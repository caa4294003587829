// SPDX-License-Identifier: MIT
// All that lies beyond the open borders of a mesh, as an obstacle for curves on its smooth surface, which goes on a
// little there.
//
// Borders are samples whose normals lie in the mesh and point into it: moving least squares over them
// (oriented_samples.h) give a smooth wall through the border, upright on the surface. Corners of the border are rounded
// by about an edge. Departure from the paper, which keeps curves in a thin layer around the mesh (obstacle_mesh.h): no
// grid, no thickness, and the curve may come to the border but not over it.
#pragma once

#include "splines/manifolds/oriented_samples.h"
#include "splines/obstacles/obstacle.h"
#include "surfaces/mesh/mesh.h"

namespace flg {

class BorderObstacle final : public Obstacle {
public:
    // The wall, and how far from it samples reach everywhere.
    BorderObstacle(OrientedSamples wall, const Box& box, double reach);
    double evaluate(const double* x, double* gradient, double* second) const override;

private:
    OrientedSamples wall_;
};

// Of a mesh, which does not change meanwhile. A Failure says so if there are fewer than 4 border edges. About 5 ns a
// corner.
Task<BorderObstacle> border_obstacle(Pace& pace, const Mesh& mesh);

}  // namespace flg
