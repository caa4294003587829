// SPDX-License-Identifier: MIT
// Polylines along lines that were laid onto the surface.
#include "filigree/filigree_project.h"
#include "tangles/tangle_host.h"

namespace flg::test {
namespace {

const Regions root = {0};

// A closed one, counter-clockwise seen from above; or open.
FlgSurfaceCurves lay(const TangleHost& host, FlgSurface surface, const std::vector<Point>& line, bool closed) {
    Curves curves;
    for (const Point& p : line) curves.add_point(p[0], p[1], p[2]);
    curves.end_curve(closed ? FLG_CURVE_CLOSED : 0);
    FlgCurveSetProjectDesc desc = flgCurveSetProjectDefaults();
    desc.surface = surface;
    desc.curves = host.create(curves);
    FlgSurfaceCurves laid{};
    EXPECT_EQ(flgCurveSetProject(host.context, &desc, &laid, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    return laid;
}

FlgTangleDivideDesc along(FlgTangle tangle, const Regions& regions, FlgSurfaceCurves curves) {
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.curves = curves;
    FlgTangleDivideDesc desc = contour(tangle, regions, seeds, 1, 1);
    desc.kind = FLG_TANGLE_OPERATOR_POLYLINE;
    return desc;
}

const std::vector<Point> square = {{0.3, 0.2, 0}, {0.7, 0.2, 0}, {0.7, 0.6, 0}, {0.3, 0.6, 0}};

TEST(TangleLines, WhatAClosedLineEnclosesIsTheForeground) {
    for (bool turned : {false, true}) {
        const TangleHost host;
        const FlgSurface surface = host.surface(plane(15));
        const FlgTangle tangle = host.tangle(surface);
        std::vector<Point> line = square;
        if (turned) std::reverse(line.begin(), line.end());
        ASSERT_EQ(host.divide(along(tangle, root, lay(host, surface, line, true))), FLG_OK);
        expect_valid(host, surface, tangle, 1);
        const std::map<uint32_t, double> parts = areas(host.view(surface));
        ASSERT_EQ(parts.size(), 2u);
        for (const auto& [region, area] : parts) {
            const bool inside = area < 0.5;
            EXPECT_NEAR(area, inside ? 0.16 : 0.84, 1e-4);
            EXPECT_EQ(host.region(tangle, region).part, inside == turned ? 1u : 0u);
        }
    }
}

// The line runs through two regions, of which one is divided.
TEST(TangleLines, AreCutWithinTheRegionsOnly) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(15));
    const FlgTangle tangle = host.tangle(surface);
    const std::vector<Point> middle = {{0.5, -0.1, 0}, {0.5, 1.1, 0}};
    ASSERT_EQ(host.divide(along(tangle, root, lay(host, surface, middle, false))), FLG_OK);
    const Regions halves = host.leaves(tangle);
    ASSERT_EQ(halves.size(), 2u);
    const uint32_t left = host.region(tangle, halves[0]).part == 0 ? halves[0] : halves[1];
    const std::vector<FlgMeshView> before = {*host.view(surface).mesh};
    std::map<uint32_t, uint32_t> triangles;
    for (uint32_t t = 0; t < before[0].triangle_count; ++t) ++triangles[before[0].regions[t]];

    ASSERT_EQ(host.divide(along(tangle, {left}, lay(host, surface, square, true))), FLG_OK);
    expect_valid(host, surface, tangle, 1);
    const FlgSurfaceView view = host.view(surface);
    const std::map<uint32_t, double> parts = areas(view);
    ASSERT_EQ(parts.size(), 3u);
    std::map<uint32_t, uint32_t> after;
    for (uint32_t t = 0; t < view.mesh->triangle_count; ++t) ++after[view.mesh->regions[t]];
    for (const auto& [region, area] : parts) {
        if (host.region(tangle, region).parent == left) {
            const bool inside = host.region(tangle, region).part == 0;
            EXPECT_NEAR(area, inside ? 0.08 : 0.42, 1e-4);
        } else {
            EXPECT_EQ(after[region], triangles[region]) << "the other half is as it was";
        }
    }
}

// A spike that goes out and back, and a small loop the wrong way round, do not turn the sides about.
TEST(TangleLines, SidesGoByTheLongerPart) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(15));
    const FlgTangle tangle = host.tangle(surface);
    const std::vector<Point> line = {{0.3, 0.2, 0},   {0.7, 0.2, 0},  {0.7, 0.3, 0}, {0.8, 0.3, 0},  {0.7, 0.3, 0},
                                     {0.7, 0.6, 0},   {0.5, 0.6, 0},  {0.5, 0.7, 0}, {0.55, 0.7, 0}, {0.55, 0.65, 0},
                                     {0.45, 0.65, 0}, {0.45, 0.6, 0}, {0.3, 0.6, 0}};
    ASSERT_EQ(host.divide(along(tangle, root, lay(host, surface, line, true))), FLG_OK);
    expect_valid(host, surface, tangle, 1);
    for (const auto& [region, area] : areas(host.view(surface))) {
        if (area < 0.1) continue;
        EXPECT_EQ(host.region(tangle, region).part, area < 0.5 ? 0u : 1u);
    }
}

