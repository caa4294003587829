// SPDX-License-Identifier: MIT
#include "splines/obstacles/obstacle_path.h"

#include <memory>
#include <numbers>

#include "core/failure.h"
#include "splines/obstacle_checks.h"
#include "splines/obstacles/obstacle_polygon.h"
#include "splines/obstacles/obstacle_shapes.h"

namespace flg::test {
namespace {

using Sides = std::vector<ObstacleSide>;

ObstaclePath path_of(const ObstacleSet& set, const std::vector<double>& points, const Sides& sides = {},
                     bool closed = false, bool haltingly = false) {
    return run_now(
        heap(), [&](Pace& pace) { return obstacle_path(pace, set, points, closed, sides); }, haltingly);
}

std::string failure_of(const ObstacleSet& set, const std::vector<double>& points, const Sides& sides = {}) {
    try {
        path_of(set, points, sides);
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "";
}

double length_of(const ObstaclePath& path, uint32_t d) {
    double length = 0;
    for (size_t i = d; i < path.points.size(); i += d) {
        double square = 0;
        for (size_t k = 0; k < d; ++k) square += std::pow(path.points[i + k] - path.points[i - d + k], 2);
        length += std::sqrt(square);
    }
    return length;
}

// By 500 samples of each edge: nowhere inside, and the given points are on it.
void expect_clear(const ObstacleSet& set, const ObstaclePath& path, const std::vector<double>& points) {
    const uint32_t d = set.dimension();
    for (size_t i = d; i < path.points.size(); i += d) {
        for (int s = 0; s <= 500; ++s) {
            double x[3] = {};
            for (size_t k = 0; k < d; ++k) {
                x[k] = path.points[i - d + k] + s / 500.0 * (path.points[i + k] - path.points[i - d + k]);
            }
            ASSERT_GT(set.distance(x), -1e-9);
        }
    }
    for (size_t p = 0; p < path.given.size(); ++p) {
        for (size_t k = 0; k < d; ++k) {
            EXPECT_EQ(path.points[path.given[p] * d + k], points[p * d % points.size() + k]);
        }
    }
    EXPECT_EQ(path.given.back() + 1, path.points.size() / d);
}

// The angle that the path turns by around a place of the plane.
double winding(const ObstaclePath& path, double x, double y) {
    double sum = 0;
    for (size_t i = 2; i < path.points.size(); i += 2) {
        const double ax = path.points[i - 2] - x, ay = path.points[i - 1] - y;
        const double bx = path.points[i] - x, by = path.points[i + 1] - y;
        sum += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
    return sum;
}

struct Disc {
    BallObstacle disc{2, std::array{0.0, 0.0}.data(), 1};
    const Obstacle* all[1] = {&disc};
    ObstacleSet set{all, 0, heap()};
};

TEST(ObstaclePath, IsStraightWhereNothingIsInTheWay) {
    const Disc scene;
    const std::vector<double> points = {-2, -2, 2, -2, 2, 2};
    const ObstaclePath path = path_of(scene.set, points);
    EXPECT_EQ(path.points, (std::pmr::vector<double>{-2, -2, 2, -2, 2, 2}));
    EXPECT_EQ(path.given, (std::pmr::vector<uint32_t>{0, 1, 2}));
}

TEST(ObstaclePath, AroundADiscIsTangentsAndAnArc) {
    const Disc scene;
    for (const double off : {0.1, 0.5}) {
        const std::vector<double> points = {-2, off, 2, off};
        const ObstaclePath path = path_of(scene.set, points);
        expect_clear(scene.set, path, points);
        EXPECT_LT(winding(path, 0, 0), 0);  // above
        const double r = std::hypot(2, off), between = std::numbers::pi - 2 * std::asin(off / r);
        const double shortest = 2 * std::sqrt(r * r - 1) + between - 2 * std::acos(1 / r);
        EXPECT_GT(length_of(path, 2), shortest - 1e-9);
        EXPECT_LT(length_of(path, 2), 1.03 * shortest);
    }
}

TEST(ObstaclePath, PassesOnTheSideThatIsAskedFor) {
    const Disc scene;
    const std::vector<double> points = {-2, 0.3, 2, 0.3};
    const ObstaclePath above = path_of(scene.set, points, {{0, {0, 1, 0}}});
    const ObstaclePath below = path_of(scene.set, points, {{0, {0, -2, 0}}});
    const ObstaclePath slanted = path_of(scene.set, points, {{0, {0.3, -1, 0}}});
    for (const ObstaclePath* path : {&above, &below, &slanted}) expect_clear(scene.set, *path, points);
    const double half = std::numbers::pi - 2 * std::atan(0.15);
    EXPECT_NEAR(winding(above, 0, 0), -half, 1e-9);
    EXPECT_NEAR(winding(below, 0, 0), 2 * std::numbers::pi - half, 1e-9);
    EXPECT_NEAR(winding(slanted, 0, 0), 2 * std::numbers::pi - half, 1e-9);
}

// Thin bars, over and under by turns; the direction of the way does not count.
TEST(ObstaclePath, Slalom) {
    std::vector<std::unique_ptr<Obstacle>> bars;
    std::vector<const Obstacle*> all;
    Sides sides;
    for (uint32_t i = 0; i < 4; ++i) {
        const double centre[2] = {double(i), 0}, half[2] = {1e-3, 0.5};
        bars.push_back(std::make_unique<BoxObstacle>(2, centre, half, nullptr));
        all.push_back(bars.back().get());
        sides.push_back({i, {0, i % 2 == 0 ? 1.0 : -1.0, 0}});
    }
    const ObstacleSet set(all, 0, heap());
    const std::vector<double> there = {-1, 0, 4, 0}, back = {4, 0, -1, 0};
    const ObstaclePath path = path_of(set, there, sides), returned = path_of(set, back, sides);
    expect_clear(set, path, there);
    expect_clear(set, returned, back);
    for (int i = 0; i < 4; ++i) {
        const double sign = i % 2 == 0 ? -1 : 1;
        EXPECT_NEAR(winding(path, i, 0), sign * std::numbers::pi, 1e-9);
        EXPECT_NEAR(winding(returned, i, 0), -sign * std::numbers::pi, 1e-9);
    }
    EXPECT_LT(length_of(path, 2), 7.05);  // the bars a cell longer
    EXPECT_GT(length_of(path, 2), 2 * std::hypot(1, 0.5) + 3 * std::hypot(1, 1) - 1e-2);
}

// Through a channel that is 0.02 wide; with a clearance of 0.02 around.
TEST(ObstaclePath, GoesThroughAChannelThatIsWideEnough) {
    const double upper[2] = {0, 1.01}, lower[2] = {0, -1.01}, half[2] = {0.5, 1};
    const BoxObstacle a(2, upper, half, nullptr), b(2, lower, half, nullptr);
    const Obstacle* all[] = {&a, &b};
    const std::vector<double> points = {-1, 0.5, 1, -0.5};
    const ObstacleSet set(all, 0, heap()), wide(all, 0.02, heap());
    const ObstaclePath through = path_of(set, points), around = path_of(wide, points);
    expect_clear(set, through, points);
    expect_clear(wide, around, points);
    EXPECT_LT(length_of(through, 2), 2.5);
    EXPECT_GT(length_of(around, 2), 4);
}

TEST(ObstaclePath, ClosedOnesComeBack) {
    const Disc scene;
    const std::vector<double> points = {2, 0, -1, 1.8, -1, -1.8};
    const ObstaclePath path = path_of(scene.set, points, {}, true);
    expect_clear(scene.set, path, points);
    ASSERT_EQ(path.given.size(), 4u);
    EXPECT_NEAR(winding(path, 0, 0), 2 * std::numbers::pi, 1e-9);
}

TEST(ObstaclePath, StartsAtBoundaries) {
    const Disc scene;
    const std::vector<double> points = {-1, 0, 0.6, 0.8};
    const ObstaclePath path = path_of(scene.set, points);
    expect_clear(scene.set, path, points);
    EXPECT_LT(length_of(path, 2), 1.08 * (std::numbers::pi - std::atan2(0.8, 0.6)));
}

TEST(ObstaclePath, AroundABallInSpace) {
    const BallObstacle ball(3, std::array{0.0, 0.0, 0.0}.data(), 1);
    const Obstacle* all[] = {&ball};
    const ObstacleSet set(all, 0, heap());
    const std::vector<double> points = {-2, 0.1, 0, 2, 0.1, 0};
    const ObstaclePath path = path_of(set, points);
    expect_clear(set, path, points);
    const double shortest = 2 * std::sqrt(3.01) + std::numbers::pi - 2 * std::asin(0.1 / std::sqrt(4.01)) -
                            2 * std::acos(1 / std::sqrt(4.01));
    EXPECT_GT(length_of(path, 3), shortest - 1e-9);
    EXPECT_LT(length_of(path, 3), 1.06 * shortest);
    // Over it, as asked for: its top is passed, and below nothing.
    const ObstaclePath over = path_of(set, points, {{0, {0, 0, 1}}});
    expect_clear(set, over, points);
    for (size_t i = 0; i < over.points.size(); i += 3) {
        EXPECT_FALSE(over.points[i + 2] < -0.1 && std::hypot(over.points[i], over.points[i + 1]) < 0.9);
    }
}

TEST(ObstaclePath, ChunksDoNotMatter) {
    const double centre[2] = {1.5, 1}, half[2] = {0.3, 0.8};
    const BallObstacle disc(2, std::array{0.0, 0.0}.data(), 1);
    const BoxObstacle box(2, centre, half, nullptr);
    const Obstacle* all[] = {&disc, &box};
    const ObstacleSet set(all, 0.1, heap());
    const std::vector<double> points = {-2, 0, 2, 0.3, 0, 1.5};
    const Sides sides = {{1, {0, 1, 0}}};
    EXPECT_EQ(path_of(set, points, sides, false, true).points, path_of(set, points, sides).points);
}

TEST(ObstaclePath, PointsInsideAreRefused) {
    const Disc scene;
    EXPECT_EQ(failure_of(scene.set, {-2, 0, 0.25, 0}),
              "point 1 is 0.75 inside of obstacle 0, or nearer than the clearance");
    const ObstacleSet wide(scene.all, 0.5, heap());
    EXPECT_EQ(failure_of(wide, {1.25, 0, 3, 0}), "point 0 is 0.25 inside of obstacle 0, or nearer than the clearance");
    EXPECT_NE(failure_of(scene.set, {-2, std::nan(""), 2, 0}), "");
    EXPECT_NE(failure_of(scene.set, {-2, 0}), "");
}

TEST(ObstaclePath, NoWayIsRefused) {
    std::vector<std::unique_ptr<Obstacle>> bars;
    std::vector<const Obstacle*> all;
    for (const auto& [x, y] : {std::pair{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
        const double centre[2] = {x, y}, half[2] = {x == 0 ? 1.1 : 1e-4, y == 0 ? 1.1 : 1e-4};
        bars.push_back(std::make_unique<BoxObstacle>(2, centre, half, nullptr));
        all.push_back(bars.back().get());
    }
    const ObstacleSet set(all, 0, heap());
    EXPECT_EQ(failure_of(set, {0, 0, 0.5, 0.5, 2, 0}).substr(0, 56),
              "no way leads from point 1 to point 2 around the obstacle");
    EXPECT_EQ(failure_of(set, {0, 0, 0.5, 0.5}), "");
}

// In space there are more than two sides: a way passes on the one that is asked for, not beside it where that is
// shorter, up to a cell of the grid.
TEST(ObstaclePath, InSpaceItPassesOnTheSideThatIsAskedFor) {
    const double centre[3] = {0, 0, 0}, cube[3] = {1, 1, 1}, slab[3] = {1, 4, 0.2}, post[3] = {0.2, 0.2, 3};
    const std::vector<double> points = {-3, 0, 0, 3, 0, 0.2};
    for (const double* half : {cube, slab, post}) {
        const BoxObstacle box(3, centre, half, nullptr);
        const Obstacle* const all[] = {&box};
        const ObstacleSet set(all, 0, heap());
        for (uint32_t k : {1u, 2u}) {
            for (const double way : {1.0, -1.0}) {
                Sides sides = {{0, {}}};
                sides[0].direction[k] = way;
                const ObstaclePath path = path_of(set, points, sides);
                // Where it passes the middle.
                double passed = 0;
                for (size_t i = 0; i + 5 < path.points.size(); i += 3) {
                    const double *const a = &path.points[i], *const b = a + 3;
                    if (a[0] <= 0 && b[0] > 0) passed = a[k] + a[0] / (a[0] - b[0]) * (b[k] - a[k]);
                }
                EXPECT_GT(way * passed, half[k] - path.spacing) << k << " " << way << " " << half[k];
            }
        }
    }
}

TEST(ObstaclePath, SidesThatCannotBeAreRefused) {
    const Disc scene;
    EXPECT_EQ(failure_of(scene.set, {-2, 0, 0, -1.5}, {{0, {0, 1, 0}}}),
              "point 1 is behind obstacle 0, seen from the side that sides[0] says the path passes");
    EXPECT_NE(failure_of(scene.set, {-2, 0, 2, 0}, {{1, {0, 1, 0}}}), "");
    EXPECT_NE(failure_of(scene.set, {-2, 0, 2, 0}, {{0, {0, 0, 0}}}), "");
    EXPECT_NE(failure_of(scene.set, {-2, 0, 2, 0}, {{0, {0, 1, 0}}, {0, {0, -1, 0}}}), "");
}

}  // namespace
}  // namespace flg::test
