// SPDX-License-Identifier: MIT
// Surfaces behind the C ABI: made, reported, shown, refined.
#include "api/surface_inputs.h"

namespace flg::test {
namespace {

TEST(SurfaceApi, DefaultsAreThoseOfTheHeader) {
    EXPECT_EQ(flgSurfaceDefaults().weld_distance, 0);
    EXPECT_EQ(flgSurfaceDefaults().mesh, nullptr);
    EXPECT_EQ(flgSurfaceViewDefaults().mesh->triangle_count, 0u);
    EXPECT_EQ(flgSurfaceRefineDefaults().scheme, FLG_SUBDIVISION_MIDPOINT);
    EXPECT_EQ(flgSurfaceRefineDefaults().levels, 1u);
    EXPECT_EQ(flgFieldGeodesicDefaults().labels, 0u);
    EXPECT_EQ(flgFieldGeodesicDefaults().max_distance, std::numeric_limits<float>::infinity());
    EXPECT_EQ(flgFieldGeodesicDefaults().perturbation, 0);
    EXPECT_EQ(flgFieldGeodesicDefaults().frequency, 1);
    EXPECT_EQ(flgFieldGeodesicDefaults().seed, 1u);
    EXPECT_EQ(flgFieldGeodesicDefaults().labels, 0u);
    EXPECT_EQ(flgSurfaceSampleDefaults().seed, 1u);
    EXPECT_EQ(flgSurfaceSampleDefaults().max_count, 0u);
    EXPECT_EQ(flgFieldTraceStreamsDefaults().end_value, std::numeric_limits<float>::infinity());
    EXPECT_EQ(flgSurfaceCurvesLiftDefaults().height, 0);
    EXPECT_EQ(flgSurfaceCutIsolinesDefaults().first_label, FLG_NO_INDEX);
    EXPECT_EQ(flgSurfaceCutCurvesDefaults().first_label, FLG_NO_INDEX);
    for (uint32_t size : {flgMeshViewDefaults().struct_size, flgSurfaceDefaults().struct_size,
                          flgSurfaceViewDefaults().struct_size, flgSurfaceRefineDefaults().struct_size,
                          flgSurfaceCurvesViewDefaults().struct_size, flgSurfaceCurvesLiftDefaults().struct_size,
                          flgFieldGeodesicDefaults().struct_size, flgFieldViewDefaults().struct_size,
                          flgFieldBlendDefaults().struct_size, flgSurfaceSampleDefaults().struct_size,
                          flgSurfaceSampleBordersDefaults().struct_size, flgFieldTraceIsolinesDefaults().struct_size,
                          flgFieldTraceStreamsDefaults().struct_size, flgFieldTracePathsDefaults().struct_size,
                          flgSurfaceCutIsolinesDefaults().struct_size, flgSurfaceCutCurvesDefaults().struct_size}) {
        EXPECT_GT(size, 0u);
    }
}

TEST(SurfaceApi, AnOpenSurfaceIsReported) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(5));
    const FlgSurfaceReport report = host.report(surface);
    EXPECT_EQ(report.vertex_count, 36u);
    EXPECT_EQ(report.triangle_count, 50u);
    EXPECT_EQ(report.component_count, 1u);
    EXPECT_EQ(report.border_count, 1u);
    EXPECT_EQ(report.border_edges, 20u);
    EXPECT_EQ(report.genus, 0u);
    EXPECT_EQ(report.euler_number, 1);
    EXPECT_NEAR(report.area, 1, 1e-6);
    EXPECT_EQ(report.vertex_of_input, nullptr);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(report.box_min[i], 0);
        EXPECT_EQ(report.box_max[i], i < 2 ? 1 : 0);
    }
    const FlgSurfaceView view = host.view(surface);
    expect_valid(view);
    EXPECT_EQ(view.revision, 0u);
    MeshArrays input = plane(5);
    EXPECT_EQ(std::vector(view.mesh->triangles, view.mesh->triangles + 150), input.triangles);
    EXPECT_EQ(std::vector(view.mesh->columns[0].data, view.mesh->columns[0].data + 108), input.positions);
    EXPECT_EQ(std::vector(view.mesh->regions, view.mesh->regions + 50), std::vector<uint32_t>(50, 0));
}

TEST(SurfaceApi, VerticesAtOnePlaceBecomeOne) {
    const SurfaceHost host;
    const MeshArrays input = cube(3);
    const FlgSurface surface = host.surface(input);
    const FlgSurfaceReport report = host.report(surface);
    EXPECT_EQ(report.input_vertex_count, 96u);
    EXPECT_EQ(report.vertex_count, 56u);  // 6 * 9 squares: as many and 2 vertices
    EXPECT_EQ(report.welded_vertices, 40u);
    EXPECT_EQ(report.euler_number, 2);
    EXPECT_EQ(report.border_count, 0u);
    EXPECT_NEAR(report.area, 6, 1e-5);
    const FlgSurfaceView view = host.view(surface);
    expect_valid(view);
    ASSERT_NE(report.vertex_of_input, nullptr);
    for (uint32_t v = 0; v < 96; ++v) {
        ASSERT_LT(report.vertex_of_input[v], 56u);
        EXPECT_EQ(vertex_at(view, report.vertex_of_input[v]), input.vertex(v));
    }
}

