// SPDX-License-Identifier: MIT
// Manifolds of every kind, and splines on them.
#include "filigree/filigree_spline.h"
#include "hardening/manifold_inputs.h"
#include "hardening/scenarios.h"

namespace flg::test {

namespace {

void look_at(Calls& calls, FlgManifold manifold) {
    FlgManifoldView view = FLG_INIT(calls, flgManifoldViewInit);
    FLG_CALL(calls, flgManifoldGetView, calls.context, manifold, &view);
    calls.note(&view.size, sizeof view.size);
    double point[3] = {0.7, 0.6, 0.5}, distance = 0;
    FLG_CALL(calls, flgManifoldProject, calls.context, manifold, point, 1u, &distance);
    calls.note(point, sizeof point);
    FLG_DRAW(calls, flgDebugDrawManifold, manifold);
}

FlgSpline fit(Calls& calls, FlgManifold manifold, FlgSpline warm_start = {}) {
    const std::vector<double> points = {1, 0.1, 0.1, 0.2, 0.9, 0.3, -0.6, 0.5, 0.6, -0.5, -0.5, 0.5};
    FlgSplineDesc desc = FLG_INIT(calls, flgSplineDescInit);
    desc.manifold = manifold;
    desc.points = points.data();
    desc.point_count = 4;
    desc.node_count = 16;
    desc.max_rounds = 20;
    desc.warm_start = warm_start;
    FlgJobOptions options = flgJobOptionsDefaults();
    options.partial_results = 1;
    desc.job = &options;
    FlgSpline spline{};
    FLG_CALL(calls, flgSplineCreate, calls.context, &desc, calls.out(spline), calls.job());
    return spline;
}

// With a tangent at a point, another that is soft, and as few cubic pieces.
FlgSpline fit_shaped(Calls& calls, FlgManifold manifold) {
    const std::vector<double> points = {1, 0.1, 0.1, 0.2, 0.9, 0.3, -0.6, 0.5, 0.6, -0.5, -0.5, 0.5};
    const double slope[3] = {1, 0.2, -0.4}, softness[4] = {0, 0, 0.1, 0};
    FlgSplineHandle handle = FLG_INIT(calls, flgSplineHandleInit);
    handle.point = 1;
    handle.slope = slope;
    FlgSplineDesc desc = FLG_INIT(calls, flgSplineDescInit);
    desc.manifold = manifold;
    desc.points = points.data();
    desc.point_count = 4;
    desc.node_count = 16;
    desc.handles = &handle;
    desc.handle_count = 1;
    desc.softness = softness;
    desc.key_tolerance = 0.01;
    FlgSpline spline{};
    FLG_CALL(calls, flgSplineCreate, calls.context, &desc, calls.out(spline), calls.job());
    return spline;
}

void look_at(Calls& calls, FlgSpline spline) {
    FlgSplineView view = FLG_INIT(calls, flgSplineViewInit);
    FLG_CALL(calls, flgSplineGetView, calls.context, spline, &view);
    calls.note(view.nodes, size_t{view.ambient} * view.node_count * sizeof(double));
    calls.note(view.key_points, size_t{view.ambient} * view.key_count * sizeof(double));
    FLG_DRAW(calls, flgDebugDrawSpline, spline);
}

FlgManifold make_shape(Calls& calls, FlgManifoldShape shape, const char* name = nullptr) {
    FlgManifoldShapeDesc desc = FLG_INIT(calls, flgManifoldShapeDescInit);
    desc.shape = shape;
    desc.name = name;
    FlgManifold manifold{};
    FLG_CALL(calls, flgManifoldCreateShape, calls.context, &desc, calls.out(manifold));
    return manifold;
}

}  // namespace

void make_manifolds(Calls& calls) {
    const char* const name = FLG_VALUE(calls, flgFormulaGetName, 0u);
    ASSERT_NE(name, nullptr);
    std::vector<FlgManifold> all = {
        make_shape(calls, FLG_MANIFOLD_SHAPE_SPACE), make_shape(calls, FLG_MANIFOLD_SHAPE_PLANE),
        make_shape(calls, FLG_MANIFOLD_SHAPE_SPHERE), make_shape(calls, FLG_MANIFOLD_SHAPE_TORUS),
        make_shape(calls, FLG_MANIFOLD_SHAPE_FORMULA, name)};
    FlgManifoldFunctions functions = FLG_INIT(calls, flgManifoldFunctionsInit);
    functions.ambient = 3;
    functions.dimension = 2;
    functions.project = project_on_sphere;
    functions.tangent_basis = basis_on_sphere;
    const double near[3] = {1, 0, 0.2};
    FlgManifold made{};
    FLG_CALL(calls, flgManifoldCreateHost, calls.context, &functions, near, calls.out(made));
    all.push_back(made);
    FlgPatchFunctions patch = FLG_INIT(calls, flgPatchFunctionsInit);
    patch.evaluate = sphere_patch;
    patch.periodic[0] = 1;
    patch.high[0] = 2 * M_PI;
    patch.low[1] = -1.2;
    patch.high[1] = 1.2;
    FLG_CALL(calls, flgManifoldCreatePatch, calls.context, &patch, calls.out(made));
    all.push_back(made);
    FLG_CALL(calls, flgManifoldCreateImage, calls.context, all[2], 0.5, calls.out(made));
    all.push_back(made);
    for (const FlgManifold manifold : all) {
        look_at(calls, manifold);
        FLG_CALL(calls, flgManifoldRelease, calls.context, manifold);
    }
}

void make_sampled_manifolds(Calls& calls) {
    MeshArrays mesh = sphere(3);
    FlgSurfaceDesc surface = FLG_INIT(calls, flgSurfaceDescInit);
    const FlgMeshView input = mesh.view();
    surface.mesh = &input;
    FlgManifoldFromSurfaceDesc by_mesh = FLG_INIT(calls, flgManifoldFromSurfaceDescInit);
    FLG_CALL(calls, flgSurfaceCreate, calls.context, &surface, calls.out(by_mesh.surface), calls.job());
    FlgManifold made[3] = {};
    FLG_CALL(calls, flgManifoldCreateFromSurface, calls.context, &by_mesh, calls.out(made[0]), calls.job());
    const std::vector<float> points = points_on_sphere(120);
    FlgManifoldFromPointsDesc cloud = FLG_INIT(calls, flgManifoldFromPointsDescInit);
    cloud.points = points.data();
    cloud.point_count = 120;
    FLG_CALL(calls, flgManifoldCreateFromPoints, calls.context, &cloud, calls.out(made[1]), calls.job());
    const std::vector<float> values = distances_from_sphere(8, 0.4);
    FlgManifoldFromGridDesc grid = FLG_INIT(calls, flgManifoldFromGridDescInit);
    for (uint32_t& count : grid.counts) count = 8;
    for (double& x : grid.corner) x = -1.4;
    grid.spacing = 0.4;
    grid.values = values.data();
    FLG_CALL(calls, flgManifoldCreateFromGrid, calls.context, &grid, calls.out(made[2]), calls.job());
    calls.finish();
    for (const FlgManifold manifold : made) {
        look_at(calls, manifold);
        const FlgSpline spline = fit(calls, manifold);
        calls.finish();
        look_at(calls, spline);
        if (manifold.id != made[0].id) continue;
        FlgSplineTraceDesc trace = FLG_INIT(calls, flgSplineTraceDescInit);
        trace.spline = spline;
        FlgSurfaceCurves curves{};
        FLG_CALL(calls, flgSplineTrace, calls.context, &trace, calls.out(curves), calls.job());
        calls.finish();
        calls.note(curves);
        FlgSplineSweepDesc ribbon = FLG_INIT(calls, flgSplineSweepDescInit);
        ribbon.spline = spline;
        ribbon.width = 0.1;
        ribbon.conforms = 1;
        FlgSurface road{};
        FLG_CALL(calls, flgSplineSweep, calls.context, &ribbon, calls.out(road), calls.job());
        calls.finish();
        calls.note(road);
        FlgSplineOffsetDesc offset = FLG_INIT(calls, flgSplineOffsetDescInit);
        offset.spline = spline;
        offset.left = 0.1;
        FlgCurveSet beside{};
        FLG_CALL(calls, flgSplineOffset, calls.context, &offset, calls.out(beside), calls.job());
        calls.finish();
        calls.note(beside);
    }
}

void hang_cables(Calls& calls) {
    FlgObstacle solids[2] = {FLG_INIT(calls, flgObstacleInit), FLG_INIT(calls, flgObstacleInit)};
    solids[0].kind = FLG_OBSTACLE_KIND_HALF_SPACE;
    solids[0].to[2] = 1;
    solids[1].kind = FLG_OBSTACLE_KIND_BOX;
    solids[1].centre[0] = 6;
    solids[1].half[0] = 0.3;
    FlgObstaclesDesc obstacles = FLG_INIT(calls, flgObstaclesDescInit);
    obstacles.obstacles = solids;
    obstacles.obstacle_count = 2;
    const double points[9] = {0, 0, 0.6, 4, 0.2, 0.7, 8, 0, 0.8};
    FlgCableHangDesc cable = FLG_INIT(calls, flgCableHangDescInit);
    FLG_CALL(calls, flgObstaclesCreate, calls.context, &obstacles, calls.out(cable.obstacles), calls.job());
    cable.points = points;
    cable.point_count = 3;
    cable.segments = 12;
    cable.slack = 0.2;
    FlgCurveSet set{};
    FLG_CALL(calls, flgCableHang, calls.context, &cable, calls.out(set), calls.job());
    calls.finish();
    calls.note(set);
    FLG_CALL(calls, flgObstaclesRelease, calls.context, cable.obstacles);
}

void fit_splines(Calls& calls) {
    for (const FlgManifoldShape shape :
         {FLG_MANIFOLD_SHAPE_SPACE, FLG_MANIFOLD_SHAPE_SPHERE, FLG_MANIFOLD_SHAPE_TORUS}) {
        const FlgManifold manifold = make_shape(calls, shape);
        const FlgSpline spline = fit(calls, manifold);
        const FlgSpline warm = fit(calls, manifold, spline);
        const FlgSpline shaped = fit_shaped(calls, manifold);
        FlgSplineSampleDesc curves = FLG_INIT(calls, flgSplineSampleDescInit);
        curves.spline = warm;
        FlgCurveSet set{};
        FLG_CALL(calls, flgSplineSample, calls.context, &curves, calls.out(set), calls.job());
        calls.finish();
        look_at(calls, spline);
        look_at(calls, warm);
        look_at(calls, shaped);
        calls.note(set);
        FLG_CALL(calls, flgSplineRelease, calls.context, spline);
    }
}

}  // namespace flg::test
