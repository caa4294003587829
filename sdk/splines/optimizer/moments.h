// SPDX-License-Identifier: MIT
// Energies of the curve through a chain of points (Hofer, Pottmann 2004, equations 1 to 3, discretized).
//
// Departure from the paper, which takes differences of differences as second derivatives: ours is the least E2 of all
// curves in R^n through the points, that of their cubic spline, whose second derivatives at the points (its moments M)
// solve R M = Q^T x (Reinsch). Where nothing restricts a curve its spline then comes out to rounding, not to the square
// of the step, and the fourth derivative is a second difference of M, which costs half the digits less. With tension it
// is the least E_t, that of their spline in tension (natural_cubic.h): R is another one, and to M^T Q^T x come the
// straight lines' shares of E1. On manifolds the error falls with the fourth power of the step; that of E1, a polyline,
// with the square.
//
// Ends. The tangent of a curve on a surface has no part along the surface's normals. So the spline is clamped in these
// directions (slope 0) and natural in the tangent ones: else a whole step at each end would count too little.
// `normals`: the projection onto them; the identity where a derivative is prescribed, 0 where the surface fills R^n or
// the end may move.
//
// Invariants: exact for splines, cubic or in tension, with breaks at given points; E2 >= 0; linear in the points but
// for the ends' slopes.
#pragma once

#include <cmath>
#include <span>

#include "linear/block_tridiagonal.h"
#include "runtime/each.h"
#include "splines/manifolds/manifold.h"
#include "splines/optimizer/natural_cubic.h"

namespace flg {

// One end of an open curve.
struct SplineEnd {
    double normals[Manifold::max_ambient * Manifold::max_ambient] = {};  // a projection of R^n, symmetric
    double slope[Manifold::max_ambient] = {};                            // the derivative there, as far as it counts
};

class Moments {
public:
    // `nodes` points of R^n, at least 2, in a cycle 3. `tension`: w of E_t, 0 for cubic splines.
    Moments(uint32_t nodes, uint32_t ambient, bool closed, double tension, Memory* memory);

    // Steps between nodes: one an interval. To be factorized again after they change.
    std::span<double> steps() { return {steps_.data(), steps_.size()}; }
    // Shares of the tension, by interval; empty: 1. Likewise.
    Buffer<double>& tension_shares() { return tension_shares_; }
    const Buffer<double>& tension_shares() const { return tension_shares_; }
    static Task<void> factorize(Pace& pace, Moments& m);

    SplineEnd& end(bool last) { return ends_[last]; }
    const SplineEnd& end(bool last) const { return ends_[last]; }

    // The moments of the spline through points, n numbers a node each.
    static Task<void> solve(Pace& pace, Moments& m, const double* points, double* moments);

    // The change of slope at a node, (Q^T x)_i; the sum over nodes of its product with the moment is E2.
    void bend(uint32_t node, const double* points, double* out) const;
    // Once factorized: what R has on its diagonal, and for an interval beside it.
    double row(uint32_t node) const;
    double across(uint32_t interval) const { return pieces_.empty() ? steps_[interval] / 6 : pieces_[interval].across; }
    RowBlocks<double>& inner() { return inner_; }
    // E2's share of a node, given its moment.
    double energy(uint32_t node, const double* points, const double* moment) const;

    // Of the interval before a node and after it; 0 where there is none.
    double step_before(uint32_t node) const {
        return node > 0 ? steps_[node - 1] : closed_ ? steps_[intervals_ - 1] : 0;
    }
    double step_after(uint32_t node) const { return node < intervals_ ? steps_[node] : 0; }
    uint32_t nodes() const { return nodes_; }

private:
    void solve_ends(const double* points);
    void moment(uint32_t node, double* out) const;
    double stiffness(uint32_t interval) const {
        return tension_shares_.empty() ? stiffness_ : stiffness_ * std::sqrt(tension_shares_[interval]);
    }

    uint32_t nodes_, ambient_, intervals_;
    bool closed_;
    double stiffness_;  // the square root of w
    Buffer<double> steps_, tension_shares_;
    Buffer<CubicPiece> pieces_;  // by interval; empty without tension
    // R without its first and last row, factorized: i = 1 to intervals - 1.
    Buffer<double> inverse_, upper_;
    // What a moment of 1 at the first node (`from_first_`) or at the last one takes from node i.
    Buffer<double> from_first_, from_last_;
    RowBlocks<double> inner_;  // moments of node i with none at the ends
    SplineEnd ends_[2];
    double end_moments_[2][Manifold::max_ambient] = {};
};

}  // namespace flg
