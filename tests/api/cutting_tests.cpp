// SPDX-License-Identifier: MIT
// Surfaces cut behind the C ABI: labels, areas, columns, what changed, and what is measured afterwards.
#include "api/surface_inputs.h"

namespace flg::test {
namespace {

double along_x(const Point& p) {
    return p[0];
}

FlgResult cut(const SurfaceHost& host, const FlgSurfaceCutIsolinesDesc& desc, FlgField* out_field = nullptr) {
    FlgJob job{};
    EXPECT_EQ(flgSurfaceCutIsolines(host.context, &desc, out_field, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    return host.result_of(job);
}

FlgSurfaceCutIsolinesDesc at_levels(FlgField field, const std::vector<float>& levels,
                                    uint32_t first_label = FLG_NO_INDEX) {
    FlgSurfaceCutIsolinesDesc desc = flgSurfaceCutIsolinesDefaults();
    desc.field = field;
    desc.levels = levels.data();
    desc.level_count = static_cast<uint32_t>(levels.size());
    desc.first_label = first_label;
    return desc;
}

FlgSurfaceCurves path(const SurfaceHost& host, FlgSurface surface, const std::vector<Point>& stops,
                      bool closed = false) {
    const FlgSurfaceView view = host.view(surface);
    std::vector<FlgSurfacePoint> points;
    for (const Point& p : stops) points.push_back(point_above(view, p[0], p[1]));
    const uint32_t offsets[] = {0, static_cast<uint32_t>(points.size())};
    FlgFieldTracePathsDesc desc = flgFieldTracePathsDefaults();
    desc.surface = surface;
    desc.points = points.data();
    desc.path_offsets = offsets;
    desc.path_count = 1;
    desc.closed = closed ? 1 : 0;
    FlgSurfaceCurves curves{};
    EXPECT_EQ(flgFieldTracePaths(host.context, &desc, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    return curves;
}

FlgResult cut(const SurfaceHost& host, FlgSurfaceCurves curves, uint32_t first_label = FLG_NO_INDEX) {
    FlgSurfaceCutCurvesDesc desc = flgSurfaceCutCurvesDefaults();
    desc.curves = curves;
    desc.first_label = first_label;
    FlgJob job{};
    EXPECT_EQ(flgSurfaceCutCurves(host.context, &desc, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    return host.result_of(job);
}

TEST(CuttingApi, IsolinesBecomeEdgesAndTheirBandsLabels) {
    const SurfaceHost host;
    MeshArrays input = plane(7);
    std::vector<float> colors;
    for (uint32_t v = 0; v < input.vertex_count(); ++v) {
        for (double value : {input.vertex(v)[0], input.vertex(v)[1], 0.25, 1.0}) colors.push_back(float(value));
    }
    input.further_columns = {{FLG_ATTRIBUTE_COLOR, 4, colors.data(), 0, 0}};
    const FlgSurface surface = host.surface(input);
    const FlgSurfaceView before = host.view(surface);
    const uint32_t vertices = before.mesh->vertex_count;
    const std::vector<float> levels = {0.3f, 0.65f};
    FlgField after_cut{};
    ASSERT_EQ(cut(host, at_levels(host.field(surface, along_x), levels, 10), &after_cut), FLG_OK);

    const FlgSurfaceView view = host.view(surface);
    expect_valid(view);
    EXPECT_EQ(view.revision, 1u);
    EXPECT_GT(view.mesh->vertex_count, vertices);
    for (uint32_t v = 0; v < vertices; ++v) EXPECT_EQ(vertex_at(view, v), input.vertex(v)) << "nothing moves";
    const std::map<uint32_t, double> parts = areas(view);
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_NEAR(parts.at(10), 0.3, 1e-6);
    EXPECT_NEAR(parts.at(11), 0.35, 1e-6);
    EXPECT_NEAR(parts.at(12), 0.35, 1e-6);
    for (uint32_t t = 0; t < view.mesh->triangle_count; ++t) {
        for (uint32_t k = 0; k < 3; ++k) {
            const double x = vertex_at(view, view.mesh->triangles[3 * t + k])[0];
            const uint32_t label = view.mesh->regions[t];
            EXPECT_GE(x, label == 10 ? 0 : levels[label - 11] - 1e-6);
            EXPECT_LE(x, label == 12 ? 1 : levels[label - 10] + 1e-6);
        }
    }
    const FlgFieldView field = host.view(after_cut);
    EXPECT_EQ(field.revision, 1u);
    ASSERT_EQ(field.vertex_count, view.mesh->vertex_count);
    for (uint32_t v = 0; v < field.vertex_count; ++v) {
        const Point p = vertex_at(view, v);
        EXPECT_NEAR(field.values[v], p[0], 1e-6);
        const float* color = view.mesh->columns[1].data + 4 * size_t{v};
        EXPECT_NEAR(color[0], p[0], 1e-6);
        EXPECT_NEAR(color[1], p[1], 1e-6);
        EXPECT_EQ(color[2], 0.25f);
    }
    // The field on the cut surface has its isolines where the edges are.
    const FlgSurfaceCurvesView lines = host.view(host.isolines(after_cut, levels));
    EXPECT_EQ(lines.curve_count, 2u);
    EXPECT_EQ(lines.revision, 1u);
}

TEST(CuttingApi, EachListedRegionHasItsOwnLabels) {
    const SurfaceHost host;
    MeshArrays input = plane(8);
    input.set_regions([](const Point& p) { return p[1] < 0.25 ? 2u : p[1] < 0.5 ? 9u : 5u; });
    const uint32_t regions[] = {2, 5};
    {
        const FlgSurface surface = host.surface(input);
        const std::vector<float> levels = {0.3f, 0.65f};
        FlgSurfaceCutIsolinesDesc desc = at_levels(host.field(surface, along_x), levels, 100);
        desc.regions = regions;
        desc.region_count = 2;
        ASSERT_EQ(cut(host, desc), FLG_OK);
        expect_valid(host.view(surface));
        const std::map<uint32_t, double> expected = {{9, 0.25},          {100, 0.25 * 0.3}, {101, 0.25 * 0.35},
                                                     {102, 0.25 * 0.35}, {103, 0.5 * 0.3},  {104, 0.5 * 0.35},
                                                     {105, 0.5 * 0.35}};
        const std::map<uint32_t, double> parts = areas(host.view(surface));
        ASSERT_EQ(parts.size(), expected.size());
        for (const auto& [label, area] : expected) EXPECT_NEAR(parts.at(label), area, 1e-6) << label;
    }
    // Of evenly spaced levels as many labels are taken as levels were asked for, whether the field reaches them or not.
    const FlgSurface surface = host.surface(input);
    FlgSurfaceCutIsolinesDesc desc = flgSurfaceCutIsolinesDefaults();
    desc.field = host.field(surface, along_x);
    desc.level_first = desc.level_every = 0.4f;
    desc.level_count = 9;
    desc.first_label = 20;
    desc.regions = regions;
    desc.region_count = 2;
    ASSERT_EQ(cut(host, desc), FLG_OK);
    const std::map<uint32_t, double> parts = areas(host.view(surface));
    for (uint32_t label : {9u, 20u, 21u, 22u, 30u, 31u, 32u}) EXPECT_TRUE(parts.contains(label)) << label;
    EXPECT_EQ(parts.size(), 7u);
}

TEST(CuttingApi, LabelsStayUnlessAskedFor) {
    const SurfaceHost host;
    MeshArrays input = plane(6);
    input.set_regions([](const Point& p) { return p[1] < 0.5 ? 3u : 4u; });
    const FlgSurface surface = host.surface(input);
    ASSERT_EQ(cut(host, at_levels(host.field(surface, along_x), {0.3f})), FLG_OK);
    EXPECT_NEAR(areas(host.view(surface))[3], 0.5, 1e-6);
    EXPECT_NEAR(areas(host.view(surface))[4], 0.5, 1e-6);
    ASSERT_EQ(cut(host, at_levels(host.field(surface, along_x), {0.7f}, 4)), FLG_OK);
    EXPECT_NEAR(areas(host.view(surface))[4], 0.7, 1e-6) << "null regions: all get the same labels";
    EXPECT_NEAR(areas(host.view(surface))[5], 0.3, 1e-6);
}

TEST(CuttingApi, ACutThatFindsNothingChangesNothing) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(6));
    const std::string before = bits(host.view(surface));
    ASSERT_EQ(cut(host, at_levels(host.field(surface, along_x), {5})), FLG_OK);
    ASSERT_EQ(cut(host, host.isolines(host.field(surface, along_x), {5}), 7), FLG_OK);
    EXPECT_EQ(bits(host.view(surface)), before);
    EXPECT_EQ(host.view(surface).revision, 2u);
    EXPECT_TRUE(host.changes(surface, 0).empty());
    const uint32_t absent = 8;
    const std::vector<float> level = {0.3f};
    FlgSurfaceCutIsolinesDesc desc = at_levels(host.field(surface, along_x), level, 9);
    desc.regions = &absent;
    desc.region_count = 1;
    ASSERT_EQ(cut(host, desc), FLG_OK);
    EXPECT_EQ(bits(host.view(surface)), before);
}

TEST(CuttingApi, ChangesAreTheTrianglesThatDiffer) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(12));
    std::vector<std::vector<uint32_t>> revisions;
    const auto remember = [&] {
        const FlgSurfaceView view = host.view(surface);
        revisions.emplace_back(view.mesh->triangles, view.mesh->triangles + 3 * size_t{view.mesh->triangle_count});
    };
    remember();
    ASSERT_EQ(cut(host, at_levels(host.field(surface, along_x), {0.3f})), FLG_OK);
    remember();
    ASSERT_EQ(cut(host, path(host, surface, {{0.1, 0.2, 0}, {0.6, 0.33, 0}})), FLG_OK);
    remember();
    for (uint32_t since = 0; since < 3; ++since) {
        std::vector<uint32_t> expected;
        for (uint32_t t = 0; t < revisions[2].size() / 3; ++t) {
            const auto differs = [&](uint32_t k) {
                return 3 * t + k >= revisions[since].size() || revisions[2][3 * t + k] != revisions[since][3 * t + k];
            };
            if (differs(0) || differs(1) || differs(2)) expected.push_back(t);
        }
        EXPECT_EQ(host.changes(surface, since), expected) << "since " << since;
    }
    const std::vector<uint32_t> all = host.changes(surface, 0);
    uint32_t few[3] = {7, 7, 7}, count = 0;
    ASSERT_EQ(flgSurfaceGetChanges(host.context, surface, 0, few, 2, &count), FLG_OK);
    EXPECT_EQ(count, all.size());
    EXPECT_EQ(few[0], all[0]);
    EXPECT_EQ(few[1], all[1]);
    EXPECT_EQ(few[2], 7u);
}

TEST(CuttingApi, CurvesDivideRegions) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(9));
    // From border to border; then a square across it; then one that ends inside and divides nothing.
    ASSERT_EQ(cut(host, path(host, surface, {{0, 0.41, 0}, {1, 0.41, 0}}), 50), FLG_OK);
    EXPECT_EQ(areas(host.view(surface)).size(), 2u);
    EXPECT_NEAR(areas(host.view(surface))[50] + areas(host.view(surface))[51], 1, 1e-5);
    EXPECT_NEAR(std::min(areas(host.view(surface))[50], areas(host.view(surface))[51]), 0.41, 1e-3);
    ASSERT_EQ(
        cut(host, path(host, surface, {{0.27, 0.2, 0}, {0.74, 0.2, 0}, {0.74, 0.63, 0}, {0.27, 0.63, 0}}, true), 60),
        FLG_OK);
    const std::map<uint32_t, double> parts = areas(host.view(surface));
    ASSERT_EQ(parts.size(), 4u) << "two inside the square, two outside";
    double inside = 0;
    for (const auto& [label, area] : parts) {
        EXPECT_GE(label, 60u) << "both regions fell apart";
        EXPECT_LE(label, 63u);
        if (area < 0.13) inside += area;
    }
    EXPECT_NEAR(inside, 0.47 * 0.43, 1e-3);
    expect_valid(host.view(surface));
    ASSERT_EQ(cut(host, path(host, surface, {{0.05, 0.05, 0}, {0.15, 0.31, 0}}), 90), FLG_OK);
    const std::map<uint32_t, double> after = areas(host.view(surface));
    ASSERT_EQ(after.size(), parts.size());
    for (const auto& [label, area] : parts) EXPECT_NEAR(after.at(label), area, 1e-6);
}

// 2^24 labels are all there are; a surface that would need more stays whole.
TEST(CuttingApi, LabelsRunOutBeforeAnythingIsCut) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(9));
    const std::string before = bits(host.view(surface));
    EXPECT_EQ(cut(host, path(host, surface, {{0, 0.41, 0}, {1, 0.41, 0}}), FLG_REGION_MAX), FLG_ERROR_LIMIT);
    EXPECT_EQ(bits(host.view(surface)), before);
    EXPECT_TRUE(host.changes(surface, 0).empty());
    const std::vector<float> levels = {0.3f, 0.6f};
    EXPECT_EQ(cut(host, at_levels(host.field(surface, along_x), levels, FLG_REGION_MAX - 1)), FLG_ERROR_LIMIT);
    EXPECT_EQ(bits(host.view(surface)), before);
    EXPECT_EQ(cut(host, at_levels(host.field(surface, along_x), levels, FLG_REGION_MAX - 2)), FLG_OK);
    EXPECT_TRUE(areas(host.view(surface)).contains(FLG_REGION_MAX));
    EXPECT_EQ(cut(host, path(host, surface, {{0, 0.41, 0}, {0.2, 0.41, 0}}), FLG_REGION_MAX), FLG_OK) << "none needed";
}

