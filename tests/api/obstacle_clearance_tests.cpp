// SPDX-License-Identifier: MIT
// Splines among random solids: everywhere, not at nodes alone, they keep their clearance from the exact solids.
#include <atomic>

#include "api/spline_inputs.h"
#include "reference/obstacle_scenes.h"

namespace flg::test {
namespace {

using reference::ObstacleScene;
using reference::SceneKind;
using reference::Solid;

struct Kind {
    SceneKind kind;
    uint32_t scenes;
};

class SplineClearance : public testing::TestWithParam<Kind> {};

FlgObstacles obstacles_of(const Host& host, const ObstacleScene& scene) {
    std::vector<FlgObstacle> solids;
    for (const Solid& solid : scene.solids) {
        solids.push_back(described(solid, scene.dimension));
        if (solid.kind != Solid::Kind::mesh) continue;
        MeshArrays mesh;
        mesh.positions = solid.positions;
        mesh.triangles = solid.triangles;
        solids.back().surface = mesh_surface(host, std::move(mesh));
    }
    return make_obstacles(host, solids, scene.dimension, scene.clearance);
}

FlgManifold manifold_of(const Host& host, SceneKind kind) {
    if (kind == SceneKind::sphere || kind == SceneKind::walled_sphere)
        return shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, reference::sphere_radius);
    return shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE, 1, 0.25,
                          kind == SceneKind::plane || kind == SceneKind::walled_plane ? 2 : 3);
}

TEST_P(SplineClearance, HoldsBetweenNodesToo) {
    uint32_t touching = 0;
    for (uint64_t seed = 1000; seed < 1000 + GetParam().scenes; ++seed) {
        const Host host;
        const ObstacleScene scene = reference::obstacle_scene(seed, GetParam().kind);
        FlgSplineDesc desc = spline_desc(manifold_of(host, GetParam().kind), scene.points, scene.dimension);
        desc.obstacles = obstacles_of(host, scene);
        desc.closed = seed % 3 == 0 && desc.point_count > 2 ? 1 : 0;
        desc.energy = seed % 5 == 0 ? FLG_SPLINE_ENERGY_E1 : FLG_SPLINE_ENERGY_E2;
        const MadeSpline made = make_spline(host, desc);
        ASSERT_EQ(made.result, FLG_OK) << "scene " << seed << ": " << made.error;
        const FlgSplineView& view = made.view;
        const reference::Approach nearest =
            closest_approach(scene, {view.nodes, size_t{view.node_count} * scene.dimension},
                             {view.parameters, size_t{view.node_count} + 1}, view.closed != 0);
        EXPECT_GT(nearest.clearance, -1e-6 * scene.size)
            << "scene " << seed << ", node " << nearest.node << ", solid " << nearest.solid;
        touching += nearest.clearance < 0.01 * scene.size ? 1 : 0;
    }
    // Many do touch: else it would say nothing.
    EXPECT_GE(5 * touching, GetParam().scenes);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SplineClearance,
                         testing::Values(Kind{SceneKind::plane, 16}, Kind{SceneKind::space, 12},
                                         Kind{SceneKind::meshes, 12}, Kind{SceneKind::sphere, 12},
                                         Kind{SceneKind::walled_plane, 10}, Kind{SceneKind::walled_space, 8},
                                         Kind{SceneKind::walled_sphere, 8}));

// Scenes that a descent over barriers enters with a kinked curve, or with chords through solids.
TEST(SplineObstacles, CrowdedScenesHaveACurve) {
    const std::pair<SceneKind, uint64_t> scenes[] = {{SceneKind::plane, 23},        {SceneKind::plane, 35},
                                                     {SceneKind::sphere, 97},       {SceneKind::walled_plane, 16},
                                                     {SceneKind::walled_space, 37}, {SceneKind::walled_space, 44},
                                                     {SceneKind::walled_sphere, 8}, {SceneKind::walled_sphere, 40}};
    for (const auto& [kind, seed] : scenes) {
        const Host host;
        const ObstacleScene scene = reference::obstacle_scene(seed, kind);
        FlgSplineDesc desc = spline_desc(manifold_of(host, kind), scene.points, scene.dimension);
        desc.obstacles = obstacles_of(host, scene);
        const MadeSpline made = make_spline(host, desc);
        ASSERT_EQ(made.result, FLG_OK) << static_cast<int>(kind) << ", " << seed << ": " << made.error;
        const reference::Approach nearest =
            closest_approach(scene, {made.view.nodes, size_t{made.view.node_count} * scene.dimension},
                             {made.view.parameters, made.view.node_count}, false);
        EXPECT_GT(nearest.clearance, -1e-6 * scene.size) << static_cast<int>(kind) << ", " << seed;
    }
}

