// SPDX-License-Identifier: MIT
// The four operators on shapes where their partitions are known.
#include "tangles/tangle_host.h"

namespace flg::test {
namespace {

FlgTangleSeeds at_points(const std::vector<FlgSurfacePoint>& points) {
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.points = points.data();
    seeds.point_count = static_cast<uint32_t>(points.size());
    return seeds;
}

FlgTangleSeeds at_stretch(const FlgBorderStretch& stretch) {
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.stretches = &stretch;
    seeds.stretch_count = 1;
    return seeds;
}

const Regions root = {0};

TEST(TangleOperators, ContoursAreRingsOfTwoGroups) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(40));
    const FlgTangle tangle = host.tangle(surface);
    const std::vector<FlgSurfacePoint> middle = {point_above(host.view(surface), 0.5, 0.5)};
    ASSERT_EQ(host.divide(contour(tangle, root, at_points(middle), 0.1f, 4)), FLG_OK);
    expect_valid(host, surface, tangle, 1);
    const FlgSurfaceView view = host.view(surface);
    const std::map<uint32_t, double> parts = areas(view);
    ASSERT_EQ(parts.size(), 5u);
    for (uint32_t child : host.children(tangle, 0)) {
        const FlgTangleRegion node = host.region(tangle, child);
        EXPECT_EQ(node.group, host.region(tangle, 1 + node.part % 2).group) << "even and odd parts";
        const double inner = M_PI * 0.01 * node.part * node.part;
        const double expected = node.part == 4 ? 1 - inner : M_PI * 0.01 * (node.part + 1) * (node.part + 1) - inner;
        EXPECT_NEAR(parts.at(child), expected, 0.002) << "ring " << node.part;
    }
    EXPECT_NE(host.region(tangle, 1).group, host.region(tangle, 2).group);
    EXPECT_EQ(host.info(tangle).group_count, 3u);
}

TEST(TangleOperators, InnerNodesAreTheIntersectionWithTheirLeaves) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(24));
    const FlgTangle tangle = host.tangle(surface);
    // From the left side, then, on the root again, from the lower one: the square's outline begins at the origin.
    ASSERT_EQ(host.divide(contour(tangle, root, at_stretch({0, 0.75f, 1}), 0.3f, 3)), FLG_OK);
    ASSERT_EQ(host.info(tangle).leaf_count, 4u);
    ASSERT_EQ(host.divide(contour(tangle, root, at_stretch({0, 0, 0.25f}), 0.4f, 2)), FLG_OK);
    expect_valid(host, surface, tangle, 1);
    const FlgSurfaceView view = host.view(surface);
    ASSERT_EQ(areas(view).size(), 12u);
    EXPECT_EQ(host.info(tangle).depth, 2u);
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> group_of;
    for (const auto& [label, area] : areas(view)) {
        const FlgTangleRegion cell = host.region(tangle, label), strip = host.region(tangle, cell.parent);
        EXPECT_NEAR(area, (strip.part == 3 ? 0.1 : 0.3) * (cell.part == 2 ? 0.2 : 0.4), 3.5e-4);
        const auto [found, is_new] = group_of.insert({{strip.group, cell.part % 2}, cell.group});
        EXPECT_EQ(found->second, cell.group) << "one group a combination";
    }
    std::set<uint32_t> groups;
    for (const auto& [combination, group] : group_of) groups.insert(group);
    EXPECT_EQ(group_of.size(), 4u);
    EXPECT_EQ(groups.size(), 4u);
}

TEST(TangleOperators, GroupsAreAsAskedFor) {
    for (const auto& [grouping, count] : {std::pair{FLG_TANGLE_GROUPING_ONE, 1u},
                                          {FLG_TANGLE_GROUPING_TWO, 2u},
                                          {FLG_TANGLE_GROUPING_CYCLE, 3u},
                                          {FLG_TANGLE_GROUPING_EACH, 8u}}) {
        const TangleHost host;
        const FlgSurface surface = host.surface(plane(16));
        const FlgTangle tangle = host.tangle(surface);
        const FlgBorderStretch left = {0, 0.75f, 1};
        FlgTangleDivideDesc desc = contour(tangle, root, at_stretch(left), 0.125f, 7);
        desc.grouping = grouping;
        ASSERT_EQ(host.divide(desc), FLG_OK);
        std::set<uint32_t> groups;
        for (uint32_t leaf : host.leaves(tangle)) groups.insert(host.region(tangle, leaf).group);
        EXPECT_EQ(groups.size(), count);
    }
}

