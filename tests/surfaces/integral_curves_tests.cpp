// SPDX-License-Identifier: MIT
#include "surfaces/tracing/integral_curves.h"

#include <gtest/gtest.h>

#include "runtime/run_now.h"
#include "surfaces/curve_checks.h"

namespace flg::test {
namespace {

using Stop = IntegralCurveStop;

struct Traced {
    SurfaceCurves curves{test_memory()};
    std::vector<IntegralCurveEnd> ends;

    Vec3 last(const Mesh& mesh, uint32_t curve) const {
        return position_of(mesh, curves.points[curves.offsets[curve + 1] - 1]);
    }
};

// Values rise (or fall) from each point to the next; level only along edges between vertices.
void expect_monotone(const Mesh& mesh, const std::vector<float>& values, const SurfaceCurves& curves, bool downhill) {
    for (uint32_t c = 0; c < curves.curve_count(); ++c) {
        const auto points = points_of(curves, c);
        for (size_t i = 0; i + 1 < points.size(); ++i) {
            const double from = value_at(mesh, values, points[i]), to = value_at(mesh, values, points[i + 1]);
            const double rise = downhill ? from - to : to - from;
            // The points' own rounding, where the curve's place is sharper.
            EXPECT_GE(rise, -1e-15 * (std::abs(from) + std::abs(to))) << "curve " << c << " point " << i;
        }
    }
}

Traced trace(const Mesh& mesh, const std::vector<float>& values, const std::vector<SurfacePoint>& starts,
             const IntegralCurveOptions& options = {}, const RegionSet& regions = RegionSet(test_memory()),
             bool haltingly = false) {
    Traced traced;
    const auto ends = run_now(
        test_memory(),
        [&](Pace& pace) { return add_integral_curves(pace, mesh, values, regions, starts, options, traced.curves); },
        haltingly);
    traced.ends.assign(ends.begin(), ends.end());
    expect_valid(mesh, traced.curves);
    expect_monotone(mesh, values, traced.curves, options.downhill);
    EXPECT_EQ(traced.ends.size(), starts.size());
    return traced;
}

SurfacePoint at_vertex(const Mesh& mesh, uint32_t vertex) {
    const Corner corner = mesh.corner_of_vertex[vertex];
    return {triangle_of(corner), corner % 3 == 1 ? 1.0f : 0.0f, corner % 3 == 2 ? 1.0f : 0.0f};
}

uint32_t vertex_near(const Mesh& mesh, const Vec3& place) {
    uint32_t nearest = 0;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        if ((mesh.position(v) - place).norm() < (mesh.position(nearest) - place).norm()) nearest = v;
    }
    return nearest;
}

std::vector<SurfacePoint> random_points(const Mesh& mesh, uint32_t count, uint64_t seed) {
    std::vector<SurfacePoint> points;
    for (uint32_t i = 0; i < count; ++i) {
        float u = float(random_unit(seed, i, 0)), v = float(random_unit(seed, i, 1));
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        // Some on edges, some on vertices.
        if (i % 3 == 1) v = 0;
        if (i % 9 == 2) u = v = 0;
        points.push_back({random_below(seed, i, 2, mesh.triangle_count()), u, v});
    }
    return points;
}

// Of a linear field they are straight lines, whatever the mesh.
TEST(IntegralCurves, OfALinearFieldAreStraight) {
    const Mesh mesh = make_mesh(plane(20, 0.2));
    const Vec3 gradient(1, 0.3, 0);
    const auto values = field_of(mesh, [&](const Vec3& p) { return gradient.dot(p); });
    const auto starts = random_points(mesh, 60, 1);
    const Traced traced = trace(mesh, values, starts);
    for (uint32_t i = 0; i < starts.size(); ++i) {
        EXPECT_EQ(traced.ends[i].stop, Stop::border);
        if (traced.ends[i].curve == no_index) continue;
        const Vec3 from = position_of(mesh, starts[i]), way = traced.last(mesh, traced.ends[i].curve) - from;
        // Float values on cells of 1 / 20 turn gradients by about 1e-5.
        EXPECT_NEAR(way.cross(gradient.normalized()).norm(), 0, 1e-4 * way.norm() + 1e-6);
        EXPECT_GT(way.dot(gradient), 0);
        const double to_border = std::min(1 - from.x(), (1 - from.y()) / 0.3);
        EXPECT_NEAR(way.x(), to_border, 1e-4);
    }
}

TEST(IntegralCurves, OfTheDistanceFromAPointAreRadii) {
    const Mesh mesh = make_mesh(plane(60, 0.2));
    const Vec3 centre(0.5, 0.5, 0);
    const auto values = field_of(mesh, [&](const Vec3& p) { return (p - centre).norm(); });
    std::vector<SurfacePoint> starts;
    for (int i = 0; i < 12; ++i) {
        const double angle = 2 * std::numbers::pi * i / 12;
        starts.push_back(at_vertex(mesh, vertex_near(mesh, centre + 0.2 * Vec3(std::cos(angle), std::sin(angle), 0))));
    }
    IntegralCurveOptions to_level;
    to_level.level = 0.45f;
    const Traced out = trace(mesh, values, starts, to_level);
    IntegralCurveOptions to_centre;
    to_centre.downhill = true;
    const uint32_t middle = vertex_near(mesh, centre);
    to_centre.targets = {&middle, 1};
    const Traced in = trace(mesh, values, starts, to_centre);
    for (uint32_t i = 0; i < starts.size(); ++i) {
        EXPECT_EQ(out.ends[i].stop, Stop::level);
        const Vec3 from = position_of(mesh, starts[i]) - centre, to = out.last(mesh, out.ends[i].curve) - centre;
        EXPECT_NEAR(value_at(mesh, values, out.curves.points[out.curves.offsets[out.ends[i].curve + 1] - 1]), 0.45,
                    1e-6);
        EXPECT_EQ(out.curves.values[out.ends[i].curve], 0.45f);
        EXPECT_GT(from.normalized().dot(to.normalized()), std::cos(0.02));
        EXPECT_NEAR(length_of(mesh, out.curves, out.ends[i].curve), to.norm() - from.norm(), 0.003);
        EXPECT_EQ(in.ends[i].stop, Stop::target);
        EXPECT_EQ(in.last(mesh, in.ends[i].curve), mesh.position(middle));
        EXPECT_NEAR(length_of(mesh, in.curves, in.ends[i].curve), from.norm(), 0.02 * from.norm());
    }
}

// From a vertex of the lower ring along edges, from between two through triangles: generators either way.
TEST(IntegralCurves, OfTheHeightOfACylinderAreItsGenerators) {
    const Mesh mesh = make_mesh(cylinder(24, 10));
    const auto values = field_of(mesh, [](const Vec3& p) { return p.z(); });
    std::vector<SurfacePoint> starts;
    for (uint32_t i = 0; i < 24; ++i) starts.push_back(at_vertex(mesh, i));
    for (uint32_t i = 0; i < 24; ++i) starts.push_back({2 * i, 0.3f, 0});
    const Traced traced = trace(mesh, values, starts);
    for (uint32_t i = 0; i < starts.size(); ++i) {
        EXPECT_EQ(traced.ends[i].stop, Stop::border);
        ASSERT_NE(traced.ends[i].curve, no_index);
        const Vec3 from = position_of(mesh, starts[i]), to = traced.last(mesh, traced.ends[i].curve);
        EXPECT_NEAR((to - from - Vec3(0, 0, 2)).norm(), 0, 1e-5);
        EXPECT_NEAR(length_of(mesh, traced.curves, traced.ends[i].curve), 2, 1e-5);
    }
}

TEST(IntegralCurves, SlideAlongRidgesOfConvergingGradients) {
    const Mesh mesh = make_mesh(plane(10));
    const auto values = field_of(mesh, [](const Vec3& p) { return 0.2 * p.x() - std::abs(p.y() - 0.5); });
    const Traced traced = trace(mesh, values, {{1, 0.3f, 0.3f}});
    EXPECT_EQ(traced.ends[0].stop, Stop::border);
    EXPECT_NEAR((traced.last(mesh, 0) - Vec3(1, 0.5, 0)).norm(), 0, 1e-6);
    uint32_t on_ridge = 0;
    for (const SurfacePoint& p : traced.curves.points) on_ridge += std::abs(position_of(mesh, p).y() - 0.5) < 1e-6;
    EXPECT_GE(on_ridge, 8u);
}

// At borders only where asked to.
TEST(IntegralCurves, FollowBordersOnRequest) {
    const Mesh mesh = make_mesh(plane(8));
    const auto values = field_of(mesh, [](const Vec3& p) { return p.x() + 2 * p.y(); });
    IntegralCurveOptions along;
    along.along_borders = true;
    const Traced ended = trace(mesh, values, {{0, 0.3f, 0.3f}}),
                 went_on = trace(mesh, values, {{0, 0.3f, 0.3f}}, along);
    EXPECT_NEAR(ended.last(mesh, 0).y(), 1, 1e-6);
    EXPECT_LT(ended.last(mesh, 0).x(), 0.6);
    EXPECT_EQ(went_on.last(mesh, 0), Vec3(1, 1, 0));
    EXPECT_EQ(went_on.ends[0].stop, Stop::border);
}

TEST(IntegralCurves, EndAtExtremaOfTheField) {
    const Mesh mesh = make_mesh(plane(20, 0.3));
    const auto values = field_of(mesh, [](const Vec3& p) { return -(p - Vec3(0.4, 0.6, 0)).norm(); });
    const uint32_t top = static_cast<uint32_t>(std::max_element(values.begin(), values.end()) - values.begin());
    const Traced traced = trace(mesh, values, random_points(mesh, 40, 2));
    for (const IntegralCurveEnd& end : traced.ends) {
        EXPECT_EQ(end.stop, Stop::extremum);
        if (end.curve == no_index) continue;
        EXPECT_EQ(traced.last(mesh, end.curve), mesh.position(top));
    }
}

// Sec. 3.3: streams on the blend field of A and B meet both.
TEST(IntegralCurves, OfABlendFieldLeadFromAToB) {
    const Mesh mesh = make_mesh(sphere(4));
    const uint32_t a = vertex_near(mesh, {1, 0, 0}), b = vertex_near(mesh, {-0.5, 0.8, 0.2});
    const auto angle = [&](const Vec3& p, uint32_t v) {
        return std::acos(std::clamp(p.normalized().dot(mesh.position(v)), -1.0, 1.0));
    };
    const auto blend = field_of(mesh, [&](const Vec3& p) { return angle(p, a) / (angle(p, a) + angle(p, b)); });
    std::vector<SurfacePoint> starts{at_vertex(mesh, a)};
    Corner corner = mesh.corner_of_vertex[a];
    do {
        starts.push_back(point_on_edge(next_corner(corner), 0.37f));
        corner = mesh.turn(corner);
    } while (corner != mesh.corner_of_vertex[a]);
    IntegralCurveOptions to_b, to_a;
    to_b.targets = {&b, 1};
    to_a.targets = {&a, 1};
    to_a.downhill = true;
    for (const IntegralCurveEnd& end : trace(mesh, blend, starts, to_b).ends) EXPECT_EQ(end.stop, Stop::target);
    for (const IntegralCurveEnd& end : trace(mesh, blend, starts, to_a).ends) EXPECT_EQ(end.stop, Stop::target);
}

TEST(IntegralCurves, CrossSmallPlateausAndEndOnLargeOnes) {
    const auto step = [](double x) { return x < 0.35 ? x : x < 0.65 ? 0.35 : x - 0.3; };
    for (const auto& [cells, crosses] : {std::pair{10u, true}, std::pair{60u, false}}) {
        const Mesh mesh = make_mesh(plane(cells));
        const auto values = field_of(mesh, [&](const Vec3& p) { return std::round(1000 * step(p.x())); });
        const Traced traced = trace(mesh, values, {at_vertex(mesh, vertex_near(mesh, {0.1, 0.5, 0}))});
        EXPECT_EQ(traced.ends[0].stop, crosses ? Stop::border : Stop::extremum);
        EXPECT_EQ(traced.last(mesh, 0).x() == 1, crosses);
    }
    // Within a constant field there is nothing to follow.
    const Mesh mesh = make_mesh(plane(4));
    const Traced traced = trace(mesh, std::vector<float>(mesh.vertex_count(), 1), random_points(mesh, 9, 3));
    EXPECT_EQ(traced.curves.curve_count(), 0u);
    // From the inside of a flat triangle that is a step, to one of its corners.
    auto values = field_of(mesh, [](const Vec3& p) { return p.x(); });
    const Triple& flat = mesh.triangles[5];
    for (uint32_t v : flat) values[v] = 0.5f;
    EXPECT_EQ(trace(mesh, values, {{5, 0.3f, 0.3f}}).ends[0].stop, Stop::border);
}

TEST(IntegralCurves, EndWhereRegionsOrFiniteValuesEnd) {
    Mesh mesh = make_mesh(plane(20));
    auto values = field_of(mesh, [](const Vec3& p) { return p.x(); });
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) mesh.regions[t] = t % 40 < 24 ? 5 : 6;
    const uint32_t label = 5;
    const RegionSet left(&label, 1, test_memory());
    const SurfacePoint start = at_vertex(mesh, vertex_near(mesh, {0.2, 0.4, 0}));
    const Traced in_region = trace(mesh, values, {start, {24, 0.25f, 0.25f}}, {}, left);
    EXPECT_EQ(in_region.ends[0].stop, Stop::border);
    EXPECT_NEAR(in_region.last(mesh, 0).x(), 0.6, 1e-6);
    EXPECT_EQ(in_region.ends[1].stop, Stop::border);
    EXPECT_EQ(in_region.ends[1].curve, no_index) << "begins outside";
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        if (mesh.position(v).x() > 0.41) values[v] = std::numeric_limits<float>::infinity();
    }
    const Traced in_field = trace(mesh, values, {start, {24, 0.25f, 0.25f}, at_vertex(mesh, 20)});
    EXPECT_EQ(in_field.ends[0].stop, Stop::border);
    EXPECT_NEAR(in_field.last(mesh, 0).x(), 0.4, 1e-6);
    for (uint32_t i : {1, 2}) {
        EXPECT_EQ(in_field.ends[i].stop, Stop::border);
        EXPECT_EQ(in_field.ends[i].curve, no_index);
    }
}

