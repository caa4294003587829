// SPDX-License-Identifier: MIT
// Obstacles on a surface (Hofer, Pottmann 2004, sec. 5, for curves that stay on a surface at the same time): over a
// surface S of R^3 the points (x, z) of R^4 with x on S and f(d(x), z) = 0, f as of the barrier over free space
// (barrier_surface.h). Of dimension 2, so that it has two normals.
//
// The obstacles are solids of R^3 that cut S; what is on S and in a solid is left out. A LayerObstacle leaves out what
// is beyond the boundary of a mesh, where S goes on. Where a solid only touches S, without cutting it, there is no
// tangent plane.
#pragma once

#include "splines/obstacles/barrier_surface.h"

namespace flg {

class SurfaceBarrier final : public Manifold {
public:
    // Both outlive it. radius: as for BarrierSurface. Its size and hint are the surface's. Throws a Failure for
    // surfaces that are not in R^3 and obstacles that are not in space.
    SurfaceBarrier(const Hypersurface& surface, const ObstacleSet& obstacles, double radius);

    double radius() const { return barrier_.radius(); }
    // Between solves, see BarrierSurface.
    void set_radius(double radius) { barrier_.set_radius(radius); }
    bool keeps_sides(const double* a, const double* b, const double* c, const double* e) const override {
        return obstacles_.keeps_sides(a, b, c, e);
    }
    // The nearest point of S, and its z. False if there is none, or if it is in an obstacle: then x is the nearest one
    // outside, as far as there is.
    bool lift(const double* point, double* hint, double* x) const;

    bool project(double* x, double* hint) const override;
    void tangent_basis(const double* x, double* hint, double* basis) const override;
    void second_form(const double* x, double* hint, const double* basis, const double* force,
                     double* form) const override;

private:
    struct Constraints;

    const Hypersurface& surface_;
    const ObstacleSet& obstacles_;
    BarrierSurface barrier_;
};

}  // namespace flg
