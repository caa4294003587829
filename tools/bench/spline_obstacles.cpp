// SPDX-License-Identifier: MIT
// Splines among random solids, in the plane, in space and on a surface: whether they keep clear of the exact solids
// everywhere, and what that costs.
#include <algorithm>
#include <cmath>

#include "bench/splines.h"
#include "reference/obstacle_scenes.h"

namespace flg::bench {
namespace {

using reference::ObstacleScene;
using reference::SceneKind;
using reference::Solid;

constexpr double kMedianMs = 40, kWorstMs = 500, kDetourMs = 50;
constexpr uint32_t kMazes = 21;
constexpr double kPenetration = 1e-6;  // of the scene's size

FlgObstacle obstacle(Host& host, const ObstacleScene& scene, const Solid& solid) {
    FlgObstacle out = reference::described(solid, scene.dimension);
    if (out.kind != FLG_OBSTACLE_KIND_MESH) return out;
    const MeshArrays mesh{.positions = solid.positions, .triangles = solid.triangles};
    FlgColumn column{};
    const FlgMeshView view = mesh.view(column);
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    desc.mesh = &view;
    check(flgSurfaceCreate(host.context(), &desc, &out.surface, nullptr));
    return out;
}

struct Outcome {
    double ms;
    double penetration;  // metres; 0: none
    bool refused;
};

Outcome run_scene(const ObstacleScene& scene, SceneKind kind) {
    Host host;
    std::vector<FlgObstacle> solids;
    for (const Solid& solid : scene.solids) solids.push_back(obstacle(host, scene, solid));
    FlgObstaclesDesc obstacles = flgObstaclesDefaults();
    obstacles.dimension = scene.dimension;
    obstacles.obstacles = solids.data();
    obstacles.obstacle_count = static_cast<uint32_t>(solids.size());
    obstacles.clearance = scene.clearance;
    FlgManifoldShapeDesc shape = flgManifoldShapeDefaults();
    shape.shape = kind == SceneKind::sphere || kind == SceneKind::walled_sphere ? FLG_MANIFOLD_SHAPE_SPHERE
                                                                                : FLG_MANIFOLD_SHAPE_SPACE;
    shape.radius = reference::sphere_radius;
    shape.ambient = scene.dimension;
    FlgManifold manifold{};
    check(flgManifoldCreateShape(host.context(), &shape, &manifold));
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = manifold;
    desc.points = scene.points.data();
    desc.point_count = static_cast<uint32_t>(scene.points.size() / scene.dimension);
    check(flgObstaclesCreate(host.context(), &obstacles, &desc.obstacles, nullptr));
    host.run();
    const double begin = thread_ms();
    FlgSpline spline{};
    check(flgSplineCreate(host.context(), &desc, &spline, nullptr));
    host.run();
    Outcome out{.ms = thread_ms() - begin, .penetration = 0, .refused = false};
    FlgSplineView view = flgSplineViewDefaults();
    const FlgResult result = flgSplineGetView(host.context(), spline, &view);
    if (result != FLG_OK) {
        out.refused = true;
        return out;
    }
    const reference::Approach approach =
        reference::closest_approach(scene, {view.nodes, size_t{view.node_count} * scene.dimension},
                                    {view.parameters, size_t{view.node_count}}, false);
    out.penetration = std::max(-approach.clearance, 0.0);
    return out;
}

std::vector<Row> scene_rows(const std::string& name, SceneKind kind, uint32_t scenes) {
    std::vector<double> times;
    uint32_t penetrating = 0, refused = 0;
    double worst = 0;
    for (uint64_t seed = 0; seed < scenes; ++seed) {
        const ObstacleScene scene = reference::obstacle_scene(seed, kind);
        const Outcome outcome = run_scene(scene, kind);
        times.push_back(outcome.ms);
        penetrating += outcome.penetration > kPenetration * scene.size ? 1 : 0;
        refused += outcome.refused ? 1 : 0;
        worst = std::max(worst, outcome.penetration);
    }
    std::sort(times.begin(), times.end());
    const std::string about = name + ", " + std::to_string(scenes) + " scenes: ";
    char note[64];
    std::snprintf(note, sizeof note, "deepest %.1e m; %u refused", worst, refused);
    return {
        below(about + "curves in solids", penetrating, "", 1, note),
        below(about + "median", times[scenes / 2], "ms", kMedianMs),
        below(about + "longest", times.back(), "ms", kWorstMs),
    };
}

// 14 solids of the plane between two points.
std::vector<Row> maze_rows() {
    std::vector<double> times;
    uint32_t missing = 0;
    for (uint64_t seed = 0; seed < kMazes; ++seed) {
        const ObstacleScene scene = reference::obstacle_maze(seed);
        const Outcome outcome = run_scene(scene, SceneKind::plane);
        times.push_back(outcome.ms);
        missing += outcome.refused || outcome.penetration > kPenetration * scene.size ? 1 : 0;
    }
    std::sort(times.begin(), times.end());
    char note[64];
    std::snprintf(note, sizeof note, "longest %.1f ms; %u without a clear curve", times.back(), missing);
    return {below("a detour around 14 solids of the plane: median", times[kMazes / 2], "ms", kDetourMs, note)};
}

}  // namespace

std::vector<Row> spline_obstacles() {
    std::vector<Row> rows;
    const auto append = [&](const std::string& name, SceneKind kind, uint32_t scenes) {
        const std::vector<Row> more = scene_rows(name, kind, scenes);
        rows.insert(rows.end(), more.begin(), more.end());
    };
    append("solids of the plane", SceneKind::plane, 150);
    append("solids of space", SceneKind::space, 100);
    append("closed meshes", SceneKind::meshes, 50);
    append("solids on a sphere", SceneKind::sphere, 100);
    append("walls and prisms in the plane", SceneKind::walled_plane, 50);
    append("walls and prisms in space", SceneKind::walled_space, 50);
    append("walls and prisms on a sphere", SceneKind::walled_sphere, 50);
    const std::vector<Row> mazes = maze_rows();
    rows.insert(rows.end(), mazes.begin(), mazes.end());
    return rows;
}

}  // namespace flg::bench
