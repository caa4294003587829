// SPDX-License-Identifier: MIT
// Ribbons and roads along splines, and even samples: closed forms on the plane, the sphere and the cylinder; rows that
// do not cross.
#include "api/spline_inputs.h"
#include "core/vec.h"

namespace flg::test {
namespace {

struct Ribbon {
    FlgMeshView mesh{};

    const float* column(FlgAttribute attribute) const { return flgMeshViewGetColumn(&mesh, attribute)->data; }
    Vec3 position(uint32_t v) const { return load_vec3(column(FLG_ATTRIBUTE_POSITION) + size_t{3} * v); }
    Vec3 normal(uint32_t v) const { return load_vec3(column(FLG_ATTRIBUTE_NORMAL) + size_t{3} * v); }
    Vec3 area(uint32_t t) const {
        const uint32_t* const c = mesh.triangles + size_t{3} * t;
        return 0.5 * (position(c[1]) - position(c[0])).cross(position(c[2]) - position(c[0]));
    }
};

Ribbon make_ribbon(const Host& host, const FlgSplineSweepDesc& desc, uint32_t budget_us = FLG_UNLIMITED) {
    FlgSurface surface{};
    EXPECT_EQ(flgSplineSweep(host.context, &desc, &surface, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish(budget_us);
    FlgSurfaceView view = flgSurfaceViewDefaults();
    EXPECT_EQ(flgSurfaceGetView(host.context, surface, &view), FLG_OK) << flgErrorGetMessage();
    return {*view.mesh};
}

std::vector<double> circle_points(uint32_t count, double radius) {
    std::vector<double> points;
    for (uint32_t i = 0; i < count; ++i) {
        const double a = 2 * M_PI * i / count;
        points.insert(points.end(), {radius * std::cos(a), radius * std::sin(a), 0});
    }
    return points;
}

MadeSpline circle(const Host& host, FlgManifold manifold, uint32_t count, double radius) {
    const std::vector<double> points = circle_points(count, radius);
    FlgSplineDesc desc = spline_desc(manifold, points);
    desc.closed = 1;
    return make_spline(host, desc);
}

// Around the equator of a sphere, counter-clockwise: left is north.
TEST(SplineRibbon, AroundTheEquatorItIsACylinder) {
    const Host host;
    const MadeSpline made = circle(host, shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 2), 12, 2);
    FlgSplineSweepDesc desc = flgSplineSweepDefaults();
    desc.spline = made.spline;
    desc.width = 0.6;
    desc.columns = 3;
    desc.spacing = 0.05;
    desc.height = 0.01;
    const Ribbon ribbon = make_ribbon(host, desc);
    const uint32_t rows = ribbon.mesh.vertex_count / 4;
    EXPECT_EQ(rows, static_cast<uint32_t>(std::round(4 * M_PI / 0.05)) + 1);
    EXPECT_EQ(ribbon.mesh.triangle_count, 6 * (rows - 1));
    const float *const uv = ribbon.column(FLG_ATTRIBUTE_UV), *const width = ribbon.column(FLG_ATTRIBUTE_WIDTH);
    for (uint32_t v = 0; v < ribbon.mesh.vertex_count; ++v) {
        const Vec3 at = ribbon.position(v);
        EXPECT_NEAR(std::hypot(at.x(), at.y()), 2.01, 2e-5);
        EXPECT_NEAR(at.z(), 0.3 - 0.2 * (v % 4), 1e-6);
        EXPECT_NEAR(ribbon.normal(v).dot(Vec3(at.x(), at.y(), 0).normalized()), 1, 1e-5);
        EXPECT_FLOAT_EQ(uv[2 * v], static_cast<float>(v % 4) / 3);
        EXPECT_FLOAT_EQ(width[v], 0.6f);
        // A texture as long as the ribbon is wide fits 21 times.
        EXPECT_NEAR(uv[2 * v + 1], 21.0 * (v / 4) / (rows - 1), 1e-4);
    }
    for (uint32_t c = 0; c < 4; ++c) EXPECT_LT((ribbon.position(c) - ribbon.position(4 * (rows - 1) + c)).norm(), 1e-6);
    for (uint32_t t = 0; t < ribbon.mesh.triangle_count; ++t) {
        const Vec3 middle = ribbon.position(ribbon.mesh.triangles[3 * t]);
        EXPECT_GT(ribbon.area(t).dot(Vec3(middle.x(), middle.y(), 0)), 0);
    }
}

// Level across z, on a bend of the plane's radius: leans by atan(bank / radius), inwards.
TEST(SplineRibbon, BankingIsTheAngleOfTheSpeed) {
    const Host host;
    const MadeSpline made = circle(host, shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE), 48, 10);
    FlgSplineSweepDesc desc = flgSplineSweepDefaults();
    desc.spline = made.spline;
    desc.width = 2;
    desc.columns = 1;
    desc.spacing = 0.25;
    desc.up[2] = 3;
    Ribbon ribbon = make_ribbon(host, desc);
    for (uint32_t v = 0; v < ribbon.mesh.vertex_count; ++v) {
        EXPECT_NEAR(ribbon.normal(v).z(), 1, 1e-6);
        const Vec3 at = ribbon.position(v);
        EXPECT_NEAR(at.z(), 0, 1e-6);
        EXPECT_NEAR(std::hypot(at.x(), at.y()), v % 2 == 0 ? 9 : 11, 1e-3);
    }
    desc.bank = 5;
    ribbon = make_ribbon(host, desc);
    const double lean = std::atan(5.0 / 10);
    for (uint32_t v = 0; v < ribbon.mesh.vertex_count; ++v) {
        EXPECT_NEAR(ribbon.position(v).z(), (v % 2 == 0 ? -1 : 1) * std::sin(lean), 2e-3);
        EXPECT_NEAR(ribbon.normal(v).z(), std::cos(lean), 2e-3);
    }
}

// A mesh of a half cylinder: rows lie on the triangles, to either side as far over them as they are wide.
MeshArrays gutter(uint32_t around, uint32_t along) {
    MeshArrays mesh;
    for (uint32_t i = 0; i <= around; ++i)
        for (uint32_t j = 0; j <= along; ++j) {
            const double a = M_PI * i / around;
            mesh.add_vertex(std::cos(a), 6.0 * j / along - 3, std::sin(a));
        }
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < along; ++j) {
            const uint32_t a = i * (along + 1) + j, b = a + along + 1;
            mesh.add_triangle(a, a + 1, b + 1);
            mesh.add_triangle(a, b + 1, b);
        }
    }
    return mesh;
}

