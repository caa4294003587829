// SPDX-License-Identifier: MIT
// Manifolds, splines on them and among obstacles, motions.
#include "filigree/filigree_motion.h"
#include "filigree/filigree_spline.h"
#include "slices/meshes.h"
#include "slices/sized_jobs.h"

namespace flg::slices {

namespace {

// On the unit sphere, winding.
std::vector<double> sphere_points(uint32_t count) {
    std::vector<double> points;
    for (uint32_t i = 0; i < count; ++i) {
        const double u = 0.05 * i, v = 0.8 * std::sin(0.013 * i);
        points.insert(points.end(), {std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)});
    }
    return points;
}

FlgManifold shape(WatchedHost& host, FlgManifoldShape kind) {
    FlgManifoldShapeDesc desc = flgManifoldShapeDefaults();
    desc.shape = kind;
    FlgManifold manifold{};
    host.call("flgManifoldCreateShape", flgManifoldCreateShape, &desc, &manifold);
    host.made("flgManifoldRelease", flgManifoldRelease, manifold);
    return manifold;
}

FlgSpline fit(WatchedHost& host, FlgManifold manifold, const std::vector<double>& points, uint32_t nodes,
              FlgObstacles obstacles = {}) {
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = manifold;
    desc.points = points.data();
    desc.point_count = static_cast<uint32_t>(points.size() / 3);
    desc.node_count = nodes;
    desc.max_rounds = 4;
    desc.obstacles = obstacles;
    FlgSpline spline{};
    host.copy("flgSplineCreate", flgSplineCreate, &desc, &spline, host.job());
    host.made("flgSplineRelease", flgSplineRelease, spline);
    host.finish();
    return spline;
}

// As many nodes, a point for ten of them.
void spline(WatchedHost& host, uint32_t size) {
    const FlgManifold sphere = shape(host, FLG_MANIFOLD_SHAPE_SPHERE);
    FlgSplineSampleDesc desc = flgSplineSampleDefaults();
    desc.spline = fit(host, sphere, sphere_points(std::min(size / 10, 65536u)), size);
    FlgCurveSet set{};
    host.call("flgSplineSample", flgSplineSample, &desc, &set, host.job());
    host.made("flgCurveSetRelease", flgCurveSetRelease, set);
    host.finish();
    FlgSplineOffsetDesc offset = flgSplineOffsetDefaults();
    offset.spline = desc.spline;
    offset.left = 0.01;
    FlgCurveSet beside{};
    host.call("flgSplineOffset", flgSplineOffset, &offset, &beside, host.job());
    host.made("flgCurveSetRelease", flgCurveSetRelease, beside);
    host.finish();
    // Across the way of the curve's bends, with loops.
    offset.up[2] = 1;
    offset.left = 0.9;
    FlgCurveSet cut{};
    host.call("flgSplineOffset", flgSplineOffset, &offset, &cut, host.job());
    host.made("flgCurveSetRelease", flgCurveSetRelease, cut);
    host.finish();
}

FlgCurveSet hang(WatchedHost& host, const std::vector<double>& points, uint32_t segments, double slack,
                 FlgObstacles obstacles) {
    FlgCableHangDesc desc = flgCableHangDefaults();
    desc.points = points.data();
    desc.point_count = static_cast<uint32_t>(points.size() / 3);
    desc.segments = segments;
    desc.slack = slack;
    desc.obstacles = obstacles;
    FlgCurveSet set{};
    host.copy("flgCableHang", flgCableHang, &desc, &set, host.job());
    host.made("flgCurveSetRelease", flgCurveSetRelease, set);
    host.finish();
    return set;
}

void manifold_of_mesh(WatchedHost& host, uint32_t size) {
    FlgManifoldFromSurfaceDesc desc = flgManifoldFromSurfaceDefaults();
    desc.surface = make_surface(host, ball(size));
    FlgManifold manifold{};
    host.call("flgManifoldCreateFromSurface", flgManifoldCreateFromSurface, &desc, &manifold, host.job());
    host.made("flgManifoldRelease", flgManifoldRelease, manifold);
    host.finish();
    FlgSplineTraceDesc trace = flgSplineTraceDefaults();
    trace.spline = fit(host, manifold, sphere_points(8), 200);
    FlgSurfaceCurves curves{};
    host.call("flgSplineTrace", flgSplineTrace, &trace, &curves, host.job());
    host.made("flgSurfaceCurvesRelease", flgSurfaceCurvesRelease, curves);
    host.finish();
    trace.offset = 0.2;
    FlgSurfaceCurves beside{};
    host.call("flgSplineTrace", flgSplineTrace, &trace, &beside, host.job());
    host.made("flgSurfaceCurvesRelease", flgSurfaceCurvesRelease, beside);
    host.finish();
}

void manifold_of_points(WatchedHost& host, uint32_t size) {
    std::vector<float> points;
    for (uint32_t i = 0; i < size; ++i) {
        const double z = 1 - (2.0 * i + 1) / size, r = std::sqrt(1 - z * z), angle = 2.399963229728653 * i;
        for (const double x : {r * std::cos(angle), r * std::sin(angle), z}) points.push_back(static_cast<float>(x));
    }
    FlgManifoldFromPointsDesc desc = flgManifoldFromPointsDefaults();
    desc.points = points.data();
    desc.point_count = size;
    FlgManifold manifold{};
    host.copy("flgManifoldCreateFromPoints", flgManifoldCreateFromPoints, &desc, &manifold, host.job());
    host.made("flgManifoldRelease", flgManifoldRelease, manifold);
    host.finish();
}

void manifold_of_grid(WatchedHost& host, uint32_t size) {
    const auto side = static_cast<uint32_t>(std::lround(std::cbrt(size)));
    const double spacing = 2.8 / (side - 1);
    std::vector<float> values;
    for (uint32_t i = 0; i < side * side * side; ++i) {
        const auto at = [&](uint32_t k) { return spacing * k - 1.4; };
        values.push_back(static_cast<float>(std::hypot(at(i % side), at(i / side % side), at(i / side / side)) - 1));
    }
    FlgManifoldFromGridDesc desc = flgManifoldFromGridDefaults();
    for (uint32_t& count : desc.counts) count = side;
    for (double& x : desc.corner) x = -1.4;
    desc.spacing = spacing;
    desc.values = values.data();
    FlgManifold manifold{};
    host.copy("flgManifoldCreateFromGrid", flgManifoldCreateFromGrid, &desc, &manifold, host.job());
    host.made("flgManifoldRelease", flgManifoldRelease, manifold);
    host.finish();
}

FlgObstacles among(WatchedHost& host, const FlgObstacle& solid, double clearance) {
    FlgObstaclesDesc desc = flgObstaclesDefaults();
    desc.dimension = 3;
    desc.obstacles = &solid;
    desc.obstacle_count = 1;
    desc.clearance = clearance;
    FlgObstacles made{};
    host.copy("flgObstaclesCreate", flgObstaclesCreate, &desc, &made, host.job());
    host.made("flgObstaclesRelease", flgObstaclesRelease, made);
    host.finish();
    return made;
}

void solid_mesh(WatchedHost& host, uint32_t size) {
    FlgObstacle solid = flgObstacleDefaults();
    solid.kind = FLG_OBSTACLE_KIND_MESH;
    solid.surface = make_surface(host, ball(size));
    solid.cells = 40;
    const FlgObstacles obstacles = among(host, solid, 0.05);
    fit(host, shape(host, FLG_MANIFOLD_SHAPE_SPACE), {-3, 0, 0.1, 0, 3, 0, 3, 0.1, 0}, 65, obstacles);
    hang(host, {-3, 0, 1.3, 3, 0, 1.3}, 64, 0.02, obstacles);
}

// Free ones, and one that rests on the ground, of as many segments.
void cables(WatchedHost& host, uint32_t size) {
    std::vector<double> points;
    for (uint32_t i = 0; i < std::min(size / 8 + 2, 65536u); ++i) points.insert(points.end(), {1.0 * i, 0, 3});
    hang(host, points, 8, 0.05, {});
    FlgObstacle ground = flgObstacleDefaults();
    ground.kind = FLG_OBSTACLE_KIND_HALF_SPACE;
    ground.to[2] = 1;
    hang(host, {-3, 0, 1, 3, 0, 1}, std::min(size, 4096u), 0.03, among(host, ground, 0));
}

void solid_border(WatchedHost& host, uint32_t size) {
    FlgObstacle border = flgObstacleDefaults();
    border.kind = FLG_OBSTACLE_KIND_BORDER;
    border.surface = make_surface(host, waves(size));
    among(host, border, 0.001);
}

// A pose for each key, turning.
void move(WatchedHost& host, uint32_t size, bool everything) {
    std::vector<double> poses, times;
    for (uint32_t i = 0; i < size; ++i) {
        const double c = std::cos(0.3 * i), s = std::sin(0.3 * i);
        poses.insert(poses.end(), {c, -s, 0, 1.0 * i, s, c, 0, std::sin(0.1 * i), 0, 0, 1, 0.1 * std::cos(0.7 * i)});
        times.push_back(i);
    }
    FlgMotionDesc desc = flgMotionDefaults();
    desc.key_count = size;
    desc.times = times.data();
    desc.poses = poses.data();
    desc.max_rounds = 3;
    if (everything) {
        desc.timing = FLG_MOTION_TIMING_CHORD;
        desc.pacing = FLG_MOTION_PACING_BODY;
        desc.max_speed = desc.max_acceleration = desc.max_turn = desc.max_turn_acceleration = 1;
        desc.look = FLG_MOTION_LOOK_PATH;
        desc.bank = 1;
        desc.times = nullptr;
    }
    FlgMotion motion{};
    host.copy("flgMotionCreate", flgMotionCreate, &desc, &motion, host.job());
    host.made("flgMotionRelease", flgMotionRelease, motion);
    host.finish();
}

void motion(WatchedHost& host, uint32_t size) {
    move(host, size, false);
}
void camera(WatchedHost& host, uint32_t size) {
    move(host, size, true);
}

constexpr SizedJob all[] = {
    {"spline", spline, FLG_SPLINE_MAX_NODES},
    {"manifold_mesh", manifold_of_mesh},
    {"manifold_points", manifold_of_points, 1u << 24},
    {"manifold_grid", manifold_of_grid},
    {"obstacle_mesh", solid_mesh},
    {"obstacle_border", solid_border},
    {"cables", cables, 524'000},
    {"motion", motion, 30'000},
    {"camera", camera, 30'000},
};

}  // namespace

std::span<const SizedJob> spline_jobs() {
    return all;
}

}  // namespace flg::slices
