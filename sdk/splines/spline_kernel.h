// SPDX-License-Identifier: MIT
// Energy-minimizing curves on manifolds (Hofer, Pottmann: Energy-minimizing splines in manifolds, 2004, sec. 3):
// Algorithm 2 on chains of points, and Newton's method in its place.
//
// Each round displaces the points in their tangent spaces such that the energy becomes least, and projects them back.
// The displaced points and the moments of their spline are unknowns together, so the system is a chain of small blocks
// (moments.h, block_tridiagonal.h) and a round takes time linear in the number of points.
//
// Departures from the paper
// - Newton's method: the Gramian gets the curvature of the surface times the force on each point
// (Manifold::second_form). It
// replaces the search for a stepsize and needs a few rounds where the paper's needs dozens. Where that is not positive,
// which
// the signs of the pivots tell, less is taken of each node's negative part (the paper's Gramian has nothing of either,
// and goes
//   too far where surfaces bend away). The paper's stepsize is there for comparison (footpoint_cone.h).
// - Parameters are lengths of the first curve, measured again when one is off by more than a fiftieth of its share.
//
// Invariants: given points stay where they are to the bit, unless smoothing; the energy falls from round to round, but
// for rounding, reparametrization and falling tension; points are on the manifold after every round; same bits whatever
// the chunks.
#pragma once

#include <algorithm>
#include <optional>

#include "splines/block_tridiagonal.h"
#include "splines/moments.h"

namespace flg {

enum class SplineMethod : uint32_t { newton, footpoint_cone };

// What is sought, and where to begin. Energies: bending * E2 + tension * E1 + sum |x - given|^2 / smoothing.
struct SplineProblem {
    const Manifold* manifold = nullptr;
    bool closed = false;
    double bending = 1;      // 1, or 0 for E1
    double tension = 0;      // w, at least 0; above 0 if bending is 0
    double smoothing = 0;    // 0: the given points are interpolated
    Buffer<double> points;   // the first curve, n numbers a node; at least 2 nodes, in a closed curve 3
    Buffer<double> memory;   // of the nodes (Manifold::memory_size()), from where they were before; may be empty
    Buffer<uint32_t> knots;  // ascending: the nodes of given points; the first is 0, and an open curve's last the last
    Buffer<double> given;    // n numbers a knot, on the manifold
    Buffer<double> parameters;  // one a knot, in a closed curve one more; ascending. Empty: lengths
    bool has_slope[2] = {false,
                         false};  // open curves: whether the derivative is prescribed at the first, the last point
    double slopes[2][Manifold::max_ambient] = {};  // tangent to the manifold
    double first_tension = 0;                      // homotopy: tension falls from here to `tension`, by 4 a round
    double tolerance = 1e-6;                       // of the residual
    uint32_t max_rounds = 200;
    SplineMethod method = SplineMethod::newton;
};

enum class SplineEnding : uint32_t { running, converged, rounding, rounds, stalled, failed };

struct SplineReport {
    // Tolerance reached; as near as rounding allows; rounds used up; no step leads down, so something is not smooth; not
    // on the manifold.
    SplineEnding ending = SplineEnding::running;
    uint32_t rounds = 0;
    uint32_t projections = 0;            // of whole curves
    uint32_t failed_node = 0;            // that could not be projected
    double energy = 0;                   // with all weights
    double bending = 0, stretching = 0;  // E2 and E1
    // Tangential part of the fourth derivative (less w times the second, where there is tension): its root mean square
    // over points that are free, over the mean size of all elastic forces a length, those at given points included.
    double residual = 0;
    double length = 0;  // of the chain
};

class SplineKernel {
public:
    // The problem outlives the kernel, its points are moved.
    SplineKernel(SplineProblem& problem, Memory* memory);

    // Spends `count` units of about 50 ns; true when done.
    bool run(uint32_t count);

    const SplineReport& report() const { return report_; }
    // Those of the last round that was accepted.
    const double* points() const { return now_.points.data(); }
    // When done: the same, and what the manifold remembers of them, to keep.
    Buffer<double> take_points() { return std::move(now_.points); }
    Buffer<double> take_memory() { return std::move(now_.memory); }
    const double* memory(uint32_t node) const { return now_.memory.data() + size_t{node} * memory_size_; }
    uint32_t nodes() const { return nodes_; }
    uint32_t ambient() const { return n_; }
    double first_parameter() const { return problem_.parameters.size() > 0 ? problem_.parameters[0] : 0; }
    // Of parameters, from a node to the next; 0 after the last one of an open curve.
    double step_after(uint32_t node) const { return moments_.step_after(node); }
    // The manifold's basis at a node, k x n numbers, of the last round that was finished.
    const double* basis(uint32_t node) const { return basis_of(node); }

private:
    enum class Pass {
        project_first,
        measure_lengths,
        set_steps,
        factorize,
        solve,
        moments,
        collect,
        gradient,
        frames,
        eliminate_free,
        substitute_free,
        subtract,
        subtract_tangent,
        eliminate,
        substitute,
        move,
        done
    };
    struct Curve {
        Buffer<double> points, memory;
        double bending = 0, stretching = 0, misfit = 0;  // E2, E1, sum |x - given|^2
    };
    // What solve, moments and collect work on.
    enum class Measured { now, trial, from_last, from_tangent };

