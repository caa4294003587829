// SPDX-License-Identifier: MIT
#include "surfaces/tracing/isolines.h"

#include <gtest/gtest.h>

#include "runtime/run_now.h"
#include "surfaces/curve_checks.h"

namespace flg::test {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

SurfaceCurves isolines(const Mesh& mesh, const std::vector<float>& values, const std::vector<float>& levels,
                       const RegionSet& regions = RegionSet(test_memory()), bool haltingly = false) {
    SurfaceCurves curves(test_memory());
    run_now(
        test_memory(), [&](Pace& pace) { return add_isolines(pace, mesh, values, levels, regions, curves); },
        haltingly);
    expect_valid(mesh, curves);
    return curves;
}

// Each point within 2^-24 of its edge's difference, and the higher values left of each stretch.
void expect_on_levels(const Mesh& mesh, const std::vector<float>& values, const SurfaceCurves& curves) {
    for (uint32_t c = 0; c < curves.curve_count(); ++c) {
        const auto points = points_of(curves, c);
        for (size_t i = 0; i < points.size(); ++i) {
            const Triple& t = mesh.triangles[points[i].triangle];
            const auto [low, high] = std::minmax({values[t[0]], values[t[1]], values[t[2]]});
            EXPECT_NEAR(value_at(mesh, values, points[i]), curves.values[c], (high - low) * 0x1p-23);
            if (i + 1 == points.size() && !curves.closed[c]) continue;
            const Vec3 from = position_of(mesh, points[i]), to = position_of(mesh, points[(i + 1) % points.size()]);
            const Vec3 a = mesh.position(t[0]), ab = mesh.position(t[1]) - a, ac = mesh.position(t[2]) - a;
            const Vec3 normal = ab.cross(ac);
            const Vec3 gradient = double{values[t[2]] - values[t[0]]} * normal.cross(ab) -
                                  double{values[t[1]] - values[t[0]]} * normal.cross(ac);
            EXPECT_GE(gradient.dot(normal.cross(to - from)), 0) << "curve " << c << " point " << i;
        }
    }
}

size_t count_closed(const SurfaceCurves& curves) {
    return static_cast<size_t>(std::count(curves.closed.begin(), curves.closed.end(), true));
}

TEST(Isolines, CirclesOnAPlane) {
    const Mesh mesh = make_mesh(plane(60, 0.3));
    const auto values = field_of(mesh, [](const Vec3& p) { return (p - Vec3(0.5, 0.5, 0)).norm(); });
    const SurfaceCurves curves = isolines(mesh, values, {0.1f, 0.2f, 0.4f, 0.6f});
    expect_on_levels(mesh, values, curves);
    // Three circles; the fourth leaves an arc in each corner.
    ASSERT_EQ(curves.curve_count(), 7u);
    EXPECT_EQ(count_closed(curves), 3u);
    const double arc = 0.6 * (std::numbers::pi / 2 - 2 * std::acos(0.5 / 0.6));
    for (uint32_t c = 0; c < curves.curve_count(); ++c) {
        const double expected = curves.closed[c] ? 2 * std::numbers::pi * curves.values[c] : arc;
        // The field's error is cell^2 / (8 radius), that of the length the square of cell / radius.
        EXPECT_NEAR(length_of(mesh, curves, c), expected, 0.01 * expected);
    }
}

TEST(Isolines, RingsOfACylinderHaveItsCircumference) {
    const uint32_t around = 40;
    const Mesh mesh = make_mesh(cylinder(around, 16));
    const auto values = field_of(mesh, [](const Vec3& p) { return p.z(); });
    // One of them through vertices of its value.
    const SurfaceCurves curves = isolines(mesh, values, {0.3f, 0.5f, 1.7f});
    expect_on_levels(mesh, values, curves);
    ASSERT_EQ(curves.curve_count(), 3u);
    for (uint32_t c = 0; c < 3; ++c) {
        EXPECT_TRUE(curves.closed[c]);
        EXPECT_NEAR(length_of(mesh, curves, c), 2 * around * std::sin(std::numbers::pi / around), 1e-5);
    }
}

// Morse theory: x on a lying torus has one minimum, two saddles (at -0.6 and 0.6) and one maximum.
TEST(Isolines, SplitAndMergeAtTheSaddlesOfATorus) {
    const Mesh mesh = make_mesh(torus(64, 32));
    const auto values = field_of(mesh, [](const Vec3& p) { return p.x(); });
    const std::pair<float, size_t> cases[] = {{-1.5f, 0}, {-1.3f, 1}, {-0.7f, 1}, {-0.5f, 2},
                                              {0.5f, 2},  {0.7f, 1},  {1.3f, 1},  {1.5f, 0}};
    for (const auto& [level, loops] : cases) {
        const SurfaceCurves curves = isolines(mesh, values, {level});
        expect_on_levels(mesh, values, curves);
        EXPECT_EQ(curves.curve_count(), loops) << level;
        EXPECT_EQ(count_closed(curves), loops);
    }
    // Exactly at the saddle value, a vertex's: one loop or two that touch, and closed.
    const SurfaceCurves saddle = isolines(mesh, values, {values[0] - 0.8f});
    EXPECT_EQ(count_closed(saddle), saddle.curve_count());
    EXPECT_GE(saddle.curve_count(), 1u);
}

// On a sphere each loop parts one piece from another: components above and components below are one more than loops.
TEST(Isolines, OfASphereAreAsManyAsItsPartsLessOne) {
    const Mesh mesh = make_mesh(sphere(3));
    std::vector<float> values;
    // Few values, so that many vertices, edges and whole triangles are exactly at a level.
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) values.push_back(float(random_below(5, v, 0, 4)));
    for (float level : {0.5f, 1.5f, 2.5f}) {
        std::vector<uint32_t> part(mesh.vertex_count());
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) part[v] = v;
        const std::function<uint32_t(uint32_t)> root = [&](uint32_t v) {
            return part[v] == v ? v : part[v] = root(part[v]);
        };
        for (Corner corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
            const uint32_t a = mesh.vertex_at(corner), b = mesh.vertex_at(next_corner(corner));
            if ((values[a] >= level) == (values[b] >= level)) part[root(a)] = root(b);
        }
        size_t parts = 0;
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) parts += root(v) == v;
        const SurfaceCurves curves = isolines(mesh, values, {level});
        expect_on_levels(mesh, values, curves);
        EXPECT_EQ(count_closed(curves), curves.curve_count());
        EXPECT_EQ(curves.curve_count(), parts - 1);
    }
}

