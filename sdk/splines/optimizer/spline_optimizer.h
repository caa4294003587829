// SPDX-License-Identifier: MIT
// Energy-minimizing curves on manifolds (Hofer, Pottmann: Energy-minimizing splines in manifolds, 2004, sec. 3):
// Algorithm 2 on chains of points, with Newton's method in place of its stepsize (Algorithm 1).
//
// Each round displaces the points in their tangent spaces such that the energy becomes least, and projects them back.
// The displaced points and the moments of their spline are unknowns together, so the system is a chain of small blocks
// (linear/block_tridiagonal.h) and a round takes time linear in the number of points.
//
// Departures from the paper
// - Newton's method: the Gramian gets the curvature of the surface times the force on each point
//   (Manifold::second_form). It replaces the search for a stepsize and needs a few rounds where the paper's needs
//   dozens. Where that is not positive, which the signs of the pivots tell, less is taken of each node's negative part
//   (the paper's Gramian has nothing of either, and goes too far where surfaces bend away).
//
// - Where the surface has an edge or a gap no step of the whole curve may lead down, however short. Nodes that jump
//   there are held, as if they were given, and the others go on.
//
// - Where the surface has a border nodes stay within it. A round finds which of them the step would press against it,
//   by a primal-dual active set (Hintermueller, Ito, Kunisch 2003): pressed nodes move along the border only, up to it,
//   and are let go where their force points inwards. At a corner that points out a node may come to rest.
//
// Parameters are lengths of the first curve. They are measured again after the paper's heavy change: when one is off by
// more than a fiftieth of its share.
//
// Invariants: given points stay where they are to the bit, unless smoothing; the energy falls from round to round, but
// for rounding, reparametrization and falling tension; points are on the manifold after every round; same bits whatever
// the slices.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "linear/block_tridiagonal.h"
#include "runtime/each.h"
#include "splines/manifolds/manifold.h"
#include "splines/optimizer/border_walls.h"
#include "splines/optimizer/moments.h"

namespace flg {

// What is sought, and where to begin. Energies: bending * E2 + tension * E1 + sum |x - given|^2 / smoothing; E1 of each
// segment times its tension's share, and each given point with a smoothing of its own.
struct SplineProblem {
    const Manifold* manifold = nullptr;
    bool closed = false;
    double bending = 1;       // 1, or 0 for E1
    double tension = 0;       // w, at least 0; above 0 if bending is 0
    double smoothing = 0;     // 0: the given points are interpolated
    Buffer<double> softness;  // one a knot, in place of `smoothing`; empty: that of all
    Buffer<double> tensions;  // one a segment: shares of `tension`, at least 0; empty: 1
    Buffer<double> points;    // the first curve, n numbers a node; at least 2 nodes, in a closed curve 3
    Buffer<double> hints;     // of the nodes (Manifold::hint_size()), from where they were before; may be empty
    Buffer<uint32_t> knots;   // ascending: the nodes of given points; the first is 0, and an open curve's last the last
    Buffer<double> given;     // n numbers a knot, on the manifold
    Buffer<double> parameters;  // one a knot, in a closed curve one more; ascending. Empty: lengths
    Buffer<double> shares;      // one an interval, of its segment's parameters; empty: those of a segment are equal
    // Open curves: whether the derivative is prescribed at the first, the last point.
    bool has_slope[2] = {false, false};
    double slopes[2][Manifold::max_ambient] = {};  // tangent to the manifold
    double first_tension = 0;                      // homotopy: tension falls from here to `tension`, by 4 a round
    double tolerance = 1e-6;                       // of the residual
    uint32_t max_rounds = 200;
    uint32_t max_work = 0xffffffff;  // rounds and projections of the curve; a round that has begun is finished
    bool holds_nodes = false;        // where the surface has edges or gaps; else it ends there, stalled
    // Of the surface in R^3, or under a barrier; null: none. Free nodes stay so far within, m; below 0: beyond.
    const MeshBorder* border = nullptr;
    double within = 0;
};

enum class SplineEnding : uint32_t { running, converged, rounding, rounds, stalled, failed };

struct SplineReport {
    // Tolerance reached; as near as rounding allows; rounds used up; no step leads down, so something is not smooth;
    // not on the manifold.
    SplineEnding ending = SplineEnding::running;
    uint32_t rounds = 0;
    uint32_t projections = 0;            // of whole curves
    uint32_t failed_node = 0;            // that could not be projected
    uint32_t held = 0;                   // nodes that stay where the surface has an edge or a gap
    uint32_t pressed = 0;                // nodes that the border keeps from going on
    double energy = 0;                   // with all weights
    double bending = 0, stretching = 0;  // E2 and E1
    // Tangential part of the fourth derivative (less w times the second, where there is tension): its root mean square
    // over points that are free, over the mean size of all elastic forces a length, those at given points included.
    double residual = 0;
    double length = 0;  // of the chain
};

class SplineOptimizer {
public:
    // The problem outlives it, its points are moved.
    SplineOptimizer(SplineProblem& problem, Memory* memory);