// Distances on a cut surface are those on one that was made so: what solvers keep was brought up to date.
TEST(CuttingApi, DistancesAfterCutsAreThoseOfASurfaceMadeAnew) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(sphere(6));
    FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
    const uint32_t vertex = 3;
    desc.surface = surface;
    desc.vertices = &vertex;
    desc.vertex_count = 1;
    ASSERT_EQ(cut(host, at_levels(host.solve(desc), {0.31f, 0.9f}, 1)), FLG_OK);
    ASSERT_EQ(cut(host, host.isolines(host.field(surface, along_x), {0.123f, 0.5f})), FLG_OK);
    const FlgSurfaceView view = host.view(surface);
    expect_valid(view);
    MeshArrays copy;
    copy.positions.assign(view.mesh->columns[0].data, view.mesh->columns[0].data + 3 * size_t{view.mesh->vertex_count});
    copy.triangles.assign(view.mesh->triangles, view.mesh->triangles + 3 * size_t{view.mesh->triangle_count});
    const FlgFieldView cut_field = host.view(host.solve(desc));
    desc.surface = host.surface(copy, -1);
    const FlgFieldView fresh = host.view(host.solve(desc));
    ASSERT_EQ(fresh.vertex_count, cut_field.vertex_count);
    uint32_t apart = 0;
    for (uint32_t v = 0; v < fresh.vertex_count; ++v) {
        // Where two ways are about as long, the order of visits decides within the solver's error: it begins at
        // another of a vertex' triangles.
        EXPECT_NEAR(cut_field.values[v], fresh.values[v], 1.5e-3 * fresh.values[v]) << v;
        apart += std::abs(cut_field.values[v] - fresh.values[v]) > 3e-4f * fresh.values[v];
    }
    EXPECT_LT(20 * apart, fresh.vertex_count);
}

