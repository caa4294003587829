// SPDX-License-Identifier: MIT
// Obstacles as a surface that curves can't leave (Hofer, Pottmann 2004, sec. 5 and Fig. 13, the barrier method of
// constrained optimization seen as geometry): over free R^d, d = 2 or 3, the hypersurface z = 0 of R^(d+1); along the
// obstacles' boundaries walls in direction z; between them quarters of circles of radius r. As r goes to 0 a spline on
// it, without its z, becomes one that stays out of the obstacles.
//
// With a_i = max(1 - d_i / r, 0) for the distance d_i from obstacle i, and c = max(1 - z / r, 0), the surface is where
//     1 - (1 - a_1^2) (1 - a_2^2) ... + c^2 = 1,
// for one obstacle the paper's f(d, z) = 0.
//
// Invariants
// - f is the signed distance from the surface, positive on the side of large z, wherever not more than one obstacle is
//   within r; its first derivatives are continuous near the surface, its second ones jump where the circles begin and
//   end.
// - d_i is nowhere negative on the surface. A gap never closes, however large r is.
// Departures: the paper takes the least d_i. In a gap narrower than 2 r that makes a crease along its middle, where
// tangents jump; the product has none. Creases stay in front of the dents of one obstacle, and where obstacles overlap:
// a smooth spline does not get there (the paper says so too). Of more than max_near obstacles within r the nearest
// count.
#pragma once

#include "splines/manifolds/hypersurface.h"
#include "splines/obstacles/obstacle.h"

namespace flg {

class BarrierSurface final : public Hypersurface {
public:
    static constexpr uint32_t max_near = 8;

    // The obstacles outlive it. radius: r > 0, below the obstacles' reach (else a Failure). size: of the scene, such as
    // the diameter of all points and obstacles (Manifold::size()).
    BarrierSurface(const ObstacleSet& obstacles, double radius, double size);

    double radius() const { return radius_; }
    // Between solves: no other thread uses the surface meanwhile, and points have to be projected, or lifted, again.
    void set_radius(double radius);

    // A point of R^d onto the surface in direction z: x gets d + 1 numbers, the first d as they are. False, and
    // projected as far as possible, if it lies in an obstacle or nearer than the clearance.
    bool lift(const double* point, double* x) const;

    // Steps of the d coordinates that are shorter, followed by project(), leave a point on its side of every obstacle,
    // so that a curve keeps its homotopy class: the way of a point on its straight step and then out of the solid does
    // not go through a solid's core.
    double step_limit() const { return obstacles_.step_limit(); }
    // Steps may be longer where this says yes for each piece of the curve (ObstacleSet::keeps_sides): points of the
    // surface. Pieces should be no longer than step_limit(): longer ones straddle an obstacle without touching it, and
    // a curve that is pulled over it can then only stop.
    bool keeps_sides(const double* a, const double* b, const double* c, const double* e) const override {
        return obstacles_.keeps_sides(a, b, c, e);
    }

    bool evaluate(const double* x, double* hint, double* value, double* gradient, double* second) const override;

    // The same for other surfaces with a barrier: f and its derivatives in R^(d+1).
    static double evaluate(const ObstacleSet& obstacles, double radius, const double* x, double* gradient,
                           double* second);
    // The z of the surface over a point of R^d; false if there is none.
    static bool height(const ObstacleSet& obstacles, double radius, const double* point, double* z);

private:
    const ObstacleSet& obstacles_;
    double radius_ = 0;
};

}  // namespace flg
