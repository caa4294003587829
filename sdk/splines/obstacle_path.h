// SPDX-License-Identifier: MIT
// The first curve of a spline among obstacles (Hofer, Pottmann 2004, sec. 5, Fig. 14): for each pair of given points
// the distance from the first one is spread over a grid, nodes inside of obstacles left out, and the second one is led
// back down it; then the way is pulled tight. It decides how the spline passes the obstacles: the optimizer moves it
// continuously.
//
// Invariants: no point of the polyline is inside of an obstacle or nearer than the clearance; given points are vertices
// of it. Departures: back from node to node, down the steepest straight way to a neighbour, not along the gradient,
// which next to nodes that are left out is unknown. Pulling tight: from each vertex to the farthest one that it sees,
// by doubling and halving; then the vertices that are left go towards the straight ways between their neighbours.
// Around a round obstacle tangents are left, some percents too long at most.
#pragma once

#include "splines/obstacle_grid.h"

namespace flg {

struct ObstaclePath {
    explicit ObstaclePath(Memory* memory) : points(memory), given(memory) {}
    std::pmr::vector<double> points;  // d numbers each: a polyline, without its z: BarrierSurface::lift()
    std::pmr::vector<uint32_t>
        given;           // which of them each given point is; of a closed one also its end, the first one again
    double spacing = 0;  // of the grid
};

class ObstaclePathKernel {
public:
    // points: d numbers each, two points at least, finite. sides: how obstacles have to be passed by all of the path.
    // All outlive the kernel; the path is complete when run() returned true. run() throws a Failure where a point is
    // inside of an obstacle (nearer than the clearance), behind one whose side is given, or in a gap finer than the
    // grid; and where there is no way.
    ObstaclePathKernel(const ObstacleSet& obstacles, std::span<const double> points, bool closed,
                       std::span<const ObstacleSide> sides, ObstaclePath& path, Memory* memory);

    // A unit is one of the grid's, of sweeping, or a look along a straight way: about 1 us, 20 us where it grazes
    // obstacles. Memory: 13 bytes a node.
    bool run(uint32_t count);

private:
    enum class Pass { points, grid, leg, straight, seeds, sweep, arrive, descend, pull, tighten, done };
    using Place = Obstacle::Place;

    Place given(uint32_t i) const;
    void check_point();
    Place free_place(uint32_t i) const;
    void begin_leg();
    void finish_leg();
    bool try_node(const Place& centre, uint32_t* node, Place* at);
    void seed();
    void arrive();
    void descend();
    bool look(const Place& a, const Place& b, bool* sees);
    void straight();
    void pull();
    void tighten();
    void add(const Place& x);

    const ObstacleSet& obstacles_;
    std::span<const double> points_;
    uint32_t d_, count_, legs_;
    ObstaclePath& path_;
    Memory* memory_;
    ObstacleGrid grid_;
    std::pmr::vector<SweepDistance> sweep_;  // none or one
    std::pmr::vector<SweepDistance::Seed> seeds_;
    std::pmr::vector<Place> trail_;  // of the leg, from its end
    std::pmr::vector<Place> taut_;   // the leg pulled tight, from its beginning
    Pass pass_ = Pass::points;
    uint32_t at_ = 0, leg_ = 0;
    Place from_{}, to_{};  // the leg's ends, as far from the obstacles as nodes
    bool strict_ = true;   // neighbours of a given point have to be on its side
    uint32_t best_ = 0;
    double least_ = 0;
    double done_ = 0;                                          // of the look
    uint32_t stand_ = 0, seen_ = 0, unseen_ = 0, stride_ = 0;  // of pulling: vertices of the trail
    uint32_t try_ = 0, round_ = 0;                             // of tightening
    bool second_ = false, moved_ = false;
};

}  // namespace flg