TEST(TangleOperators, BlendsLieBetweenTheirSeeds) {
    const TangleHost host;
    const FlgSurface surface = host.surface(cylinder(48, 20));
    const FlgTangle tangle = host.tangle(surface);
    const FlgBorderStretch low = {0, 0, 1}, high = {1, 0, 1};
    FlgTangleDivideDesc desc = contour(tangle, root, at_stretch(low), 0.25f, 3);
    desc.b = kept(at_stretch(high));
    ASSERT_EQ(host.divide(desc), FLG_OK);
    const double whole = host.report(surface).area;
    expect_valid(host, surface, tangle, whole);
    const std::map<uint32_t, double> parts = areas(host.view(surface));
    ASSERT_EQ(parts.size(), 4u);
    for (const auto& [label, area] : parts) EXPECT_NEAR(area, whole / 4, 1e-3 * whole);
}

TEST(TangleOperators, StreamsMakeEqualStrips) {
    const TangleHost host;
    const FlgSurface surface = host.surface(cylinder(48, 12));
    const FlgTangle tangle = host.tangle(surface);
    const double whole = host.report(surface).area, around = whole / 2;
    const FlgBorderStretch low = {0, 0, 1};
    FlgTangleDivideDesc desc = contour(tangle, root, at_stretch(low), static_cast<float>(around / 10), 1);
    desc.kind = FLG_TANGLE_OPERATOR_STREAM;
    ASSERT_EQ(host.divide(desc), FLG_OK);
    expect_valid(host, surface, tangle, whole);
    const FlgSurfaceView view = host.view(surface);
    const std::map<uint32_t, double> parts = areas(view);
    ASSERT_EQ(parts.size(), 10u);
    for (const auto& [label, area] : parts) EXPECT_NEAR(area, whole / 10, 1e-3 * whole);
    expect_chequered(host, surface, tangle);  // parts are counted around
}

TEST(TangleOperators, StreamsOfBothBordersEndAtTheRidgeBetweenThem) {
    const TangleHost host;
    const FlgSurface surface = host.surface(cylinder(120, 30));
    const FlgTangle tangle = host.tangle(surface);
    const double whole = host.report(surface).area;
    FlgTangleDivideDesc desc = contour(tangle, root, borders(FLG_TANGLE_BORDERS_OUTER), 0.4f, 1);
    desc.kind = FLG_TANGLE_OPERATOR_STREAM;
    ASSERT_EQ(host.divide(desc), FLG_OK);
    expect_valid(host, surface, tangle, whole);
    // 2 pi / 0.4 to the next even number, twice: half of the tube each.
    const std::map<uint32_t, double> strips = areas(host.view(surface));
    ASSERT_EQ(strips.size(), 32u);
    for (const auto& [label, area] : strips) EXPECT_NEAR(area, whole / 32, 0.03 * whole / 32);
}

// The strip of a stretch of the outline is what lies between it and the diagonals.
TEST(TangleOperators, StreamsOfASquareEndAtItsDiagonals) {
    constexpr int count = 42;
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(60));
    const FlgTangle tangle = host.tangle(surface);
    FlgTangleDivideDesc desc = contour(tangle, root, borders(FLG_TANGLE_BORDERS_OUTER), 4.0f / count, 1);
    desc.kind = FLG_TANGLE_OPERATOR_STREAM;
    ASSERT_EQ(host.divide(desc), FLG_OK);
    expect_valid(host, surface, tangle, 1);
    const std::map<uint32_t, double> strips = areas(host.view(surface));
    ASSERT_EQ(strips.size(), size_t{count});
    // What lies before a place on the outline, in metres from a corner.
    const auto area_up_to = [](double along) {
        const double side = std::floor(along), x = along - side;
        return 0.25 * side + (x < 0.5 ? x * x / 2 : 0.25 - (1 - x) * (1 - x) / 2);
    };
    std::vector<double> sorted, expected;
    for (const auto& [label, area] : strips) sorted.push_back(area);
    for (int i = 0; i < count; ++i) expected.push_back(area_up_to(4.0 * (i + 1) / count) - area_up_to(4.0 * i / count));
    std::sort(sorted.begin(), sorted.end());
    std::sort(expected.begin(), expected.end());
    for (int i = 0; i < count; ++i) EXPECT_NEAR(sorted[i], expected[i], 0.0012) << i;
}