TEST(SurfaceApi, TheWeldDistanceDecidesWhatIsOne) {
    const SurfaceHost host;
    MeshArrays apart;
    for (int side : {0, 1}) {
        apart.add_vertex(0, 0, 0.01 * side);
        apart.add_vertex(0, 1, 0.01 * side);
        apart.add_vertex(side == 0 ? -1 : 1, 0, 0);
    }
    apart.add_triangle(0, 1, 2);
    apart.add_triangle(3, 5, 4);
    EXPECT_EQ(host.report(host.surface(apart)).component_count, 2u);
    EXPECT_EQ(host.report(host.surface(apart, 0.02f)).component_count, 1u);
    EXPECT_EQ(host.report(host.surface(cube(1))).component_count, 1u);
    EXPECT_EQ(host.report(host.surface(cube(1), -1)).component_count, 6u);
}

TEST(SurfaceApi, WhatWasWrongIsCounted) {
    const SurfaceHost host;
    MeshArrays input = plane(1);
    input.add_vertex(5, 5, 5);                       // unused
    input.add_triangle(0, 1, 1);                     // degenerate
    input.add_triangle(1, 3, 0);                     // the first again
    input.triangles[4] = 2, input.triangles[5] = 3;  // 0 3 2 turned over
    const FlgSurfaceReport report = host.report(host.surface(input));
    EXPECT_EQ(report.unused_vertices, 1u);
    EXPECT_EQ(report.degenerate_triangles, 1u);
    EXPECT_EQ(report.duplicate_triangles, 1u);
    EXPECT_EQ(report.flipped_triangles, 1u);
    EXPECT_EQ(report.triangle_count, 2u);
    ASSERT_EQ(report.input_vertex_count, 5u);
    ASSERT_NE(report.vertex_of_input, nullptr);
    EXPECT_EQ(report.vertex_of_input[4], FLG_NO_INDEX);
}

TEST(SurfaceApi, ColumnsAndRegionsAreCarriedAlong) {
    const SurfaceHost host;
    MeshArrays input = cube(2);
    input.set_regions([](const Point& p) { return p[2] > 0.5 ? 7u : FLG_REGION_MAX; });
    std::vector<float> colors, strided;
    for (uint32_t v = 0; v < input.vertex_count(); ++v) {
        const Point p = input.vertex(v);
        for (double value : {p[0], p[1], p[2], 1.0}) colors.push_back(static_cast<float>(value));
        for (double value : {p[0] + p[1], 2 * p[2], -9.0}) strided.push_back(static_cast<float>(value));
    }
    input.further_columns = {{FLG_ATTRIBUTE_COLOR, 4, colors.data(), 0, 0},
                             {static_cast<FlgAttribute>(FLG_ATTRIBUTE_USER + 3), 2, strided.data(), 12, 0}};
    const FlgSurface surface = host.surface(input);
    const FlgSurfaceView view = host.view(surface);
    ASSERT_EQ(view.mesh->column_count, 3u);
    EXPECT_EQ(view.mesh->columns[1].attribute, FLG_ATTRIBUTE_COLOR);
    EXPECT_EQ(view.mesh->columns[2].attribute, FLG_ATTRIBUTE_USER + 3);
    EXPECT_EQ(view.mesh->columns[2].stride, 0u);
    for (uint32_t v = 0; v < view.mesh->vertex_count; ++v) {
        const Point p = vertex_at(view, v);
        for (int i = 0; i < 3; ++i) EXPECT_EQ(view.mesh->columns[1].data[4 * v + i], p[i]);
        EXPECT_FLOAT_EQ(view.mesh->columns[2].data[2 * v], static_cast<float>(p[0] + p[1]));
        EXPECT_FLOAT_EQ(view.mesh->columns[2].data[2 * v + 1], static_cast<float>(2 * p[2]));
    }
    EXPECT_NEAR(areas(view)[7], 3, 1e-6);
    EXPECT_NEAR(areas(view)[FLG_REGION_MAX], 3, 1e-6);
}

TEST(SurfaceApi, RefiningAtMidpointsKeepsTheSurface) {
    const SurfaceHost host;
    MeshArrays input = cube(1);
    input.set_regions([](const Point& p) { return p[0] > 0.99 ? 4u : 1u; });
    const FlgSurface coarse = host.surface(input);
    FlgSurfaceRefineDesc desc = flgSurfaceRefineDefaults();
    desc.surface = coarse;
    desc.levels = 2;
    FlgSurface fine{};
    ASSERT_EQ(flgSurfaceRefine(host.context, &desc, &fine, nullptr), FLG_OK) << flgErrorGetMessage();
    FlgSurfaceView pending = flgSurfaceViewDefaults();
    EXPECT_EQ(flgSurfaceGetView(host.context, fine, &pending), FLG_NOT_READY);
    host.finish();
    const FlgSurfaceView before = host.view(coarse), after = host.view(fine);
    expect_valid(after);
    EXPECT_EQ(after.mesh->triangle_count, 16u * 12);
    EXPECT_EQ(after.mesh->vertex_count, 98u);
    EXPECT_NEAR(host.report(fine).area, 6, 1e-5);
    EXPECT_EQ(host.report(fine).euler_number, 2);
    EXPECT_NEAR(areas(after)[4], 1, 1e-6);
    for (uint32_t v = 0; v < 8; ++v) EXPECT_EQ(vertex_at(after, v), vertex_at(before, v));
}