TEST(SplineObstacles, ADetourAroundFourteenSolidsIsFound) {
    for (uint64_t seed = 0; seed < 12; ++seed) {
        const Host host;
        const ObstacleScene scene = reference::obstacle_maze(seed);
        ASSERT_EQ(scene.solids.size(), 14u);
        FlgSplineDesc desc = spline_desc(manifold_of(host, SceneKind::plane), scene.points, 2);
        desc.obstacles = obstacles_of(host, scene);
        const MadeSpline made = make_spline(host, desc);
        ASSERT_EQ(made.result, FLG_OK) << seed << ": " << made.error;
        EXPECT_NE(made.view.ending, FLG_SPLINE_ENDING_STALLED) << seed;
        const reference::Approach nearest = closest_approach(scene, {made.view.nodes, size_t{made.view.node_count} * 2},
                                                             {made.view.parameters, made.view.node_count}, false);
        EXPECT_GT(nearest.clearance, -1e-6 * scene.size) << seed;
        EXPECT_GT(made.view.length, 4.8) << seed;
    }
}

// A long curve through a row of posts: the host's own function counts.
TEST(SplineObstacles, TheDefaultBoundsTheWorkOfManyPoints) {
    const Host host;
    constexpr uint64_t calls_each = 10;
    static constexpr double posts[4][2] = {{0.7, 0.3}, {1.9, -0.35}, {3.1, 0.25}, {4.3, -0.3}};
    std::atomic<uint64_t> calls = 0;
    FlgObstacle function = flgObstacleDefaults();
    function.kind = FLG_OBSTACLE_KIND_FUNCTION;
    function.centre[0] = 2.5;
    function.half[0] = 2.6;
    function.half[1] = 1.2;
    function.user_data = &calls;
    function.value = [](void* counter, const double* x, double* gradient) {
        ++*static_cast<std::atomic<uint64_t>*>(counter);
        double nearest = HUGE_VAL;
        for (const auto& post : posts) {
            const double away = std::hypot(x[0] - post[0], x[1] - post[1]);
            if (away - 0.3 >= nearest) continue;
            nearest = away - 0.3;
            for (int k = 0; k < 2; ++k) gradient[k] = away > 0 ? (x[k] - post[k]) / away : 1;
        }
        return nearest;
    };
    std::vector<double> points;
    for (uint32_t i = 0; points.size() < 502; ++i) {
        const double x = 0.01 * i - 0.5, y = 0.6 * std::sin(2.6 * x);
        double ignored[2];
        if (function.value(&calls, std::array{x, y}.data(), ignored) > 0.02) points.insert(points.end(), {x, y});
    }
    FlgSplineDesc desc = spline_desc(shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE, 1, 0.25, 2), points, 2);
    desc.obstacles = make_obstacles(host, {function}, 2);
    calls = 0;
    const MadeSpline made = make_spline(host, desc);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    const uint64_t bounded = calls;
    EXPECT_EQ(desc.max_evaluations, 2000000u);
    // Putting a node onto a barrier, and its part of a round, look at the obstacle some seven times.
    EXPECT_LT(bounded, calls_each * desc.max_evaluations);
    // The bound is of all that is done: a hundredth of it is a hundredth of the work.
    calls = 0;
    desc.max_evaluations /= 100;
    const MadeSpline little = make_spline(host, desc);
    EXPECT_LT(calls, calls_each * desc.max_evaluations);
    if (little.result != FLG_OK) {
        EXPECT_NE(little.error.find("desc.max_evaluations, 20000, were used up"), std::string::npos) << little.error;
    }
}

// Points on the solids' very boundary are no points inside. Beside them a curve may come nearer by a tenth of the
// barriers' radius.
TEST(SplineObstacles, GivenPointsMayTouch) {
    const Host host;
    const FlgManifold plane = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE, 1, 0.25, 2);
    ObstacleScene scene;
    scene.dimension = 2;
    scene.size = 4;
    Solid& ball = scene.solids.emplace_back();
    ball.radius = 0.5;
    scene.points = {-2, 0, 0, 0.5, 2, 0.1};
    FlgSplineDesc desc = spline_desc(plane, scene.points, 2);
    desc.obstacles = obstacles_of(host, scene);
    const MadeSpline made = make_spline(host, desc);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    const reference::Approach nearest = closest_approach(scene, {made.view.nodes, size_t{made.view.node_count} * 2},
                                                         {made.view.parameters, made.view.node_count}, false);
    EXPECT_GT(nearest.clearance, -0.1 * desc.obstacle_radius * 1.01 * scene.size);
    EXPECT_LT(nearest.clearance, 1e-9);
    EXPECT_EQ(made.node(made.view.point_nodes[1]), (Point{0, 0.5, 0}));
}

