// SPDX-License-Identifier: MIT
// Geodesic distances behind the C ABI, against closed forms.
#include "api/surface_inputs.h"

namespace flg::test {
namespace {

FlgFieldGeodesicDesc from_vertex(FlgSurface surface, const uint32_t* vertex) {
    FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
    desc.surface = surface;
    desc.vertices = vertex;
    desc.vertex_count = 1;
    return desc;
}

// Isolated errors are below 0.2 % (RMS).
TEST(GeodesicApi, DistancesOnAPlane) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(24));
    const uint32_t vertex = 24 * 25 + 24 - 3;  // at (21/24, 1)
    const auto exact = [](const Point& p) { return distance(p, {21.0 / 24, 1, 0}); };
    const FlgFieldView field = host.view(host.solve(from_vertex(surface, &vertex)));
    EXPECT_LT(relative_error(host.view(surface), field, exact), 0.002);
    EXPECT_EQ(field.labels, nullptr);
    EXPECT_EQ(field.samples, nullptr);
    EXPECT_EQ(field.sample_count, 0u);
}

TEST(GeodesicApi, DistancesOnASphereAndACylinder) {
    const SurfaceHost host;
    const uint32_t vertex = 0;
    const FlgSurface ball = host.surface(sphere(16));
    const Point pole = vertex_at(host.view(ball), vertex);
    const auto angle = [&](const Point& p) { return 2 * std::asin(std::min(1.0, distance(p, pole) / 2)); };
    EXPECT_LT(relative_error(host.view(ball), host.view(host.solve(from_vertex(ball, &vertex))), angle), 0.005);

    const uint32_t around = 64;
    const FlgSurface tube = host.surface(cylinder(around, 24));
    const double circumference = 2 * around * std::sin(M_PI / around);  // of the polygon
    const auto helix = [&](const Point& p) {
        return std::hypot(std::abs(std::atan2(p[1], p[0])) / (2 * M_PI) * circumference, p[2]);
    };
    EXPECT_LT(relative_error(host.view(tube), host.view(host.solve(from_vertex(tube, &vertex))), helix), 0.002);
}

// However the triangles are: from one vertex, from points, from many that labels tell apart.
TEST(GeodesicApi, NoDistanceIsShorterThanTheStraightLine) {
    const SurfaceHost host;
    for (const Point& stretch : {Point{1, 1, 1}, Point{1, 20, 1}, Point{10, 1, 0.2}}) {
        MeshArrays input = sphere(16);
        for (size_t i = 0; i < input.positions.size(); ++i) input.positions[i] *= static_cast<float>(stretch[i % 3]);
        const FlgSurface surface = host.surface(input);
        const FlgSurfaceView view = host.view(surface);
        std::vector<uint32_t> vertices;
        for (uint32_t v = 0; v < view.mesh->vertex_count; v += 40) vertices.push_back(v);
        const FlgSurfacePoint point = {7, 0.2f, 0.3f};
        for (const uint32_t labels : {0u, 1u}) {
            FlgFieldGeodesicDesc desc = from_vertex(surface, vertices.data());
            desc.vertex_count = labels ? static_cast<uint32_t>(vertices.size()) : 3;
            desc.points = &point;
            desc.point_count = 1;
            desc.labels = labels;
            std::vector<Point> sources;
            for (uint32_t i = 0; i < desc.vertex_count; ++i) sources.push_back(vertex_at(view, vertices[i]));
            Point& inside = sources.emplace_back();
            const double weights[] = {1 - point.u - point.v, point.u, point.v};
            for (int k = 0; k < 3; ++k) {
                const Point corner = vertex_at(view, view.mesh->triangles[3 * point.triangle + k]);
                for (int i = 0; i < 3; ++i) inside[i] += weights[k] * corner[i];
            }
            const FlgFieldView field = host.view(host.solve(desc));
            for (uint32_t v = 0; v < view.mesh->vertex_count; ++v) {
                double straight = std::numeric_limits<double>::infinity();
                for (const Point& source : sources) straight = std::min(straight, distance(source, vertex_at(view, v)));
                EXPECT_GE(field.values[v], straight * (1 - 1e-6)) << v;
            }
        }
    }
}

