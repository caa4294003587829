// SPDX-License-Identifier: MIT
// What splines, manifolds and obstacles refuse, and how they behave on surfaces that are not whole.
#include <functional>

#include "api/spline_inputs.h"

namespace flg::test {
namespace {

const std::vector<double> three = {1, 0, 0, 0, 1, 0, 0, 0, 1};

TEST(SplineRefusals, BadDescriptorsAreNamed) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE);
    const auto refuse = [&](const std::function<void(FlgSplineDesc&)>& spoil, const char* words) {
        FlgSplineDesc desc = spline_desc(sphere, three);
        spoil(desc);
        FlgSpline spline{};
        expect_failure(flgSplineCreate(host.context, &desc, &spline, nullptr), FLG_ERROR_INVALID_ARGUMENT, words);
        EXPECT_EQ(spline.id, 0u);
    };
    const double nan[9] = {1, 0, 0, 0, NAN, 0, 0, 0, 1}, falling[3] = {0, 2, 1};
    const uint32_t knots[3] = {0, 2, 1}, late[3] = {1, 2, 3};
    refuse([](FlgSplineDesc& d) { d.point_count = 1; }, "desc.point_count is 1");
    refuse([](FlgSplineDesc& d) { d.point_count = 2, d.closed = 1; }, "3 to 65536");
    refuse([](FlgSplineDesc& d) { d.point_count = 70000; }, "desc.point_count is 70000");
    refuse([](FlgSplineDesc& d) { d.points = nullptr; }, "desc.points is null");
    refuse([&](FlgSplineDesc& d) { d.points = nan; }, "desc.points[4] is nan");
    refuse([&](FlgSplineDesc& d) { d.parameters = falling; }, "desc.parameters[2] is 1");
    refuse([](FlgSplineDesc& d) { d.energy = static_cast<FlgSplineEnergy>(7); }, "desc.energy is 7");
    refuse([](FlgSplineDesc& d) { d.energy = FLG_SPLINE_ENERGY_ET, d.tension = 0; }, "desc.tension is 0");
    refuse([](FlgSplineDesc& d) { d.smoothing = -1; }, "desc.smoothing is -1");
    refuse([](FlgSplineDesc& d) { d.first_tension = INFINITY; }, "desc.first_tension is inf");
    refuse([](FlgSplineDesc& d) { d.start = static_cast<FlgSplineStart>(9); }, "desc.start is 9");
    refuse([](FlgSplineDesc& d) { d.node_count = 2000000; }, "desc.node_count is 2000000");
    refuse([](FlgSplineDesc& d) { d.max_rounds = 0; }, "desc.max_rounds is 0");
    refuse([](FlgSplineDesc& d) { d.tolerance = 0; }, "desc.tolerance is 0");
    refuse([](FlgSplineDesc& d) { d.subdivisions = 9; }, "desc.subdivisions is 9");
    refuse([](FlgSplineDesc& d) { d.node_count = 1 << 19, d.subdivisions = 8; }, "more than 2^20 nodes");
    refuse([](FlgSplineDesc& d) { d.curve = three.data(), d.curve_count = 3; }, "desc.curve_knots is null");
    refuse([&](FlgSplineDesc& d) { d.curve = three.data(), d.curve_count = 3, d.curve_knots = knots; },
           "desc.curve_knots[2] is 1");
    refuse([&](FlgSplineDesc& d) { d.curve = three.data(), d.curve_count = 3, d.curve_knots = late; },
           "desc.curve_knots[0] is 1");
    FlgSplineDesc desc = spline_desc({}, three);
    FlgSpline spline{};
    expect_failure(flgSplineCreate(host.context, &desc, &spline, nullptr), FLG_ERROR_INVALID_HANDLE, "desc.manifold");
}

