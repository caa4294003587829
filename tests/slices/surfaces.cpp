// SPDX-License-Identifier: MIT
// Surfaces: made, measured, traced, cut.
#include "slices/meshes.h"
#include "slices/sized_jobs.h"

namespace flg::slices {

namespace {

void make(WatchedHost& host, Mesh mesh) {
    make_surface(host, std::move(mesh));
    host.finish();
}
void make_waves(WatchedHost& host, uint32_t size) {
    make(host, waves(size));
}
void make_fan(WatchedHost& host, uint32_t size) {
    make(host, fan(size));
}
void make_book(WatchedHost& host, uint32_t size) {
    make(host, book(size));
}
void make_soup(WatchedHost& host, uint32_t size) {
    make(host, soup(size));
}

void make_with_provenance(WatchedHost& host, uint32_t size) {
    make_surface(host, waves(size), true);
    host.finish();
}

FlgSurface whole(WatchedHost& host, uint32_t size) {
    const FlgSurface surface = make_surface(host, waves(size));
    host.finish();
    return surface;
}

void refine(WatchedHost& host, uint32_t size) {
    FlgSurfaceRefineDesc desc = flgSurfaceRefineDefaults();
    desc.surface = whole(host, size / 4);
    desc.scheme = FLG_SUBDIVISION_LOOP;
    FlgSurface finer{};
    host.call("flgSurfaceRefine", flgSurfaceRefine, &desc, &finer, host.job());
    host.made("flgSurfaceRelease", flgSurfaceRelease, finer);
    host.finish();
}

void write(WatchedHost& host, uint32_t size) {
    const FlgSurface surface = whole(host, size);
    FlgSurfaceView view = flgSurfaceViewDefaults();
    host.call("flgSurfaceGetView", flgSurfaceGetView, surface, &view);
    std::vector<float> positions(size_t{3} * view.mesh->vertex_count);
    std::vector<uint32_t> indices(size_t{3} * view.mesh->triangle_count);
    const FlgBufferColumn column = {
        FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, positions.data(), 0, 0, {}, 0, 0};
    FlgBufferOutput output = flgBufferOutputDefaults();
    output.columns = &column;
    output.column_count = 1;
    output.row_capacity = view.mesh->vertex_count;
    output.indices = indices.data();
    output.index_capacity = indices.size();
    host.call("flgSurfaceWrite", flgSurfaceWrite, surface, &output, nullptr, host.job());
    host.finish();
}

FlgField measure(WatchedHost& host, const FlgFieldGeodesicDesc& desc) {
    FlgField field{};
    host.copy("flgFieldCreateGeodesic", flgFieldCreateGeodesic, &desc, &field, host.job());
    host.made("flgFieldRelease", flgFieldRelease, field);
    host.finish();
    return field;
}

FlgField distances(WatchedHost& host, FlgSurface surface, uint32_t vertex) {
    FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
    desc.surface = surface;
    desc.vertices = &vertex;
    desc.vertex_count = 1;
    return measure(host, desc);
}

void field_of_one(WatchedHost& host, uint32_t size) {
    distances(host, whole(host, size), 0);
}

// From a tenth of the vertices, with cells.
void field_of_many(WatchedHost& host, uint32_t size) {
    std::vector<uint32_t> vertices;
    for (uint32_t v = 0; v < size / 2; v += 10) vertices.push_back(v);
    FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
    desc.surface = whole(host, size);
    desc.vertices = vertices.data();
    desc.vertex_count = static_cast<uint32_t>(vertices.size());
    desc.labels = 1;
    measure(host, desc);
}

void field_perturbed(WatchedHost& host, uint32_t size) {
    const uint32_t vertex = 0;
    FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
    desc.surface = whole(host, size);
    desc.vertices = &vertex;
    desc.vertex_count = 1;
    desc.perturbation = 0.02f;
    measure(host, desc);
}

void field_on_fan(WatchedHost& host, uint32_t size) {
    const FlgSurface surface = make_surface(host, fan(size));
    host.finish();
    distances(host, surface, 1);
}

void blend(WatchedHost& host, uint32_t size) {
    const FlgSurface surface = whole(host, size);
    FlgFieldBlendDesc desc = flgFieldBlendDefaults();
    desc.from = distances(host, surface, 0);
    desc.to = distances(host, surface, 10);
    FlgField field{};
    host.call("flgFieldBlend", flgFieldBlend, &desc, &field, host.job());
    host.made("flgFieldRelease", flgFieldRelease, field);
    host.finish();
    std::vector<float> values(size);
    const FlgBufferColumn column = {FLG_ATTRIBUTE_VALUE, FLG_NUMBER_FORMAT_FLOAT32, values.data(), 0, 0, {}, 0, 0};
    FlgBufferOutput output = flgBufferOutputDefaults();
    output.columns = &column;
    output.column_count = 1;
    output.row_capacity = size;
    host.call("flgFieldWrite", flgFieldWrite, field, &output, nullptr, host.job());
    host.finish();
}

// A point for some 200 triangles.
void sample(WatchedHost& host, uint32_t size) {
    FlgSurfaceSampleDesc desc = flgSurfaceSampleDefaults();
    desc.surface = whole(host, size);
    desc.radius = static_cast<float>(std::sqrt(200.0 / size));
    FlgField field{};
    host.call("flgSurfaceSample", flgSurfaceSample, &desc, &field, host.job());
    host.made("flgFieldRelease", flgFieldRelease, field);
    host.finish();
}

void sample_borders(WatchedHost& host, uint32_t size) {
    FlgSurfaceSampleBordersDesc desc = flgSurfaceSampleBordersDefaults();
    desc.surface = whole(host, size);
    desc.spacing = static_cast<float>(4.0 / size);
    FlgSurfaceCurves points{};
    host.call("flgSurfaceSampleBorders", flgSurfaceSampleBorders, &desc, &points, host.job());
    host.made("flgSurfaceCurvesRelease", flgSurfaceCurvesRelease, points);
    host.finish();
}

FlgSurfaceCurves isolines(WatchedHost& host, FlgField field, uint32_t size) {
    FlgFieldTraceIsolinesDesc desc = flgFieldTraceIsolinesDefaults();
    desc.field = field;
    desc.level_every = static_cast<float>(10 / std::sqrt(size));
    FlgSurfaceCurves curves{};
    host.call("flgFieldTraceIsolines", flgFieldTraceIsolines, &desc, &curves, host.job());
    host.made("flgSurfaceCurvesRelease", flgSurfaceCurvesRelease, curves);
    host.finish();
    return curves;
}

void trace_isolines(WatchedHost& host, uint32_t size) {
    isolines(host, distances(host, whole(host, size), 0), size);
}

void trace_streams(WatchedHost& host, uint32_t size) {
    const FlgSurface surface = whole(host, size);
    std::vector<FlgSurfacePoint> starts;
    for (uint32_t t = 0; t + 1 < size / 2; t += 100) starts.push_back({t, 0.2f, 0.3f});
    FlgFieldTraceStreamsDesc desc = flgFieldTraceStreamsDefaults();
    desc.field = distances(host, surface, 0);
    desc.starts = starts.data();
    desc.start_count = static_cast<uint32_t>(starts.size());
    desc.downhill = 1;
    FlgSurfaceCurves flows{};
    host.copy("flgFieldTraceStreams", flgFieldTraceStreams, &desc, &flows, host.job());
    host.made("flgSurfaceCurvesRelease", flgSurfaceCurvesRelease, flows);
    host.finish();
}

// A path through many points, raised and laid down again.
void trace_paths(WatchedHost& host, uint32_t size) {
    const FlgSurface surface = whole(host, size);
    std::vector<FlgSurfacePoint> stops;
    for (uint32_t t = 0; t < 12; ++t) stops.push_back({t * (size / 16), 0.2f, 0.3f});
    const uint32_t offsets[] = {0, 12};
    FlgFieldTracePathsDesc desc = flgFieldTracePathsDefaults();
    desc.surface = surface;
    desc.points = stops.data();
    desc.path_offsets = offsets;
    desc.path_count = 1;
    FlgSurfaceCurves paths{}, laid{};
    host.copy("flgFieldTracePaths", flgFieldTracePaths, &desc, &paths, host.job());
    FlgSurfaceCurvesLiftDesc lift = flgSurfaceCurvesLiftDefaults();
    lift.curves = paths;
    lift.height = 0.05f;
    FlgCurveSet lifted{};
    host.call("flgSurfaceCurvesLift", flgSurfaceCurvesLift, &lift, &lifted, host.job());
    FlgCurveSetProjectDesc project = flgCurveSetProjectDefaults();
    project.surface = surface;
    project.curves = lifted;
    host.call("flgCurveSetProject", flgCurveSetProject, &project, &laid, host.job());
    host.made("flgSurfaceCurvesRelease", flgSurfaceCurvesRelease, paths);
    host.made("flgSurfaceCurvesRelease", flgSurfaceCurvesRelease, laid);
    host.made("flgCurveSetRelease", flgCurveSetRelease, lifted);
    host.finish();
}

void cut_isolines(WatchedHost& host, uint32_t size) {
    const FlgSurface surface = whole(host, size);
    FlgSurfaceCutIsolinesDesc desc = flgSurfaceCutIsolinesDefaults();
    desc.field = distances(host, surface, 0);
    desc.level_every = static_cast<float>(10 / std::sqrt(size));
    desc.first_label = 5;
    FlgField after{};
    host.call("flgSurfaceCutIsolines", flgSurfaceCutIsolines, &desc, &after, host.job());
    host.made("flgFieldRelease", flgFieldRelease, after);
    host.finish();
    distances(host, surface, 3);
}

void cut_curves(WatchedHost& host, uint32_t size) {
    const FlgSurface surface = whole(host, size);
    FlgSurfaceCutCurvesDesc desc = flgSurfaceCutCurvesDefaults();
    desc.curves = isolines(host, distances(host, surface, 0), size);
    desc.first_label = 100;
    host.call("flgSurfaceCutCurves", flgSurfaceCutCurves, &desc, host.job());
    host.finish();
}

constexpr SizedJob all[] = {
    {"surface", make_waves},
    {"surface_provenance", make_with_provenance},
    {"surface_fan", make_fan},
    {"surface_book", make_book, 1000},
    {"surface_soup", make_soup},
    {"refine", refine},
    {"surface_write", write},
    {"field", field_of_one},
    {"field_many_sources", field_of_many},
    {"field_perturbed", field_perturbed, 1'000'000},
    {"field_fan", field_on_fan, 100'000},
    {"field_blend", blend},
    {"sample", sample, 1'000'000},
    {"sample_borders", sample_borders},
    {"isolines", trace_isolines},
    {"streams", trace_streams, 1'000'000},
    {"paths", trace_paths, 1'000'000},
    {"cut_isolines", cut_isolines},
    {"cut_curves", cut_curves},
};

}  // namespace

std::span<const SizedJob> surface_jobs() {
    return all;
}

}  // namespace flg::slices