// How to divide the triangles is found first, which takes longest.
TEST(CuttingApi, ACutAlongCurvesCanBeCancelledUntilTheSurfaceChanges) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(1));
    const std::string before = bits(host.view(surface));
    std::vector<Point> stops;
    for (int i = 0; i < 80; ++i) {
        const double t = 0.05 + 0.9 * (i * 7 % 80) / 80.0;
        stops.push_back(i % 2 == 0 ? Point{t, 0.05, 0} : Point{1 - t, 0.95, 0});
    }
    FlgSurfaceCutCurvesDesc desc = flgSurfaceCutCurvesDefaults();
    desc.curves = path(host, surface, stops);
    FlgJob job{};
    ASSERT_EQ(flgSurfaceCutCurves(host.context, &desc, &job), FLG_OK) << flgErrorGetMessage();
    for (int tick = 0; tick < 3; ++tick) flgContextTick(host.context, 10, nullptr);
    EXPECT_STREQ(host.status_of(job).stage, "cut");
    ASSERT_EQ(flgJobCancel(host.context, job), FLG_OK);
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_ERROR_CANCELLED);
    EXPECT_EQ(bits(host.view(surface)), before);
    desc.curves = path(host, surface, stops);
    ASSERT_EQ(flgSurfaceCutCurves(host.context, &desc, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_OK);
    expect_valid(host.view(surface));
}

TEST(CuttingApi, ATriangleAndLoosePiecesCanBeCut) {
    const SurfaceHost host;
    const FlgSurface one = host.surface(loose_triangles(1));
    ASSERT_EQ(cut(host, at_levels(host.field(one, along_x), {0.5f}, 1)), FLG_OK);
    EXPECT_EQ(host.view(one).mesh->triangle_count, 3u);
    EXPECT_NEAR(areas(host.view(one))[2], 0.125, 1e-6);
    const FlgSurface pieces = host.surface(loose_triangles(100));
    FlgSurfaceCutIsolinesDesc desc = flgSurfaceCutIsolinesDefaults();
    desc.field = host.field(pieces, along_x);
    desc.level_first = 0.5f;
    desc.level_every = 2;
    ASSERT_EQ(cut(host, desc), FLG_OK);
    EXPECT_EQ(host.view(pieces).mesh->triangle_count, 300u);
    expect_valid(host.view(pieces));
    desc.field = host.field(pieces, along_x);
    desc.level_every = 0.1f;
    EXPECT_EQ(cut(host, desc), FLG_ERROR_LIMIT) << "more than 256 levels";
}

}  // namespace
}  // namespace flg::test