    // Goes on until the next round was accepted; false when done. A round takes about 1 us a node on a mesh.
    static Task<bool> next_round(Pace& pace, SplineOptimizer& s);
    // All rounds.
    static Task<void> minimize(Pace& pace, SplineOptimizer& s);

    const SplineReport& report() const { return report_; }
    // Those of the last round that was accepted.
    const double* points() const { return now_.points.data(); }
    // When done: gives its memory back in slices, but for the points and their hints.
    static Task<void> give_back(Pace& pace, SplineOptimizer& s);
    // When done: the same, and their hints, to keep.
    Buffer<double> take_points() { return std::move(now_.points); }
    Buffer<double> take_hints() { return std::move(now_.hints); }
    const double* hint(uint32_t node) const { return now_.hints.data() + size_t{node} * hint_size_; }
    uint32_t nodes() const { return nodes_; }
    uint32_t ambient() const { return n_; }
    double first_parameter() const { return problem_.parameters.size() > 0 ? problem_.parameters[0] : 0; }
    // Of parameters, from a node to the next; 0 after the last one of an open curve.
    double step_after(uint32_t node) const { return moments_.step_after(node); }
    // The manifold's basis at a node, k x n numbers, of the last round that was finished.
    const double* basis(uint32_t node) const { return basis_of(node); }
    // Whether the node stays where the surface has an edge or a gap.
    bool is_held(uint32_t node) const { return is_held_[node] != 0; }

private:
    struct Curve {
        Buffer<double> points, hints;
        double bending = 0, stretching = 0;  // E2, E1
        double tensed = 0, misfit = 0;       // E1 by shares of tension; sum |x - given|^2 by shares of pull
    };

    static constexpr uint32_t no_knot = 0xffffffffu;

    double weighted(const Curve& curve) const {
        return problem_.bending * curve.bending + tension_ * curve.tensed + pull_ * curve.misfit;
    }
    double* at(Curve& curve, uint32_t node) { return &curve.points[size_t{node} * n_]; }
    const double* at(const Curve& curve, uint32_t node) const { return &curve.points[size_t{node} * n_]; }
    double* hint_of(Curve& curve, uint32_t node) { return curve.hints.data() + size_t{node} * hint_size_; }
    const double* basis_of(uint32_t node) const { return basis_[node]; }
    bool bends() const { return problem_.bending > 0; }
    bool is_free(uint32_t node) const { return !is_held(node) && (knot_of_[node] == no_knot || pull_at(node) > 0); }
    // Of the given point that a node is held to; 0 where it is fixed, or there is none.
    double pull_at(uint32_t node) const {
        if (knot_of_[node] == no_knot) return 0;
        return pull_shares_.size() > 0 ? pull_ * pull_shares_[knot_of_[node]] : pull_;
    }
    double tension_after(uint32_t node) const {
        const Buffer<double>& shares = moments_.tension_shares();
        return shares.size() > 0 ? tension_ * shares[node] : tension_;
    }
    // Along the a-th direction of its basis.
    bool is_free(uint32_t node, uint32_t a) const {
        return is_free(node) && (!has_border() || walls_[node].pressed == 0 || (walls_[node].pressed == 1 && a == 0));
    }
    bool has_border() const { return problem_.border != nullptr; }
    // More are no exceptions.
    uint32_t max_held() const { return nodes_ / 16 + 3; }
    uint32_t next(uint32_t node) const { return node + 1 == nodes_ ? 0 : node + 1; }
    uint32_t previous(uint32_t node) const { return node == 0 ? nodes_ - 1 : node - 1; }
    bool has_next(uint32_t node) const { return problem_.closed || node + 1 < nodes_; }
    bool has_previous(uint32_t node) const { return problem_.closed || node > 0; }