TEST(SplineRibbon, ConformsToTheTriangles) {
    const Host host;
    const uint32_t around = 64;
    const FlgManifold manifold = mesh_manifold(host, gutter(around, 32));
    // Along the ridge.
    const std::vector<double> points = {0, -2.5, 1, 0, 0.1, 1, 0, 2.5, 1};
    const MadeSpline made = make_spline(host, spline_desc(manifold, points));
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    FlgSplineSweepDesc desc = flgSplineSweepDefaults();
    desc.spline = made.spline;
    desc.conforms = 1;
    desc.width = 1;
    desc.columns = 8;
    desc.spacing = 0.1;
    Ribbon ribbon = make_ribbon(host, desc);
    const double sag = 1 - std::cos(M_PI / around / 2), step = 1.0 / 8;
    const float* const width = ribbon.column(FLG_ATTRIBUTE_WIDTH);
    for (uint32_t v = 0; v < ribbon.mesh.vertex_count; ++v) {
        const Vec3 at = ribbon.position(v);
        const double radius = std::hypot(at.x(), at.z());
        EXPECT_LT(radius, 1 + 1e-6);
        EXPECT_GT(radius, 1 - sag - 1e-6);
        // Left of the way to +y is -x.
        EXPECT_NEAR(std::atan2(at.x(), at.z()), (v % 9) * step - 0.5, 2e-3);
        EXPECT_NEAR(width[v], 1, 1e-6);
    }
    // Wider than the mesh it ends at its borders.
    desc.width = 8;
    ribbon = make_ribbon(host, desc);
    const float* const cut = ribbon.column(FLG_ATTRIBUTE_WIDTH);
    for (uint32_t v = 0; v < ribbon.mesh.vertex_count; ++v) EXPECT_NEAR(cut[v], M_PI, 5e-3);
    for (uint32_t v = 0; v < ribbon.mesh.vertex_count; v += 9) {
        EXPECT_NEAR(ribbon.position(v).z(), 0, 1e-4);
        EXPECT_NEAR(ribbon.position(v + 8).z(), 0, 1e-4);
    }
}

