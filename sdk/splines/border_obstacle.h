// SPDX-License-Identifier: MIT
// All that lies beyond the open borders of a mesh, as an obstacle for curves on its smooth surface, which goes on a
// little there.
//
// Borders are samples whose normals lie in the mesh and point into it: moving least squares over them
// (oriented_samples.h) give a smooth wall through the border, upright on the surface. Corners of the border are rounded
// by about an edge. Departure from the paper, which keeps curves in a thin layer around the mesh (obstacle_mesh.h): no
// grid, no thickness, and the curve may come to the border but not over it.
#pragma once

#include "splines/obstacle.h"
#include "splines/oriented_samples.h"
#include "surfaces/mesh.h"

namespace flg {

class BorderObstacle final : public Obstacle {
public:
    // The wall, and how far from it samples reach everywhere.
    BorderObstacle(OrientedSamples wall, const Box& box, double reach);
    double evaluate(const double* x, double* gradient, double* second) const override;

private:
    OrientedSamples wall_;
};

class BorderObstacleKernel {
public:
    // Outlives the kernel.
    BorderObstacleKernel(const Mesh& mesh, Memory* memory);
    // A unit is a corner or some of a sample's sorting: about 20 ns. A Failure says so if there are fewer than 4 border
    // edges.
    bool run(uint32_t count);
    // After run() returned true, once.
    BorderObstacle take() { return BorderObstacle(sort_->take(), box_, reach_); }

private:
    void add_edge(Corner corner);

    const Mesh& mesh_;
    Memory* memory_;
    GrowingBuffer<OrientedSample> samples_;
    std::optional<OrientedSamplesKernel> sort_;
    Obstacle::Box box_;
    double reach_ = std::numeric_limits<double>::infinity();
    uint32_t edges_ = 0;
    uint32_t at_ = 0;  // corners are counted, then added
};

}  // namespace flg
