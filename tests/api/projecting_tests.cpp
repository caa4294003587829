// SPDX-License-Identifier: MIT
// Curves in space laid onto surfaces behind the C ABI, and what is refused.
#include <set>

#include "api/surface_refusals.h"
#include "filigree/filigree_project.h"

namespace flg::test {
namespace {

using Line = std::vector<Point>;

Curves curves_of(const std::vector<Line>& lines, bool closed) {
    Curves curves;
    for (const Line& line : lines) {
        for (const Point& p : line) curves.add_point(p[0], p[1], p[2]);
        curves.end_curve(closed ? FLG_CURVE_CLOSED : 0);
    }
    return curves;
}

struct Laid {
    FlgSurfaceCurves curves{};
    FlgJob job{};
};

Laid lay(const SurfaceHost& host, FlgSurface surface, const std::vector<Line>& lines, bool closed,
         uint32_t budget_us = FLG_UNLIMITED) {
    FlgCurveSetProjectDesc desc = flgCurveSetProjectDefaults();
    desc.surface = surface;
    desc.curves = host.create(curves_of(lines, closed));
    Laid laid;
    EXPECT_EQ(flgCurveSetProject(host.context, &desc, &laid.curves, &laid.job), FLG_OK) << flgErrorGetMessage();
    host.finish(budget_us);
    return laid;
}

// Around (x, y), `height` above the plane.
Line circle(double x, double y, double radius, uint32_t points, double height) {
    Line line;
    for (uint32_t i = 0; i < points; ++i) {
        const double angle = 2 * M_PI * i / points;
        line.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle), height});
    }
    return line;
}

// Two squares that nothing joins.
MeshArrays two_sheets() {
    MeshArrays mesh = plane(4);
    const uint32_t first = mesh.vertex_count();
    const MeshArrays other = plane(4);
    for (uint32_t v = 0; v < first; ++v) mesh.add_vertex(other.vertex(v)[0] + 3, other.vertex(v)[1], 0);
    for (uint32_t t = 0; t < other.triangle_count(); ++t) {
        const uint32_t* corners = other.triangles.data() + 3 * size_t{t};
        mesh.add_triangle(first + corners[0], first + corners[1], first + corners[2]);
    }
    return mesh;
}

// A square without its middle.
MeshArrays frame() {
    MeshArrays mesh = plane(20);
    std::vector<uint32_t> kept;
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const Point p = mesh.centre(t);
        if (std::abs(p[0] - 0.5) < 0.2 && std::abs(p[1] - 0.5) < 0.2) continue;
        kept.insert(kept.end(), mesh.triangles.begin() + 3 * t, mesh.triangles.begin() + 3 * t + 3);
    }
    mesh.triangles = kept;
    return mesh;
}

TEST(Projecting, ClosedCurvesCutOutWhatTheyEnclose) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(30));
    const Laid laid = lay(host, surface, {circle(0.4, 0.5, 0.2, 24, 0.3), circle(0.8, 0.2, 0.1, 5, -0.1)}, true);
    const FlgSurfaceCurvesView view = host.view(laid.curves);
    ASSERT_EQ(view.curve_count, 2u);
    EXPECT_EQ(view.curve_flags[0], FLG_CURVE_CLOSED);
    EXPECT_NEAR(view.curve_values[0], 24 * 0.4 * std::sin(M_PI / 24), 1e-5);
    EXPECT_NEAR(view.curve_values[1], 5 * 0.2 * std::sin(M_PI / 5), 1e-5);
    FlgSurfaceCutCurvesDesc cut = flgSurfaceCutCurvesDefaults();
    cut.curves = laid.curves;
    cut.first_label = 1;
    ASSERT_EQ(flgSurfaceCutCurves(host.context, &cut, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    std::vector<double> found;
    for (const auto& [label, area] : areas(host.view(surface))) found.push_back(area);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), 3u);
    EXPECT_NEAR(found[0], 2.5 * 0.01 * std::sin(2 * M_PI / 5), 1e-5);
    EXPECT_NEAR(found[1], 12 * 0.04 * std::sin(2 * M_PI / 24), 1e-5);
}

