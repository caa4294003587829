// SPDX-License-Identifier: MIT
// What measuring and sampling surfaces refuses.
#include "api/surface_refusals.h"

namespace flg::test {
namespace {

TEST(SurfaceRefusals, Blends) {
    const Things things;
    FlgFieldBlendDesc good = flgFieldBlendDefaults();
    good.from = good.to = things.field;
    const Refusal refused{things.host, &flgFieldBlend, good};
    refused.common();
    using D = FlgFieldBlendDesc;
    refused([](D& d) { d.from = {}; }, "desc.from is null", FLG_ERROR_INVALID_HANDLE);
    refused([&](D& d) { d.to = things.stale_field; }, "desc.to", FLG_ERROR_INVALID_HANDLE);
    refused([&](D& d) { d.to = things.of_other; }, "desc.to belongs to another surface");
    things.cut();
    const FlgField later = things.host.field(things.surface, [](const Point& p) { return p[0]; });
    refused([&](D& d) { d.to = later; }, "desc.to belongs to revision 1 of the surface, not 0");
}

TEST(SurfaceRefusals, Distances) {
    const Things things;
    const uint32_t vertex = 0, label = FLG_REGION_MAX + 1;
    FlgFieldGeodesicDesc good = flgFieldGeodesicDefaults();
    good.surface = things.surface;
    good.vertices = &vertex;
    good.vertex_count = 1;
    const Refusal refused{things.host, &flgFieldCreateGeodesic, good};
    refused.common();
    using D = FlgFieldGeodesicDesc;
    expect_failure(flgFieldCreateGeodesic(things.host.context, &good, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "out_field is null");
    refused([](D& d) { d.surface = {}; }, "desc.surface is null", FLG_ERROR_INVALID_HANDLE);
    refused([](D& d) { d.vertex_count = 0; }, "desc has no sources");
    refused([](D& d) { d.vertices = nullptr; }, "desc.vertices is null");
    refused([](D& d) { d.point_count = 1; }, "desc.points is null");
    refused([](D& d) { d.border_region_count = 1; }, "desc.border_regions is null");
    refused([](D& d) { d.target_count = 1; }, "desc.targets is null");
    refused([](D& d) { d.region_count = 1; }, "desc.regions is null, but region_count is 1");
    refused([&](D& d) { d.regions = &label, d.region_count = 1; }, "desc.regions[0] is 16777216");
    refused([&](D& d) { d.border_regions = &label, d.border_region_count = 1; }, "desc.border_regions[0] is 16777216");
    for (float bad : {0.0f, -1.0f, nan}) refused([&](D& d) { d.max_distance = bad; }, "desc.max_distance is");
    for (float bad : {-1.0f, inf, nan}) refused([&](D& d) { d.perturbation = bad; }, "desc.perturbation is");
    for (float bad : {0.0f, -1.0f, inf, nan}) refused([&](D& d) { d.frequency = bad; }, "desc.frequency is");
    for (const FlgSurfacePoint& bad :
         std::vector<FlgSurfacePoint>{{0, -0.1f, 0}, {0, 0, -0.1f}, {0, 0.6f, 0.5f}, {0, nan, 0}, {0, 0, inf}}) {
        refused([&](D& d) { d.points = &bad, d.point_count = 1; }, "desc.points[0] has the weights");
    }
    refused([&](D& d) { d.curves = things.stale_curves; }, "desc.curves", FLG_ERROR_INVALID_HANDLE);
    refused([&](D& d) { d.curves = things.curves_of_other; }, "desc.curves belongs to another surface");
    things.cut();
    refused([&](D& d) { d.curves = things.curves; }, "desc.curves belongs to revision 0 of the surface, not 1");
}

TEST(SurfaceRefusals, IndicesThatOnlyTheJobCanCheck) {
    const Things things;
    const uint32_t vertex = 0, beyond = 9;
    const FlgSurfacePoint outside = {8, 0, 0};
    FlgFieldGeodesicDesc good = flgFieldGeodesicDefaults();
    good.surface = things.surface;
    good.vertices = &vertex;
    good.vertex_count = 1;
    const auto fails = [&](const FlgFieldGeodesicDesc& desc, const char* words) {
        FlgJob job{};
        things.host.start(desc, &job);
        things.host.finish();
        EXPECT_EQ(things.host.result_of(job), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_STREQ(things.host.status_of(job).error, words);
    };
    FlgFieldGeodesicDesc desc = good;
    desc.vertices = &beyond;
    fails(desc, "desc.vertices[0] is vertex 9, but there are 9 vertices");
    desc = good;
    desc.targets = &beyond;
    desc.target_count = 1;
    fails(desc, "desc.targets[0] is vertex 9, but there are 9 vertices");
    desc = good;
    desc.points = &outside;
    desc.point_count = 1;
    fails(desc, "desc.points[0] is in triangle 8, but there are 8 triangles");

    FlgFieldTraceStreamsDesc streams = flgFieldTraceStreamsDefaults();
    streams.field = things.field;
    streams.starts = &outside;
    streams.start_count = 1;
    FlgSurfaceCurves curves{};
    FlgJob job{};
    ASSERT_EQ(flgFieldTraceStreams(things.host.context, &streams, &curves, &job), FLG_OK);
    things.host.finish();
    EXPECT_STREQ(things.host.status_of(job).error, "desc.starts[0] is in triangle 8, but there are 8 triangles");
}

TEST(SurfaceRefusals, Samplings) {
    const Things things;
    const uint32_t label = FLG_REGION_MAX + 1;
    FlgSurfaceSampleDesc good = flgSurfaceSampleDefaults();
    good.surface = things.surface;
    good.radius = 1;
    const Refusal refused{things.host, &flgSurfaceSample, good};
    refused.common();
    using D = FlgSurfaceSampleDesc;
    refused([](D& d) { d.surface = {}; }, "desc.surface", FLG_ERROR_INVALID_HANDLE);
    for (float bad : {0.0f, -1.0f, inf, nan}) refused([&](D& d) { d.radius = bad; }, "desc.radius is");
    refused([](D& d) { d.region_count = 1; }, "desc.regions is null, but region_count is 1");
    refused([&](D& d) { d.regions = &label, d.region_count = 1; }, "desc.regions[0] is 16777216");

    FlgSurfaceSampleBordersDesc border = flgSurfaceSampleBordersDefaults();
    border.surface = things.surface;
    border.spacing = 1;
    const Refusal no_border{things.host, &flgSurfaceSampleBorders, border};
    no_border.common();
    using B = FlgSurfaceSampleBordersDesc;
    no_border([](B& d) { d.surface = {}; }, "desc.surface", FLG_ERROR_INVALID_HANDLE);
    for (float bad : {0.0f, -1.0f, inf, nan}) no_border([&](B& d) { d.spacing = bad; }, "desc.spacing is");
    no_border([](B& d) { d.region = FLG_NO_INDEX; }, "desc.region is 4294967295");
    border.spacing = 1e-9f;
    FlgSurfaceCurves curves{};
    FlgJob job{};
    ASSERT_EQ(flgSurfaceSampleBorders(things.host.context, &border, &curves, &job), FLG_OK);
    things.host.finish();
    EXPECT_EQ(things.host.result_of(job), FLG_ERROR_LIMIT);
}

}  // namespace
}  // namespace flg::test