TEST(Isolines, CloseWhereManyVerticesHaveTheirValue) {
    const Mesh mesh = make_mesh(sphere(3));
    for (uint64_t seed = 0; seed < 20; ++seed) {
        std::vector<float> values;
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) values.push_back(float(random_below(seed, v, 0, 3)));
        const SurfaceCurves curves = isolines(mesh, values, {0, 1, 2, 3});
        expect_on_levels(mesh, values, curves);
        EXPECT_EQ(count_closed(curves), curves.curve_count());
        EXPECT_GT(curves.curve_count(), 0u);
        for (uint32_t c = 0; c < curves.curve_count(); ++c) {
            const auto points = points_of(curves, c);
            for (size_t i = 0; i < points.size(); ++i) {
                EXPECT_NE(position_of(mesh, points[i]), position_of(mesh, points[(i + 1) % points.size()]));
            }
        }
    }
}

// A plateau of the level's value counts as above: its border is drawn once, along its edges.
TEST(Isolines, PassPlateausOnTheLowerSide) {
    const Mesh mesh = make_mesh(plane(10));
    const auto values = field_of(mesh, [](const Vec3& p) {
        return std::max(0.0,
                        4.0 - std::max(std::round(10 * std::abs(p.x() - 0.5)), std::round(10 * std::abs(p.y() - 0.5))));
    });
    const auto top = field_of(
        mesh, [&](const Vec3& p) { return std::abs(p.x() - 0.5) < 0.25 && std::abs(p.y() - 0.5) < 0.25 ? 1.0 : 0.0; });
    const SurfaceCurves curves = isolines(mesh, top, {1.0f});
    ASSERT_EQ(curves.curve_count(), 1u);
    EXPECT_NEAR(length_of(mesh, curves, 0), 4 * 0.4, 1e-6);
    // A plateau of a lower value has no isoline within.
    EXPECT_EQ(isolines(mesh, std::vector<float>(mesh.vertex_count(), 1.0f), {1.0f}).curve_count(), 0u);
    EXPECT_EQ(isolines(mesh, values, {4.0f}).curve_count(), 0u) << "a single vertex has no length";
}