TEST(TangleOperators, StreamsOfEachLeafStayInIt) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(60));
    const FlgTangle tangle = host.tangle(surface);
    ASSERT_EQ(host.divide(contour(tangle, root, at_stretch({0, 0.75f, 1}), 0.25f, 3)), FLG_OK);
    FlgTangleDivideDesc desc = contour(tangle, root, borders(FLG_TANGLE_BORDERS_EACH), 0.14f, 1);
    desc.kind = FLG_TANGLE_OPERATOR_STREAM;
    ASSERT_EQ(host.divide(desc), FLG_OK);
    expect_valid(host, surface, tangle, 1);
    // Each leaf of 2.5 m of border: 18 strips, which tile it; but where a stream starts in a triangle that fills a
    // corner those beside it may be one.
    std::map<uint32_t, double> of_leaf;
    std::map<uint32_t, uint32_t> count;
    uint32_t odd = 0;
    for (const auto& [label, area] : areas(host.view(surface))) {
        of_leaf[host.region(tangle, label).parent] += area;
        ++count[host.region(tangle, label).parent];
        odd += host.region(tangle, label).part % 2;
    }
    EXPECT_NEAR(odd, 36, 6) << "they take turns";
    ASSERT_EQ(of_leaf.size(), 4u);
    for (const auto& [leaf, area] : of_leaf) {
        EXPECT_NEAR(area, 0.25, 1e-5);
        EXPECT_GE(count[leaf], 17u);
        EXPECT_LE(count[leaf], 18u);
    }
}

// A line that cuts off less than a millionth of the surface cuts off nothing.
TEST(TangleOperators, SpecksStayWithThePartBesideThem) {
    const TangleHost host;
    for (const double size : {0.0005, 0.02}) {
        const FlgSurface surface = host.surface(plane(8));
        const FlgTangle tangle = host.tangle(surface);
        const FlgSurfaceView view = host.view(surface);
        // From the left side to the lower one around the corner: a triangle of size^2 / 2, beside the whole.
        const std::vector<FlgSurfacePoint> points = {point_above(view, 0, size), point_above(view, size, 0),
                                                     point_above(view, size, 0.5), point_above(view, 1, 0.5)};
        FlgTangleDivideDesc desc = contour(tangle, root, at_points(points), 0.1f, 1);
        desc.kind = FLG_TANGLE_OPERATOR_POLYLINE;
        ASSERT_EQ(host.divide(desc), FLG_OK);
        const std::map<uint32_t, double> parts = areas(host.view(surface));
        for (const auto& [label, area] : parts) EXPECT_GT(area, 1e-6);
        EXPECT_EQ(parts.size(), size < 0.01 ? 2u : 3u);
        expect_valid(host, surface, tangle, 1);
    }
}

TEST(TangleOperators, CellsAreNearestToTheirPoints) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(48));
    const FlgTangle tangle = host.tangle(surface);
    const std::vector<Point> places = {
        {0.21, 0.3, 0}, {0.74, 0.18, 0}, {0.55, 0.62, 0}, {0.13, 0.81, 0}, {0.9, 0.9, 0}};
    std::vector<FlgSurfacePoint> points;
    for (const Point& p : places) points.push_back(point_above(host.view(surface), p[0], p[1]));
    FlgTangleDivideDesc desc = contour(tangle, root, at_points(points), 1, 1);
    desc.kind = FLG_TANGLE_OPERATOR_VORONOI;
    ASSERT_EQ(host.divide(desc), FLG_OK);
    expect_valid(host, surface, tangle, 1);
    const FlgSurfaceView view = host.view(surface);
    ASSERT_EQ(areas(view).size(), 5u);
    // The area that is labelled otherwise than by the nearest point.
    std::map<uint32_t, std::set<uint32_t>> nearest_of;
    std::map<std::pair<uint32_t, uint32_t>, double> shared;
    for (uint32_t t = 0; t < view.mesh->triangle_count; ++t) {
        const Point c = point_at(view, {t, 1 / 3.0f, 1 / 3.0f});
        uint32_t nearest = 0;
        for (uint32_t i = 1; i < places.size(); ++i) {
            if (distance(c, places[i]) < distance(c, places[nearest])) nearest = i;
        }
        shared[{view.mesh->regions[t], nearest}] += area_of(view, t);
    }
    double right = 0;
    for (uint32_t label : host.leaves(tangle)) {
        double most = 0;
        for (uint32_t i = 0; i < places.size(); ++i) most = std::max(most, shared[{label, i}]);
        right += most;
    }
    EXPECT_GT(right, 0.997);
}

