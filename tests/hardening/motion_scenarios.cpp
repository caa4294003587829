// SPDX-License-Identifier: MIT
// Obstacles of every kind with splines among them, and motions.
#include "filigree/filigree_motion.h"
#include "hardening/scenarios.h"

namespace flg::test {

namespace {

double ball_distance(void*, const double* x, double* gradient) {
    const double d[3] = {x[0], x[1] - 3, x[2]};
    const double size = std::hypot(d[0], d[1], d[2]);
    for (int i = 0; i < 3; ++i) gradient[i] = size == 0 ? 0 : d[i] / size;
    return size - 0.5;
}

FlgSurface create(Calls& calls, MeshArrays mesh) {
    FlgSurfaceDesc desc = FLG_INIT(calls, flgSurfaceDescInit);
    const FlgMeshView input = mesh.view();
    desc.mesh = &input;
    FlgSurface surface{};
    FLG_CALL(calls, flgSurfaceCreate, calls.context, &desc, calls.out(surface), calls.job());
    return surface;
}

FlgObstacle obstacle(Calls& calls, FlgObstacleKind kind, double x, double y, double z, double radius) {
    FlgObstacle made = FLG_INIT(calls, flgObstacleInit);
    made.kind = kind;
    made.centre[0] = made.to[0] = x;
    made.centre[1] = y;
    made.to[1] = y + 0.5;
    made.centre[2] = made.to[2] = z;
    made.radius = radius;
    for (double& half : made.half) half = radius;
    made.cells = 8;
    return made;
}

FlgObstacles among(Calls& calls, uint32_t dimension, const std::vector<FlgObstacle>& solids) {
    FlgObstaclesDesc desc = FLG_INIT(calls, flgObstaclesDescInit);
    desc.dimension = dimension;
    desc.obstacles = solids.data();
    desc.obstacle_count = static_cast<uint32_t>(solids.size());
    desc.clearance = 0.05;
    FlgObstacles made{};
    FLG_CALL(calls, flgObstaclesCreate, calls.context, &desc, calls.out(made), calls.job());
    return made;
}

void fit(Calls& calls, uint32_t dimension, const std::vector<double>& points, FlgObstacles obstacles) {
    FlgManifoldShapeDesc shape = FLG_INIT(calls, flgManifoldShapeDescInit);
    shape.ambient = dimension;
    FlgSplineDesc desc = FLG_INIT(calls, flgSplineDescInit);
    FLG_CALL(calls, flgManifoldCreateShape, calls.context, &shape, calls.out(desc.manifold));
    desc.points = points.data();
    desc.point_count = static_cast<uint32_t>(points.size() / dimension);
    desc.obstacles = obstacles;
    desc.obstacle_radius = 0.02;
    desc.max_rounds = 10;
    desc.node_count = 17;
    FlgSpline spline{};
    FLG_CALL(calls, flgSplineCreate, calls.context, &desc, calls.out(spline), calls.job());
    calls.finish();
    FlgSplineView view = FLG_INIT(calls, flgSplineViewInit);
    FLG_CALL(calls, flgSplineGetView, calls.context, spline, &view);
    calls.note(view.nodes, size_t{view.ambient} * view.node_count * sizeof(double));
}

}  // namespace

namespace {

FlgObstacle wall(Calls& calls) {
    FlgObstacle out = obstacle(calls, FLG_OBSTACLE_KIND_HALF_SPACE, 0, -8, 0, 1);
    out.to[1] = 1;
    return out;
}

}  // namespace

void avoid_obstacles(Calls& calls) {
    const double triangle[] = {1.5, -0.4, 2.2, -0.3, 1.8, 0.5};
    FlgObstacle polygon = obstacle(calls, FLG_OBSTACLE_KIND_POLYGON, 0, 0, 0, 1);
    polygon.points = triangle;
    polygon.point_count = 3;
    const FlgObstacles flat =
        among(calls, 2, {polygon, obstacle(calls, FLG_OBSTACLE_KIND_BALL, 0.5, 0.1, 0, 0.3), wall(calls)});
    fit(calls, 2, {0, 0, 1.1, 0, 3, 0.1}, flat);

    FlgObstacle function = obstacle(calls, FLG_OBSTACLE_KIND_FUNCTION, 0, 3, 0, 0.6);
    function.value = ball_distance;
    FlgObstacle solid = obstacle(calls, FLG_OBSTACLE_KIND_MESH, 0, 0, 0, 1);
    solid.surface = create(calls, sphere(2));
    const FlgObstacles space = among(
        calls, 3,
        {obstacle(calls, FLG_OBSTACLE_KIND_BALL, 0, -3, 0, 0.5), obstacle(calls, FLG_OBSTACLE_KIND_BOX, 3, 0, 0, 0.4),
         obstacle(calls, FLG_OBSTACLE_KIND_CAPSULE, -3, 0, 0, 0.3), function, solid, wall(calls), polygon});
    fit(calls, 3, {-1.6, 0, 0.1, 1.6, 0.1, 0}, space);
    FLG_DRAW(calls, flgDebugDrawObstacles, space);

    FlgObstacle layer = obstacle(calls, FLG_OBSTACLE_KIND_LAYER, 0, 0, 0, 0.6);
    layer.cells = 20;
    FlgObstacle border = obstacle(calls, FLG_OBSTACLE_KIND_BORDER, 0, 0, 0, 1);
    layer.surface = border.surface = create(calls, plane(4));
    among(calls, 3, {layer});
    fit(calls, 3, {0.2, 0.2, 0.1, 0.8, 0.7, 0.1}, among(calls, 3, {border}));
    FLG_CALL(calls, flgObstaclesRelease, calls.context, flat);
}

void move_bodies(Calls& calls) {
    const double times[] = {0, 1, 2.5};
    const double poses[] = {1, 0, 0, 0, 0, 1, 0,  0, 0, 0, 1, 0,  //
                            1, 0, 0, 1, 0, 0, -1, 0, 0, 1, 0, 0,  //
                            0, 0, 1, 1, 1, 0, 0,  2, 0, 1, 0, 0};
    FlgMotionDesc desc = FLG_INIT(calls, flgMotionDescInit);
    desc.key_count = 3;
    desc.times = times;
    desc.poses = poses;
    desc.position_count = 13;
    desc.max_rounds = 10;
    FlgJobOptions options = flgJobOptionsDefaults();
    options.partial_results = 1;
    desc.job = &options;
    for (const bool closed : {false, true}) {
        desc.closed = closed;
        FlgMotion motion{};
        FLG_CALL(calls, flgMotionCreate, calls.context, &desc, calls.out(motion), calls.job());
        calls.finish();
        FlgMotionView view = FLG_INIT(calls, flgMotionViewInit);
        FLG_CALL(calls, flgMotionGetView, calls.context, motion, &view);
        calls.note(view.poses, size_t{12} * view.position_count * sizeof(double));
        FLG_DRAW(calls, flgDebugDrawMotion, motion);
        FLG_CALL(calls, flgMotionRelease, calls.context, motion);
    }
    const double target[] = {0, 0, -4, 1, 0, -4}, eases[] = {0, 1, 0.5, 0.5, 1, 0};
    desc.job = nullptr;
    desc.timing = FLG_MOTION_TIMING_CHORD;
    desc.pacing = FLG_MOTION_PACING_BODY;
    desc.eases = eases;
    desc.max_speed = desc.max_acceleration = desc.max_turn = desc.max_turn_acceleration = 1;
    desc.look = FLG_MOTION_LOOK_TARGET;
    desc.look_points = target;
    desc.look_count = 2;
    desc.bank = 1;
    FlgMotion camera{};
    FLG_CALL(calls, flgMotionCreate, calls.context, &desc, calls.out(camera), calls.job());
    calls.finish();
    FlgMotionView view = FLG_INIT(calls, flgMotionViewInit);
    FLG_CALL(calls, flgMotionGetView, calls.context, camera, &view);
    calls.note(view.poses, size_t{12} * view.position_count * sizeof(double));
    FLG_CALL(calls, flgMotionRelease, calls.context, camera);
}

}  // namespace flg::test