TEST(Projecting, GoesAroundWhatThePlaneMisses) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(frame());
    const Laid laid = lay(host, surface, {{{0.1, 0.5, 0}, {0.9, 0.5, 0}}}, false);
    const FlgSurfaceCurvesView view = host.view(laid.curves);
    ASSERT_EQ(view.curve_count, 1u);
    // By two corners of the hole, whose sides lie at 0.3 and 0.7.
    EXPECT_NEAR(view.curve_values[0], 2 * std::hypot(0.2, 0.2) + 0.4, 1e-4);
}

TEST(Projecting, PointsFarOffComeToTheBorder) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(8));
    const Laid laid = lay(host, surface, {{{-5, -7, 2}, {9, -4, 1}}, {{1000, 0.5, 0}, {-1000, 0.5, 0}}}, false);
    const FlgSurfaceCurvesView view = host.view(laid.curves);
    ASSERT_EQ(view.curve_count, 2u);
    EXPECT_NEAR(view.curve_values[0], 1, 1e-6) << "along the lower side";
    for (uint32_t i = 0; i < view.curve_offsets[1]; ++i) {
        EXPECT_NEAR(point_at(host.view(surface), view.points[i])[1], 0, 1e-6);
    }
    EXPECT_NEAR(view.curve_values[1], 1, 1e-4);
}

TEST(Projecting, CurvesThatComeToAPointAreLeftOut) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(8));
    const Line point = {{0.3, 0.4, 0}}, above = {{0.3, 0.4, 1}, {0.3, 0.4, 2}, {0.3, 0.4, 3}},
               line = {{0.2, 0.2, 0}, {0.2, 0.2, 0}, {0.6, 0.7, 0}};
    const Laid laid = lay(host, surface, {point, line, above}, false);
    ASSERT_EQ(host.view(laid.curves).curve_count, 1u);
    EXPECT_NEAR(host.view(laid.curves).curve_values[0], std::hypot(0.4, 0.5), 1e-6);
    EXPECT_EQ(host.view(lay(host, surface, {point, above}, true).curves).curve_count, 0u);
}

TEST(Projecting, SameBitsUnderAnyBudgetAndWorkers) {
    std::set<std::string> results;
    for (uint32_t workers : {0u, 3u}) {
        for (uint32_t budget_us : {FLG_UNLIMITED, 20u}) {
            const SurfaceHost host(workers);
            const FlgSurface surface = host.surface(cylinder(40, 20));
            Line line;
            for (int i = 0; i < 60; ++i) line.push_back({1.2 * std::cos(0.1 * i), 1.2 * std::sin(0.1 * i), 0.03 * i});
            const Laid laid = lay(host, surface, {line, circle(0, 0, 1.5, 30, 1)}, true, budget_us);
            EXPECT_EQ(host.result_of(laid.job), FLG_OK) << host.status_of(laid.job).error;
            results.insert(bits(host.view(laid.curves)));
        }
    }
    EXPECT_EQ(results.size(), 1u);
}

TEST(Projecting, FailsWhereNoWayLeads) {
    const SurfaceHost host;
    const Laid laid =
        lay(host, host.surface(two_sheets()), {{{0.1, 0.1, 0}, {0.5, 0.5, 0}}, {{0.5, 0.5, 0}, {3.5, 0.5, 0}}}, false);
    EXPECT_EQ(host.result_of(laid.job), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(host.status_of(laid.job).error,
                 "desc.curves: no way leads over the surface to point 1 of curve 1 from the one before it");
}

TEST(Projecting, Refusals) {
    const Things things;
    FlgCurveSetProjectDesc good = flgCurveSetProjectDefaults();
    good.surface = things.surface;
    good.curves = things.host.create(curves_of({{{0, 0, 0}, {1, 1, 0}}}, false));
    const Refusal refused{things.host, &flgCurveSetProject, good};
    refused.common();
    using D = FlgCurveSetProjectDesc;
    refused([](D& d) { d.surface = {}; }, "desc.surface is null", FLG_ERROR_INVALID_HANDLE);
    refused([&](D& d) { d.surface = things.stale; }, "desc.surface", FLG_ERROR_INVALID_HANDLE);
    refused([](D& d) { d.curves = {}; }, "desc.curves is null", FLG_ERROR_INVALID_HANDLE);
}

}  // namespace
}  // namespace flg::test
