// SPDX-License-Identifier: MIT
// The first curve of a spline among obstacles (Hofer, Pottmann 2004, sec. 5, Fig. 14): for each pair of given points
// the distance from the first one is spread over a grid, nodes inside of obstacles left out, and the second one is led
// back down it; then the way is pulled tight. A coarser grid comes first: the way there says how far around
// to look. It decides how the spline passes the obstacles: the optimizer moves it continuously.
//
// Invariants: no point of the polyline is inside of an obstacle or nearer than the clearance; given points are vertices
// of it. Departures: back from node to node, down the steepest straight way to a neighbour, not along the gradient,
// which next to nodes that are left out is unknown. Pulling tight: from each vertex to the farthest one that it sees,
// by doubling and halving; then the vertices that are left go towards the straight ways between their neighbours.
// Around a round obstacle tangents are left, some percents too long at most.
#pragma once

#include "splines/obstacles/evaluations.h"
#include "splines/obstacles/obstacle_grid.h"

namespace flg {

struct ObstaclePath {
    explicit ObstaclePath(Memory* memory) : points(memory), given(memory) {}
    std::pmr::vector<double> points;  // d numbers each: a polyline, without its z: BarrierSurface::lift()
    // Which of them each given point is; of a closed one also its end, the first one again.
    std::pmr::vector<uint32_t> given;
    double spacing = 0;  // of the grid
};

// points: d numbers each, two points at least, finite. sides: how obstacles have to be passed by all of the path.
// slack: metres, by which given points may be nearer than the clearance. evaluations: what it costs is taken from
// them; null: no bound. longest: no way from a point to the next that is longer is wanted, so none is looked for where
// there are only longer ones.
// Throws a Failure where a point is inside of an obstacle (nearer than the clearance), behind one whose side is given,
// or in a gap finer than the grid; where there is no way; and where the evaluations are used up before it is found.
// Memory: 14 bytes a node of the grid.
Task<ObstaclePath> obstacle_path(Pace& pace, const ObstacleSet& obstacles, std::span<const double> points, bool closed,
                                 std::span<const ObstacleSide> sides, double slack = 0,
                                 Evaluations* evaluations = nullptr,
                                 double longest = std::numeric_limits<double>::infinity());

// Its first check: throws a Failure that names the point.
Task<void> refuse_inside(Pace& pace, const ObstacleSet& obstacles, std::span<const double> points, double slack);

}  // namespace flg
