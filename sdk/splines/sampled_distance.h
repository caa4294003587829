// SPDX-License-Identifier: MIT
// A distance sampled on a grid in space, as the tricubic B-spline through its samples: twice continuously differentiable
// (Unser: Splines, a perfect fit for signal and image processing, 1999, for the recursive filter that finds the coefficients).
//
// Where the distance is smooth the error falls with the fourth power of the spacing h; at its creases (edges, the middle
// between walls) it is rounded off by up to 0.1 h, and waves by half of that two cells around.
#pragma once

#include "splines/sweep_distance.h"

namespace flg {

struct SampledDistance {
    SweepGrid grid;         // dimension 3
    Buffer<double> values;  // one a node: samples, then coefficients
    Obstacle::Box box;      // of what the distance is from
    double reach = 0;       // up to which it is sampled all around the box
    double deepest = 0;     // the greatest depth of a node; 0 if none is inside or the distance has no sign

    // Samples of one line of nodes to coefficients: line `index` of those along `axis`, of line_count(axis). 3 ns a node. All
    // lines of an axis before those of the next one.
    uint32_t line_count(uint32_t axis) const { return grid.size() / grid.counts[axis]; }
    void filter_line(uint32_t axis, uint32_t index);
    // The first node of a line.
    uint32_t line_start(uint32_t axis, uint32_t index) const;

    // False outside of the grid. With all coefficients; second may be null. 0.2 us.
    bool evaluate(const double* x, double* value, double* gradient, double* second) const;
};

}  // namespace flg
