// SPDX-License-Identifier: MIT
// Whether a whole curve keeps clear of obstacles, not only its nodes: the chain, and the cubic spline through it.
//
// Between two nodes that are a step h of the parameter apart, with second derivatives m and n at them, a cubic stays
// within t (1 - t) / 2 * h^2 * max(|m|, |n|) of its chord, t in [0, 1]. The chord is followed in steps of the distance
// less that (Obstacle: what is `value` away from a place is free). So a piece that passes is clear everywhere: nothing
// is sampled.
#pragma once

#include <vector>

#include "runtime/each.h"
#include "splines/obstacles/obstacle.h"

namespace flg {

// An interval that may not keep clear.
struct Trespass {
    uint32_t interval;
    uint32_t obstacle;
    double depth;  // metres > 0, by which it falls short at most, as far as was looked
    double at;     // where: t
};

struct CurvePieces {
    std::span<const double> nodes;    // d numbers each
    std::span<const double> steps;    // of the parameter, one an interval
    std::span<const double> moments;  // second derivatives, d numbers a node; empty: the chain alone
    std::span<const double> allowed;  // metres, one an interval: how much nearer it may come
    std::span<const double> spare;    // metres > 0, one an interval: how much of a distance is not used up
    bool closed;
};

// Appends the intervals that may come nearer to an obstacle than they are allowed to, and those where less than the
// spare part is left of the distance: of the others no place is nearer. 50 ns an obstacle that is near and step; steps
// are no shorter than the spare part. Returns how many steps those were.
Task<uint64_t> find_trespasses(Pace& pace, const ObstacleSet& obstacles, CurvePieces curve,
                               std::pmr::vector<Trespass>& out);

// Whether the straight way from a to b (d numbers each) stays clear by `margin` metres > 0 (ObstacleSet::follow).
Task<bool> is_clear(Pace& pace, const ObstacleSet& obstacles, Obstacle::Place a, Obstacle::Place b, double margin);

}  // namespace flg