TEST(Isolines, EndWhereTheFieldIsNotFinite) {
    const Mesh mesh = make_mesh(plane(20));
    auto values = field_of(mesh, [](const Vec3& p) { return p.y(); });
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        if (mesh.position(v).x() > 0.62) values[v] = v % 2 == 0 ? infinite : std::numeric_limits<float>::quiet_NaN();
    }
    const SurfaceCurves curves = isolines(mesh, values, {0.52f});
    ASSERT_EQ(curves.curve_count(), 1u);
    EXPECT_FALSE(curves.closed[0]);
    EXPECT_NEAR(length_of(mesh, curves, 0), 0.6, 1e-6);
}

TEST(Isolines, KeepToTheirRegions) {
    Mesh mesh = make_mesh(plane(20));
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t)
        mesh.regions[t] = mesh.position(mesh.triangles[t][0]).x() < 0.49 ? 3 : 70;
    const auto values = field_of(mesh, [](const Vec3& p) { return p.y(); });
    const uint32_t label = 70;
    const SurfaceCurves curves = isolines(mesh, values, {0.52f}, RegionSet(&label, 1, test_memory()));
    ASSERT_EQ(curves.curve_count(), 1u);
    for (const SurfacePoint& p : points_of(curves, 0)) EXPECT_EQ(mesh.regions[p.triangle], label);
    EXPECT_NEAR(length_of(mesh, curves, 0), 0.5, 0.05);
}

TEST(Isolines, TakeTrianglesWithoutArea) {
    // Two triangles with a third between them whose corners lie on a line, and one of two equal positions.
    const Soup soup{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}, {1, -1, 0}},
                    {{0, 2, 3}, {2, 1, 3}, {0, 1, 2}, {0, 4, 1}, {4, 5, 1}}};
    const Mesh mesh = make_mesh(soup);
    const std::vector<float> values{0, 2, 1.2f, 1, 1, 0.9f};
    const SurfaceCurves curves = isolines(mesh, values, {0.5f, 0.95f, 1.5f});
    expect_on_levels(mesh, values, curves);
    // 0.95 has vertex 0 and vertex 5 below it, apart from each other.
    EXPECT_EQ(curves.curve_count(), 4u);
    for (const SurfacePoint& p : curves.points) EXPECT_TRUE(std::isfinite(p.u) && std::isfinite(p.v));
}

TEST(Isolines, ManyLevelsAreThoseOneByOne) {
    const Mesh mesh = make_mesh(torus(40, 20));
    const auto values = field_of(mesh, [](const Vec3& p) { return p.x() + 0.3 * p.y(); });
    std::vector<float> levels;
    for (int i = -12; i <= 12; ++i) levels.push_back(0.1f * float(i));
    const SurfaceCurves all = isolines(mesh, values, levels);
    uint32_t count = 0;
    for (float level : levels) {
        const SurfaceCurves one = isolines(mesh, values, {level});
        for (uint32_t c = 0; c < one.curve_count(); ++c, ++count) {
            double length = 0;
            for (uint32_t d = 0; d < all.curve_count(); ++d) {
                if (all.values[d] == level &&
                    all.points[all.offsets[d]].triangle == one.points[one.offsets[c]].triangle) {
                    length = length_of(mesh, all, d);
                }
            }
            EXPECT_EQ(length, length_of(mesh, one, c));
        }
    }
    EXPECT_EQ(count, all.curve_count());
}

TEST(Isolines, DoNotDependOnSlices) {
    const Mesh mesh = make_mesh(plane(30, 0.3));
    const auto values = field_of(mesh, [](const Vec3& p) { return std::sin(9 * p.x()) * std::cos(7 * p.y()); });
    const std::vector<float> levels{-0.5f, 0, 0.01f, 0.5f};
    const RegionSet all(test_memory());
    const SurfaceCurves whole = isolines(mesh, values, levels, all, UINT32_MAX);
    EXPECT_GT(whole.curve_count(), 4u);
    expect_same(whole, isolines(mesh, values, levels, all, true));
}

}  // namespace
}  // namespace flg::test