// However few evaluations there are: a curve that keeps clear, or the sentence that says where it did not.
TEST(SplineObstacles, EvaluationsBoundTheWork) {
    uint32_t cut_short = 0, refused = 0;
    for (const uint64_t seed : {1001u, 1002u, 1006u}) {
        const Host host;
        const ObstacleScene scene = reference::obstacle_scene(seed, SceneKind::plane);
        FlgSplineDesc desc = spline_desc(manifold_of(host, SceneKind::plane), scene.points, 2);
        desc.obstacles = obstacles_of(host, scene);
        desc.max_evaluations = 0;
        const MadeSpline whole = make_spline(host, desc);
        ASSERT_EQ(whole.result, FLG_OK) << whole.error;
        for (const uint64_t most : {1u, 300u, 1000u, 2000u, 3000u, 5000u, 8000u, 12000u, 100000000u}) {
            desc.max_evaluations = most;
            const MadeSpline made = make_spline(host, desc);
            if (made.result != FLG_OK) {
                EXPECT_NE(made.error.find("desc.max_evaluations, " + std::to_string(most) + ", were used up"),
                          std::string::npos)
                    << made.error;
                ++refused;
                continue;
            }
            const reference::Approach nearest =
                closest_approach(scene, {made.view.nodes, size_t{made.view.node_count} * 2},
                                 {made.view.parameters, made.view.node_count}, false);
            EXPECT_GT(nearest.clearance, -1e-6 * scene.size) << seed << ", " << most;
            if (made.view.ending == FLG_SPLINE_ENDING_EVALUATIONS) {
                ++cut_short;
            } else {
                ASSERT_EQ(made.view.node_count, whole.view.node_count);
                EXPECT_TRUE(std::equal(whole.view.nodes, whole.view.nodes + size_t{2} * whole.view.node_count,
                                       made.view.nodes));
            }
            if (most == 100000000u) {
                EXPECT_EQ(made.view.ending, whole.view.ending);
            }
        }
    }
    EXPECT_GT(cut_short, 0u);
    EXPECT_GT(refused, 0u);
}

// Of a mesh, by a clearance of many cells of its grid: as the box that it is.
TEST(SplineObstacles, AWideClearanceFromAMeshHolds) {
    const Host host;
    const FlgManifold space = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE);
    FlgObstacle box = flgObstacleDefaults();
    box.kind = FLG_OBSTACLE_KIND_MESH;
    MeshArrays mesh;
    for (uint32_t i = 0; i < 8; ++i) mesh.add_vertex(i & 1 ? 1 : -1, i & 2 ? 0.5 : -0.5, i & 4 ? 0.25 : -0.25);
    const uint32_t corners[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    for (const auto& t : corners) mesh.add_triangle(t[0], t[1], t[2]);
    box.surface = mesh_surface(host, std::move(mesh));
    const double clearance = 0.6;
    const std::vector<double> points = {-3, 0.1, 0, 3, 0, 0.1};
    FlgSplineDesc desc = spline_desc(space, points);
    desc.obstacles = make_obstacles(host, {box}, 3, clearance);
    const MadeSpline made = make_spline(host, desc);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    double least = HUGE_VAL;
    for (uint32_t i = 0; i < made.view.node_count; ++i) {
        const Point at = made.node(i);
        const double half[3] = {1, 0.5, 0.25};
        double square = 0;
        for (size_t c = 0; c < 3; ++c) square += std::pow(std::max(std::abs(at[c]) - half[c], 0.0), 2);
        least = std::min(least, std::sqrt(square));
    }
    EXPECT_GT(least, clearance - 1e-5);
    EXPECT_LT(least, clearance + 0.03);  // half a cell
}

TEST(SplineObstacles, SameBitsUnderAnyWorkersAndBudgets) {
    const ObstacleScene scene = reference::obstacle_scene(3, SceneKind::plane);
    std::vector<double> expected;
    for (const uint32_t workers : {0u, 3u}) {
        for (const uint32_t budget_us : {FLG_UNLIMITED, 300u}) {
            const Host host(workers);
            FlgSplineDesc desc = spline_desc(manifold_of(host, SceneKind::plane), scene.points, 2);
            desc.obstacles = obstacles_of(host, scene);
            const MadeSpline made = make_spline(host, desc, budget_us);
            ASSERT_EQ(made.result, FLG_OK) << made.error;
            const std::vector<double> now(made.view.nodes, made.view.nodes + size_t{2} * made.view.node_count);
            if (expected.empty()) expected = now;
            EXPECT_TRUE(now == expected) << workers << " workers, budget " << budget_us;
        }
    }
}

}  // namespace
}  // namespace flg::test
