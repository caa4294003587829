// SPDX-License-Identifier: MIT
// Surfaces that a function of two parameters gives (Hofer, Pottmann 2004, sec. 3.2, Parameterized surfaces).
//
// The paper moves the parameters by the step's coordinates and so needs no projection. Here a point is a point of
// space, and its parameters are remembered with it: Newton's method on the squared distance finds the nearest point
// from there. So the optimizer sees the surface and not its parametrization, and steps are as long as on every other
// manifold.
//
// Invariants
// - The hint is u, v and whether they are known (1) or not (0). A point without one starts at the nearest point of a
//   grid of 33 x 33 over the domain; so does one whose footpoint has come to lie 1/50 of the size away, if that is
//   nearer.
// - Periodic parameters are brought back into their period; nothing is said of the surface's other symmetries.
// - A domain that is not periodic ends: a nearest point that lies beyond its end by more than `margin` of its extent is
//   refused. Up to that, and twice as far during the search, the functions are evaluated beyond the end and have to be
//   smooth there.
#pragma once

#include <array>
#include <memory_resource>
#include <vector>

#include "core/vec.h"
#include "splines/manifolds/manifold.h"

namespace flg {

struct PatchDomain {
    std::array<double, 2> low, high;  // of u and v; low < high
    std::array<bool, 2> periodic{};   // then the function has the period high - low
    double margin = 0.05;             // of high - low, at least 0
};

// A point of a patch with its derivatives. The cross product of u and v points outwards.
struct PatchPoint {
    Vec3 at, u, v, uu, uv, vv;
};

class ParametricPatch : public Manifold {
public:
    // Three times continuously differentiable; the derivatives u and v are independent. 100 ns at most, so that a
    // search is some us.
    virtual PatchPoint evaluate(double u, double v) const = 0;

    bool project(double* x, double* hint) const override;
    void tangent_basis(const double* x, double* hint, double* basis) const override;
    void second_form(const double* x, double* hint, const double* basis, const double* force,
                     double* form) const override;

    const PatchDomain& domain() const { return domain_; }

protected:
    ParametricPatch(const PatchDomain& domain, double size, Memory* memory)
        : Manifold(3, 2, 3, size), domain_(domain), grid_(memory) {}

    // For the end of the constructor of the class that evaluates: the grid to start from. 1089 evaluations.
    void prepare();

private:
    // Returns the square of its distance.
    double nearest_on_grid(const Vec3& x, std::array<double, 2>& parameters) const;
    bool find_footpoint(const Vec3& target, std::array<double, 2>& at, Vec3& foot) const;
    bool keep_inside(std::array<double, 2>& parameters) const;

    PatchDomain domain_;
    std::pmr::vector<Vec3> grid_;
};

}  // namespace flg