TEST(TangleLines, AnOpenLineDividesByItsSides) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(10));
    const FlgTangle tangle = host.tangle(surface);
    const std::vector<Point> up = {{0.3, 0, 0}, {0.3, 1, 0}};
    ASSERT_EQ(host.divide(along(tangle, root, lay(host, surface, up, false))), FLG_OK);
    for (const auto& [region, area] : areas(host.view(surface))) {
        EXPECT_NEAR(area, host.region(tangle, region).part == 0 ? 0.3 : 0.7, 1e-4);
    }
}

TEST(TangleLines, JoinPointsWithTheirShortestWays) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(10));
    const FlgTangle tangle = host.tangle(surface);
    FlgTangleDivideDesc desc = along(tangle, root, lay(host, surface, square, true));
    const FlgSurfaceView view = host.view(surface);
    const std::vector<FlgSurfacePoint> points = {point_above(view, 0, 0.8), point_above(view, 1, 0.8)};
    FlgTangleSeeds a = *desc.a;
    a.points = points.data();
    a.point_count = 2;
    desc.a = &a;
    ASSERT_EQ(host.divide(desc), FLG_OK);
    const std::map<uint32_t, double> parts = areas(host.view(surface));
    EXPECT_EQ(parts.size(), 3u);
    a.point_count = 1;
    a.curves = lay(host, surface, square, true);
    expect_failure(flgTangleDivide(host.context, &desc, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "desc.a.point_count is 1, a polyline needs 2 points at least");
}

// On a mesh four times as fine a stretch that lay in one triangle crosses several: lines are laid anew.
TEST(TangleLines, AreFoundOnAFinerMesh) {
    const TangleHost host;
    const FlgSurface coarse = host.surface(plane(7)), fine = host.surface(plane(31));
    const FlgTangle from = host.tangle(coarse), to = host.tangle(fine);
    ASSERT_EQ(host.divide(along(from, root, lay(host, coarse, square, true))), FLG_OK);
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    ASSERT_EQ(flgTangleGetHistory(host.context, from, &history), FLG_OK) << flgErrorGetMessage();
    FlgJob job{};
    ASSERT_EQ(flgTangleReplay(host.context, to, &history, nullptr, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    ASSERT_EQ(host.result_of(job), FLG_OK) << host.status_of(job).error;
    EXPECT_EQ(host.tree_bits(to), host.tree_bits(from));
    for (const auto& [region, area] : areas(host.view(fine))) {
        EXPECT_NEAR(area, host.region(to, region).part == 0 ? 0.16 : 0.84, 1e-3);
    }
}

}  // namespace
}  // namespace flg::test
