// SPDX-License-Identifier: MIT
// On which side curves on surfaces pass obstacles.
#include "api/spline_inputs.h"

namespace flg::test {
namespace {

FlgObstacle ball_at(double x, double y, double z, double radius) {
    FlgObstacle solid = flgObstacleDefaults();
    solid.centre[0] = x;
    solid.centre[1] = y;
    solid.centre[2] = z;
    solid.radius = radius;
    return solid;
}

FlgObstacleSide side_of(uint32_t obstacle, double x, double y, double z) {
    return {obstacle, 0, {x, y, z}};
}

// The node nearest to a place.
Point nearest_node(const MadeSpline& made, const Point& to) {
    Point out{};
    double least = 1e9;
    for (uint32_t i = 0; i < made.view.node_count; ++i) {
        const Point x = made.node(i);
        const double away = std::hypot(x[0] - to[0], x[1] - to[1], x[2] - to[2]);
        if (away < least) least = away, out = x;
    }
    return out;
}

double nearest_to(const MadeSpline& made, const FlgObstacle& ball) {
    const Point x = nearest_node(made, {ball.centre[0], ball.centre[1], ball.centre[2]});
    return std::hypot(x[0] - ball.centre[0], x[1] - ball.centre[1], x[2] - ball.centre[2]) - ball.radius;
}

// Along the equator, a little north of it: the shorter way past a ball there is north, the other one on request.
TEST(ObstacleSides, OnASphereTheyHold) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE);
    const std::vector<double> points = {std::cos(0.9), -std::sin(0.9), 0.05, std::cos(0.9), std::sin(0.9), 0.05};
    const FlgObstacle ball = ball_at(1, 0, 0, 0.3);
    for (const double side : {0.0, 1.0, -1.0}) {
        const FlgObstacleSide sides[] = {side_of(0, 0.5, 0, side)};
        FlgSplineDesc desc = spline_desc(sphere, points);
        desc.obstacles = make_obstacles(host, {ball});
        desc.sides = sides;
        desc.side_count = side == 0 ? 0 : 1;
        const MadeSpline made = make_spline(host, desc);
        ASSERT_EQ(made.result, FLG_OK) << made.error;
        EXPECT_GT(nearest_to(made, ball), -1e-6);
        const Point beside = nearest_node(made, {1, 0, 0});
        EXPECT_GT(beside[2] * (side == 0 ? 1 : side), 0.25) << side;
        EXPECT_LT(made.view.length, 3) << side;
    }
}

// Four balls in a row of the plane, as a surface: a slalom, either way round.
TEST(ObstacleSides, OnAPlaneTheyMakeASlalom) {
    const Host host;
    const FlgManifold plane = shape_manifold(host, FLG_MANIFOLD_SHAPE_PLANE, 1);
    const std::vector<double> points = {-1, 0, 0, 1, 0, 0};
    std::vector<FlgObstacle> balls;
    for (int i = 0; i < 4; ++i) balls.push_back(ball_at(0.4 * i - 0.6, 0, 0, 0.08));
    for (const double first : {1.0, -1.0}) {
        std::vector<FlgObstacleSide> sides;
        for (uint32_t i = 0; i < 4; ++i) sides.push_back(side_of(i, 0, i % 2 == 0 ? first : -first, 0));
        FlgSplineDesc desc = spline_desc(plane, points);
        desc.obstacles = make_obstacles(host, balls);
        desc.sides = sides.data();
        desc.side_count = 4;
        const MadeSpline made = make_spline(host, desc);
        ASSERT_EQ(made.result, FLG_OK) << made.error;
        for (uint32_t i = 0; i < 4; ++i) {
            EXPECT_GT(nearest_to(made, balls[i]), -1e-6);
            const Point beside = nearest_node(made, {balls[i].centre[0], 0, 0});
            EXPECT_GT(beside[1] * (i % 2 == 0 ? first : -first), 0.07) << i;
        }
    }
}

// Around a torus's tube the way back to the obstacle is short: the wall goes half of it.
TEST(ObstacleSides, OnAMeshTheyHold) {
    const Host host;
    const FlgManifold torus = mesh_manifold(host, torus_mesh(96, 48, 1, 0.4));
    const std::vector<double> points = {1.4 * std::cos(0.7), -1.4 * std::sin(0.7), 0.02,
                                        1.4 * std::cos(0.7), 1.4 * std::sin(0.7),  0.02};
    const FlgObstacle ball = ball_at(1.4, 0, 0, 0.2);
    for (const double side : {1.0, -1.0}) {
        const FlgObstacleSide sides[] = {side_of(0, 0, 0, side)};
        FlgSplineDesc desc = spline_desc(torus, points);
        desc.obstacles = make_obstacles(host, {ball});
        desc.sides = sides;
        desc.side_count = 1;
        const MadeSpline made = make_spline(host, desc);
        ASSERT_EQ(made.result, FLG_OK) << made.error;
        EXPECT_GT(nearest_to(made, ball), -1e-6);
        EXPECT_GT(nearest_node(made, {1.4, 0, 0})[2] * side, 0.15);
    }
}

TEST(ObstacleSides, BadOnesOnSurfacesAreNamed) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE);
    const std::vector<double> points = {0.6, -0.8, 0, 0.6, 0.8, 0};
    FlgObstacle ground = flgObstacleDefaults();
    ground.kind = FLG_OBSTACLE_KIND_HALF_SPACE;
    ground.centre[2] = -0.9;
    ground.to[2] = 1;
    const FlgObstacles obstacles = make_obstacles(host, {ball_at(1, 0, 0, 0.3), ball_at(0, 0, 3, 0.3), ground});
    const auto refuse = [&](const FlgObstacleSide& side, const char* words) {
        FlgSplineDesc desc = spline_desc(sphere, points);
        desc.obstacles = obstacles;
        desc.sides = &side;
        desc.side_count = 1;
        const MadeSpline made = make_spline(host, desc);
        EXPECT_EQ(made.result, FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(made.error.find(words), std::string::npos) << made.error;
    };
    refuse(side_of(3, 0, 0, 1), "sides[0] is of obstacle 3, which there is not");
    refuse(side_of(2, 0, 0, 1), "sides[0] is of obstacle 2, which has no other side");
    refuse(side_of(0, 0, 0, 0), "sides[0] has a direction without length");
    refuse(side_of(1, 1, 0, 0), "sides[0] is of obstacle 1, which does not cut the surface");
    refuse(side_of(0, 1, 0, 0), "sides[0] has a direction across the surface at obstacle 0");
}

}  // namespace
}  // namespace flg::test