TEST(SplineRefusals, CoincidentPointsAreNamed) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE);
    // Two that only come to one place when they are projected.
    const std::vector<double> points = {1, 0, 0, 0, 1, 0, 0, 2, 0};
    const MadeSpline made = make_spline(host, spline_desc(sphere, points));
    EXPECT_EQ(made.result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(made.error.find("points 1 and 2 come to one place"), std::string::npos) << made.error;
    const std::vector<double> back = {1, 0, 0, 0, 1, 0, 1, 0, 0};
    FlgSplineDesc closed = spline_desc(sphere, back);
    closed.closed = 1;
    EXPECT_EQ(make_spline(host, closed).result, FLG_ERROR_INVALID_ARGUMENT);
    // Not in a row they are a crossing.
    EXPECT_EQ(make_spline(host, spline_desc(sphere, back)).result, FLG_OK);
}

TEST(SplineRefusals, APointThatHasNoNearestOneIsNamed) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE);
    const std::vector<double> points = {1, 0, 0, 0, 0, 0};
    const MadeSpline made = make_spline(host, spline_desc(sphere, points));
    EXPECT_EQ(made.result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(made.error.find("point 1 can't be projected"), std::string::npos) << made.error;
}

TEST(SplineRefusals, PartsOfAMeshThatDoNotHangTogetherAreNotJoined) {
    const Host host;
    MeshArrays two = torus_mesh(40, 20, 2, 0.5);
    const uint32_t first = two.vertex_count();
    const MeshArrays other = torus_mesh(40, 20, 2, 0.5);
    for (uint32_t v = 0; v < other.vertex_count(); ++v) {
        const Point p = other.vertex(v);
        two.add_vertex(p[0] + 12, p[1], p[2]);
    }
    for (uint32_t t = 0; t < other.triangle_count(); ++t) {
        const uint32_t* const c = &other.triangles[3 * t];
        two.add_triangle(c[0] + first, c[1] + first, c[2] + first);
    }
    const FlgManifold mesh = mesh_manifold(host, two);
    const std::vector<double> points = {2.5, 0, 0, 9.5, 0, 0};
    const MadeSpline made = make_spline(host, spline_desc(mesh, points));
    EXPECT_EQ(made.result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(made.error.find("no way leads over the surface from point 0 to point 1"), std::string::npos)
        << made.error;
    const std::vector<double> one_part = {2.5, 0, 0, 0, 2.5, 0, -2.5, 0, 0};
    EXPECT_EQ(make_spline(host, spline_desc(mesh, one_part)).result, FLG_OK);
}

// Gaps too narrow to be seen by how long the chain's pieces are.
TEST(SplineRefusals, SheetsSideBySideAreNotJoined) {
    for (const double gap : {0.05, 0.3, 2.0}) {
        const Host host;
        MeshArrays sheets;
        for (const double x : {0.0, 1 + gap}) {
            const uint32_t first = sheets.vertex_count();
            for (uint32_t j = 0; j <= 10; ++j) {
                for (uint32_t i = 0; i <= 10; ++i) sheets.add_vertex(x + 0.1 * i, 0.1 * j, 0);
            }
            for (uint32_t j = 0; j < 10; ++j) {
                for (uint32_t i = 0; i < 10; ++i) {
                    const uint32_t a = first + 11 * j + i;
                    sheets.add_triangle(a, a + 1, a + 12);
                    sheets.add_triangle(a, a + 12, a + 11);
                }
            }
        }
        const FlgManifold mesh = mesh_manifold(host, sheets);
        const std::vector<double> points = {0.2, 0.5, 0, 1.8 + gap, 0.4, 0};
        const MadeSpline made = make_spline(host, spline_desc(mesh, points));
        EXPECT_EQ(made.result, FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(made.error.find("no way leads over the surface from point 0 to point 1"), std::string::npos)
            << made.error;
    }
}

// A square with a square hole, and points around it: curves stay off the hole where they are told to stay by the mesh.
TEST(SplineRefusals, ByItsBordersOrInALayerCurvesStayOnAMeshWithAHole) {
    const Host host;
    MeshArrays mesh;
    const uint32_t cells = 40;
    for (uint32_t j = 0; j <= cells; ++j) {
        for (uint32_t i = 0; i <= cells; ++i) mesh.add_vertex(double(i) / cells, double(j) / cells, 0);
    }
    for (uint32_t j = 0; j < cells; ++j) {
        for (uint32_t i = 0; i < cells; ++i) {
            const bool in_hole = i >= 14 && i < 26 && j >= 14 && j < 26;
            const uint32_t a = j * (cells + 1) + i;
            if (in_hole) continue;
            mesh.add_triangle(a, a + 1, a + cells + 2);
            mesh.add_triangle(a, a + cells + 2, a + cells + 1);
        }
    }
    const FlgSurface surface = mesh_surface(host, mesh);
    const FlgManifold manifold = mesh_manifold(host, surface);
    for (const FlgObstacleKind kind : {FLG_OBSTACLE_KIND_LAYER, FLG_OBSTACLE_KIND_BORDER}) {
        FlgObstacle layer = flgObstacleDefaults();
        layer.kind = kind;
        layer.surface = surface;
        layer.radius = 0.05;
        layer.cells = 128;
        const FlgObstacles obstacles = make_obstacles(host, {layer});
        const std::vector<double> points = {0.2, 0.55, 0, 0.5, 0.8, 0, 0.8, 0.55, 0};
        FlgSplineDesc spline = spline_desc(manifold, points);
        spline.closed = 1;
        spline.obstacles = obstacles;
        const MadeSpline made = make_spline(host, spline);
        ASSERT_EQ(made.result, FLG_OK) << made.error;
        double deepest = 0;
        for (uint32_t i = 0; i < made.view.node_count; ++i) {
            const Point p = made.node(i);
            deepest = std::max(deepest, std::min({p[0] - 0.35, 0.65 - p[0], p[1] - 0.35, 0.65 - p[1]}));
            EXPECT_NEAR(p[2], 0, 1e-6);
        }
        // The layer's thickness; nodes stay within borders.
        EXPECT_LT(deepest, kind == FLG_OBSTACLE_KIND_LAYER ? 0.051 : 1e-7);
    }
}

// A hole in stairs, and curves close around it: they come to rest, whether they are told to stay within or not.
TEST(SplineRefusals, CurvesComeToRestAtBordersInStairs) {
    const Host host;
    MeshArrays mesh;
    const uint32_t cells = 40;
    for (uint32_t j = 0; j <= cells; ++j) {
        for (uint32_t i = 0; i <= cells; ++i) mesh.add_vertex(double(i) / cells, double(j) / cells, 0);
    }
    const auto is_out = [](double x, double y) {
        return std::hypot((std::floor(x * cells) + 0.5) / cells - 0.5, (std::floor(y * cells) + 0.5) / cells - 0.5) <
               0.22;
    };
    for (uint32_t j = 0; j < cells; ++j) {
        for (uint32_t i = 0; i < cells; ++i) {
            const uint32_t a = j * (cells + 1) + i;
            if (is_out((i + 0.5) / cells, (j + 0.5) / cells)) continue;
            mesh.add_triangle(a, a + 1, a + cells + 2);
            mesh.add_triangle(a, a + cells + 2, a + cells + 1);
        }
    }
    const FlgSurface surface = mesh_surface(host, mesh);
    const FlgManifold manifold = mesh_manifold(host, surface);
    FlgObstacle border = flgObstacleDefaults();
    border.kind = FLG_OBSTACLE_KIND_BORDER;
    border.surface = surface;
    const FlgObstacles borders = make_obstacles(host, {border});
    for (const bool within : {false, true}) {
        for (uint32_t stroke = 0; stroke < 10; ++stroke) {
            std::vector<double> points;
            for (uint32_t k = 0; k < 6; ++k) {
                const double angle = 0.7 * stroke + 0.8 * k, radius = 0.26 + 0.03 * ((stroke + k) % 3);
                points.insert(points.end(), {0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), 0});
            }
            FlgSplineDesc spline = spline_desc(manifold, points);
            spline.tolerance = 1e-4;
            spline.energy = stroke % 2 == 0 ? FLG_SPLINE_ENERGY_E2 : FLG_SPLINE_ENERGY_ET;
            spline.tension = 100;
            if (within) spline.obstacles = borders;
            const MadeSpline made = make_spline(host, spline);
            ASSERT_EQ(made.result, FLG_OK) << made.error;
            EXPECT_EQ(made.view.ending, FLG_SPLINE_ENDING_CONVERGED) << stroke << " within " << within;
            EXPECT_EQ(made.view.held_count, 0u);
            for (uint32_t i = 0; within && i < made.view.node_count; ++i) {
                // A hair nearer to the corner of its cell that is farthest from the hole's middle.
                const Point p = made.node(i);
                const double away = 1e-6 / std::hypot(p[0] - 0.5, p[1] - 0.5);
                EXPECT_FALSE(is_out(p[0] + away * (p[0] - 0.5), p[1] + away * (p[1] - 0.5)))
                    << stroke << ", node " << i;
            }
        }
    }
}

TEST(SplineRefusals, BordersThatAreNotThereAreNoObstacle) {
    const Host host;
    const FlgSurface surface = mesh_surface(host, torus_mesh(20, 10, 2, 0.5));
    FlgObstacle border = flgObstacleDefaults();
    border.kind = FLG_OBSTACLE_KIND_BORDER;
    border.surface = surface;
    FlgObstaclesDesc desc = flgObstaclesDefaults();
    desc.obstacles = &border;
    desc.obstacle_count = 1;
    FlgObstacles out{};
    FlgJob job{};
    ASSERT_EQ(flgObstaclesCreate(host.context, &desc, &out, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::strstr(host.status_of(job).error, "0 border edges"), nullptr) << host.status_of(job).error;
}

FlgObstacles discs(const Host& host, const std::vector<std::array<double, 3>>& all, double clearance = 0) {
    std::vector<FlgObstacle> solids;
    for (const auto& [x, y, radius] : all) {
        solids.push_back(flgObstacleDefaults());
        solids.back().centre[0] = x;
        solids.back().centre[1] = y;
        solids.back().radius = radius;
    }
    return make_obstacles(host, solids, 2, clearance);
}

TEST(SplineObstacles, CurvesClearEveryObstacleAndTouchThem) {
    const Host host;
    const FlgManifold plane = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE, 1, 0.25, 2);
    const std::vector<std::array<double, 3>> all = {{1, 0.1, 0.4}, {2.2, -0.2, 0.5}};
    for (const double clearance : {0.0, 0.1}) {
        const std::vector<double> points = {0, 0, 3.2, 0};
        FlgSplineDesc desc = spline_desc(plane, points, 2);
        desc.obstacles = discs(host, all, clearance);
        desc.node_count = 129;
        const MadeSpline made = make_spline(host, desc);
        ASSERT_EQ(made.result, FLG_OK) << made.error;
        EXPECT_EQ(made.view.ambient, 2u);
        double least = HUGE_VAL;
        for (uint32_t i = 0; i < made.view.node_count; ++i) {
            for (const auto& [x, y, radius] : all) {
                least = std::min(least, std::hypot(made.node(i)[0] - x, made.node(i)[1] - y) - radius - clearance);
            }
        }
        // The barrier's radius is a thousandth of the scene.
        EXPECT_GT(least, -1e-9);
        EXPECT_LT(least, 0.01);
    }
}

// Much thinner than the nodes are apart: there are more of them until pieces keep out too.
TEST(SplineObstacles, ThinWallsAreNotJumpedOver) {
    const Host host;
    const FlgManifold plane = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE, 1, 0.25, 2);
    FlgObstacle wall = flgObstacleDefaults();
    wall.kind = FLG_OBSTACLE_KIND_BOX;
    wall.half[0] = 0.002;
    wall.half[1] = 0.8;
    wall.centre[1] = -0.2;
    const FlgObstacles obstacles = make_obstacles(host, {wall}, 2);
    const std::vector<double> points = {-2, 0, 2, 0};
    FlgSplineDesc desc = spline_desc(plane, points, 2);
    desc.obstacles = obstacles;
    const MadeSpline made = make_spline(host, desc);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    for (uint32_t i = 1; i < made.view.node_count; ++i) {
        const Point a = made.node(i - 1), b = made.node(i);
        if (a[0] > 0 || b[0] <= 0) continue;
        EXPECT_GT(a[1] + (b[1] - a[1]) * a[0] / (a[0] - b[0]), 0.6);
    }
    // With hardly any nodes, around one that is as thin as a hair.
    desc.node_count = 3;
    wall.half[0] = 1e-6;
    desc.obstacles = make_obstacles(host, {wall}, 2);
    const MadeSpline coarse = make_spline(host, desc);
    ASSERT_EQ(coarse.result, FLG_OK) << coarse.error;
    for (uint32_t i = 1; i < coarse.view.node_count; ++i) {
        const Point a = coarse.node(i - 1), b = coarse.node(i);
        if (a[0] > 0 || b[0] <= 0) continue;
        EXPECT_GT(a[1] + (b[1] - a[1]) * a[0] / (a[0] - b[0]), 0.6);
    }
}