TEST(IntegralCurves, ThatBeginWhereTheyEndAreNone) {
    const Mesh mesh = make_mesh(plane(6));
    const auto values = field_of(mesh, [](const Vec3& p) { return p.x(); });
    IntegralCurveOptions options;
    options.level = 0.5f;
    const uint32_t target = 8;
    options.targets = {&target, 1};
    const Traced traced = trace(mesh, values, {at_vertex(mesh, 5), at_vertex(mesh, 8)}, options);
    EXPECT_EQ(traced.ends[0].stop, Stop::level);
    EXPECT_EQ(traced.ends[1].stop, Stop::target);
    EXPECT_EQ(traced.curves.curve_count(), 0u);
}

// A flat square whose middle edge has a triangle without area in it, and one with two equal positions at its end.
TEST(IntegralCurves, CrossTrianglesWithoutArea) {
    const Soup soup{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}, {1, -1, 0}},
                    {{0, 2, 3}, {2, 1, 3}, {0, 1, 2}, {0, 4, 1}, {4, 5, 1}}};
    const Mesh mesh = make_mesh(soup);
    auto values = field_of(mesh, [](const Vec3& p) { return p.y() + 0.1 * p.x(); });
    const std::vector<SurfacePoint> starts{{3, 0.4f, 0.3f}, {3, 0.8f, 0.1f}};
    // The third vertex says which way the field falls across it.
    values[2] += 0.01f;
    const Traced through = trace(mesh, values, starts);
    for (const IntegralCurveEnd& end : through.ends) {
        ASSERT_NE(end.curve, no_index);
        EXPECT_GT(through.last(mesh, end.curve).y(), 0.5);
    }
    values[2] -= 0.02f;
    const Traced along = trace(mesh, values, starts);
    for (const IntegralCurveEnd& end : along.ends) EXPECT_EQ(along.last(mesh, end.curve), Vec3(2, 0, 0));
    // And where no gradient can be told at all: any end will do.
    values[2] += 0.01f;
    EXPECT_EQ(trace(mesh, values, {{4, 0.2f, 0.3f}, {2, 0.3f, 0.3f}}).ends.size(), 2u);
}

