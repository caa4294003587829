// SPDX-License-Identifier: MIT
#include "splines/obstacles/clearance.h"

#include <numbers>

#include "splines/obstacle_checks.h"
#include "splines/obstacles/obstacle_shapes.h"

namespace flg::test {
namespace {

// Chains of 24 random nodes, with random second derivatives at them.
struct RandomChain {
    explicit RandomChain(uint64_t item) {
        for (uint64_t i = 0; i < count; ++i) {
            const Numbers x = random_numbers(100 * item + i, 2), m = random_numbers(5000 + 100 * item + i, 3);
            nodes.insert(nodes.end(), x.begin(), x.begin() + 3);
            moments.insert(moments.end(), m.begin(), m.begin() + 3);
        }
    }
    // The cubic piece after node i, t of the way.
    std::array<double, 3> place(uint32_t i, double t) const {
        std::array<double, 3> x{};
        const double s = 1 - t, h = steps[i];
        const size_t a = size_t{3} * i, b = size_t{3} * ((i + 1) % count);
        for (size_t c = 0; c < 3; ++c) {
            x[c] = s * nodes[a + c] + t * nodes[b + c] +
                   h * h / 6 * ((s * s * s - s) * moments[a + c] + (t * t * t - t) * moments[b + c]);
        }
        return x;
    }

    static constexpr uint32_t count = 24;
    std::vector<double> nodes, moments, steps = std::vector<double>(count, 0.4);
};

// Both ways: what passes has no place that is too near, and what is farther away than the bound takes passes.
TEST(Clearance, PiecesThatPassAreClearEverywhere) {
    const double centre[3] = {0.3, 0.1, -0.2}, half[3] = {0.5, 0.3, 0.4}, corner[3] = {-1, -0.6, 0.4};
    const BallObstacle ball(3, corner, 0.5);
    const BoxObstacle box(3, centre, half, nullptr);
    const Obstacle* const both[] = {&ball, &box};
    const ObstacleSet set(both, 0.05, heap());
    uint32_t passed = 0, refused = 0;
    for (uint64_t item = 0; item < 20; ++item) {
        for (const bool closed : {false, true}) {
            const RandomChain chain(item);
            const uint32_t intervals = closed ? chain.count : chain.count - 1;
            const std::vector<double> allowed(intervals, 1e-6), spare(intervals, 1e-3);
            std::pmr::vector<Trespass> found;
            run_now(heap(), [&](Pace& pace) {
                return find_trespasses(pace, set, {chain.nodes, chain.steps, chain.moments, allowed, spare, closed},
                                       found);
            });
            size_t next = 0;
            for (uint32_t i = 0; i < intervals; ++i) {
                const bool trespasses = next < found.size() && found[next].interval == i;
                double nearest = 1e9, bound = 0, least_left = 1e9;
                for (const uint32_t node : {i, (i + 1) % chain.count}) {
                    const double* const m = &chain.moments[size_t{3} * node];
                    bound = std::max(bound, 0.5 * 0.16 * std::hypot(m[0], m[1], m[2]));
                }
                for (int look = 0; look <= 1000; ++look) {
                    const double t = look / 1000.0;
                    std::array<double, 3> chord{};
                    for (size_t c = 0; c < 3; ++c)
                        chord[c] = (1 - t) * chain.nodes[size_t{3} * i + c] +
                                   t * chain.nodes[size_t{3} * ((i + 1) % chain.count) + c];
                    nearest = std::min(nearest, set.distance(chain.place(i, t).data()));
                    least_left = std::min(least_left, set.distance(chord.data()) - t * (1 - t) * bound);
                }
                if (trespasses) {
                    EXPECT_LT(least_left, 1e-3 + 5e-3) << "chain " << item << ", interval " << i;
                    EXPECT_GT(found[next].depth, 0);
                    ++next;
                    ++refused;
                } else {
                    EXPECT_GT(nearest, -1e-6) << "chain " << item << ", interval " << i;
                    ++passed;
                }
            }
            EXPECT_EQ(next, found.size());
        }
    }
    EXPECT_GT(passed, 200u);
    EXPECT_GT(refused, 200u);
}

// Nodes on a circle around a ball: chords leave it by their sagitta.
TEST(Clearance, ChordsOfACircleFallShortByTheirSagitta) {
    constexpr uint32_t count = 32;
    const double origin[2] = {0, 0};
    const BallObstacle ball(2, origin, 1);
    const Obstacle* const one = &ball;
    const ObstacleSet set({&one, 1}, 0, heap());
    std::vector<double> nodes;
    for (uint32_t i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        nodes.insert(nodes.end(), {std::cos(angle), std::sin(angle)});
    }
    const double sagitta = 1 - std::cos(std::numbers::pi / count);
    const std::vector<double> steps(count, 0.1), spare(count, 1e-4);
    for (const double share : {0.9, 1.1}) {
        const std::vector<double> allowed(count, share * sagitta + 1e-4);
        std::pmr::vector<Trespass> found;
        run_now(heap(), [&](Pace& pace) {
            return find_trespasses(pace, set, {nodes, steps, {}, allowed, spare, true}, found);
        });
        EXPECT_EQ(found.size(), share < 1 ? count : 0u);
        for (const Trespass& trespass : found) EXPECT_NEAR(trespass.depth, 0.1 * sagitta, 1e-4);
    }
}

}  // namespace
}  // namespace flg::test