// The shortest way between two points of a sphere leads through the middle of a ball on it.
TEST(SplineObstacles, OnASurfaceTheFirstCurveGoesAround) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 1);
    FlgObstacle ball = flgObstacleDefaults();
    ball.centre[0] = 1;
    ball.radius = 0.4;
    const FlgObstacles obstacles = make_obstacles(host, {ball});
    const std::vector<double> points = {std::cos(1.0), -std::sin(1.0), 0, std::cos(1.0), std::sin(1.0), 0};
    FlgSplineDesc desc = spline_desc(sphere, points);
    desc.energy = FLG_SPLINE_ENERGY_E1;
    desc.node_count = 17;
    desc.obstacles = obstacles;
    const MadeSpline made = make_spline(host, desc);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    EXPECT_NE(made.view.ending, FLG_SPLINE_ENDING_STALLED);
    // Two great arcs that touch the ball's circle, and a part of that. The circle's angle from the ball's centre:
    const double rim = 2 * std::asin(0.2), tangent = std::acos(std::cos(1.0) / std::cos(rim));
    const double turn = M_PI - 2 * std::acos(std::tan(rim) / std::tan(1.0));
    EXPECT_NEAR(made.view.length, 2 * tangent + turn * std::sin(rim), 0.01);
}

// A ring of balls around a point of the sphere leaves no way out.
TEST(SplineObstacles, NoWayOverASurfaceIsSaid) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 1);
    std::vector<FlgObstacle> ring;
    for (int i = 0; i < 12; ++i) {
        const double angle = M_PI / 6 * i;
        ring.push_back(flgObstacleDefaults());
        ring.back().centre[0] = 0.8;
        ring.back().centre[1] = 0.6 * std::cos(angle);
        ring.back().centre[2] = 0.6 * std::sin(angle);
        ring.back().radius = 0.2;
    }
    const std::vector<double> points = {1, 0, 0, 0, 1, 0};
    FlgSplineDesc desc = spline_desc(sphere, points);
    desc.obstacles = make_obstacles(host, ring);
    const MadeSpline made = make_spline(host, desc);
    EXPECT_EQ(made.result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(made.error.find("no way leads from point 0 to point 1"), std::string::npos) << made.error;

    const std::vector<double> swallowed = {1, 0, 0, 0.8, 0.6, 0};
    desc.points = swallowed.data();
    const MadeSpline inside = make_spline(host, desc);
    EXPECT_EQ(inside.result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(inside.error.find("point 1 is 0.2 inside of obstacle 0"), std::string::npos) << inside.error;
}

TEST(SplineObstacles, TheSideIsTheHosts) {
    const Host host;
    const FlgManifold plane = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE, 1, 0.25, 2);
    const std::vector<double> points = {-2, 0, 2, 0.01};
    for (const double side : {1.0, -1.0}) {
        FlgSplineDesc desc = spline_desc(plane, points, 2);
        desc.obstacles = discs(host, {{0, 0, 0.5}});
        const FlgObstacleSide passed = {0, 0, {0, side, 0}};
        desc.sides = &passed;
        desc.side_count = 1;
        const MadeSpline made = make_spline(host, desc);
        ASSERT_EQ(made.result, FLG_OK) << made.error;
        for (uint32_t i = 0; i < made.view.node_count; ++i) {
            if (std::abs(made.node(i)[0]) < 0.3) {
                EXPECT_GT(side * made.node(i)[1], 0.3);
            }
        }
    }
}

