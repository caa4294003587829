// SPDX-License-Identifier: MIT
// A distance sampled on a grid in space (mesh_distance.h), as the cubic B-spline through its samples (distance_grid.h).
//
// Where the distance is smooth the error falls with the fourth power of the spacing h; at its creases (edges, the
// middle between walls) it is rounded off by up to 0.1 h, and waves by half of that two cells around.
#pragma once

#include <optional>

#include "splines/distance_grid.h"
#include "splines/sweep_distance.h"

namespace flg {

struct SampledDistance {
    SweepGrid grid;                      // dimension 3
    std::optional<DistanceGrid> spline;  // through the distance less `shift`
    double shift = 0;                    // such that there are values of both signs
    Obstacle::Box box;                   // of what the distance is from
    double reach = 0;                    // up to which it is sampled all around the box
    double deepest = 0;  // the greatest depth of a node; 0 if none is inside or the distance has no sign

    // False outside of the grid. gradient and second may be null. 0.2 us.
    bool evaluate(const double* x, double* value, double* gradient, double* second) const {
        double own[3];
        if (!spline->evaluate(x, nullptr, value, gradient != nullptr ? gradient : own, second)) return false;
        *value += shift;
        return true;
    }
};

}  // namespace flg
