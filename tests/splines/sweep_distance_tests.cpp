// SPDX-License-Identifier: MIT
#include "splines/obstacles/sweep_distance.h"

#include <numbers>

#include "splines/obstacle_checks.h"
#include "splines/obstacles/obstacle_shapes.h"

namespace flg::test {
namespace {

SweepGrid cube(uint32_t dimension, uint32_t cells) {
    SweepGrid grid;
    grid.dimension = dimension;
    grid.spacing = 4.0 / cells;
    for (uint32_t k = 0; k < dimension; ++k) {
        grid.counts[k] = cells + 1;
        grid.origin[k] = -2;
    }
    return grid;
}

std::vector<double> solved(const SweepGrid& grid, const std::vector<uint8_t>& flags,
                           const std::vector<SweepDistance::Seed>& seeds, bool haltingly = false) {
    SweepDistance sweep(grid, flags.data(), heap());
    run_now(
        heap(), [&](Pace& pace) { return SweepDistance::solve(pace, sweep, grid.whole(), seeds); }, haltingly);
    std::vector<double> values(grid.size());
    for (uint32_t i = 0; i < grid.size(); ++i) values[i] = sweep[i];
    return values;
}

// Of the way around a ball of radius 1 at the origin: straight, or two tangents and an arc.
double around_ball(const Obstacle::Place& a, const Obstacle::Place& b) {
    double ra = 0, rb = 0, dot = 0, away = 0;
    for (size_t k = 0; k < 3; ++k) {
        ra += a[k] * a[k];
        rb += b[k] * b[k];
        dot += a[k] * b[k];
        away += (b[k] - a[k]) * (b[k] - a[k]);
    }
    const double between = std::acos(std::clamp(dot / std::sqrt(ra * rb), -1.0, 1.0));
    const double arc = between - std::acos(1 / std::sqrt(ra)) - std::acos(1 / std::sqrt(rb));
    return arc <= 0 ? std::sqrt(away) : std::sqrt(ra - 1) + std::sqrt(rb - 1) + arc;
}

struct Errors {
    double lit = 0, shadow = 0;
};

// The largest errors where the source is seen, and behind the ball; the source's surroundings are given.
Errors ball_errors(uint32_t dimension, uint32_t cells) {
    const SweepGrid grid = cube(dimension, cells);
    const Obstacle::Place source{-1.5, 0, 0};
    std::vector<uint8_t> flags(grid.size());
    std::vector<SweepDistance::Seed> seeds;
    for (uint32_t i = 0; i < grid.size(); ++i) {
        const Obstacle::Place x = grid.place(i);
        const double r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        if (r < 1) flags[i] = SweepDistance::unused;
        const double away = r < 1 ? 1 : around_ball(source, x);
        if (away < 0.2) seeds.push_back({i, away});
    }
    const auto values = solved(grid, flags, seeds);
    Errors errors;
    for (uint32_t i = 0; i < grid.size(); ++i) {
        if (flags[i] != 0) continue;
        const Obstacle::Place x = grid.place(i);
        const double exact = around_ball(source, x), straight = std::hypot(x[0] - source[0], x[1], x[2]);
        double& most = exact > straight ? errors.shadow : errors.lit;
        most = std::max(most, std::abs(values[i] - exact));
    }
    return errors;
}

TEST(SweepDistance, AroundADiscIsTangentsAndAnArc) {
    double last = 1;
    for (const uint32_t cells : {64u, 128u, 256u}) {
        const double h = 4.0 / cells;
        const Errors errors = ball_errors(2, cells);
        EXPECT_LT(errors.lit, 2 * h);
        EXPECT_LT(errors.shadow, 2.3 * std::pow(h, 2.0 / 3));
        EXPECT_LT(errors.shadow, 0.68 * last);
        last = errors.shadow;
    }
}

TEST(SweepDistance, AroundABallIsTangentsAndAnArc) {
    double last = 1;
    for (const uint32_t cells : {24u, 48u}) {
        const double h = 4.0 / cells;
        const Errors errors = ball_errors(3, cells);
        EXPECT_LT(errors.lit, 2.5 * h);
        EXPECT_LT(errors.shadow, 2.3 * std::pow(h, 2.0 / 3));
        EXPECT_LT(errors.shadow, 0.68 * last);
        last = errors.shadow;
    }
}

TEST(SweepDistance, FromAPointItErrsByHLogH) {
    double last = 1;
    for (const uint32_t cells : {40u, 80u, 160u}) {
        const SweepGrid grid = cube(2, cells);
        const uint32_t source = grid.node({cells / 4, cells / 2, 0});
        const auto values = solved(grid, std::vector<uint8_t>(grid.size()), {{source, 0}});
        const Obstacle::Place a = grid.place(source);
        double most = 0;
        for (uint32_t i = 0; i < grid.size(); ++i) {
            const Obstacle::Place x = grid.place(i);
            const double away = std::hypot(x[0] - a[0], x[1] - a[1]);
            EXPECT_GE(values[i], away - 1e-12);
            most = std::max(most, values[i] - away);
        }
        EXPECT_LT(most, 0.7 * grid.spacing * std::log(1 / grid.spacing) + grid.spacing);
        EXPECT_LT(most, 0.7 * last);
        last = most;
    }
}

// Each value solves the upwind equation of its neighbours: sum of max(u - a, 0)^2 = h^2.
TEST(SweepDistance, ValuesSolveTheEquation) {
    for (const uint32_t dimension : {2u, 3u}) {
        const SweepGrid grid = cube(dimension, dimension == 2 ? 40 : 12);
        std::vector<uint8_t> flags(grid.size());
        const uint32_t source = 5;
        for (uint32_t i = 0; i < grid.size(); ++i) {
            if (random_unit(3, i, 0) < 0.2 && i != source) flags[i] = SweepDistance::unused;
            if (random_unit(4, i, 0) < 0.1) flags[i] |= SweepDistance::closed(i % dimension);
        }
        const auto values = solved(grid, flags, {{source, 0}});
        uint32_t reached = 0;
        for (uint32_t i = 0; i < grid.size(); ++i) {
            if ((flags[i] & SweepDistance::unused) != 0) {
                EXPECT_EQ(values[i], std::numeric_limits<double>::infinity());
                continue;
            }
            if (i == source || std::isinf(values[i])) continue;
            ++reached;
            double sum = 0;
            const auto cell = grid.cell(i);
            for (uint32_t k = 0; k < dimension; ++k) {
                double least = std::numeric_limits<double>::infinity();
                const uint32_t stride = grid.stride(k);
                if (cell[k] > 0 && !(flags[i - stride] & SweepDistance::closed(k))) least = values[i - stride];
                if (cell[k] + 1 < grid.counts[k] && !(flags[i] & SweepDistance::closed(k))) {
                    least = std::min(least, values[i + stride]);
                }
                sum += std::pow(std::max(values[i] - least, 0.0), 2);
            }
            EXPECT_NEAR(sum, grid.spacing * grid.spacing, 1e-7 * grid.spacing);
        }
        EXPECT_GT(reached, grid.size() / 2);
    }
}

// A wall between two columns of nodes, with a door.
TEST(SweepDistance, ClosedEdgesPartTheSides) {
    const SweepGrid grid = cube(2, 40);
    std::vector<uint8_t> flags(grid.size());
    for (uint32_t y = 0; y <= 40; ++y) flags[grid.node({20, y, 0})] = SweepDistance::closed(0);
    const uint32_t source = grid.node({10, 20, 0}), other = grid.node({30, 20, 0});
    EXPECT_TRUE(std::isinf(solved(grid, flags, {{source, 0}})[other]));
    flags[grid.node({20, 40, 0})] = 0;
    EXPECT_NEAR(solved(grid, flags, {{source, 0}})[other], 2 * std::hypot(1, 2), 0.35);
}

TEST(SweepDistance, ChunksDoNotMatter) {
    const SweepGrid grid = cube(3, 10);
    const std::vector<uint8_t> flags(grid.size());
    EXPECT_EQ(solved(grid, flags, {{7, 0}, {99, 0.5}}, true), solved(grid, flags, {{7, 0}, {99, 0.5}}));
}

// Ways that are too long for the goal may be left out, some cells spared: there it is the same.
TEST(SweepDistance, AGoalLeavesItsOwnDistanceAsItIs) {
    SweepGrid grid;
    grid.counts = {60, 50, 1};
    grid.spacing = 0.1;
    std::vector<uint8_t> flags(grid.size(), 0);
    for (uint32_t y = 0; y < 35; ++y) flags[grid.node({30, y, 0})] = SweepDistance::unused;
    const SweepDistance::Seed seeds[] = {{grid.node({5, 10, 0}), 0.0}};
    const uint32_t goal = grid.node({55, 12, 0});
    SweepDistance whole(grid, flags.data(), heap()), part(grid, flags.data(), heap());
    const uint64_t passed = run_now(
        heap(), [&](Pace& pace) { return SweepDistance::solve(pace, whole, grid.whole(), seeds); }, false);
    const SweepGoal wanted{grid.place(goal), whole[goal] + 6 * grid.spacing};
    const uint64_t fewer = run_now(
        heap(), [&](Pace& pace) { return SweepDistance::solve(pace, part, grid.whole(), seeds, wanted); }, false);
    EXPECT_NEAR(part[goal], whole[goal], 1e-3 * grid.spacing);
    EXPECT_LE(fewer, passed);
    EXPECT_EQ(part[grid.node({0, 49, 0})], std::numeric_limits<double>::infinity());
    EXPECT_LT(whole[grid.node({0, 49, 0})], 10);
}

}  // namespace
}  // namespace flg::test
