// SPDX-License-Identifier: MIT
// Surfaces: made, measured, traced, cut.
#include "filigree/filigree_project.h"
#include "hardening/host_buffers.h"
#include "hardening/scenarios.h"

namespace flg::test {

namespace {

FlgSurface create(Calls& calls, MeshArrays mesh) {
    FlgSurfaceDesc desc = FLG_INIT(calls, flgSurfaceDescInit);
    const FlgMeshView input = mesh.view();
    desc.mesh = &input;
    desc.provenance = 1;
    FlgSurface surface{};
    FLG_CALL(calls, flgSurfaceCreate, calls.context, &desc, calls.out(surface), calls.job());
    return surface;
}

FlgField distances(Calls& calls, FlgSurface surface, uint32_t vertex) {
    FlgFieldGeodesicDesc desc = FLG_INIT(calls, flgFieldGeodesicDescInit);
    desc.surface = surface;
    desc.vertices = &vertex;
    desc.vertex_count = 1;
    desc.labels = 1;
    FlgField field{};
    FLG_CALL(calls, flgFieldCreateGeodesic, calls.context, &desc, calls.out(field), calls.job());
    return field;
}

FlgSurfaceCurves isolines(Calls& calls, FlgField field, float every) {
    FlgFieldTraceIsolinesDesc desc = FLG_INIT(calls, flgFieldTraceIsolinesDescInit);
    desc.field = field;
    desc.level_every = every;
    FlgSurfaceCurves curves{};
    FLG_CALL(calls, flgFieldTraceIsolines, calls.context, &desc, calls.out(curves), calls.job());
    return curves;
}

}  // namespace

void make_surfaces(Calls& calls) {
    MeshArrays mesh = cube(2);
    mesh.add_triangle(0, 0, 1);
    mesh.set_regions([](const Point& p) { return p[0] > 0.5 ? 1u : 0u; });
    const FlgMeshView given = FLG_INIT(calls, flgMeshViewInit);
    EXPECT_EQ(given.triangle_count, 0u);
    EXPECT_EQ(FLG_VALUE(calls, flgMeshViewGetColumn, &given, FLG_ATTRIBUTE_POSITION), nullptr);
    FlgSurface plain{};
    FLG_CALL(calls, flgSurfaceCreateFromTriangles, calls.context, mesh.positions.data(), mesh.vertex_count(),
             mesh.triangles.data(), mesh.triangle_count(), nullptr, calls.out(plain), calls.job());
    calls.finish();
    calls.note(plain);
    FLG_CALL(calls, flgSurfaceRelease, calls.context, plain);
    const FlgSurface surface = create(calls, mesh);
    calls.finish();
    FlgSurfaceReport report{};
    report.struct_size = sizeof report;
    FLG_CALL(calls, flgSurfaceGetReport, calls.context, surface, &report);
    EXPECT_EQ(report.degenerate_triangles, 1u);
    calls.note(surface);
    FLG_DRAW(calls, flgDebugDrawSurface, surface);
    FlgBufferOutput output = output_to_buffers(calls, {{FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32}});
    add_triangles(output);
    output.regions = host_buffers().regions.data();
    output.region_capacity = host_buffers().regions.size();
    output.region_format = FLG_NUMBER_FORMAT_UINT8;
    FLG_CALL(calls, flgSurfaceWrite, calls.context, surface, &output, nullptr, calls.job());
    calls.finish();
    note_buffers(calls, output);
    for (const FlgSubdivision scheme : {FLG_SUBDIVISION_MIDPOINT, FLG_SUBDIVISION_LOOP}) {
        FlgSurfaceRefineDesc refine = FLG_INIT(calls, flgSurfaceRefineDescInit);
        refine.surface = surface;
        refine.scheme = scheme;
        FlgSurface finer{};
        FLG_CALL(calls, flgSurfaceRefine, calls.context, &refine, calls.out(finer), calls.job());
        calls.finish();
        calls.note(finer);
    }
    FLG_CALL(calls, flgSurfaceRelease, calls.context, surface);
}

void measure_surfaces(Calls& calls) {
    const FlgSurface surface = create(calls, plane(6));
    const FlgField from = distances(calls, surface, 0), to = distances(calls, surface, 48);
    const FlgBufferOutput output = output_to_buffers(
        calls, {{FLG_ATTRIBUTE_VALUE, FLG_NUMBER_FORMAT_FLOAT16}, {FLG_ATTRIBUTE_LABEL, FLG_NUMBER_FORMAT_UINT8}});
    FLG_CALL(calls, flgFieldWrite, calls.context, from, &output, nullptr, calls.job());
    calls.finish();
    note_buffers(calls, output);
    FlgFieldBlendDesc blend = FLG_INIT(calls, flgFieldBlendDescInit);
    blend.from = from;
    blend.to = to;
    FlgField blended{}, sampled{}, perturbed{}, own{};
    FLG_CALL(calls, flgFieldBlend, calls.context, &blend, calls.out(blended), calls.job());
    FlgSurfaceSampleDesc sampling = FLG_INIT(calls, flgSurfaceSampleDescInit);
    sampling.surface = surface;
    sampling.radius = 0.3f;
    FLG_CALL(calls, flgSurfaceSample, calls.context, &sampling, calls.out(sampled), calls.job());
    FlgSurfaceSampleBordersDesc border = FLG_INIT(calls, flgSurfaceSampleBordersDescInit);
    border.surface = surface;
    border.spacing = 0.2f;
    FlgSurfaceCurves points{};
    FLG_CALL(calls, flgSurfaceSampleBorders, calls.context, &border, calls.out(points), calls.job());

    const uint32_t zero = 0;
    const FlgSurfacePoint point = {7, 0.2f, 0.2f};
    FlgFieldGeodesicDesc desc = FLG_INIT(calls, flgFieldGeodesicDescInit);
    desc.surface = surface;
    desc.points = &point;
    desc.point_count = 1;
    desc.curves = points;
    desc.border_regions = desc.regions = desc.targets = &zero;
    desc.border_region_count = desc.region_count = desc.target_count = 1;
    desc.perturbation = 0.01f;
    desc.labels = 1;
    FLG_CALL(calls, flgFieldCreateGeodesic, calls.context, &desc, calls.out(perturbed), calls.job());
    calls.finish();
    const std::vector<float> values(49, 0.5f);
    FLG_CALL(calls, flgFieldCreate, calls.context, surface, values.data(), 49u, calls.out(own));
    for (const FlgField field : {from, to, blended, sampled, perturbed, own}) {
        calls.note(field);
        FLG_DRAW(calls, flgDebugDrawField, field);
        FLG_CALL(calls, flgFieldRelease, calls.context, field);
    }
    calls.note(points);
}

void trace_surfaces(Calls& calls) {
    const FlgSurface surface = create(calls, sphere(3));
    const FlgField field = distances(calls, surface, 3);
    const FlgSurfaceCurves rings = isolines(calls, field, 0.4f);
    FlgSurfaceCurves flows{}, paths{}, laid{};
    const FlgSurfacePoint starts[] = {{40, 0.2f, 0.2f}, {70, 0.1f, 0.3f}};
    FlgFieldTraceStreamsDesc streams = FLG_INIT(calls, flgFieldTraceStreamsDescInit);
    streams.field = field;
    streams.starts = starts;
    streams.start_count = 2;
    streams.downhill = 1;
    FLG_CALL(calls, flgFieldTraceStreams, calls.context, &streams, calls.out(flows), calls.job());
    const FlgSurfacePoint stops[] = {{3, 0.2f, 0.3f}, {50, 0.5f, 0.1f}, {90, 0.1f, 0.1f}};
    const uint32_t offsets[] = {0, 3};
    FlgFieldTracePathsDesc path = FLG_INIT(calls, flgFieldTracePathsDescInit);
    path.surface = surface;
    path.points = stops;
    path.path_offsets = offsets;
    path.path_count = 1;
    path.closed = 1;
    FLG_CALL(calls, flgFieldTracePaths, calls.context, &path, calls.out(paths), calls.job());
    FlgSurfaceCurvesLiftDesc lift = FLG_INIT(calls, flgSurfaceCurvesLiftDescInit);
    lift.curves = paths;
    lift.height = 0.1f;
    FlgCurveSet lifted{};
    FLG_CALL(calls, flgSurfaceCurvesLift, calls.context, &lift, calls.out(lifted), calls.job());
    FlgCurveSetProjectDesc project = FLG_INIT(calls, flgCurveSetProjectDescInit);
    project.surface = surface;
    project.curves = lifted;
    FLG_CALL(calls, flgCurveSetProject, calls.context, &project, calls.out(laid), calls.job());
    calls.finish();
    calls.note(lifted);
    for (const FlgSurfaceCurves curves : {rings, flows, paths, laid}) {
        FlgSurfaceCurvesView view = FLG_INIT(calls, flgSurfaceCurvesViewInit);
        FLG_CALL(calls, flgSurfaceCurvesGetView, calls.context, curves, &view);
        calls.bits += bits(view);
        FLG_DRAW(calls, flgDebugDrawSurfaceCurves, curves);
        FLG_CALL(calls, flgSurfaceCurvesRelease, calls.context, curves);
    }
}

void cut_surfaces(Calls& calls) {
    const FlgSurface surface = create(calls, sphere(3));
    calls.surfaces.push_back(surface);
    calls.finish();
    calls.note(surface);
    const FlgField first = distances(calls, surface, 3);
    calls.finish();
    FlgSurfaceCutIsolinesDesc bands = FLG_INIT(calls, flgSurfaceCutIsolinesDescInit);
    bands.field = first;
    bands.level_first = 0.5f;
    bands.level_every = 0.7f;
    bands.first_label = 5;
    FlgField after{};
    FLG_CALL(calls, flgSurfaceCutIsolines, calls.context, &bands, calls.out(after), calls.job());
    calls.finish();
    calls.note(surface);
    calls.note(after);

    const FlgField second = distances(calls, surface, 30);
    FlgSurfaceCutCurvesDesc along = FLG_INIT(calls, flgSurfaceCutCurvesDescInit);
    along.curves = isolines(calls, second, 0.33f);
    along.first_label = 100;
    calls.finish();
    FLG_CALL(calls, flgSurfaceCutCurves, calls.context, &along, calls.job());
    calls.finish();
    calls.note(surface);
    FlgSurfaceProvenanceView lies = FLG_INIT(calls, flgSurfaceProvenanceViewInit);
    FLG_CALL(calls, flgSurfaceGetProvenance, calls.context, surface, &lies);
    FlgSurfacePoint point{};
    FlgSurfaceView shown = flgSurfaceViewDefaults();
    FLG_CALL(calls, flgSurfaceGetView, calls.context, surface, &shown);
    const uint32_t last = lies.triangle_count - 1;
    FLG_CALL(calls, flgSurfaceProvenanceViewGetPoint, &lies, last, shown.mesh->triangles[size_t{3} * last], &point);
    calls.note(&point, sizeof point);
    uint32_t changed = 0;
    FLG_CALL(calls, flgSurfaceGetChanges, calls.context, surface, 0u, nullptr, 0u, &changed);
    EXPECT_GT(changed, 0u);
}

}  // namespace flg::test
