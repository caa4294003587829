// SPDX-License-Identifier: MIT
// Where the optimization begins (Hofer, Pottmann 2004, sec. 3.2): piecewise geodesics, nearly, or the unrestricted
// spline, projected.
//
// Geodesics are found by halving chords and projecting their middles, again and again, on any manifold; a chord whose
// middle is as near to two places (antipodal points of a sphere) is led off along the first tangent of its first point.
// Where a middle comes out on another sheet than the ends do (the way over it is more than twice the chord, or the
// surface's normals turn over between neighbours), shortest paths on the mesh are taken. Without a mesh the way is
// walked step by step in the tangent spaces.
#pragma once

#include <vector>

#include "splines/manifolds/manifold_product.h"
#include "splines/optimizer/spline_optimizer.h"

namespace flg {

// A curve through given points as polylines, one a segment, each with its ends.
struct FirstCurve {
    explicit FirstCurve(Memory* memory) : points(memory), ends(memory) {}

    std::pmr::vector<double> points;  // n a point
    std::pmr::vector<uint32_t> ends;  // of segment s: how many points there are up to its last one, that included
};

struct GivenPoints {
    std::span<const double> values;  // n a point, on the manifold
    bool closed;
    const char* argument;  // what errors call them
    uint32_t count(uint32_t ambient) const { return static_cast<uint32_t>(values.size() / ambient); }
    uint32_t segments(uint32_t ambient) const { return count(ambient) - (closed ? 0 : 1); }
};

// Fails, and names the points, where no way leads from one to the next.
Task<void> find_first_curve(Pace& pace, const ManifoldProduct& held, GivenPoints given, FirstCurve& out);

// Puts `nodes` nodes along it, as many intervals a segment as its share of the length says, but at least
// `min_intervals`: the problem's points, knots and given points. In parameters that are given intervals are shared by
// these.
Task<void> place_nodes(Pace& pace, const Manifold& manifold, const FirstCurve& first, GivenPoints given, uint32_t nodes,
                       uint32_t min_intervals, SplineProblem& problem);

// The chain of an optimizer that is done becomes that of so many nodes, along the classical spline through its nodes
// (E1: along itself), intervals shared by parameters: to go on from where a coarser chain has come to.
Task<void> refine_chain(Pace& pace, const SplineOptimizer& coarse, uint32_t nodes, uint32_t min_intervals,
                        SplineProblem& problem);

// The problem's points become those of the unrestricted spline through its knots.
Task<void> unrestricted_spline(Pace& pace, SplineProblem& problem);

}  // namespace flg
