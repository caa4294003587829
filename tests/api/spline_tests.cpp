// SPDX-License-Identifier: MIT
// Splines behind the C ABI: what they give on every kind of manifold.
#include "api/spline_inputs.h"

namespace flg::test {
namespace {

double largest_distance(const MadeSpline& a, const MadeSpline& b) {
    EXPECT_EQ(a.view.node_count, b.view.node_count);
    double largest = 0;
    for (uint32_t i = 0; i < a.view.node_count; ++i) largest = std::max(largest, distance(a.node(i), b.node(i)));
    return largest;
}

// The torus of radii 2 and 0.8 as the host knows it by its angles.
void torus_patch(void*, double u, double v, double* out) {
    const double cu = std::cos(u), su = std::sin(u), cv = std::cos(v), sv = std::sin(v), r = 2 + 0.8 * cv;
    const double numbers[18] = {r * cu,         r * su,         0.8 * sv, -r * su,        r * cu,         0,
                                -0.8 * sv * cu, -0.8 * sv * su, 0.8 * cv, -r * cu,        -r * su,        0,
                                0.8 * sv * su,  -0.8 * sv * cu, 0,        -0.8 * cv * cu, -0.8 * cv * su, -0.8 * sv};
    std::copy_n(numbers, 18, out);
}

// The same as functions of a manifold, without a second form.
int32_t project_torus(void*, double* x, double*) {
    const double q = std::hypot(x[0], x[1]), d = std::hypot(q - 2, x[2]);
    if (q == 0 || d == 0) return 0;
    const double r = 2 + 0.8 * (q - 2) / d;
    x[2] *= 0.8 / d;
    x[0] *= r / q;
    x[1] *= r / q;
    return 1;
}
void torus_basis(void*, const double* x, double*, double* basis) {
    const double q = std::hypot(x[0], x[1]);
    const double c = (q - 2) / 0.8, s = x[2] / 0.8;
    const double rows[6] = {-x[1] / q, x[0] / q, 0, -s * x[0] / q, -s * x[1] / q, c};
    std::copy_n(rows, 6, basis);
}

TEST(SplineApi, OneTorusAsFormulaPatchFunctionsAndMesh) {
    const Host host(2);
    FlgPatchFunctions patch = flgPatchFunctionsDefaults();
    patch.periodic[0] = patch.periodic[1] = 1;
    patch.high[0] = patch.high[1] = 2 * M_PI;
    patch.size = 5.6;
    patch.evaluate = torus_patch;
    FlgManifold by_patch{}, by_functions{};
    ASSERT_EQ(flgManifoldCreatePatch(host.context, &patch, &by_patch), FLG_OK) << flgErrorGetMessage();
    FlgManifoldFunctions functions = flgManifoldFunctionsDefaults();
    functions.project = project_torus;
    functions.tangent_basis = torus_basis;
    functions.size = 5.6;
    const double near[3] = {3, 0, 0};
    ASSERT_EQ(flgManifoldCreateHost(host.context, &functions, near, &by_functions), FLG_OK) << flgErrorGetMessage();
    const FlgManifold by_formula = shape_manifold(host, FLG_MANIFOLD_SHAPE_TORUS, 2, 0.8);
    const FlgManifold by_mesh = mesh_manifold(host, torus_mesh(160, 64, 2, 0.8));

    const std::vector<double> points = torus_points(8, 2, 0.8);
    std::vector<MadeSpline> made;
    for (const FlgManifold manifold : {by_formula, by_patch, by_functions, by_mesh}) {
        FlgSplineDesc desc = spline_desc(manifold, points);
        desc.closed = 1;
        desc.tolerance = 1e-8;
        made.push_back(make_spline(host, desc));
        ASSERT_EQ(made.back().result, FLG_OK) << made.back().error;
        EXPECT_EQ(made.back().view.ending, FLG_SPLINE_ENDING_CONVERGED);
        EXPECT_EQ(made.back().view.node_count, 256u);
        EXPECT_LE(made.back().view.residual, 1e-8);
    }
    EXPECT_LT(largest_distance(made[0], made[1]), 1e-8);
    EXPECT_LT(largest_distance(made[0], made[2]), 1e-6);
    // The mesh's smooth surface is off by the fourth power of its edges.
    EXPECT_LT(largest_distance(made[0], made[3]), 1e-3);
    EXPECT_NEAR(made[3].view.bending, made[0].view.bending, 1e-3 * made[0].view.bending);
    ASSERT_NE(made[3].view.normals, nullptr);
    for (uint32_t i = 0; i < 256; i += 16) {
        const Point p = made[3].node(i);
        const double q = std::hypot(p[0], p[1]);
        const double outwards[3] = {p[0] / q * (q - 2) / 0.8, p[1] / q * (q - 2) / 0.8, p[2] / 0.8};
        double cosine = 0;
        for (int c = 0; c < 3; ++c) cosine += outwards[c] * double{made[3].view.normals[3 * i + c]};
        EXPECT_GT(cosine, 0.999);
    }
}

TEST(SplineApi, PointsOffTheSurfaceAreProjectedAndToldHowFar) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 2);
    const std::vector<double> points = {3, 0, 0, 0, 1.5, 0, 0, 0, 2};
    const MadeSpline made = make_spline(host, spline_desc(sphere, points));
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    const double expected[3] = {1, 0.5, 0};
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(made.view.offsets[i], expected[i], 1e-12);
    EXPECT_NEAR(made.view.largest_offset, 1, 1e-12);
    EXPECT_NEAR(made.node(made.view.point_nodes[1])[1], 2, 1e-12);
    for (uint32_t i = 0; i < made.view.node_count; ++i) EXPECT_NEAR(distance(made.node(i), {0, 0, 0}), 2, 1e-12);
}