// Random values, with many equal ones, have all there is: ridges, saddles, plateaus, extrema at every other vertex.
TEST(IntegralCurves, OfRandomFieldsEndAndNeverTurnBack) {
    const Mesh meshes[] = {make_mesh(plane(12, 0.49)), make_mesh(sphere(2)), make_mesh(torus(9, 5)),
                           make_mesh(tetrahedron()), make_mesh(cylinder(3, 5))};
    for (const Mesh& mesh : meshes) {
        for (uint64_t seed = 0; seed < 60; ++seed) {
            std::vector<float> values;
            for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
                values.push_back(seed % 3 == 0   ? float(random_below(seed, v, 0, 4))
                                 : seed % 3 == 1 ? float(random_unit(seed, v, 1))
                                                 : float(v) + 0.001f * float(random_unit(seed, v, 1)));
            }
            IntegralCurveOptions options;
            options.downhill = seed % 2 == 1;
            options.along_borders = seed % 4 < 2;
            const Traced traced = trace(mesh, values, random_points(mesh, 20, seed), options);
            for (const IntegralCurveEnd& end : traced.ends) {
                EXPECT_TRUE(end.stop == Stop::border || end.stop == Stop::extremum);
                if (end.curve == no_index) continue;
                EXPECT_LT(points_of(traced.curves, end.curve).size(), 4 * mesh.triangle_count());
            }
        }
    }
}

TEST(IntegralCurves, DoNotDependOnSlices) {
    const Mesh mesh = make_mesh(plane(20, 0.3));
    const auto values =
        field_of(mesh, [](const Vec3& p) { return std::round(40 * std::sin(9 * p.x()) * std::cos(7 * p.y())); });
    const auto starts = random_points(mesh, 50, 4);
    const RegionSet all(test_memory());
    const Traced whole = trace(mesh, values, starts, {}, all, UINT32_MAX),
                 sliced = trace(mesh, values, starts, {}, all, true);
    EXPECT_GT(whole.curves.curve_count(), 30u);
    expect_same(whole.curves, sliced.curves);
}

}  // namespace
}  // namespace flg::test
