// SPDX-License-Identifier: MIT
// Distances on a grid by fast sweeping (Zhao: A fast sweeping method for Eikonal equations, 2004): Gauss-Seidel rounds
// over the nodes in each of the 2^d orders of their axes, with the upwind difference of first order. As Hofer and
// Pottmann (2004, sec. 5) use it among obstacles: some nodes are not used, and edges can be closed too (what is thinner
// than a cell still parts its sides). Nodes are passed over while no neighbour has become less (Bak, McLaughlin, Renzi:
// Some improvements for the fast sweeping method, 2010).
//
// Invariants: a value only falls, and comes from neighbours along the axes, across open edges, that are smaller. The
// error is O(h log h) for a point as source, O(h) where the source's neighbourhood is exact; O(h^(2/3)), measured,
// where the way creeps around a round obstacle: the second derivatives are not bounded there.
#pragma once

#include "runtime/each.h"
#include "splines/obstacles/obstacle.h"

namespace flg {

// The nodes of a box, both ends included.
struct SweepRange {
    std::array<uint32_t, 3> lower{}, upper{};

    uint32_t size() const { return (upper[0] - lower[0] + 1) * (upper[1] - lower[1] + 1) * (upper[2] - lower[2] + 1); }
    // Number i of them, x fastest.
    std::array<uint32_t, 3> cell(uint32_t i) const {
        const uint32_t x = upper[0] - lower[0] + 1, y = upper[1] - lower[1] + 1;
        return {lower[0] + i % x, lower[1] + i / x % y, lower[2] + i / x / y};
    }
};

// Nodes in a box of the plane or of space, x fastest.
struct SweepGrid {
    uint32_t dimension = 2;
    std::array<uint32_t, 3> counts{1, 1, 1};  // along each axis, 2 at least; of the plane 1 along the third
    Obstacle::Place origin{};
    double spacing = 1;

    uint32_t size() const { return counts[0] * counts[1] * counts[2]; }
    uint32_t stride(uint32_t axis) const { return axis == 0 ? 1 : axis == 1 ? counts[0] : counts[0] * counts[1]; }
    std::array<uint32_t, 3> cell(uint32_t node) const {
        return {node % counts[0], node / counts[0] % counts[1], node / (counts[0] * counts[1])};
    }
    uint32_t node(const std::array<uint32_t, 3>& cell) const {
        return (cell[2] * counts[1] + cell[1]) * counts[0] + cell[0];
    }
    Obstacle::Place place(uint32_t node) const {
        Obstacle::Place x{};
        const std::array<uint32_t, 3> at = cell(node);
        for (uint32_t k = 0; k < dimension; ++k) x[k] = origin[k] + spacing * at[k];
        return x;
    }
    SweepRange whole() const { return {{}, {counts[0] - 1, counts[1] - 1, counts[2] - 1}}; }
    // The node that is nearest.
    std::array<uint32_t, 3> nearest(const double* x) const;
};

// Where distances are wanted: ways to there that are longer than `longest` may be left out. It should be some cells
// more than is wanted: a value comes from nodes beside the way, too.
struct SweepGoal {
    Obstacle::Place at{};
    double longest = std::numeric_limits<double>::infinity();
};

class SweepDistance {
public:
    // Of a node: the edge to the next node along axis k is closed; the node is not used.
    static constexpr uint8_t closed(uint32_t axis) { return static_cast<uint8_t>(1u << axis); }
    static constexpr uint8_t unused = 8;

    struct Seed {
        uint32_t node;
        double value;
    };

    // flags: one a node; read while it is solved. Memory: 9 bytes a node.
    SweepDistance(const SweepGrid& grid, const uint8_t* flags, Memory* memory)
        : grid_(grid),
          flags_(flags),
          values_(grid.size(), memory),
          is_due_(grid.size(), memory),
          row_is_due_(size_t{grid.counts[1]} * grid.counts[2], memory) {}

    // From these nodes, which are in the range, anew; on ways within the range. About 13 ns a node and sweep in the
    // plane, 19 in space, nothing where nothing is to be done along a row. In free space two rounds of 2^d sweeps, with
    // obstacles a round more for each time that a shortest way turns. Returns how many nodes the sweeps passed.
    static Task<uint64_t> solve(Pace& pace, SweepDistance& of, SweepRange range, std::span<const Seed> seeds,
                                SweepGoal goal = {});
    // After that; infinite where nothing leads.
    double operator[](uint32_t node) const { return values_[node]; }

private:
    double updated(uint32_t node, uint32_t x, uint32_t y, uint32_t z) const;
    void call_neighbours(uint32_t node, const std::array<uint32_t, 3>& cell);
    bool sweep_row(std::array<uint32_t, 3> cell, const SweepRange& range, bool backwards, double change,
                   const SweepGoal& goal);
    bool leads_to(const SweepGoal& goal, uint32_t node, const std::array<uint32_t, 3>& cell) const;

    SweepGrid grid_;
    const uint8_t* flags_;
    Buffer<double> values_;
    Buffer<uint8_t> is_due_;      // a neighbour has become less since it was looked at
    Buffer<uint8_t> row_is_due_;  // by row along x: perhaps a node of it is
};

}  // namespace flg