TEST(TangleOperators, SamplesKeepTheirDistance) {
    const TangleHost host;
    const FlgSurface surface = host.surface(sphere(32));
    const FlgTangle tangle = host.tangle(surface);
    FlgTangleSeeds samples = flgTangleSeedsDefaults();
    samples.sample_radius = 0.5f;
    ASSERT_EQ(host.divide(contour(tangle, root, samples, 0.2f, 1)), FLG_OK);
    const double whole = host.report(surface).area;
    expect_valid(host, surface, tangle, whole);
    uint32_t dots = 0;
    const std::map<uint32_t, double> parts = areas(host.view(surface));
    for (uint32_t child : host.children(tangle, 0)) {
        if (host.region(tangle, child).part == 1) continue;
        ++dots;
        EXPECT_NEAR(parts.at(child), 2 * M_PI * (1 - std::cos(0.2)), 0.004);
    }
    // Discs of half the radius fit side by side, of the whole radius cover everything.
    const auto cap = [](double radius) { return 2 * M_PI * (1 - std::cos(radius)); };
    EXPECT_GE(dots, 4 * M_PI / cap(0.5));
    EXPECT_LE(dots, 4 * M_PI / cap(0.25));
}

TEST(TangleOperators, PolylinesDivideWhatTheySeparate) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(12));
    const FlgTangle tangle = host.tangle(surface);
    const FlgSurfaceView view = host.view(surface);
    const std::vector<FlgSurfacePoint> stops = {point_above(view, 0.3, 0), point_above(view, 0.3, 1)};
    FlgTangleDivideDesc desc = contour(tangle, root, at_points(stops), 1, 1);
    desc.kind = FLG_TANGLE_OPERATOR_POLYLINE;
    ASSERT_EQ(host.divide(desc), FLG_OK);
    expect_valid(host, surface, tangle, 1);
    const std::map<uint32_t, double> parts = areas(host.view(surface));
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_NEAR(std::min(parts.begin()->second, parts.rbegin()->second), 0.3, 1e-3);

    // One that ends inside separates nothing: a step, but no region.
    const FlgTangleInfo before = host.info(tangle);
    const std::vector<FlgSurfacePoint> inside = {point_above(host.view(surface), 0.5, 0.5),
                                                 point_above(host.view(surface), 0.8, 0.6)};
    desc = contour(tangle, root, at_points(inside), 1, 1);
    desc.kind = FLG_TANGLE_OPERATOR_POLYLINE;
    ASSERT_EQ(host.divide(desc), FLG_OK);
    EXPECT_EQ(host.info(tangle).region_count, before.region_count);
    EXPECT_EQ(host.info(tangle).undo_count, before.undo_count + 1);
}

TEST(TangleOperators, EachBorderIsASeedOfItsOwn) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(40));
    const FlgTangle tangle = host.tangle(surface);
    const FlgBorderStretch left = {0, 0.75f, 1};
    ASSERT_EQ(host.divide(contour(tangle, root, at_stretch(left), 0.5f, 1)), FLG_OK);
    ASSERT_EQ(host.info(tangle).leaf_count, 2u);
    ASSERT_EQ(host.divide(contour(tangle, root, borders(FLG_TANGLE_BORDERS_EACH), 0.1f, 1)), FLG_OK);
    expect_valid(host, surface, tangle, 1);
    const std::map<uint32_t, double> parts = areas(host.view(surface));
    ASSERT_EQ(parts.size(), 4u);
    for (const auto& [label, area] : parts) {
        EXPECT_NEAR(area, host.region(tangle, label).part == 0 ? 0.5 - 0.3 * 0.8 : 0.3 * 0.8, 1e-3);
    }
}