// Loop's border is the cubic spline of the border's vertices; far from it a flat regular grid stays as it is.
TEST(SurfaceApi, LoopsSchemeRoundsBordersAndKeepsPlanesFlat) {
    const SurfaceHost host;
    MeshArrays input = plane(6);
    std::vector<float> along_x;
    for (uint32_t v = 0; v < input.vertex_count(); ++v) along_x.push_back(input.positions[3 * v]);
    input.further_columns = {{FLG_ATTRIBUTE_USER, 1, along_x.data(), 0, 0}};
    FlgSurfaceRefineDesc desc = flgSurfaceRefineDefaults();
    desc.surface = host.surface(input);
    desc.scheme = FLG_SUBDIVISION_LOOP;
    FlgSurface fine{};
    ASSERT_EQ(flgSurfaceRefine(host.context, &desc, &fine, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const FlgSurfaceView view = host.view(fine);
    expect_valid(view);
    EXPECT_EQ(view.mesh->triangle_count, 4u * 72);
    for (uint32_t v = 0; v < view.mesh->vertex_count; ++v) {
        EXPECT_EQ(vertex_at(view, v)[2], 0);
        EXPECT_NEAR(view.mesh->columns[1].data[v], vertex_at(view, v)[0], 1e-6) << "columns move as positions do";
    }
    const Point corner = vertex_at(view, 0), middle = vertex_at(view, 3 * 7 + 3);
    EXPECT_NEAR(corner[0], 1.0 / 48, 1e-6);  // (1, 6, 1) / 8 of (0, 1/6), (0, 0), (1/6, 0)
    EXPECT_NEAR(corner[1], 1.0 / 48, 1e-6);
    EXPECT_NEAR(distance(middle, {0.5, 0.5, 0}), 0, 1e-6);
    EXPECT_LT(host.report(fine).area, 1);
}

TEST(SurfaceApi, ARefinedSurfaceCanBeAskedForBeforeItsCoarseOneIsMade) {
    const SurfaceHost host(1);
    FlgSurfaceRefineDesc desc = flgSurfaceRefineDefaults();
    desc.surface = host.start_surface(plane(2));
    FlgSurface fine{}, finer{};
    ASSERT_EQ(flgSurfaceRefine(host.context, &desc, &fine, nullptr), FLG_OK);
    EXPECT_EQ(flgSurfaceRelease(host.context, desc.surface), FLG_OK);
    desc.surface = fine;
    ASSERT_EQ(flgSurfaceRefine(host.context, &desc, &finer, nullptr), FLG_OK);
    host.finish();
    EXPECT_EQ(host.view(finer).mesh->triangle_count, 128u);
    FlgSurfaceView view = flgSurfaceViewDefaults();
    flgSurfaceRelease(host.context, fine);
    expect_failure(flgSurfaceGetView(host.context, fine, &view), FLG_ERROR_INVALID_HANDLE, "not a living surface");
}

// What the host held on to stays right when the surface's own handle is gone.
TEST(SurfaceApi, FieldsAndCurvesOutliveTheSurfacesHandle) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(4));
    const FlgField field = host.field(surface, [](const Point& p) { return p[0]; });
    flgSurfaceRelease(host.context, surface);
    const FlgSurfaceCurves curves = host.isolines(field, {0.3f});
    flgFieldRelease(host.context, field);
    FlgSurfaceCurvesLiftDesc lift = flgSurfaceCurvesLiftDefaults();
    lift.curves = curves;
    FlgCurveSet set{};
    ASSERT_EQ(flgSurfaceCurvesLift(host.context, &lift, &set, nullptr), FLG_OK);
    flgSurfaceCurvesRelease(host.context, curves);
    host.finish();
    EXPECT_EQ(host.view_of(set).curve_count, 1u);
}

TEST(SurfaceApi, OneTriangleAndAHundredPieces) {
    const SurfaceHost host;
    const FlgSurfaceReport one = host.report(host.surface(loose_triangles(1)));
    EXPECT_EQ(one.triangle_count, 1u);
    EXPECT_EQ(one.border_edges, 3u);
    EXPECT_EQ(one.area, 0.5);
    const FlgSurfaceReport pieces = host.report(host.surface(loose_triangles(100)));
    EXPECT_EQ(pieces.component_count, 100u);
    EXPECT_EQ(pieces.border_count, 100u);
    EXPECT_EQ(pieces.euler_number, 100);
}

}  // namespace
}  // namespace flg::test
