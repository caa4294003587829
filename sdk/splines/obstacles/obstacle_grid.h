// SPDX-License-Identifier: MIT
// The grid that first curves around obstacles are found on (Hofer, Pottmann 2004, sec. 5, Fig. 14): how fine it is,
// which of its nodes are free, which edges are closed by something thinner than a cell; and which side of an obstacle a
// curve must pass.
//
// A side is had by extending the obstacle without end in the opposite direction: what the extension holds is not free,
// so every way passes on the side that is left. A point x is in the extension of O along -u if O is met from x in
// direction u. In space ways would go around that on the third side: so the extension is a wall, which goes twice as
// far to both sides, across u and the straight way past the obstacle, as the obstacle is high along u; over it is
// shorter. Obstacles that are thinner than a cell are extended as bars two cells wide, which no way along the grid
// crosses.
//
// Spacing: a quarter of the narrowest gap between two obstacles (found by projecting to and fro, so between dents not
// the narrowest) and of a layer's thickness, not coarser than 1/128 of the longest side of the grid's box (space:
// 1/48), not finer than 1/512 (1/96). Gaps that are narrower than a cell are seen only where nodes happen to lie in
// them.
#pragma once

#include <optional>

#include "splines/obstacles/sweep_distance.h"

namespace flg {

struct ObstacleSide {
    uint32_t obstacle;
    Obstacle::Place direction;  // the side that is passed, as seen from the obstacle; any length but 0
};

class ObstacleGrid {
public:
    // Nodes are looked at when they are needed: those of a range, before anything else is asked about them. Where there
    // are sides obstacle_grid() has looked at all. About 1 us a node that is new.
    // Returns how many those were.
    static Task<uint32_t> look(Pace& pace, ObstacleGrid& of, SweepRange range);

    const SweepGrid& grid() const { return grid_; }
    const uint8_t* flags() const { return flags_.data(); }  // as for SweepDistance
    // So far from all obstacles are free nodes, a sixteenth of the spacing; and ways at least 0.
    double margin() const { return margin_; }
    double way_margin() const { return margin_ / 4; }
    bool free(uint32_t node) const { return (flags_[node] & SweepDistance::unused) == 0; }
    // Whether a straight way stays out of all extensions, by the nodes that are nearest to it: 5 ns half a cell.
    bool on_side(const double* a, const double* b) const;
    // The first side of which the extension holds x, by the obstacle as it is; the number of sides if none does.
    uint32_t behind(const double* x) const;
    uint32_t side_count() const { return static_cast<uint32_t>(sides_.size()); }
    const ObstacleSide& side(uint32_t i) const { return sides_[i]; }

private:
    // Beside SweepDistance's flags. Of a node that was looked at; whose edges were, too.
    static constexpr uint8_t extension = 16, known = 32, has_edges = 64;

    friend Task<ObstacleGrid> obstacle_grid(Pace& pace, const ObstacleSet& obstacles, std::span<const double> points,
                                            std::span<const ObstacleSide> sides, std::optional<Obstacle::Box> within,
                                            double coarser);
    ObstacleGrid(const ObstacleSet& obstacles, std::span<const ObstacleSide> sides, Memory* memory);
    bool flag_node(uint32_t node);
    uint32_t close_edges(uint32_t node);
    void widen(size_t side, std::span<const double> points);
    bool in_extension(const ObstacleSide& side, const double* x, double margin) const;
    bool in_wall(size_t side, const double* x, double margin) const;

    const ObstacleSet& obstacles_;
    std::pmr::vector<ObstacleSide> sides_;  // with unit directions
    // Of each in space, across its direction and the way past it: a unit vector, or 0; and how far the wall goes there.
    struct Across {
        Obstacle::Place along{};
        double reach = 0;  // metres to either side of the obstacle's core
    };
    std::pmr::vector<Across> across_;
    double margin_ = 0;
    SweepGrid grid_;
    Buffer<uint8_t> flags_;
    Buffer<float> away_;  // a node's distance, where it is known
};

// points: d numbers each; the grid's box has them and all obstacles, of these what is `within`, with a tenth of its
// size around. Obstacles outlive the grid. coarser: a factor of the spacing, at least 1. Throws a Failure: sides of
// obstacles that there are not, or that have no outside, directions without length. About 1 ns a node; with sides 1 us,
// and more where a side's extension is grazed.
Task<ObstacleGrid> obstacle_grid(Pace& pace, const ObstacleSet& obstacles, std::span<const double> points,
                                 std::span<const ObstacleSide> sides,
                                 std::optional<Obstacle::Box> within = std::nullopt, double coarser = 1);

}  // namespace flg