TEST(SplineObstacles, OnASurfaceTheyAreKeptOutOfToo) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 1);
    FlgObstacle ball = flgObstacleDefaults();
    ball.centre[1] = 1;
    ball.radius = 0.4;
    const FlgObstacles obstacles = make_obstacles(host, {ball});
    const std::vector<double> points = {1, 0, 0.1, -1, 0, 0.1};
    FlgSplineDesc desc = spline_desc(sphere, {});
    desc.points = points.data();
    desc.point_count = 2;
    const double by[9] = {1, 0, 0.05, 0, 1, 0.6, -1, 0, 0.05};
    desc.points = by;
    desc.point_count = 3;
    desc.obstacles = obstacles;
    const MadeSpline made = make_spline(host, desc);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    double least = HUGE_VAL;
    for (uint32_t i = 0; i < made.view.node_count; ++i) {
        EXPECT_NEAR(distance(made.node(i), {0, 0, 0}), 1, 1e-7);
        least = std::min(least, distance(made.node(i), {0, 1, 0}) - 0.4);
    }
    EXPECT_GT(least, -1e-7);
}

TEST(SplineObstacles, BadOnesAreNamed) {
    const Host host;
    const FlgManifold plane = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE, 1, 0.25, 2);
    const std::vector<double> swallowed = {-2, 0, 0.1, 0, 2, 0};
    FlgSplineDesc desc = spline_desc(plane, swallowed, 2);
    desc.obstacles = discs(host, {{0, 0, 0.5}});
    const MadeSpline made = make_spline(host, desc);
    EXPECT_EQ(made.result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(made.error.find("1"), std::string::npos) << made.error;
    EXPECT_NE(made.error.find("obstacle"), std::string::npos) << made.error;

    const std::vector<double> twice = {-2, 0, 2, 0, 2, 0};
    desc.points = twice.data();
    const MadeSpline coincident = make_spline(host, desc);
    EXPECT_EQ(coincident.result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(coincident.error.find("points 1 and 2 come to one place"), std::string::npos) << coincident.error;

    desc.manifold = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE);
    FlgSpline spline{};
    expect_failure(flgSplineCreate(host.context, &desc, &spline, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "desc.obstacles are of 2 dimensions");

    const auto refuse = [&](const std::function<void(FlgObstacle&, FlgObstaclesDesc&)>& spoil, const char* words) {
        FlgObstacle solid = flgObstacleDefaults();
        FlgObstaclesDesc bad = flgObstaclesDefaults();
        bad.obstacles = &solid;
        bad.obstacle_count = 1;
        spoil(solid, bad);
        FlgObstacles out{};
        const FlgResult result = flgObstaclesCreate(host.context, &bad, &out, nullptr);
        EXPECT_LT(result, 0) << words;
        EXPECT_NE(std::strstr(flgErrorGetMessage(), words), nullptr) << flgErrorGetMessage();
    };
    refuse([](FlgObstacle&, FlgObstaclesDesc& d) { d.dimension = 4; }, "desc.dimension is 4");
    refuse([](FlgObstacle&, FlgObstaclesDesc& d) { d.obstacle_count = 0; }, "desc.obstacle_count is 0");
    refuse([](FlgObstacle&, FlgObstaclesDesc& d) { d.clearance = -1; }, "desc.clearance is -1");
    refuse([](FlgObstacle& o, FlgObstaclesDesc&) { o.kind = static_cast<FlgObstacleKind>(42); },
           "desc.obstacles[0]: kind is 42");
    refuse([](FlgObstacle& o, FlgObstaclesDesc&) { o.radius = 0; }, "desc.obstacles[0]");
    refuse([](FlgObstacle& o, FlgObstaclesDesc&) { o.centre[0] = NAN; }, "desc.obstacles[0]");
    refuse([](FlgObstacle& o, FlgObstaclesDesc&) { o.kind = FLG_OBSTACLE_KIND_BOX, o.axes[0] = 2; },
           "desc.obstacles[0]");
    refuse([](FlgObstacle& o, FlgObstaclesDesc&) { o.kind = FLG_OBSTACLE_KIND_POLYGON; }, "points is null");
    refuse([](FlgObstacle& o, FlgObstaclesDesc&) { o.kind = FLG_OBSTACLE_KIND_HALF_SPACE; },
           "desc.obstacles[0]: an obstacle's length of the direction outwards is 0");
    refuse([](FlgObstacle& o, FlgObstaclesDesc&) { o.kind = FLG_OBSTACLE_KIND_FUNCTION; }, "value is null");
    refuse([](FlgObstacle& o, FlgObstaclesDesc&) { o.kind = FLG_OBSTACLE_KIND_MESH; }, "desc.obstacles[0]: surface");
}

TEST(ManifoldRefusals, BadOnesAreNamed) {
    const Host host;
    FlgManifold out{};
    const auto refuse_shape = [&](const std::function<void(FlgManifoldShapeDesc&)>& spoil, const char* words) {
        FlgManifoldShapeDesc desc = flgManifoldShapeDefaults();
        spoil(desc);
        expect_failure(flgManifoldCreateShape(host.context, &desc, &out), FLG_ERROR_INVALID_ARGUMENT, words);
    };
    refuse_shape([](FlgManifoldShapeDesc& d) { d.shape = static_cast<FlgManifoldShape>(12); }, "desc.shape is 12");
    refuse_shape([](FlgManifoldShapeDesc& d) { d.ambient = 1; }, "desc.ambient is 1");
    refuse_shape([](FlgManifoldShapeDesc& d) { d.shape = FLG_MANIFOLD_SHAPE_SPHERE, d.radius = -1; },
                 "desc.radius is -1");
    refuse_shape([](FlgManifoldShapeDesc& d) { d.shape = FLG_MANIFOLD_SHAPE_TORUS, d.tube_radius = 2; },
                 "desc.tube_radius is 2");
    refuse_shape([](FlgManifoldShapeDesc& d) { d.shape = FLG_MANIFOLD_SHAPE_PLANE, d.size = NAN; }, "desc.size is nan");
    refuse_shape([](FlgManifoldShapeDesc& d) { d.shape = FLG_MANIFOLD_SHAPE_FORMULA; }, "desc.name is null");
    refuse_shape([](FlgManifoldShapeDesc& d) { d.shape = FLG_MANIFOLD_SHAPE_FORMULA, d.name = "no such"; },
                 "\"no such\"");
    for (const double scale : {-1.0, double{NAN}, HUGE_VAL}) {
        FlgManifoldFromSurfaceDesc desc = flgManifoldFromSurfaceDefaults();
        desc.surface = mesh_surface(host, torus_mesh(40, 20, 2, 0.5));
        desc.smoothing_scale = scale;
        expect_failure(flgManifoldCreateFromSurface(host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                       "desc.smoothing_scale is ");
    }

    ASSERT_NE(flgFormulaGetName(0), nullptr);
    EXPECT_EQ(flgFormulaGetName(10000), nullptr);

    const double at[3] = {1, 0, 0};
    const auto refuse_functions = [&](const std::function<void(FlgManifoldFunctions&)>& spoil, const char* words) {
        FlgManifoldFunctions functions = flgManifoldFunctionsDefaults();
        functions.project = [](void*, double*, double*) -> int32_t { return 1; };
        functions.tangent_basis = [](void*, const double*, double*, double* b) {
            const double rows[6] = {1, 0, 0, 0, 1, 0};
            std::copy_n(rows, 6, b);
        };
        spoil(functions);
        expect_failure(flgManifoldCreateHost(host.context, &functions, at, &out), FLG_ERROR_INVALID_ARGUMENT, words);
    };
    refuse_functions([](FlgManifoldFunctions& f) { f.project = nullptr; }, "functions.project is null");
    refuse_functions([](FlgManifoldFunctions& f) { f.dimension = 4; }, "functions.dimension is 4");
    refuse_functions([](FlgManifoldFunctions& f) { f.memory_size = 1000; }, "functions.memory_size is 1000");
    refuse_functions([](FlgManifoldFunctions& f) { f.project = [](void*, double*, double*) -> int32_t { return 0; }; },
                     "finds no point");
    refuse_functions(
        [](FlgManifoldFunctions& f) {
            f.project = [](void*, double* x, double*) -> int32_t {
                x[0] = NAN;
                return 1;
            };
        },
        "nan");
    refuse_functions(
        [](FlgManifoldFunctions& f) {
            f.tangent_basis = [](void*, const double*, double*, double* b) { std::fill_n(b, 6, 1.0); };
        },
        "inner product");

    FlgManifoldFromPointsDesc cloud = flgManifoldFromPointsDefaults();
    const float points[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, NAN, 1, 1};
    cloud.points = points;
    cloud.point_count = 3;
    expect_failure(flgManifoldCreateFromPoints(host.context, &cloud, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "desc.point_count is 3");
    cloud.point_count = 4;
    expect_failure(flgManifoldCreateFromPoints(host.context, &cloud, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "desc.points[9] is nan");
    FlgManifoldFromGridDesc samples = flgManifoldFromGridDefaults();
    const float values[8] = {1, 1, 1, 1, 1, 1, 1, 1};
    samples.counts[0] = samples.counts[1] = samples.counts[2] = 2;
    samples.values = values;
    FlgJob job{};
    ASSERT_EQ(flgManifoldCreateFromGrid(host.context, &samples, &out, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_LT(host.result_of(job), 0);  // no sign changes
    samples.spacing = 0;
    expect_failure(flgManifoldCreateFromGrid(host.context, &samples, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "desc.spacing is 0");
    FlgPatchFunctions patch = flgPatchFunctionsDefaults();
    expect_failure(flgManifoldCreatePatch(host.context, &patch, &out), FLG_ERROR_INVALID_ARGUMENT,
                   "functions.evaluate is null");
    patch.evaluate = [](void*, double, double, double* o) { std::fill_n(o, 18, 1.0); };
    expect_failure(flgManifoldCreatePatch(host.context, &patch, &out), FLG_ERROR_INVALID_ARGUMENT, "parallel");
    expect_failure(flgManifoldCreateImage(host.context, shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE), 1, &out),
                   FLG_ERROR_INVALID_ARGUMENT, "base is not");
}

TEST(ManifoldRefusals, ACursorIsProjected) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 2);
    double points[6] = {3, 0, 0, 0, 0, 0}, distances[2];
    ASSERT_EQ(flgManifoldProject(host.context, sphere, points, 2, distances), FLG_OK) << flgErrorGetMessage();
    EXPECT_NEAR(points[0], 2, 1e-12);
    EXPECT_NEAR(distances[0], 1, 1e-12);
    EXPECT_EQ(distances[1], HUGE_VAL);
    EXPECT_EQ(points[3], 0);
    expect_failure(flgManifoldProject(host.context, sphere, points, 65, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "point_count is 65");
}

}  // namespace
}  // namespace flg::test