    // The course of a round.
    static Task<void> begin(Pace& pace, SplineOptimizer& s);
    static Task<void> set_parameters(Pace& pace, SplineOptimizer& s);
    static Task<void> measure(Pace& pace, SplineOptimizer& s, Curve& curve);
    static Task<void> find_forces(Pace& pace, SplineOptimizer& s);
    static Task<void> eliminate(Pace& pace, SplineOptimizer& s);
    static Task<void> substitute(Pace& pace, SplineOptimizer& s);
    static Task<bool> try_step(Pace& pace, SplineOptimizer& s);
    static Task<void> hold_jumping(Pace& pace, SplineOptimizer& s);
    static Task<void> solve(Pace& pace, SplineOptimizer& s);
    static Task<bool> press(Pace& pace, SplineOptimizer& s);
    static Task<void> press_as_begun(Pace& pace, SplineOptimizer& s);
    void assess();
    bool needs_parameters() const;
    bool is_over();
    bool is_indefinite() const;
    bool accept();
    double noise() const;

    // What is done at one node.
    void project_first(uint32_t node);
    void measure_length(uint32_t node);
    void set_step(uint32_t interval);
    uint32_t intervals_of(uint32_t knot) const;
    void set_end(bool last, Curve& curve);
    void add_energy(Curve& curve, uint32_t node);
    void find_gradient(uint32_t node);
    void find_frame(uint32_t node);
    void find_wall(uint32_t node);
    void face_wall(uint32_t node, const BorderView& view);
    bool confine(double* x, double* hint, const double* basis) const;
    void find_base(uint32_t node);
    double force_along(uint32_t node, uint32_t a, const double* direction) const;
    double push_at_wall(uint32_t node) const;
    bool press_node(uint32_t node);
    void assemble(uint32_t node);
    void restrict_moment(uint32_t node, double* vector) const;
    void find_shift(uint32_t node);
    void move(uint32_t node);

    SplineProblem& problem_;
    const uint32_t n_, k_, nodes_, hint_size_;
    Moments moments_;
    Curve now_, trial_;
    Buffer<double> moment_;                   // n a node
    RowBlocks<double> gradient_;              // n a node; half the energy's
    RowBlocks<double> basis_, form_, shift_;  // k x n, k x k, k a node
    Buffer<uint32_t> knot_of_;                // by node: its knot, or no_knot
    Buffer<uint8_t> is_held_;                 // by node
    BorderWalls walls_;
    Buffer<double> base_;             // n a node: where pressed ones are at the border; likewise
    Buffer<double> pull_shares_;      // by knot, of the strongest pull; empty: 1
    Buffer<double> lengths_, spans_;  // one a knot, of the segment that it begins: of the chain, and of parameters
    BlockTridiagonal system_;

    bool has_begun_ = false;
    double tension_ = 0, pull_ = 0;  // weights of E1 and of the distances to given points
    // How much of what makes the energy less convex in the surface's curvature the system has.
    double concave_share_ = 1;
    bool projects_ = true;
    bool remembers_ = false;  // from before
    double step_ = 1;         // of the trial
    uint32_t reparametrizations_ = 0;
    double slope_ = 0;    // of half the energy along the displacement
    double largest_ = 0;  // displacement, m
    uint32_t segment_ = 0, next_knot_ = 0;
    double span_ = 0;    // of all parameters
    double change_ = 0;  // of a segment's share of the length, since it was measured
    double forces_ = 0, tangential_ = 0;
    uint32_t free_nodes_ = 0;
    double last_residual_ = 0;
    SplineReport report_;
};

}  // namespace flg
