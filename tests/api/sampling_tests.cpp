// SPDX-License-Identifier: MIT
// Points spread over surfaces and along borders, behind the C ABI.
#include <set>

#include "api/surface_inputs.h"

namespace flg::test {
namespace {

FlgField sample(const SurfaceHost& host, const FlgSurfaceSampleDesc& desc) {
    FlgField field{};
    EXPECT_EQ(flgSurfaceSample(host.context, &desc, &field, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    return field;
}

FlgSurfaceCurves sample_border(const SurfaceHost& host, FlgSurface surface, uint32_t region, float spacing) {
    FlgSurfaceSampleBordersDesc desc = flgSurfaceSampleBordersDefaults();
    desc.surface = surface;
    desc.region = region;
    desc.spacing = spacing;
    FlgSurfaceCurves curves{};
    EXPECT_EQ(flgSurfaceSampleBorders(host.context, &desc, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    return curves;
}

// No two are nearer than the radius, none fits any more, and each vertex belongs to its nearest one.
TEST(SamplingApi, PointsKeepTheirDistanceAndFillTheSurface) {
    const SurfaceHost host;
    FlgSurfaceSampleDesc desc = flgSurfaceSampleDefaults();
    desc.surface = host.surface(plane(24));
    desc.radius = 0.2f;
    const FlgSurfaceView mesh = host.view(desc.surface);
    const FlgFieldView field = host.view(sample(host, desc));
    ASSERT_GT(field.sample_count, 10u);
    ASSERT_NE(field.labels, nullptr);
    const auto to_sample = [&](uint32_t vertex, uint32_t s) {
        return distance(vertex_at(mesh, vertex), vertex_at(mesh, field.samples[s]));
    };
    for (uint32_t s = 0; s < field.sample_count; ++s) {
        EXPECT_EQ(field.values[field.samples[s]], 0);
        EXPECT_EQ(field.labels[field.samples[s]], s);
        for (uint32_t other = 0; other < s; ++other) EXPECT_GT(to_sample(field.samples[s], other), 0.199);
    }
    for (uint32_t v = 0; v < field.vertex_count; ++v) {
        double nearest = 9;
        for (uint32_t s = 0; s < field.sample_count; ++s) nearest = std::min(nearest, to_sample(v, s));
        EXPECT_LT(field.values[v], 0.2f);
        EXPECT_NEAR(field.values[v], nearest, 0.002);
        ASSERT_LT(field.labels[v], field.sample_count);
        EXPECT_NEAR(to_sample(v, field.labels[v]), nearest, 0.002);
    }
}

TEST(SamplingApi, CountSeedAndRegionsAreAsAskedFor) {
    const SurfaceHost host;
    MeshArrays input = plane(20);
    input.set_regions([](const Point& p) { return p[0] > 0.5 ? 6u : 0u; });
    FlgSurfaceSampleDesc desc = flgSurfaceSampleDefaults();
    desc.surface = host.surface(input);
    desc.radius = 0.1f;
    const FlgFieldView all = host.view(sample(host, desc));
    EXPECT_EQ(bits(host.view(sample(host, desc))), bits(all));
    desc.max_count = 5;
    const FlgFieldView five = host.view(sample(host, desc));
    ASSERT_EQ(five.sample_count, 5u);
    for (uint32_t s = 0; s < 5; ++s) EXPECT_EQ(five.samples[s], all.samples[s]);
    std::set<uint32_t> first;
    for (desc.seed = 1; desc.seed < 20; ++desc.seed) first.insert(host.view(sample(host, desc)).samples[0]);
    EXPECT_GT(first.size(), 10u);
    const uint32_t region = 6;
    desc.regions = &region;
    desc.region_count = 1;
    desc.max_count = 0;
    const FlgFieldView half = host.view(sample(host, desc));
    ASSERT_GT(half.sample_count, 5u);
    for (uint32_t s = 0; s < half.sample_count; ++s) {
        EXPECT_GE(vertex_at(host.view(desc.surface), half.samples[s])[0], 0.5);
    }
    EXPECT_TRUE(std::isinf(half.values[0]));
    EXPECT_EQ(half.labels[0], FLG_NO_INDEX);
}

TEST(SamplingApi, EachPieceGetsAPointAndNoRegionNone) {
    const SurfaceHost host;
    FlgSurfaceSampleDesc desc = flgSurfaceSampleDefaults();
    desc.surface = host.surface(loose_triangles(100));
    desc.radius = 50;
    EXPECT_EQ(host.view(sample(host, desc)).sample_count, 100u);
    const uint32_t region = 77;
    desc.regions = &region;
    desc.region_count = 1;
    EXPECT_EQ(host.view(sample(host, desc)).sample_count, 0u);
    desc.region_count = 0;
    EXPECT_EQ(host.view(sample(host, desc)).sample_count, 0u) << "a list without labels holds no region";
}

TEST(SamplingApi, BordersAreDividedEvenly) {
    const SurfaceHost host;
    MeshArrays input = plane(10);
    input.set_regions(
        [](const Point& p) { return std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5)) < 0.2 ? 1u : 0u; });
    const FlgSurface surface = host.surface(input);
    const FlgSurfaceView mesh = host.view(surface);
    const FlgSurfaceCurvesView inner = host.view(sample_border(host, surface, 1, 0.21f));
    ASSERT_EQ(inner.curve_count, 1u);
    EXPECT_EQ(inner.curve_flags[0], FLG_CURVE_CLOSED);
    EXPECT_NEAR(inner.curve_values[0], 1.6, 1e-6);
    ASSERT_EQ(inner.curve_offsets[1], 8u);
    for (uint32_t i = 0; i < 8; ++i) {
        const Point p = point_at(mesh, inner.points[i]), q = point_at(mesh, inner.points[(i + 1) % 8]);
        EXPECT_NEAR(std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5)), 0.2, 1e-6);
        EXPECT_NEAR(distance(p, q), 0.2, 1e-5) << "corners are points here";
    }
    EXPECT_EQ(host.view(sample_border(host, surface, 0, 0.2f)).curve_count, 2u);
    EXPECT_EQ(host.view(sample_border(host, surface, 5, 0.2f)).curve_count, 0u);
    EXPECT_EQ(host.view(sample_border(host, host.surface(cube(2)), 0, 0.2f)).curve_count, 0u);
    const FlgSurfaceCurvesView ends = host.view(sample_border(host, host.surface(cylinder(32, 4)), 0, 100));
    ASSERT_EQ(ends.curve_count, 2u);
    EXPECT_EQ(ends.curve_offsets[2], 6u);
    EXPECT_NEAR(ends.curve_values[1], 64 * std::sin(M_PI / 32), 1e-5);
}

// Between samples lies more than one triangle: they are no cut.
TEST(SamplingApi, BorderSamplesCantBeCutIn) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(10));
    const std::string before = bits(host.view(surface));
    FlgSurfaceCutCurvesDesc desc = flgSurfaceCutCurvesDefaults();
    desc.curves = sample_border(host, surface, 0, 0.5f);
    FlgJob job{};
    ASSERT_EQ(flgSurfaceCutCurves(host.context, &desc, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(host.status_of(job).result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(bits(host.view(surface)), before);
}

}  // namespace
}  // namespace flg::test
