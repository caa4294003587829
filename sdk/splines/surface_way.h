// SPDX-License-Identifier: MIT
// Ways over a surface around solids that cut it: where first curves of splines begin that the shortest way would lead
// through a solid.
//
// A* (Hart, Nilsson, Raphael 1968) over the cells of a grid in space that the surface passes; a cell stands for the
// surface's point nearest to its middle, and is joined to those around it where the chord is clear. Then the way is
// pulled tight: from each place to the farthest one that a clear chord, put onto the surface, leads to. Cells that the
// search does not come to are never looked at.
//
// A side of an obstacle is had by a wall that no chord crosses: it stands on the surface along the straight way from a
// place inside the obstacle, in the opposite direction, as long as the surface is large or, where it comes back to the
// obstacle, half that way.
//
// Invariants: chords of the result are clear. A way through a gap wider than some cells is found; from grid to grid
// cells are halved.
#pragma once

#include "splines/manifolds/hypersurface.h"
#include "splines/obstacles/evaluations.h"
#include "splines/obstacles/obstacle_grid.h"
#include "splines/optimizer/first_curve.h"

namespace flg {

// Replaces the segments of `first` of which chords are not clear by `margin` metres. Throws a Failure that names the
// points where no way is found, or before which the evaluations are used up; and for sides of obstacles that there are
// not or that do not cut the surface, and directions across it. About 20 us a cell, and half as long again for each 64
// sides.
Task<void> lead_around(Pace& pace, const Hypersurface& surface, const ObstacleSet& obstacles,
                       std::span<const ObstacleSide> sides, double margin, GivenPoints given, FirstCurve& first,
                       Evaluations& evaluations);

}  // namespace flg