// A vertex, a point, a curve and a region's border at once: the distance is to the nearest, the label says which it is.
TEST(GeodesicApi, SourcesOfAllKindsAreNumberedInOrder) {
    const SurfaceHost host;
    MeshArrays input = plane(20);
    input.set_regions(
        [](const Point& p) { return std::abs(p[0] - 0.5) < 0.1 && std::abs(p[1] - 0.4) < 0.1 ? 9u : 2u; });
    const FlgSurface surface = host.surface(input);
    const FlgSurfaceView view = host.view(surface);
    const uint32_t vertices[] = {0, 0};
    const FlgSurfacePoint point = point_above(view, 0.91, 0.07);
    const uint32_t border = 9;
    FlgFieldGeodesicDesc desc = from_vertex(surface, vertices);
    desc.vertex_count = 2;
    desc.points = &point;
    desc.point_count = 1;
    desc.curves = host.start_isolines(host.field(surface, [](const Point& p) { return p[1]; }), {0.77f, 0.93f});
    desc.border_regions = &border;
    desc.border_region_count = 1;
    desc.labels = 1;
    const FlgFieldView field = host.view(host.solve(desc));
    ASSERT_NE(field.labels, nullptr);
    const double tolerance = 0.007;  // a cell is 0.05: where the fronts of two sources meet
    for (uint32_t v = 0; v < field.vertex_count; ++v) {
        const Point p = vertex_at(view, v);
        const double dx = std::abs(p[0] - 0.5) - 0.1, dy = std::abs(p[1] - 0.4) - 0.1;
        const double to_square =
            dx > 0 || dy > 0 ? std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) : -std::max(dx, dy);
        const double to_source[] = {distance(p, {}),
                                    std::numeric_limits<double>::infinity(),  // the same vertex again
                                    distance(p, {0.91, 0.07, 0}),
                                    std::abs(p[1] - 0.77),
                                    std::abs(p[1] - 0.93),
                                    to_square};
        const double nearest = *std::min_element(std::begin(to_source), std::end(to_source));
        EXPECT_NEAR(field.values[v], nearest, tolerance) << p[0] << ", " << p[1];
        ASSERT_LT(field.labels[v], 6u);
        EXPECT_NEAR(to_source[field.labels[v]], nearest, tolerance) << p[0] << ", " << p[1];
    }
}

// An L of region 1: what lies across its corner is reached around that.
TEST(GeodesicApi, DistancesKeepToTheRegions) {
    const SurfaceHost host;
    MeshArrays input = plane(20);
    input.set_regions([](const Point& p) { return p[0] > 0.5 && p[1] < 0.5 ? 3u : 1u; });
    const FlgSurface surface = host.surface(input);
    const FlgSurfaceView view = host.view(surface);
    const uint32_t vertex = 10, region = 1;  // (0.5, 0)
    FlgFieldGeodesicDesc desc = from_vertex(surface, &vertex);
    desc.regions = &region;
    desc.region_count = 1;
    desc.labels = 1;
    const FlgFieldView field = host.view(host.solve(desc));
    for (uint32_t v = 0; v < field.vertex_count; ++v) {
        const Point p = vertex_at(view, v);
        if (p[0] > 0.51 && p[1] < 0.49) {
            EXPECT_EQ(field.values[v], std::numeric_limits<float>::infinity());
            EXPECT_EQ(field.labels[v], FLG_NO_INDEX);
            continue;
        }
        const bool hidden = p[0] > 0.5;
        const double exact = hidden ? 0.5 + distance(p, {0.5, 0.5, 0}) : distance(p, {0.5, 0, 0});
        EXPECT_NEAR(field.values[v], exact, 0.012 * exact);
        EXPECT_EQ(field.labels[v], 0u);
    }
    const uint32_t elsewhere = 20;  // (1, 0), of region 3 only
    desc.vertices = &elsewhere;
    const FlgFieldView none = host.view(host.solve(desc));
    for (uint32_t v = 0; v < none.vertex_count; ++v) EXPECT_TRUE(std::isinf(none.values[v]));
}

TEST(GeodesicApi, LimitsStopTheSearch) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(20));
    const uint32_t vertex = 0, target = 5 * 21 + 5;
    const FlgFieldView whole = host.view(host.solve(from_vertex(surface, &vertex)));
    FlgFieldGeodesicDesc desc = from_vertex(surface, &vertex);
    const FlgFieldView full = host.view(host.solve(desc));
    desc.max_distance = 0.5f;
    const FlgFieldView near = host.view(host.solve(desc));
    uint32_t infinite = 0;
    for (uint32_t v = 0; v < near.vertex_count; ++v) {
        if (full.values[v] <= 0.5f) {
            EXPECT_EQ(near.values[v], full.values[v]);
        } else if (full.values[v] > 0.501f) {
            EXPECT_TRUE(std::isinf(near.values[v])) << full.values[v];
        }
        infinite += std::isinf(near.values[v]) ? 1 : 0;
    }
    EXPECT_GT(infinite, near.vertex_count / 2);
    desc.max_distance = flgFieldGeodesicDefaults().max_distance;
    desc.targets = &target;
    desc.target_count = 1;
    const FlgFieldView early = host.view(host.solve(desc));
    EXPECT_EQ(early.values[target], full.values[target]);
    EXPECT_GT(early.values[early.vertex_count - 1], whole.values[early.vertex_count - 1] * 0.999f);
}