TEST(TangleOperators, ScaffoldsAreNotSeen) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(24));
    const FlgTangle tangle = host.tangle(surface);
    const FlgBorderStretch left = {0, 0.75f, 1}, low = {0, 0, 0.25f};
    FlgTangleDivideDesc desc = contour(tangle, root, at_stretch(left), 0.5f, 1);
    desc.scaffold = 1;
    ASSERT_EQ(host.divide(desc), FLG_OK);
    const Regions halves = host.children(tangle, 0);
    for (uint32_t half : halves) {
        EXPECT_EQ(host.region(tangle, half).look, 0u);
        EXPECT_EQ(host.region(tangle, half).visible_group, 0u);
    }
    EXPECT_NE(host.region(tangle, halves[0]).group, host.region(tangle, halves[1]).group);
    ASSERT_EQ(host.divide(contour(tangle, root, at_stretch(low), 0.5f, 1)), FLG_OK);
    std::map<uint32_t, uint32_t> leaves_of_look;
    for (uint32_t leaf : host.leaves(tangle)) ++leaves_of_look[host.region(tangle, leaf).look];
    ASSERT_EQ(leaves_of_look.size(), 2u) << "only the second cut is seen";
    for (const auto& [look, count] : leaves_of_look) EXPECT_EQ(count, 2u);
}

// Every edge where looks differ is in one curve, and no other.
TEST(TangleOperators, BordersAreWhereLooksDiffer) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(24));
    const FlgTangle tangle = host.tangle(surface);
    const FlgBorderStretch left = {0, 0.75f, 1}, low = {0, 0, 0.25f};
    ASSERT_EQ(host.divide(contour(tangle, root, at_stretch(left), 0.5f, 1)), FLG_OK);
    FlgTangleDivideDesc scaffold = contour(tangle, root, at_stretch(low), 0.25f, 3);
    scaffold.scaffold = 1;
    ASSERT_EQ(host.divide(scaffold), FLG_OK);
    const std::vector<FlgSurfacePoint> middle = {point_above(host.view(surface), 0.8, 0.6)};
    ASSERT_EQ(host.divide(contour(tangle, root, at_points(middle), 0.15f, 1)), FLG_OK);
    FlgSurfaceCurves curves{};
    ASSERT_EQ(flgTangleTraceBorders(host.context, tangle, nullptr, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const FlgSurfaceView view = host.view(surface);
    const FlgSurfaceCurvesView lines = host.view(curves);
    ASSERT_EQ(lines.curve_count, 2u) << "the first cut, and a circle";
    EXPECT_NEAR(lines.curve_values[0], 1, 1e-3);
    EXPECT_NEAR(lines.curve_values[1], 2 * M_PI * 0.15, 0.01);
    EXPECT_FALSE(lines.curve_flags[0] & FLG_CURVE_CLOSED);
    EXPECT_TRUE(lines.curve_flags[1] & FLG_CURVE_CLOSED);
    double expected = 0;
    for (uint32_t t = 0; t < view.mesh->triangle_count; ++t) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t other = view.neighbours[3 * t + k];
            if (other == FLG_NO_INDEX || other < t) continue;
            const uint32_t look = host.region(tangle, view.mesh->regions[t]).look;
            if (look == host.region(tangle, view.mesh->regions[other]).look) continue;
            expected += distance(vertex_at(view, view.mesh->triangles[3 * t + k]),
                                 vertex_at(view, view.mesh->triangles[3 * t + (k + 1) % 3]));
        }
    }
    EXPECT_NEAR(lines.curve_values[0] + lines.curve_values[1], expected, 1e-5);
}

TEST(TangleOperators, BeyondTheFieldNothingIsDivided) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(8));
    const FlgTangle tangle = host.tangle(surface);
    const std::string before = bits(host.view(surface));
    ASSERT_EQ(host.divide(contour(tangle, root, borders(FLG_TANGLE_BORDERS_OUTER), 10, 3)), FLG_OK);
    EXPECT_EQ(bits(host.view(surface)), before);
    EXPECT_EQ(host.info(tangle).region_count, 1u);
    EXPECT_EQ(host.info(tangle).undo_count, 1u);
}

}  // namespace
}  // namespace flg::test