// Around a bend much tighter than the ribbon is wide no triangle turns over, and WIDTH tells.
TEST(SplineRibbon, RowsDoNotCrossInTightBends) {
    const Host host;
    const FlgManifold space = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE);
    const std::vector<double> points = {-4, 0, 0, -0.2, 0.1, 0, 0, 0.4, 0, 0.2, 0.1, 0, 4, 0, 0};
    const MadeSpline made = make_spline(host, spline_desc(space, points));
    FlgSplineSweepDesc desc = flgSplineSweepDefaults();
    desc.spline = made.spline;
    desc.width = 2;
    desc.spacing = 0.02;
    desc.up[2] = 1;
    const Ribbon ribbon = make_ribbon(host, desc);
    const float* const width = ribbon.column(FLG_ATTRIBUTE_WIDTH);
    double narrowest = HUGE_VAL, widest = 0;
    for (uint32_t v = 0; v < ribbon.mesh.vertex_count; ++v) {
        narrowest = std::min(narrowest, double{width[v]});
        widest = std::max(widest, double{width[v]});
    }
    EXPECT_LT(narrowest, 1.5);
    EXPECT_FLOAT_EQ(static_cast<float>(widest), 2);
    for (uint32_t t = 0; t < ribbon.mesh.triangle_count; ++t) EXPECT_GE(ribbon.area(t).z(), -1e-9) << t;
}

TEST(SplineRibbon, SameBitsUnderAnyWorkersAndBudgets) {
    std::vector<float> expected;
    for (const uint32_t workers : {0u, 3u}) {
        for (const uint32_t budget_us : {FLG_UNLIMITED, 300u}) {
            const Host host(workers);
            const std::vector<double> points = torus_points(5, 1, 0.4);
            const FlgManifold manifold = mesh_manifold(host, torus_mesh(60, 30, 1, 0.4));
            const MadeSpline made = make_spline(host, spline_desc(manifold, points), budget_us);
            FlgSplineSweepDesc desc = flgSplineSweepDefaults();
            desc.spline = made.spline;
            desc.width = 0.2;
            desc.conforms = 1;
            const Ribbon ribbon = make_ribbon(host, desc, budget_us);
            const float* const positions = ribbon.column(FLG_ATTRIBUTE_POSITION);
            const std::vector<float> now(positions, positions + size_t{3} * ribbon.mesh.vertex_count);
            if (expected.empty()) expected = now;
            EXPECT_TRUE(now == expected) << workers << " workers, budget " << budget_us;
        }
    }
}