TEST(SplineApi, TwoPointsGiveAGeodesicAndAntipodesAHalfCircle) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 1);
    for (const FlgSplineEnergy energy : {FLG_SPLINE_ENERGY_E1, FLG_SPLINE_ENERGY_E2}) {
        const std::vector<double> two = {1, 0, 0, 0, 1, 0}, antipodes = {1, 0, 0, -1, 0, 0};
        FlgSplineDesc desc = spline_desc(sphere, two);
        desc.energy = energy;
        const MadeSpline quarter = make_spline(host, desc);
        ASSERT_EQ(quarter.result, FLG_OK) << quarter.error;
        EXPECT_NEAR(quarter.view.length, M_PI / 2, 1e-3);
        for (uint32_t i = 0; i < quarter.view.node_count; ++i) EXPECT_NEAR(quarter.node(i)[2], 0, 1e-9);
        desc = spline_desc(sphere, antipodes);
        desc.energy = energy;
        const MadeSpline half = make_spline(host, desc), again = make_spline(host, desc);
        ASSERT_EQ(half.result, FLG_OK) << half.error;
        EXPECT_NEAR(half.view.length, M_PI, 0.01);
        EXPECT_EQ(largest_distance(half, again), 0);
    }
}

TEST(SplineApi, TheSameBitsUnderAnyWorkersAndBudgets) {
    std::vector<std::string> all;
    for (const uint32_t workers : {0u, 1u, 3u}) {
        for (const uint32_t budget : {FLG_UNLIMITED, 50u}) {
            const Host host(workers);
            const std::vector<double> points = torus_points(7, 2, 0.8);
            const FlgManifold mesh = mesh_manifold(host, torus_mesh(60, 24, 2, 0.8));
            const MadeSpline made = make_spline(host, spline_desc(mesh, points), budget);
            ASSERT_EQ(made.result, FLG_OK) << made.error;
            all.emplace_back(reinterpret_cast<const char*>(made.view.nodes), sizeof(double) * 3 * made.view.node_count);
        }
    }
    for (const std::string& bits : all) EXPECT_EQ(bits, all[0]);
}

