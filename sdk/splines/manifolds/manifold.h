// SPDX-License-Identifier: MIT
// What the optimizer of splines knows of the surface a curve stays on (Hofer, Pottmann: Energy-minimizing splines in
// manifolds, 2004, sec. 3.2): how to get onto it, what is tangent to it there, and how it bends.
//
// A manifold has dimension k and lies in Euclidean R^n. A metric that is a constant quadratic form (that of motions,
// sec. 4.1) is had by scaled coordinates, so nothing here knows of metrics.
//
// What lives in this room: manifolds, the energies of curves on them, the optimizer, obstacles, motions and first
// curves. What does not: meshes and distances along them (surfaces/), strokes and ribbons (curves/, stylization/).
#pragma once

#include <cstdint>

#include "core/memory.h"

namespace flg {

class Manifold {
public:
    static constexpr uint32_t max_ambient = 12;
    static constexpr uint32_t max_dimension = 12;
    static constexpr uint32_t max_hint = 256;

    virtual ~Manifold() = default;

    uint32_t ambient() const { return ambient_; }      // n, 2 to max_ambient
    uint32_t dimension() const { return dimension_; }  // k, 1 to max_dimension, at most n
    // How many doubles a point's hint has: where it was found last (a patch's parameters, neighbours). They begin as
    // zeros and are the manifold's own from then on. They speed up and disambiguate; a result must not depend on how a
    // point got to its place by more than rounding, but for manifolds that cover themselves.
    uint32_t hint_size() const { return hint_size_; }
    // A length to measure tolerances by: the diameter, or a period.
    double size() const { return size_; }

    // Moves x onto the surface, to the nearest point or, near the surface, to one that differs from it to second order
    // in the distance (Remark 2). False if there is none to be found; then x is as it was. Finite x. Some us at most,
    // so that 8 are a chunk. Any thread, for points whose hint is not used at the same time.
    virtual bool project(double* x, double* hint) const = 0;

    // An orthonormal basis of the tangent space: k rows of n numbers. x was projected with this hint. In R^3 the
    // cross product of the basis of a surface is its outward normal.
    virtual void tangent_basis(const double* x, double* hint, double* basis) const = 0;

    // form[i * k + j] = <force, II(b_i, b_j)>: the second fundamental form along a vector of R^n, of which only the
    // part normal to the surface counts, in the basis tangent_basis() gave. Symmetric. Unless a manifold knows better,
    // from projections of points 1e-4 of its size away: k (k + 1) of them.
    virtual void second_form(const double* x, double* hint, const double* basis, const double* force,
                             double* form) const;

    // Whether a curve's straight piece from a to b may become that from c to e in one step: a manifold around obstacles
    // says no where the step would pass one on another side. All four are on it.
    virtual bool keeps_sides(const double*, const double*, const double*, const double*) const { return true; }

protected:
    Manifold(uint32_t ambient, uint32_t dimension, uint32_t hint_size, double size)
        : ambient_(ambient), dimension_(dimension), hint_size_(hint_size), size_(size) {}
    Manifold(const Manifold&) = default;
    Manifold& operator=(const Manifold&) = default;

private:
    uint32_t ambient_, dimension_, hint_size_;
    double size_;
};

}  // namespace flg