TEST(SplineRibbon, BadOnesAreNamed) {
    const Host host;
    const MadeSpline made = circle(host, shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 2), 12, 2);
    const FlgManifold space = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE);
    const std::vector<double> three = circle_points(3, 1);
    const MadeSpline free = make_spline(host, spline_desc(space, three));
    const auto refuse = [&](const std::function<void(FlgSplineSweepDesc&)>& spoil, const char* words) {
        FlgSplineSweepDesc desc = flgSplineSweepDefaults();
        desc.spline = made.spline;
        spoil(desc);
        FlgSurface out{};
        EXPECT_LT(flgSplineSweep(host.context, &desc, &out, nullptr), 0) << words;
        EXPECT_NE(std::strstr(flgErrorGetMessage(), words), nullptr) << flgErrorGetMessage();
    };
    refuse([](FlgSplineSweepDesc& d) { d.width = 0; }, "desc.width is 0");
    refuse([](FlgSplineSweepDesc& d) { d.width = NAN; }, "desc.width");
    refuse([](FlgSplineSweepDesc& d) { d.columns = 0; }, "desc.columns is 0");
    refuse([](FlgSplineSweepDesc& d) { d.columns = 257; }, "desc.columns is 257");
    refuse([](FlgSplineSweepDesc& d) { d.spacing = -1; }, "desc.spacing is -1");
    refuse([](FlgSplineSweepDesc& d) { d.up[1] = INFINITY; }, "desc.up");
    refuse([](FlgSplineSweepDesc& d) { d.width = 1e-320; }, "desc.width");
    refuse([](FlgSplineSweepDesc& d) { d.height = INFINITY; }, "desc.height");
    refuse([](FlgSplineSweepDesc& d) { d.bank = NAN; }, "desc.bank");
    refuse([](FlgSplineSweepDesc& d) { d.texture_length = -1; }, "desc.texture_length is -1");
    refuse([](FlgSplineSweepDesc& d) { d.texture_length = 1e-320; }, "desc.texture_length");
    refuse([](FlgSplineSweepDesc& d) { d.reserved = 7; }, "desc.reserved is 7");
    const std::vector<double> on_torus = torus_points(5, 1, 0.4);
    const FlgManifold torus = mesh_manifold(host, torus_mesh(30, 15, 1, 0.4));
    const MadeSpline on_mesh = make_spline(host, spline_desc(torus, on_torus));
    refuse(
        [&](FlgSplineSweepDesc& d) {
            d.spline = on_mesh.spline;
            d.conforms = 1;
            d.bank = 1;
        },
        "desc.bank can't be given together with desc.conforms");
    refuse(
        [&](FlgSplineSweepDesc& d) {
            d.spline = on_mesh.spline;
            d.conforms = 1;
            d.up[2] = 1;
        },
        "desc.up can't be given together with desc.conforms");
    refuse([](FlgSplineSweepDesc& d) { d.conforms = 1; },
           "desc.conforms: desc.spline is not on the manifold of a mesh");
    refuse([&](FlgSplineSweepDesc& d) { d.spline = free.spline; }, "desc.up is 0");
    refuse([](FlgSplineSweepDesc& d) { d.spline = {}; }, "desc.spline");
    FlgSplineSweepDesc desc = flgSplineSweepDefaults();
    desc.spline = made.spline;
    desc.spacing = 1e-9;
    FlgSurface out{};
    EXPECT_EQ(flgSplineSweep(host.context, &desc, &out, nullptr), FLG_OK);
    host.finish();
    FlgSurfaceView view = flgSurfaceViewDefaults();
    EXPECT_EQ(flgSurfaceGetView(host.context, out, &view), FLG_ERROR_LIMIT);
    EXPECT_NE(std::strstr(flgErrorGetMessage(), "desc.spacing is 1e-09"), nullptr) << flgErrorGetMessage();
}

// However far apart rows are to be, a closed ribbon encloses something; and an up of any length is a direction.
TEST(SplineRibbon, AClosedOneHasThreeRows) {
    const Host host;
    const MadeSpline made = circle(host, shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 2), 12, 2);
    FlgSplineSweepDesc desc = flgSplineSweepDefaults();
    desc.spline = made.spline;
    desc.columns = 1;
    desc.width = 0.1;
    desc.spacing = 1e30;
    desc.up[2] = 1e-200;
    const Ribbon ribbon = make_ribbon(host, desc);
    ASSERT_EQ(ribbon.mesh.vertex_count, 8u);
    for (uint32_t v = 0; v < 8; ++v) {
        EXPECT_NEAR(ribbon.position(v).z(), 0, 1e-5);
        EXPECT_NEAR(ribbon.position(v).norm(), v % 2 == 0 ? 1.95 : 2.05, 1e-3);
    }
}

// A circle in even steps: all chords alike, and all points on it.
TEST(SplineSamples, AreEvenAlongTheCurve) {
    const Host host;
    std::vector<double> points;
    for (const double a : {0.0, 0.3, 1.5, 2.0, 3.5, 5.5}) points.insert(points.end(), {std::cos(a), std::sin(a), 0});
    FlgSplineDesc desc = spline_desc(shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE), points);
    desc.closed = 1;
    const MadeSpline made = make_spline(host, desc);
    FlgSplineSampleDesc sample = flgSplineSampleDefaults();
    sample.spline = made.spline;
    sample.spacing = 0.1;
    FlgCurveSet set{};
    ASSERT_EQ(flgSplineSample(host.context, &sample, &set, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgCurveSetView view = flgCurveSetViewDefaults();
    ASSERT_EQ(flgCurveSetGetView(host.context, set, &view), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(view.curve_offsets[1], 63u);
    const float* const at = flgCurveSetViewGetColumn(&view, FLG_ATTRIBUTE_POSITION)->data;
    for (uint32_t i = 0; i < 63; ++i) {
        const Vec3 a = load_vec3(at + size_t{3} * i), b = load_vec3(at + size_t{3} * ((i + 1) % 63));
        EXPECT_NEAR(a.norm(), 1, 1e-5);
        EXPECT_NEAR((b - a).norm(), 2 * std::sin(M_PI / 63), 1e-5);
    }
}

}  // namespace
}  // namespace flg::test