TEST(SplineApi, RoundsCanBeWatched) {
    const Host host;
    const FlgManifold torus = shape_manifold(host, FLG_MANIFOLD_SHAPE_TORUS, 2, 0.8);
    const std::vector<double> points = torus_points(9, 2, 0.8);
    FlgSplineDesc desc = spline_desc(torus, points);
    FlgJobOptions options = flgJobOptionsDefaults();
    options.partial_results = 1;
    desc.job = &options;
    desc.node_count = 2000;
    FlgSpline spline{};
    FlgJob job{};
    ASSERT_EQ(flgSplineCreate(host.context, &desc, &spline, &job), FLG_OK) << flgErrorGetMessage();
    uint32_t seen = 0, last_rounds = 0;
    FlgSplineView view = flgSplineViewDefaults();
    for (int tick = 0; tick < 100000; ++tick) {
        ASSERT_EQ(flgContextTick(host.context, 20, nullptr), FLG_OK);
        const FlgResult result = flgSplineGetView(host.context, spline, &view);
        if (result != FLG_OK) continue;
        if (view.ending != FLG_SPLINE_ENDING_RUNNING) break;
        if (view.rounds != last_rounds) ++seen;
        last_rounds = view.rounds;
        EXPECT_EQ(view.normals, nullptr);
        for (uint32_t i = 0; i < view.node_count; i += 100) {
            const double* const p = view.nodes + 3 * i;
            EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]) - 2, p[2]), 0.8, 1e-9);
        }
    }
    EXPECT_GE(seen, 2u);
    EXPECT_EQ(view.ending, FLG_SPLINE_ENDING_CONVERGED);
    EXPECT_EQ(view.node_count, 2000u);
}

// The first state is over the triangles: exactly on them, through the points, and the optimizer's rounds follow.
TEST(SplineApi, OnAMeshACurveOverItsTrianglesIsSeenFirst) {
    const Host host;
    const MeshArrays mesh = torus_mesh(60, 24, 2, 0.8);
    const FlgManifold manifold = mesh_manifold(host, mesh);
    std::vector<double> points;
    for (uint32_t i = 0; i < 8; ++i) {
        const size_t vertex = (7 * i) % 60 * 24 + (5 * i) % 24;
        for (size_t c = 0; c < 3; ++c) points.push_back(mesh.positions[3 * vertex + c]);
    }
    FlgSplineDesc desc = spline_desc(manifold, points);
    FlgJobOptions options = flgJobOptionsDefaults();
    options.partial_results = 1;
    desc.job = &options;
    FlgSpline spline{};
    ASSERT_EQ(flgSplineCreate(host.context, &desc, &spline, nullptr), FLG_OK) << flgErrorGetMessage();
    FlgSplineView view = flgSplineViewDefaults();
    bool is_first = true;
    for (int tick = 0; tick < 100000 && (is_first || view.ending == FLG_SPLINE_ENDING_RUNNING); ++tick) {
        ASSERT_EQ(flgContextTick(host.context, 20, nullptr), FLG_OK);
        if (flgSplineGetView(host.context, spline, &view) != FLG_OK || !is_first) continue;
        is_first = false;
        EXPECT_NE(view.on_triangles, 0u);
        EXPECT_EQ(view.ending, FLG_SPLINE_ENDING_RUNNING);
        ASSERT_EQ(view.node_count, 7 * 32 + 1u);
        for (uint32_t k = 0; k < 8; ++k) {
            for (size_t c = 0; c < 3; ++c) EXPECT_EQ(view.nodes[3 * 32 * k + c], points[3 * k + c]);
        }
        EXPECT_GT(view.length, 0);
        EXPECT_GT(view.bending, 0);
    }
    EXPECT_EQ(view.on_triangles, 0u);
    EXPECT_EQ(view.ending, FLG_SPLINE_ENDING_CONVERGED);

    desc.job = nullptr;
    desc.on_triangles = desc.surface_points = 1;
    const MadeSpline laid = make_spline(host, desc);
    ASSERT_EQ(laid.result, FLG_OK) << laid.error;
    EXPECT_EQ(laid.view.ending, FLG_SPLINE_ENDING_TRIANGLES);
    EXPECT_NE(laid.view.normals, nullptr);
    EXPECT_EQ(laid.view.point_nodes[3], 96u);
    EXPECT_LT(laid.view.largest_moved, 1e-9);
    EXPECT_NEAR(laid.view.length, view.length, 0.05 * view.length);

    // Dragged: far segments stay, to the bit.
    points[12] += 0.1;
    desc.warm_start = laid.spline;
    const MadeSpline dragged = make_spline(host, desc);
    desc.warm_start = {};
    const MadeSpline anew = make_spline(host, desc);
    EXPECT_EQ(largest_distance(dragged, anew), 0);
    EXPECT_EQ(distance(dragged.node(7 * 32 - 5), laid.node(7 * 32 - 5)), 0);
    EXPECT_GT(distance(dragged.node(128), laid.node(128)), 0.01);
}