    static constexpr uint32_t no_knot = 0xffffffffu;

    double weighted(const Curve& curve) const {
        return problem_.bending * curve.bending + tension_ * curve.stretching + pull_ * curve.misfit;
    }
    double* at(Curve& curve, uint32_t node) { return &curve.points[size_t{node} * n_]; }
    double* memory_of(Curve& curve, uint32_t node) { return curve.memory.data() + size_t{node} * memory_size_; }
    const double* basis_of(uint32_t node) const { return &basis_[size_t{node} * k_ * n_]; }
    bool bends() const { return problem_.bending > 0; }
    bool is_free(uint32_t node) const { return pull_ > 0 || knot_of_[node] == no_knot; }
    uint32_t next(uint32_t node) const { return node + 1 == nodes_ ? 0 : node + 1; }
    uint32_t previous(uint32_t node) const { return node == 0 ? nodes_ - 1 : node - 1; }
    bool has_next(uint32_t node) const { return problem_.closed || node + 1 < nodes_; }
    bool has_previous(uint32_t node) const { return problem_.closed || node > 0; }

    void step();
    void enter(Pass pass, uint32_t end);
    void leave();
    void charge(uint32_t units) { units_ -= std::min(units, units_); }
    void begin_measuring(Measured measured);
    const double* measured_points() const;

    void project_first(uint32_t node);
    void measure_length(uint32_t node);
    void set_step(uint32_t interval);
    uint32_t intervals_of(uint32_t knot) const;
    void set_end(bool last, double* points, double* memory, bool with_slope);
    void collect(uint32_t node);
    void find_gradient(uint32_t node);
    void find_frame(uint32_t node);
    void assemble(BlockTridiagonal& system, uint32_t node, bool unrestricted);
    void eliminate(BlockTridiagonal& system, uint32_t k, bool unrestricted);
    void restrict_moment(uint32_t node, double* vector) const;
    void substitute(uint32_t node);
    void substitute_free(uint32_t node);
    void move(uint32_t node);

    void after_collecting();
    void after_frames();
    void after_elimination();
    void after_substitution();
    void choose_cone_step();
    void try_step(double size);
    void accept();
    void begin_gradient();
    double noise() const;
    void refuse();
    bool reparametrize();
    void begin_elimination(BlockTridiagonal& system, Pass pass);
    void finish(SplineEnding ending);

    SplineProblem& problem_;
    Memory* memory_;
    const uint32_t n_, k_, nodes_, memory_size_;
    Moments moments_;
    Curve now_, trial_;
    Buffer<double> last_;                  // points of the round before
    Buffer<double> difference_;            // from there to here, then to the displaced points
    Buffer<double> moment_, gradient_;     // n a node; half the energy's
    Buffer<double> basis_, form_, shift_;  // k x n, k x k, k a node
    Buffer<uint32_t> knot_of_;             // by node: its knot, or no_knot
    Buffer<double> lengths_, spans_;       // one a knot, of the segment that it begins: of the chain, and of parameters
    BlockTridiagonal system_;
    std::optional<BlockTridiagonal> free_system_;

    double tension_ = 0, pull_ = 0;  // weights of E1 and of the distances to given points
    Pass pass_ = Pass::project_first;
    uint32_t units_ = 0, at_ = 0, end_ = 0;
    Measured measured_ = Measured::now;
    double sums_[3] = {};  // of what is collected
    // How much of what makes the energy less convex in the surface's curvature the system has.
    double concave_share_ = 1;
    bool has_last_ = false, has_least_ = false;
    bool projects_ = true;
    bool remembers_ = false;  // from before
    double least_ = 0;        // the energy of the free minimizer
    double step_ = 1;         // of the trial
    double cone_step_ = 1;    // the last one the cone told
    double square_last_ = 0, square_tangent_ = 0;
    double last_energy_ = 0;
    uint32_t shrinks_ = 0, reparametrizations_ = 0;
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