// Moved along their normals vertices of a plane are no nearer to each other than before.
TEST(GeodesicApi, APerturbedMetricIsRougherAndTheSeedsOwn) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(20));
    const uint32_t vertex = 0;
    FlgFieldGeodesicDesc desc = from_vertex(surface, &vertex);
    const std::string flat = bits(host.view(host.solve(desc)));
    desc.perturbation = 0.05f;
    desc.frequency = 4;
    const FlgFieldView rough = host.view(host.solve(desc));
    const double bumps = relative_error(host.view(surface), rough, [](const Point& p) { return distance(p, {}); });
    EXPECT_GT(bumps, 0.002);
    EXPECT_LT(bumps, 0.3);
    for (uint32_t v = 0; v < rough.vertex_count; ++v) {
        EXPECT_GT(rough.values[v], 0.995 * distance(vertex_at(host.view(surface), v), {}) - 1e-6);
    }
    EXPECT_EQ(bits(host.view(host.solve(desc))), bits(rough));
    desc.seed = 2;
    EXPECT_NE(bits(host.view(host.solve(desc))), bits(rough));
    desc.perturbation = 0;
    EXPECT_EQ(bits(host.view(host.solve(desc))), flat);
}

TEST(GeodesicApi, PiecesThatHangTogetherByNothingAreInfinitelyFar) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(loose_triangles(100));
    const uint32_t vertex = 31 * 3;
    FlgFieldGeodesicDesc desc = from_vertex(surface, &vertex);
    const FlgFieldView field = host.view(host.solve(desc));
    for (uint32_t v = 0; v < 300; ++v) {
        if (v / 3 != 31) {
            EXPECT_TRUE(std::isinf(field.values[v]));
        } else {
            EXPECT_EQ(field.values[v], v % 3 == 0 ? 0 : 1);
        }
    }
    const FlgSurface one = host.surface(loose_triangles(1));
    const uint32_t corner = 1;
    const FlgFieldView alone = host.view(host.solve(from_vertex(one, &corner)));
    EXPECT_EQ(alone.values[0], 1);
    EXPECT_FLOAT_EQ(alone.values[2], std::sqrt(2.0f));
}

TEST(GeodesicApi, CurvesWithoutACurveAreNowhere) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(3));
    FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
    desc.surface = surface;
    desc.curves = host.start_isolines(host.field(surface, [](const Point& p) { return p[0]; }), {5});
    const FlgFieldView field = host.view(host.solve(desc));
    for (uint32_t v = 0; v < field.vertex_count; ++v) EXPECT_TRUE(std::isinf(field.values[v]));
}

TEST(GeodesicApi, AFieldOfTheHostsOwn) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(1));
    const float values[] = {1, -2, HUGE_VALF, 3};
    FlgField field{};
    ASSERT_EQ(flgFieldCreate(host.context, surface, values, 4, &field), FLG_OK) << flgErrorGetMessage();
    const FlgFieldView view = host.view(field);
    EXPECT_EQ(std::vector(view.values, view.values + view.vertex_count), std::vector(values, values + 4));
    EXPECT_EQ(view.labels, nullptr);
    EXPECT_EQ(view.revision, 0u);
}

TEST(GeodesicApi, ABlendGoesFromOneFieldToTheOther) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(2));
    const float inf = HUGE_VALF;
    const float from[] = {0, 0, 1, 2, inf, inf, 3, 5, 1e-30f};
    const float to[] = {0, 1, 0, 6, inf, 4, inf, 5, 3e-30f};
    const float expected[] = {0.5f, 0, 1, 0.25f, inf, 1, 0, 0.5f, 0.25f};
    FlgFieldBlendDesc desc = flgFieldBlendDefaults();
    ASSERT_EQ(flgFieldCreate(host.context, surface, from, 9, &desc.from), FLG_OK);
    ASSERT_EQ(flgFieldCreate(host.context, surface, to, 9, &desc.to), FLG_OK);
    FlgField blend{};
    ASSERT_EQ(flgFieldBlend(host.context, &desc, &blend, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const FlgFieldView view = host.view(blend);
    for (uint32_t v = 0; v < 9; ++v) EXPECT_FLOAT_EQ(view.values[v], expected[v]) << v;
}

// Sources, fields and curves may still be in the making.
TEST(GeodesicApi, JobsWaitForWhatTheyRead) {
    const SurfaceHost host;
    const FlgSurface surface = host.start_surface(plane(8));
    FlgFieldBlendDesc blend = flgFieldBlendDefaults();
    blend.from = host.start_distances(surface, 0);
    blend.to = host.start_distances(surface, 80);
    FlgField middle{};
    ASSERT_EQ(flgFieldBlend(host.context, &blend, &middle, nullptr), FLG_OK) << flgErrorGetMessage();
    FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
    desc.surface = surface;
    desc.curves = host.start_isolines(middle, {0.5f});
    const FlgField field = host.start(desc);
    FlgFieldView view = flgFieldViewDefaults();
    EXPECT_EQ(flgFieldGetView(host.context, field, &view), FLG_NOT_READY);
    EXPECT_EQ(view.vertex_count, 0u);
    host.finish();
    EXPECT_NEAR(host.view(field).values[0], std::sqrt(0.5), 0.01);  // the diagonal is as far from either corner
}

}  // namespace
}  // namespace flg::test