TEST(SplineApi, CurvesOverTrianglesNeedAMesh) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 1);
    const std::vector<double> points = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    FlgSplineDesc desc = spline_desc(sphere, points);
    desc.on_triangles = 1;
    EXPECT_EQ(make_spline(host, desc).result, FLG_ERROR_INVALID_ARGUMENT);
    desc.on_triangles = 0;
    desc.surface_points = 1;
    EXPECT_EQ(make_spline(host, desc).result, FLG_ERROR_INVALID_ARGUMENT);
    desc.surface_points = 0;
    const MadeSpline made = make_spline(host, desc);
    FlgSplineTraceDesc trace = flgSplineTraceDefaults();
    trace.spline = made.spline;
    FlgSurfaceCurves curves{};
    EXPECT_EQ(flgSplineTrace(host.context, &trace, &curves, nullptr), FLG_ERROR_INVALID_ARGUMENT);
}

// Each piece of the result lies in one triangle; cut along a closed one, a ring comes apart into regions.
TEST(SplineApi, IsLaidOntoTrianglesToCutThere) {
    const Host host;
    const FlgSurface surface = mesh_surface(host, torus_mesh(40, 16, 2, 0.8));
    const FlgManifold manifold = mesh_manifold(host, surface);
    std::vector<double> points;
    for (int i = 0; i < 5; ++i) {
        const double a = 0.4 * std::cos(1.25 * i), b = 0.7 * std::sin(1.25 * i), r = 2 + 0.8 * std::cos(b);
        points.insert(points.end(), {r * std::cos(a), r * std::sin(a), 0.8 * std::sin(b)});
    }
    FlgSplineDesc desc = spline_desc(manifold, points);
    desc.closed = desc.surface_points = 1;
    const MadeSpline made = make_spline(host, desc);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    ASSERT_NE(made.view.surface_points, nullptr);
    EXPECT_GT(made.view.largest_moved, 0);
    EXPECT_LT(made.view.largest_moved, 0.03);
    FlgSplineTraceDesc trace = flgSplineTraceDefaults();
    trace.spline = made.spline;
    FlgSurfaceCurves curves{};
    ASSERT_EQ(flgSplineTrace(host.context, &trace, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgSurfaceCurvesView traced = flgSurfaceCurvesViewDefaults();
    ASSERT_EQ(flgSurfaceCurvesGetView(host.context, curves, &traced), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(traced.curve_count, 1u);
    EXPECT_EQ(traced.curve_flags[0], FLG_CURVE_CLOSED);
    EXPECT_GE(traced.curve_offsets[1], made.view.node_count);
    EXPECT_NEAR(traced.curve_values[0], made.view.length, 0.01 * made.view.length);
    FlgSurfaceCutCurvesDesc cut = flgSurfaceCutCurvesDefaults();
    cut.curves = curves;
    FlgJob job{};
    ASSERT_EQ(flgSurfaceCutCurves(host.context, &cut, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgJobStatus status = flgJobStatusDefaults();
    ASSERT_EQ(flgJobGetStatus(host.context, job, &status), FLG_OK);
    EXPECT_EQ(status.result, FLG_OK) << status.error;
    // After the cut there are more triangles, and a spline on the same manifold still finds them.
    const MadeSpline again = make_spline(host, desc);
    ASSERT_EQ(again.result, FLG_OK) << again.error;
    EXPECT_NEAR(again.view.largest_moved, made.view.largest_moved, 1e-4);
}

TEST(SplineApi, DraggingAPointGoesOnFromTheLastCurve) {
    const Host host;
    const FlgManifold torus = shape_manifold(host, FLG_MANIFOLD_SHAPE_TORUS, 2, 0.8);
    std::vector<double> points = torus_points(10, 2, 0.8);
    FlgSplineDesc desc = spline_desc(torus, points);
    const MadeSpline first = make_spline(host, desc);
    for (int c = 0; c < 3; ++c) points[9 + c] += 0.03;
    const MadeSpline cold = make_spline(host, desc);
    desc.warm_start = first.spline;
    const MadeSpline warm = make_spline(host, desc);
    ASSERT_EQ(warm.result, FLG_OK) << warm.error;
    EXPECT_LE(warm.view.rounds, 4u);
    // Nodes are shared among the segments as they were before.
    EXPECT_NEAR(warm.view.length, cold.view.length, 1e-3 * cold.view.length);
    EXPECT_NEAR(warm.view.bending, cold.view.bending, 0.05 * cold.view.bending);
    EXPECT_EQ(warm.view.point_nodes[3], first.view.point_nodes[3]);
    for (int c = 0; c < 3; ++c)
        EXPECT_EQ(warm.node(warm.view.point_nodes[3])[c], cold.node(cold.view.point_nodes[3])[c]);
    // One that does not fit is not used.
    points.resize(27);
    FlgSplineDesc fewer = spline_desc(torus, points);
    const MadeSpline alone = make_spline(host, fewer);
    fewer.warm_start = first.spline;
    EXPECT_EQ(largest_distance(make_spline(host, fewer), alone), 0);
}

// Far enough that nodes would bunch: they are placed anew.
TEST(SplineApi, NodesOfADraggedCurveStayEven) {
    const Host host;
    const FlgManifold plane = shape_manifold(host, FLG_MANIFOLD_SHAPE_PLANE);
    std::vector<double> points = {0, 0, 0, 1, 0.3, 0, 2, 0, 0};
    MadeSpline last = make_spline(host, spline_desc(plane, points));
    for (int step = 0; step < 40; ++step) {
        points[3] += 0.022;
        FlgSplineDesc desc = spline_desc(plane, points);
        desc.warm_start = last.spline;
        last = make_spline(host, desc);
        ASSERT_EQ(last.result, FLG_OK) << last.error;
        EXPECT_EQ(last.view.node_count, 65u);
        double least = HUGE_VAL, largest = 0;
        for (uint32_t i = 1; i < last.view.node_count; ++i) {
            least = std::min(least, distance(last.node(i), last.node(i - 1)));
            largest = std::max(largest, distance(last.node(i), last.node(i - 1)));
        }
        EXPECT_LT(largest, 6 * least) << step;
    }
    const MadeSpline cold = make_spline(host, spline_desc(plane, points));
    EXPECT_NEAR(last.view.bending, cold.view.bending, 0.05 * cold.view.bending);
}

// Chords between these lead through the tube.
TEST(SplineApi, WhereChordsLeadAstrayTheFirstCurveWalks) {
    const Host host;
    const FlgManifold torus = shape_manifold(host, FLG_MANIFOLD_SHAPE_TORUS, 1, 0.3);
    const std::vector<double> equator = {1.3, 0, 0, 0, 1.3, 0, -1.3, 0, 0, 0, -1.3, 0};
    for (const FlgSplineStart start : {FLG_SPLINE_START_GEODESIC, FLG_SPLINE_START_PROJECTED}) {
        FlgSplineDesc desc = spline_desc(torus, equator);
        desc.closed = 1;
        desc.start = start;
        const MadeSpline made = make_spline(host, desc);
        ASSERT_EQ(made.result, FLG_OK) << made.error;
        for (uint32_t i = 0; i < made.view.node_count; ++i) {
            EXPECT_NEAR(std::hypot(made.node(i)[0], made.node(i)[1]), 1.3, 1e-6);
        }
    }
}

// A ring as a scanner sees it.
MeshArrays scanned_torus(float noise) {
    MeshArrays mesh = torus_mesh(240, 96, 2, 0.8);
    uint32_t state = 1;
    for (float& c : mesh.positions) {
        state = state * 1664525u + 1013904223u;
        c += noise * (static_cast<float>(state >> 8) / 16777216.0f - 0.5f);
    }
    return mesh;
}

// Curves come to rest, and say which of their nodes are held at edges.
TEST(SplineApi, RoughMeshesHaveCurvesToo) {
    const Host host(2);
    const FlgManifold rough = mesh_manifold(host, scanned_torus(0.045f));
    uint32_t held = 0;
    for (uint32_t stroke = 0; stroke < 16; ++stroke) {
        std::vector<double> points;
        for (uint32_t i = 0; i < 7; ++i) {
            const double a = 0.3 * stroke + 0.25 * i, b = 0.7 * std::sin(1.7 * i + stroke), r = 2 + 0.8 * std::cos(b);
            points.insert(points.end(), {r * std::cos(a), r * std::sin(a), 0.8 * std::sin(b)});
        }
        FlgSplineDesc desc = spline_desc(rough, points);
        desc.tolerance = 1e-4;
        const MadeSpline made = make_spline(host, desc);
        ASSERT_EQ(made.result, FLG_OK) << made.error;
        EXPECT_EQ(made.view.ending, FLG_SPLINE_ENDING_CONVERGED) << stroke;
        held += made.view.held_count;
        for (uint32_t k = 0; k < made.view.held_count; ++k) {
            EXPECT_LT(made.view.held_nodes[k], made.view.node_count);
            if (k > 0) {
                EXPECT_GT(made.view.held_nodes[k], made.view.held_nodes[k - 1]);
            }
            for (uint32_t p = 0; p < 7; ++p) EXPECT_NE(made.view.held_nodes[k], made.view.point_nodes[p]);
        }
    }
    EXPECT_GT(held, 0u);
}

// Through a scale of some edges the noise is gone, and with it the edges.
TEST(SplineApi, ThroughAScaleRoughMeshesAreSmooth) {
    const Host host(2);
    const FlgSurface surface = mesh_surface(host, scanned_torus(0.03f));
    FlgManifoldFromSurfaceDesc smooth = flgManifoldFromSurfaceDefaults();
    smooth.surface = surface;
    smooth.smoothing_scale = 0.25;
    FlgManifold seen{};
    ASSERT_EQ(flgManifoldCreateFromSurface(host.context, &smooth, &seen, nullptr), FLG_OK) << flgErrorGetMessage();
    const std::vector<double> points = torus_points(8, 2, 0.8);
    const MadeSpline made = make_spline(host, spline_desc(seen, points));
    const MadeSpline rough = make_spline(host, spline_desc(mesh_manifold(host, surface), points));
    const MadeSpline exact =
        make_spline(host, spline_desc(shape_manifold(host, FLG_MANIFOLD_SHAPE_TORUS, 2, 0.8), points));
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    EXPECT_EQ(made.view.ending, FLG_SPLINE_ENDING_CONVERGED);
    EXPECT_EQ(made.view.held_count, 0u);
    EXPECT_EQ(made.view.held_nodes, nullptr);
    EXPECT_LT(made.view.rounds, rough.view.rounds);
    EXPECT_LT(largest_distance(made, exact), 0.03);
    EXPECT_NEAR(made.view.bending, exact.view.bending, 0.05 * exact.view.bending);
    EXPECT_GT(rough.view.bending, 1.2 * exact.view.bending);
}

TEST(SplineApi, RoundsAreNotExceeded) {
    const Host host;
    const FlgManifold torus = shape_manifold(host, FLG_MANIFOLD_SHAPE_TORUS, 2, 0.8);
    const std::vector<double> points = torus_points(9, 2, 0.8);
    for (const uint32_t rounds : {1u, 2u, 3u}) {
        FlgSplineDesc desc = spline_desc(torus, points);
        desc.node_count = 600;
        desc.max_rounds = rounds;
        desc.tolerance = 1e-12;
        const MadeSpline made = make_spline(host, desc);
        ASSERT_EQ(made.result, FLG_OK) << made.error;
        EXPECT_EQ(made.view.rounds, rounds);
        EXPECT_EQ(made.view.ending, FLG_SPLINE_ENDING_ROUNDS);
        EXPECT_EQ(made.view.node_count, 600u);
    }
}

TEST(SplineApi, AsManyPointsAsThereMayBe) {
    const Host host;
    const FlgManifold plane = shape_manifold(host, FLG_MANIFOLD_SHAPE_PLANE);
    std::vector<double> points;
    for (int i = 0; i < 40000; ++i) points.insert(points.end(), {0.01 * i, std::sin(0.01 * i), 0});
    FlgSplineDesc desc = spline_desc(plane, points);
    desc.max_rounds = 2;
    const MadeSpline made = make_spline(host, desc);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    EXPECT_EQ(made.view.node_count, FLG_SPLINE_MAX_NODES);
}

TEST(SplineApi, ACurveIsMadeFairAndSubdivided) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 1);
    std::vector<double> curve, held;
    const std::vector<uint32_t> knots = {0, 20, 40};
    for (int i = 0; i <= 40; ++i) {
        const double a = 0.05 * i, z = 0.3 * std::sin(a) + 0.02 * std::sin(40.0 * i * i);
        curve.insert(curve.end(), {std::cos(a), std::sin(a), z});
        if (i % 20 == 0) held.insert(held.end(), curve.end() - 3, curve.end());
    }
    FlgSplineDesc desc = spline_desc(sphere, held);
    desc.curve = curve.data();
    desc.curve_count = 41;
    desc.curve_knots = knots.data();
    desc.max_rounds = 1;
    const MadeSpline fair = make_spline(host, desc);
    ASSERT_EQ(fair.result, FLG_OK) << fair.error;
    EXPECT_EQ(fair.view.node_count, 41u);
    EXPECT_EQ(fair.view.ending, FLG_SPLINE_ENDING_ROUNDS);
    desc.max_rounds = 200;
    desc.subdivisions = 2;
    const MadeSpline fine = make_spline(host, desc);
    ASSERT_EQ(fine.result, FLG_OK) << fine.error;
    EXPECT_EQ(fine.view.node_count, 161u);
    EXPECT_EQ(fine.view.point_nodes[1], 80u);
    EXPECT_EQ(fine.view.ending, FLG_SPLINE_ENDING_CONVERGED);
}

TEST(SplineApi, AStrokeOnAMeshIsStylizedInItsFrame) {
    const Host host;
    const FlgManifold mesh = mesh_manifold(host, torus_mesh(80, 32, 2, 0.8));
    const std::vector<double> points = torus_points(8, 2, 0.8);
    const MadeSpline made = make_spline(host, spline_desc(mesh, points));
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    FlgSplineSampleDesc copy = flgSplineSampleDefaults();
    copy.spline = made.spline;
    copy.height = 0.01f;
    FlgCurveSet set{};
    ASSERT_EQ(flgSplineSample(host.context, &copy, &set, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const FlgCurveSetView view = host.view_of(set);
    const FlgColumn* const normals = find_column(view, FLG_ATTRIBUTE_NORMAL);
    ASSERT_NE(normals, nullptr);
    ASSERT_NE(find_column(view, FLG_ATTRIBUTE_TIME), nullptr);
    EXPECT_EQ(view.curve_offsets[1], made.view.node_count);

    FlgStyleDesc style_desc = flgStyleDefaults();
    style_desc.style = host.create(coil());
    FlgStyle style{};
    ASSERT_EQ(flgStyleCreate(host.context, &style_desc, &style, nullptr), FLG_OK) << flgErrorGetMessage();
    FlgCurveSetStylizeDesc stylize = flgCurveSetStylizeDefaults();
    stylize.style = style;
    stylize.target = set;
    stylize.frame = FLG_FRAME_METHOD_SUPPLIED;
    stylize.scale = 0.2f;
    FlgCurveSet stylized{};
    FlgJob job{};
    ASSERT_EQ(flgCurveSetStylize(host.context, &stylize, &stylized, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_OK);
    EXPECT_GT(host.view_of(stylized).curve_offsets[1], 100u);
}

// Each of two shortest curves is the shortest in its own metric: in space, and with the normals, which turn most over a
// hill.
TEST(SplineApi, NormalsAmongObstaclesAreTheSurfaces) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE);
    FlgObstacle ball = flgObstacleDefaults();
    ball.centre[0] = 1;
    ball.radius = 0.3;
    const FlgObstacles obstacles = make_obstacles(host, {ball});
    const std::vector<double> points = {0.6, 0.8, 0.05, 0.6, -0.8, 0.05, -0.8, -0.6, 0.3};
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = sphere;
    desc.points = points.data();
    desc.point_count = 3;
    desc.obstacles = obstacles;
    FlgSpline spline{};
    ASSERT_EQ(flgSplineCreate(host.context, &desc, &spline, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgSplineView view = flgSplineViewDefaults();
    ASSERT_EQ(flgSplineGetView(host.context, spline, &view), FLG_OK) << flgErrorGetMessage();
    for (uint32_t i = 0; i < view.node_count; ++i) {
        for (size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(view.normals[3 * i + c], view.nodes[3 * i + c], 1e-6) << "node " << i << ", coordinate " << c;
    }
}

TEST(SplineApi, ShortestCurvesOfTheImageManifoldTurnTheirNormalsLess) {
    const Host host;
    const auto height = [](double x, double y) { return 0.5 * std::exp(-8 * (x * x + (y - 0.15) * (y - 0.15))); };
    const FlgManifold hill =
        mesh_manifold(host, grid(100, 100, [&](double x, double y) {
                          return Point{3 * (x - 0.5), 3 * (y - 0.5), height(3 * (x - 0.5), 3 * (y - 0.5))};
                      }));
    host.finish();
    FlgManifold image{};
    constexpr double weight = 1;
    ASSERT_EQ(flgManifoldCreateImage(host.context, hill, weight, &image), FLG_OK) << flgErrorGetMessage();
    const std::vector<double> points = {-1, 0, 0, 1, 0, 0};
    FlgSplineDesc plain = spline_desc(hill, points), sensitive = spline_desc(image, points);
    plain.energy = sensitive.energy = FLG_SPLINE_ENERGY_E1;
    const MadeSpline a = make_spline(host, plain), b = make_spline(host, sensitive);
    ASSERT_EQ(a.result, FLG_OK) << a.error;
    ASSERT_EQ(b.result, FLG_OK) << b.error;
    EXPECT_EQ(b.view.ambient, 3u);
    const auto normal = [&](const Point& p) {
        const double dx = -16 * p[0] * height(p[0], p[1]), dy = -16 * (p[1] - 0.15) * height(p[0], p[1]),
                     n = std::hypot(dx, dy, 1.0);
        return Point{-dx / n, -dy / n, 1 / n};
    };
    const auto length = [&](const MadeSpline& made, double of_normals) {
        double sum = 0;
        for (uint32_t i = 1; i < made.view.node_count; ++i) {
            const Point p = made.node(i - 1), q = made.node(i);
            sum += std::hypot(distance(p, q), of_normals * distance(normal(p), normal(q)));
        }
        return sum;
    };
    EXPECT_LT(length(a, 0), length(b, 0));
    EXPECT_LT(length(b, weight), 0.98 * length(a, weight));
}

TEST(SplineApi, CancelledAndFailedJobsLeaveNothing) {
    const Host host;
    const FlgManifold torus = shape_manifold(host, FLG_MANIFOLD_SHAPE_TORUS, 2, 0.8);
    const std::vector<double> points = torus_points(9, 2, 0.8);
    FlgSplineDesc desc = spline_desc(torus, points);
    desc.node_count = 100000;
    FlgSpline spline{};
    FlgJob job{};
    ASSERT_EQ(flgSplineCreate(host.context, &desc, &spline, &job), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(flgContextTick(host.context, 500, nullptr), FLG_OK);
    ASSERT_EQ(flgJobCancel(host.context, job), FLG_OK);
    host.finish();
    FlgSplineView view = flgSplineViewDefaults();
    EXPECT_EQ(flgSplineGetView(host.context, spline, &view), FLG_ERROR_CANCELLED);
    // A curve that begins at a cancelled one begins anew.
    desc.node_count = 0;
    desc.warm_start = spline;
    EXPECT_EQ(make_spline(host, desc).result, FLG_OK);
}

// Dragged around a torus, a geodesic goes on around the hole; where that is much longer than the way back, it jumps if
// it may, and says so.
TEST(Splines, SeekLowerJumpsWhereAnotherCurveIsClearlyBetter) {
    const Host host;
    const FlgManifold torus = shape_manifold(host, FLG_MANIFOLD_SHAPE_TORUS, 1, 0.3);
    for (const uint32_t seeks : {0u, 1u}) {
        FlgSpline last{};
        uint32_t jumps = 0;
        double length = 0;
        for (uint32_t step = 0; step <= 13; ++step) {
            const double a = (40 + 20.0 * step) * M_PI / 180;
            const std::vector<double> points = {1.3, 0, 0, 1.3 * std::cos(a), 1.3 * std::sin(a), 0};
            FlgSplineDesc desc = spline_desc(torus, points);
            desc.energy = FLG_SPLINE_ENERGY_E1;
            const MadeSpline cold = make_spline(host, desc);
            desc.warm_start = last;
            desc.seek_lower = seeks;
            const MadeSpline made = make_spline(host, desc);
            ASSERT_EQ(made.result, FLG_OK) << made.error;
            jumps += made.view.jumped;
            last = made.spline;
            length = made.view.length;
            if (seeks != 0) {
                EXPECT_LT(made.view.energy, 1.053 * cold.view.energy) << step;
            }
            if (made.view.jumped != 0) {
                EXPECT_EQ(made.view.energy, cold.view.energy);
            }
        }
        EXPECT_EQ(jumps > 0, seeks != 0);
        // To 300 degrees: the long way, or back over 60.
        EXPECT_EQ(length > 3, seeks == 0) << length;
    }
}

}  // namespace
}  // namespace flg::test
