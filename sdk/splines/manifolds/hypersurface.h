// SPDX-License-Identifier: MIT
// Surfaces of codimension one that a function of R^n is zero on (Hofer, Pottmann 2004, sec. 3.2, Implicit surfaces):
// level sets, point clouds and meshes by moving least squares, barriers around obstacles.
#pragma once

#include "splines/manifolds/manifold.h"

namespace flg {

class Hypersurface : public Manifold {
public:
    // The function at x, its gradient (n numbers) and, unless null, its second derivatives (n x n, symmetric).
    // Continuous first derivatives, and second ones that are bounded. False where it is not defined. The gradient
    // points outwards and is not 0 near the surface. 1 us at most.
    virtual bool evaluate(const double* x, double* hint, double* value, double* gradient, double* second) const = 0;

    // Newton's method along the gradient (the paper searches along the one at the first point; following it as it turns
    // ends nearer to the nearest point), to rounding. A step goes at most `max_step` far.
    bool project(double* x, double* hint) const override;
    void tangent_basis(const double* x, double* hint, double* basis) const override;
    void second_form(const double* x, double* hint, const double* basis, const double* force,
                     double* form) const override;

protected:
    Hypersurface(uint32_t ambient, uint32_t hint_size, double size, double max_step)
        : Manifold(ambient, ambient - 1, hint_size, size), max_step_(max_step) {}

private:
    double max_step_;
};

}  // namespace flg
