// SPDX-License-Identifier: MIT
// Isolines, streams, paths and lifted curves behind the C ABI, against closed forms.
#include "api/surface_inputs.h"

namespace flg::test {
namespace {

double along_x(const Point& p) {
    return p[0];
}

// Each point but the last also lies, as the next one's start, in the triangle that it names.
void expect_stretches_in_triangles(const FlgSurfaceView& surface, const FlgSurfaceCurvesView& curves) {
    for (uint32_t c = 0; c < curves.curve_count; ++c) {
        const uint32_t first = curves.curve_offsets[c], end = curves.curve_offsets[c + 1];
        const bool closed = (curves.curve_flags[c] & FLG_CURVE_CLOSED) != 0;
        for (uint32_t i = first; i < end - (closed ? 0 : 1); ++i) {
            const uint32_t next = i + 1 == end ? first : i + 1;
            const Point q = point_at(surface, curves.points[next]);
            const uint32_t* corners = surface.mesh->triangles + 3 * size_t{curves.points[i].triangle};
            const Point a = vertex_at(surface, corners[0]), b = vertex_at(surface, corners[1]),
                        c3 = vertex_at(surface, corners[2]);
            const auto area = [](const Point& p, const Point& u, const Point& v) {
                const Point e = {u[0] - p[0], u[1] - p[1], u[2] - p[2]}, f = {v[0] - p[0], v[1] - p[1], v[2] - p[2]};
                return 0.5 *
                       distance({e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]}, {});
            };
            EXPECT_NEAR(area(q, a, b) + area(q, b, c3) + area(q, c3, a), area(a, b, c3), 1e-6)
                << "curve " << c << ", point " << i;
        }
    }
}

double length_of(const FlgSurfaceView& surface, const FlgSurfaceCurvesView& curves, uint32_t curve) {
    const uint32_t first = curves.curve_offsets[curve], end = curves.curve_offsets[curve + 1];
    double length = 0;
    for (uint32_t i = first; i + 1 < end; ++i) {
        length += distance(point_at(surface, curves.points[i]), point_at(surface, curves.points[i + 1]));
    }
    if ((curves.curve_flags[curve] & FLG_CURVE_CLOSED) != 0) {
        length += distance(point_at(surface, curves.points[end - 1]), point_at(surface, curves.points[first]));
    }
    return length;
}

FlgSurfaceCurves trace_paths(const SurfaceHost& host, FlgSurface surface, const std::vector<FlgSurfacePoint>& points,
                             const std::vector<uint32_t>& offsets, bool closed = false, FlgJob* job = nullptr) {
    FlgFieldTracePathsDesc desc = flgFieldTracePathsDefaults();
    desc.surface = surface;
    desc.points = points.data();
    desc.path_offsets = offsets.data();
    desc.path_count = static_cast<uint32_t>(offsets.size()) - 1;
    desc.closed = closed ? 1 : 0;
    FlgSurfaceCurves curves{};
    EXPECT_EQ(flgFieldTracePaths(host.context, &desc, &curves, job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    return curves;
}

TEST(TracingApi, IsolinesHaveTheirValueAndTheHigherOnesToTheirLeft) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(7));
    const FlgSurfaceView mesh = host.view(surface);
    const std::vector<float> levels = {0.1f, 0.55f, 0.9f};
    const FlgSurfaceCurvesView lines = host.view(host.isolines(host.field(surface, along_x), levels));
    ASSERT_EQ(lines.curve_count, 3u);
    EXPECT_EQ(lines.revision, 0u);
    expect_stretches_in_triangles(mesh, lines);
    for (uint32_t c = 0; c < 3; ++c) {
        EXPECT_EQ(lines.curve_flags[c], 0);
        EXPECT_EQ(lines.curve_values[c], levels[c]);
        for (uint32_t i = lines.curve_offsets[c]; i < lines.curve_offsets[c + 1]; ++i) {
            EXPECT_NEAR(point_at(mesh, lines.points[i])[0], levels[c], 1e-6);
        }
        EXPECT_NEAR(point_at(mesh, lines.points[lines.curve_offsets[c]])[1], 1, 1e-6);
        EXPECT_NEAR(point_at(mesh, lines.points[lines.curve_offsets[c + 1] - 1])[1], 0, 1e-6);
    }
}

TEST(TracingApi, EvenLevelsAreAsManyAsAskedForOrAsTheFieldHas) {
    const SurfaceHost host;
    const FlgField field = host.field(host.surface(plane(7)), along_x);
    FlgFieldTraceIsolinesDesc desc = flgFieldTraceIsolinesDefaults();
    desc.field = field;
    desc.level_first = 0.1f;
    desc.level_every = 0.2f;
    for (const auto& [count, expected] : {std::pair{0u, 5u}, {2u, 2u}, {9u, 5u}}) {
        desc.level_count = count;
        FlgSurfaceCurves curves{};
        ASSERT_EQ(flgFieldTraceIsolines(host.context, &desc, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        const FlgSurfaceCurvesView lines = host.view(curves);
        ASSERT_EQ(lines.curve_count, expected);
        for (uint32_t c = 0; c < expected; ++c) EXPECT_FLOAT_EQ(lines.curve_values[c], 0.1f + 0.2f * float(c));
    }
}

TEST(TracingApi, EvenLevelsBelowTheFieldAreNotCounted) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(7));
    FlgFieldTraceIsolinesDesc desc = flgFieldTraceIsolinesDefaults();
    desc.field = host.field(surface, [](const Point& p) { return 100'000 + along_x(p); });
    desc.level_first = 0.25f;
    desc.level_every = 0.5f;  // 200,000 are below
    FlgSurfaceCurves curves{};
    ASSERT_EQ(flgFieldTraceIsolines(host.context, &desc, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const FlgSurfaceCurvesView lines = host.view(curves);
    ASSERT_EQ(lines.curve_count, 2u);
    EXPECT_EQ(lines.curve_values[0], 100'000.25f);
    EXPECT_EQ(lines.curve_values[1], 100'000.75f);

    // None between two values, nor where the first is above all.
    for (const float first : {0.0f, 200'000.0f}) {
        desc.level_first = first;
        desc.level_every = 7;
        ASSERT_EQ(flgFieldTraceIsolines(host.context, &desc, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        EXPECT_EQ(host.view(curves).curve_count, 0u) << first;
    }
}

TEST(TracingApi, ClosedIsolinesAndThoseThatEndAtRegions) {
    const SurfaceHost host;
    MeshArrays input = plane(24);
    input.set_regions([](const Point& p) { return p[0] > 0.5 ? 1u : 0u; });
    const FlgSurface surface = host.surface(input);
    const FlgField field = host.field(surface, [](const Point& p) { return distance(p, {0.5, 0.5, 0}); });
    const FlgSurfaceCurvesView circle = host.view(host.isolines(field, {0.3f}));
    ASSERT_EQ(circle.curve_count, 1u);
    EXPECT_EQ(circle.curve_flags[0], FLG_CURVE_CLOSED);
    EXPECT_NEAR(length_of(host.view(surface), circle, 0), 0.6 * M_PI, 0.01);
    expect_stretches_in_triangles(host.view(surface), circle);

    FlgFieldTraceIsolinesDesc desc = flgFieldTraceIsolinesDefaults();
    const float level = 0.3f;
    const uint32_t region = 1;
    desc.field = field;
    desc.levels = &level;
    desc.level_count = 1;
    desc.regions = &region;
    desc.region_count = 1;
    FlgSurfaceCurves half{};
    ASSERT_EQ(flgFieldTraceIsolines(host.context, &desc, &half, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const FlgSurfaceCurvesView arc = host.view(half);
    ASSERT_EQ(arc.curve_count, 1u);
    EXPECT_EQ(arc.curve_flags[0], 0);
    EXPECT_NEAR(length_of(host.view(surface), arc, 0), 0.3 * M_PI, 0.005);
}

TEST(TracingApi, StreamsFollowTheGradientToTheirEnd) {
    const SurfaceHost host;
    MeshArrays input = plane(9);
    input.set_regions([](const Point& p) { return p[1] > 2.0 / 3 ? 1u : 0u; });
    const FlgSurface surface = host.surface(input);
    const FlgSurfaceView mesh = host.view(surface);
    const FlgSurfacePoint starts[] = {point_above(mesh, 0.31, 0.52), point_above(mesh, 0.31, 0.87)};
    FlgFieldTraceStreamsDesc desc = flgFieldTraceStreamsDefaults();
    desc.field = host.field(surface, along_x);
    desc.starts = starts;
    desc.start_count = 2;
    const auto ends_at = [&](uint32_t curves, double x) {
        FlgSurfaceCurves streams{};
        ASSERT_EQ(flgFieldTraceStreams(host.context, &desc, &streams, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        const FlgSurfaceCurvesView view = host.view(streams);
        ASSERT_EQ(view.curve_count, curves);
        expect_stretches_in_triangles(mesh, view);
        for (uint32_t c = 0; c < curves; ++c) {
            EXPECT_EQ(view.curve_flags[c], 0);
            EXPECT_NEAR(view.curve_values[c], x, 1e-6);
            const uint32_t first = view.curve_offsets[c], last = view.curve_offsets[c + 1] - 1;
            EXPECT_NEAR(point_at(mesh, view.points[first])[0], 0.31, 1e-6);
            EXPECT_NEAR(point_at(mesh, view.points[last])[0], x, 1e-6);
            for (uint32_t i = first; i < last; ++i) {
                const Point p = point_at(mesh, view.points[i]), q = point_at(mesh, view.points[i + 1]);
                EXPECT_EQ(q[0] > p[0], desc.downhill == 0);
                EXPECT_NEAR(q[1], p[1], 1e-6);
            }
        }
    };
    ends_at(2, 1);
    desc.end_value = 0.6f;
    ends_at(2, 0.6);
    desc.end_value = -HUGE_VALF;
    ends_at(2, 1);
    desc.downhill = 1;
    ends_at(2, 0);
    const uint32_t region = 0;
    desc.regions = &region;
    desc.region_count = 1;
    ends_at(1, 0);
}

TEST(TracingApi, StreamsStartFromBorderSamplesInTheMaking) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(9));
    FlgSurfaceSampleBordersDesc border = flgSurfaceSampleBordersDefaults();
    border.surface = surface;
    border.spacing = 0.5f;
    FlgFieldTraceStreamsDesc desc = flgFieldTraceStreamsDefaults();
    ASSERT_EQ(flgSurfaceSampleBorders(host.context, &border, &desc.border_samples, nullptr), FLG_OK)
        << flgErrorGetMessage();
    desc.field = host.field(surface, [](const Point& p) { return -distance(p, {0.45, 0.52, 0}); });
    FlgSurfaceCurves streams{};
    ASSERT_EQ(flgFieldTraceStreams(host.context, &desc, &streams, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const FlgSurfaceCurvesView samples = host.view(desc.border_samples), view = host.view(streams);
    ASSERT_EQ(samples.curve_offsets[samples.curve_count], 8u);
    ASSERT_EQ(view.curve_count, 8u);
    for (uint32_t c = 0; c < 8; ++c) {
        EXPECT_NEAR(distance(point_at(host.view(surface), view.points[view.curve_offsets[c]]),
                             point_at(host.view(surface), samples.points[c])),
                    0, 1e-6);
        EXPECT_GT(view.curve_values[c], -0.12) << "near the summit";
    }
}

TEST(TracingApi, PathsAreStraightOnAPlaneAndOverEdges) {
    const SurfaceHost host;
    const FlgSurface flat = host.surface(plane(11));
    const FlgSurfaceView mesh = host.view(flat);
    const Point stops[] = {{0.05, 0.07, 0}, {0.93, 0.36, 0}, {0.4, 0.95, 0}};
    std::vector<FlgSurfacePoint> points;
    for (const Point& p : {stops[0], stops[1], stops[2], stops[0], stops[1]}) {
        points.push_back(point_above(mesh, p[0], p[1]));
    }
    const FlgSurfaceCurvesView paths = host.view(trace_paths(host, flat, points, {0, 3, 5}));
    ASSERT_EQ(paths.curve_count, 2u);
    expect_stretches_in_triangles(mesh, paths);
    const double a = distance(stops[0], stops[1]), b = distance(stops[1], stops[2]), c = distance(stops[2], stops[0]);
    EXPECT_NEAR(paths.curve_values[0], a + b, 1e-5);
    EXPECT_NEAR(paths.curve_values[1], a, 1e-5);
    EXPECT_NEAR(length_of(mesh, paths, 0), a + b, 1e-5);
    EXPECT_NEAR(distance(point_at(mesh, paths.points[0]), stops[0]), 0, 1e-5);
    points.resize(3);
    const FlgSurfaceCurvesView ring = host.view(trace_paths(host, flat, points, {0, 3}, true));
    ASSERT_EQ(ring.curve_count, 1u);
    EXPECT_EQ(ring.curve_flags[0], FLG_CURVE_CLOSED);
    EXPECT_NEAR(ring.curve_values[0], a + b + c, 1e-5);
    EXPECT_NEAR(length_of(mesh, ring, 0), a + b + c, 1e-5);

    // From the middle of a side of the unit cube to that of one beside it: 1.
    const FlgSurface box = host.surface(cube(5));
    const FlgSurfaceView sides = host.view(box);
    const auto middle_of = [&](const Point& wanted) -> FlgSurfacePoint {
        for (uint32_t t = 0; t < sides.mesh->triangle_count; ++t) {
            for (float u : {0.0f, 0.5f}) {
                if (distance(point_at(sides, {t, u, 0.5f}), wanted) < 1e-6) return {t, u, 0.5f};
                if (distance(point_at(sides, {t, 0.5f, u}), wanted) < 1e-6) return {t, 0.5f, u};
            }
        }
        ADD_FAILURE();
        return {};
    };
    const FlgSurfaceCurvesView over =
        host.view(trace_paths(host, box, {middle_of({0.5, 0.5, 1}), middle_of({1, 0.5, 0.5})}, {0, 2}));
    ASSERT_EQ(over.curve_count, 1u);
    EXPECT_NEAR(over.curve_values[0], 1, 1e-5);
    expect_stretches_in_triangles(sides, over);
}

TEST(TracingApi, PathsKeepToTheirRegions) {
    const SurfaceHost host;
    MeshArrays input = plane(12);
    input.set_regions([](const Point& p) { return p[0] > 0.5 && p[1] < 0.5 ? 3u : 1u; });
    const FlgSurface surface = host.surface(input);
    const FlgSurfaceView mesh = host.view(surface);
    const FlgSurfacePoint points[] = {point_above(mesh, 0.4, 0.05), point_above(mesh, 0.97, 0.55)};
    const uint32_t offsets[] = {0, 2}, region = 1;
    FlgFieldTracePathsDesc desc = flgFieldTracePathsDefaults();
    desc.surface = surface;
    desc.points = points;
    desc.path_offsets = offsets;
    desc.path_count = 1;
    desc.regions = &region;
    desc.region_count = 1;
    FlgSurfaceCurves curves{};
    ASSERT_EQ(flgFieldTracePaths(host.context, &desc, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const Point corner = {0.5, 0.5, 0};
    EXPECT_NEAR(host.view(curves).curve_values[0], distance({0.4, 0.05, 0}, corner) + distance(corner, {0.97, 0.55, 0}),
                1e-5);
}

TEST(TracingApi, PointsWithNoWayBetweenThemFail) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(loose_triangles(2));
    FlgJob job{};
    const FlgSurfaceCurves curves = trace_paths(host, surface, {{0, 0.3f, 0.3f}, {1, 0.3f, 0.3f}}, {0, 2}, false, &job);
    EXPECT_EQ(host.status_of(job).result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(host.status_of(job).error, "no way leads from desc.points[0] to desc.points[1]");
    FlgSurfaceCurvesView view = flgSurfaceCurvesViewDefaults();
    expect_failure(flgSurfaceCurvesGetView(host.context, curves, &view), FLG_ERROR_INVALID_ARGUMENT, "no way leads");
    FlgSurfaceCurvesLiftDesc lift = flgSurfaceCurvesLiftDefaults();
    lift.curves = curves;
    FlgCurveSet set{};
    expect_failure(flgSurfaceCurvesLift(host.context, &lift, &set, nullptr), FLG_ERROR_DEPENDENCY,
                   "desc.curves was not made");
}

TEST(TracingApi, LiftedCurvesHaveTheSurfacesNormals) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(sphere(12));
    FlgSurfaceCurvesLiftDesc desc = flgSurfaceCurvesLiftDefaults();
    desc.curves = host.start_isolines(host.field(surface, [](const Point& p) { return p[2]; }), {-0.4f, 0.1f});
    for (float height : {0.0f, 0.25f, -0.5f}) {
        desc.height = height;
        FlgCurveSet set{};
        ASSERT_EQ(flgSurfaceCurvesLift(host.context, &desc, &set, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        const FlgCurveSetView view = host.view_of(set);
        const FlgSurfaceCurvesView curves = host.view(desc.curves);
        ASSERT_EQ(view.curve_count, curves.curve_count);
        const uint32_t count = curves.curve_offsets[curves.curve_count];
        const float* positions = find_column(view, FLG_ATTRIBUTE_POSITION)->data;
        const float* normals = find_column(view, FLG_ATTRIBUTE_NORMAL)->data;
        for (uint32_t c = 0; c < view.curve_count; ++c) {
            EXPECT_EQ(view.curve_offsets[c + 1], curves.curve_offsets[c + 1]);
            EXPECT_EQ(view.curve_flags[c], curves.curve_flags[c]);
        }
        for (uint32_t i = 0; i < count; ++i) {
            const Point on = point_at(host.view(surface), curves.points[i]);
            const Point normal = {normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]};
            EXPECT_NEAR(distance(normal, {}), 1, 1e-6);
            EXPECT_LT(distance(normal, on), 0.03) << "of the sphere";
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(positions[3 * i + k], on[k] + height * normal[k], 1e-6);
        }
    }
}

TEST(TracingApi, NoCurvesCanBeShownButNotLifted) {
    const SurfaceHost host;
    const FlgField field = host.field(host.surface(plane(2)), along_x);
    FlgSurfaceCurvesLiftDesc desc = flgSurfaceCurvesLiftDefaults();
    desc.curves = host.isolines(field, {7});
    EXPECT_EQ(host.view(desc.curves).curve_count, 0u);
    EXPECT_EQ(host.view(desc.curves).curve_offsets[0], 0u);
    FlgCurveSet set{};
    FlgJob job{};
    ASSERT_EQ(flgSurfaceCurvesLift(host.context, &desc, &set, &job), FLG_OK);
    host.finish();
    EXPECT_EQ(host.status_of(job).result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(host.status_of(job).error, "there are no curves to lift");
}

}  // namespace
}  // namespace flg::test
