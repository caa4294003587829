// SPDX-License-Identifier: MIT
// What making and showing surfaces refuses.
#include "api/surface_refusals.h"

namespace flg::test {
namespace {

TEST(SurfaceRefusals, Meshes) {
    const SurfaceHost host;
    MeshArrays mesh = plane(1);
    mesh.regions = {0, FLG_REGION_MAX + 1};
    std::vector<float> colors(16, 1);
    mesh.further_columns = {{FLG_ATTRIBUTE_COLOR, 4, colors.data(), 0, 0}};
    FlgMeshView view = mesh.view();
    view.regions = nullptr;
    FlgSurfaceDesc good = flgSurfaceDefaults();
    good.mesh = &view;
    const Refusal refused{host, &flgSurfaceCreate, good};
    const auto refused_view = [&](const std::function<void(FlgMeshView&)>& change, const char* words) {
        FlgMeshView changed = view;
        change(changed);
        refused([&](FlgSurfaceDesc& d) { d.mesh = &changed; }, words);
    };
    refused.common();
    using D = FlgSurfaceDesc;
    expect_failure(flgSurfaceCreate(host.context, &good, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "out_surface is null");
    refused([](D& d) { d.weld_distance = nan; }, "desc.weld_distance is nan");
    refused([](D& d) { d.weld_distance = inf; }, "desc.weld_distance is inf");
    refused([](D& d) { d.mesh = nullptr; }, "desc.mesh is null");
    refused_view([](FlgMeshView& v) { v.struct_size = 4; }, "desc.mesh: struct_size is 4");
    refused_view([](FlgMeshView& v) { v.triangles = nullptr; }, "desc.mesh.triangles is null");
    refused_view([](FlgMeshView& v) { v.columns = nullptr; }, "desc.mesh.columns is null");
    refused_view([](FlgMeshView& v) { v.column_count = 0; }, "desc.mesh.column_count is 0, must be 1 to 16");
    refused_view([](FlgMeshView& v) { v.column_count = 17; }, "desc.mesh.column_count is 17");
    refused_view([](FlgMeshView& v) { ++v.columns, --v.column_count; },
                 "desc.mesh.columns has no FLG_ATTRIBUTE_POSITION");
    refused_view([&](FlgMeshView& v) { v.regions = mesh.regions.data(); },
                 "desc.mesh.regions[1] is 16777216, the largest label is 16777215");
    colors[6] = nan;
    refused([](D&) {}, "desc.mesh.columns[1] holds nan at vertex 1, must be finite");
    colors[6] = 1;
    mesh.positions[4] = inf;
    refused([](D&) {}, "desc.mesh.columns[0] holds inf at vertex 1");
    mesh.positions[4] = 2e30f;
    refused([](D&) {}, "must be at most 1e30 in size");
    mesh.positions[4] = 0;
    mesh.columns[1].attribute = FLG_ATTRIBUTE_POSITION;
    mesh.columns[1].components = 3;
    refused([](D&) {}, "desc.mesh.columns[0] and [1] are both attribute 0");
    mesh.columns[1].components = 4;
    refused([](D&) {}, "desc.mesh.columns[1].components is 4, attribute 0 has 3");
    mesh.columns[1] = {FLG_ATTRIBUTE_COLOR, 4, nullptr, 0, 0};
    refused([](D&) {}, "desc.mesh.columns[1].data is null");
    mesh.columns[1] = {FLG_ATTRIBUTE_COLOR, 4, colors.data(), 8, 0};
    refused([](D&) {}, "desc.mesh.columns[1].stride is 8 bytes");
}

// What takes a look at all triangles is found by the job.
TEST(SurfaceRefusals, MeshesThatTheJobCantUse) {
    const SurfaceHost host;
    const auto fails = [&](MeshArrays mesh, const char* words) {
        FlgSurfaceDesc desc = flgSurfaceDefaults();
        const FlgMeshView input = mesh.view();
        desc.mesh = &input;
        FlgSurface surface{};
        FlgJob job{};
        ASSERT_EQ(flgSurfaceCreate(host.context, &desc, &surface, &job), FLG_OK) << flgErrorGetMessage();
        // Started while nobody knows yet that the surface will not be.
        const FlgField field = host.start_distances(surface, 0);
        host.finish();
        EXPECT_EQ(host.result_of(job), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::strstr(host.status_of(job).error, words), nullptr) << host.status_of(job).error;
        FlgSurfaceView view = flgSurfaceViewDefaults();
        expect_failure(flgSurfaceGetView(host.context, surface, &view), FLG_ERROR_INVALID_ARGUMENT, words);
        FlgSurfaceReport report{};
        report.struct_size = sizeof report;
        expect_failure(flgSurfaceGetReport(host.context, surface, &report), FLG_ERROR_INVALID_ARGUMENT, words);
        uint32_t count = 0;
        expect_failure(flgSurfaceGetChanges(host.context, surface, 0, nullptr, 0, &count), FLG_ERROR_INVALID_ARGUMENT,
                       words);
        FlgFieldView field_view = flgFieldViewDefaults();
        expect_failure(flgFieldGetView(host.context, field, &field_view), FLG_ERROR_DEPENDENCY, words);
        FlgSurfaceRefineDesc refine = flgSurfaceRefineDefaults();
        refine.surface = surface;
        FlgSurface fine{};
        expect_failure(flgSurfaceRefine(host.context, &refine, &fine, nullptr), FLG_ERROR_DEPENDENCY,
                       "desc.surface was not made");
    };
    MeshArrays mesh = plane(1);
    mesh.triangles[4] = 4;
    fails(mesh, "triangle 1 of the mesh names vertex 4; there are 4 vertices");
    mesh.triangles = {0, 1, 1, 2, 2, 3};
    fails(mesh, "nothing is left of the mesh");
    mesh.triangles = {0, 1, 2};
    mesh.positions = {1, 2, 3, 1, 2, 3, 4, 5, 6};
    fails(mesh, "nothing is left of the mesh");
    mesh.triangles.clear();
    fails(mesh, "the mesh is empty: it has 3 vertices and 0 triangles");
}

TEST(SurfaceRefusals, Refining) {
    const Things things;
    FlgSurfaceRefineDesc good = flgSurfaceRefineDefaults();
    good.surface = things.surface;
    const Refusal refused{things.host, &flgSurfaceRefine, good};
    refused.common();
    using D = FlgSurfaceRefineDesc;
    expect_failure(flgSurfaceRefine(things.host.context, &good, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "out_surface is null");
    refused([](D& d) { d.levels = 0; }, "desc.levels is 0, must be 1 to 8");
    refused([](D& d) { d.levels = 9; }, "desc.levels is 9");
    refused([](D& d) { d.scheme = static_cast<FlgSubdivision>(2); }, "desc.scheme is 2");
    refused([](D& d) { d.surface = {}; }, "desc.surface is null", FLG_ERROR_INVALID_HANDLE);
    refused([&](D& d) { d.surface = things.stale; }, "is not a living surface", FLG_ERROR_INVALID_HANDLE);
    refused([&](D& d) { d.surface.id = things.field.id; }, "is not a living surface", FLG_ERROR_INVALID_HANDLE);
}

TEST(SurfaceRefusals, Views) {
    const Things things;
    const FlgContext context = things.host.context;
    FlgSurfaceView view = flgSurfaceViewDefaults();
    expect_failure(flgSurfaceGetView(context, things.surface, nullptr), FLG_ERROR_INVALID_ARGUMENT, "out_view is null");
    expect_failure(flgSurfaceGetView(context, things.stale, &view), FLG_ERROR_INVALID_HANDLE, "not a living surface");
    view.struct_size = 3;
    expect_failure(flgSurfaceGetView(context, things.surface, &view), FLG_ERROR_INVALID_ARGUMENT, "struct_size is 3");
    FlgSurfaceReport report{};
    expect_failure(flgSurfaceGetReport(context, things.surface, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "out_report is null");
    expect_failure(flgSurfaceGetReport(context, things.surface, &report), FLG_ERROR_INVALID_ARGUMENT,
                   "out_report: struct_size is 0");
    report.struct_size = sizeof report;
    expect_failure(flgSurfaceGetReport(context, {}, &report), FLG_ERROR_INVALID_HANDLE, "surface is null");
    uint32_t count = 7;
    expect_failure(flgSurfaceGetChanges(context, things.surface, 0, nullptr, 0, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "out_count is null");
    expect_failure(flgSurfaceGetChanges(context, things.surface, 0, nullptr, 1, &count), FLG_ERROR_INVALID_ARGUMENT,
                   "out_triangles is null");
    EXPECT_EQ(count, 0u);
    expect_failure(flgSurfaceGetChanges(context, things.surface, 1, nullptr, 0, &count), FLG_ERROR_INVALID_ARGUMENT,
                   "since_revision is 1, must be at most that of the surface");
    expect_failure(flgSurfaceGetChanges(context, things.stale, 0, nullptr, 0, &count), FLG_ERROR_INVALID_HANDLE,
                   "not a living surface");
    FlgFieldView field = flgFieldViewDefaults();
    expect_failure(flgFieldGetView(context, things.field, nullptr), FLG_ERROR_INVALID_ARGUMENT, "out_view is null");
    expect_failure(flgFieldGetView(context, things.stale_field, &field), FLG_ERROR_INVALID_HANDLE,
                   "not a living field");
    FlgSurfaceCurvesView curves = flgSurfaceCurvesViewDefaults();
    expect_failure(flgSurfaceCurvesGetView(context, things.curves, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "out_view is null");
    expect_failure(flgSurfaceCurvesGetView(context, things.stale_curves, &curves), FLG_ERROR_INVALID_HANDLE,
                   "is not a living");
    expect_failure(flgSurfaceRelease(context, things.stale), FLG_ERROR_INVALID_HANDLE, "not a living surface");
    expect_failure(flgFieldRelease(context, {}), FLG_ERROR_INVALID_HANDLE, "field is null");
    expect_failure(flgSurfaceCurvesRelease(context, {things.field.id}), FLG_ERROR_INVALID_HANDLE, "is not a living");
    expect_failure(flgSurfaceDescInit(nullptr, 8), FLG_ERROR_INVALID_ARGUMENT, "desc is null");
    FlgSurfaceCutCurvesDesc desc;
    expect_failure(flgSurfaceCutCurvesDescInit(&desc, 4), FLG_ERROR_INVALID_ARGUMENT, "struct_size is 4");
}

TEST(SurfaceRefusals, FieldsOfTheHostsOwn) {
    const Things things;
    const FlgContext context = things.host.context;
    std::vector<float> values(9, 1);
    FlgField field{7};
    expect_failure(flgFieldCreate(context, things.surface, values.data(), 9, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "out_field is null");
    expect_failure(flgFieldCreate(context, things.surface, nullptr, 9, &field), FLG_ERROR_INVALID_ARGUMENT,
                   "values is null");
    expect_failure(flgFieldCreate(context, things.surface, values.data(), 8, &field), FLG_ERROR_INVALID_ARGUMENT,
                   "value_count is 8, but the surface has 9 vertices");
    values[5] = nan;
    expect_failure(flgFieldCreate(context, things.surface, values.data(), 9, &field), FLG_ERROR_INVALID_ARGUMENT,
                   "values[5] is nan");
    expect_failure(flgFieldCreate(context, things.stale, values.data(), 9, &field), FLG_ERROR_INVALID_HANDLE,
                   "not a living surface");
    EXPECT_EQ(field.id, 0u);
}

}  // namespace
}  // namespace flg::test
