// SPDX-License-Identifier: MIT
// Curves beside splines: closed forms, loops, refusals.
#include <functional>

#include "api/spline_inputs.h"
#include "core/vec.h"

namespace flg::test {
namespace {

struct Beside {
    FlgCurveSetView view;
    std::vector<Vec3> places, normals;
    std::vector<float> times;
};

Beside offset(const Host& host, const FlgSplineOffsetDesc& desc, uint32_t budget_us = FLG_UNLIMITED) {
    FlgCurveSet set{};
    EXPECT_EQ(flgSplineOffset(host.context, &desc, &set, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish(budget_us);
    Beside out{host.view_of(set), {}, {}, {}};
    for (uint32_t i = 0; i < out.view.curve_offsets[1]; ++i) {
        out.places.push_back(load_vec3(find_column(out.view, FLG_ATTRIBUTE_POSITION)->data + size_t{3} * i));
        out.normals.push_back(load_vec3(find_column(out.view, FLG_ATTRIBUTE_NORMAL)->data + size_t{3} * i));
        out.times.push_back(find_column(out.view, FLG_ATTRIBUTE_TIME)->data[i]);
    }
    return out;
}

// All nodes given: the curve through them, exactly.
MadeSpline given_nodes(const Host& host, FlgManifold manifold, uint32_t count, bool closed,
                       const std::function<Vec3(double)>& place) {
    std::vector<double> points;
    std::vector<uint32_t> knots;
    for (uint32_t i = 0; i < count; ++i) {
        const Vec3 x = place(static_cast<double>(i) / (closed ? count : count - 1));
        points.insert(points.end(), x.begin(), x.end());
        knots.push_back(i);
    }
    FlgSplineDesc desc = spline_desc(manifold, points);
    desc.curve = points.data();
    desc.curve_count = count;
    desc.curve_knots = knots.data();
    desc.closed = closed;
    MadeSpline made = make_spline(host, desc);
    EXPECT_EQ(made.result, FLG_OK) << made.error;
    return made;
}

FlgSplineOffsetDesc beside(const MadeSpline& made, double left, double above = 0) {
    FlgSplineOffsetDesc desc = flgSplineOffsetDefaults();
    desc.spline = made.spline;
    desc.left = left;
    desc.above = above;
    return desc;
}

MadeSpline circle_of(const Host& host, FlgManifold manifold, double radius, double height = 0) {
    return given_nodes(host, manifold, 256, true, [=](double t) {
        return Vec3(radius * std::cos(2 * M_PI * t), radius * std::sin(2 * M_PI * t), height);
    });
}

TEST(SplineOffset, OfACircleIsACircle) {
    const Host host;
    const MadeSpline made = circle_of(host, shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE), 2);
    for (const double left : {0.5, -1.5, 1.9}) {
        for (const bool turns_least : {false, true}) {
            FlgSplineOffsetDesc desc = beside(made, left, 0.25);
            desc.up[2] = 7;
            desc.turns_least = turns_least;
            const Beside out = offset(host, desc);
            ASSERT_EQ(out.places.size(), 256u);
            EXPECT_EQ(out.view.curve_flags[0], FLG_CURVE_CLOSED);
            for (const Vec3& x : out.places) {
                EXPECT_NEAR(std::hypot(x.x(), x.y()), 2 - left, 1e-6);
                EXPECT_NEAR(x.z(), 0.25, 1e-6);
            }
            for (const Vec3& up : out.normals) EXPECT_NEAR(up.z(), 1, 1e-6);
        }
    }
    // Within its own radius all of it is one loop.
    FlgSplineOffsetDesc desc = beside(made, 2.5);
    desc.up[2] = 1;
    FlgCurveSet set{};
    EXPECT_EQ(flgSplineOffset(host.context, &desc, &set, nullptr), FLG_OK);
    host.finish();
    FlgCurveSetView view = flgCurveSetViewDefaults();
    expect_failure(flgCurveSetGetView(host.context, set, &view), FLG_ERROR_INVALID_ARGUMENT,
                   "nothing is left of the curve 2.5 m to the left");
    desc.keeps_loops = 1;
    for (const Vec3& x : offset(host, desc).places) EXPECT_NEAR(x.norm(), 0.5, 1e-6);
}

TEST(SplineOffset, OfALineIsALine) {
    const Host host;
    const std::vector<double> points = {1, 2, 3, 4, 2, 3};
    const MadeSpline made = make_spline(host, spline_desc(shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE), points));
    FlgSplineOffsetDesc desc = beside(made, 0.5, 0.2);
    desc.spacing = 0.1;
    const Beside out = offset(host, desc);
    ASSERT_EQ(out.places.size(), 31u);
    for (size_t i = 0; i < out.places.size(); ++i)
        EXPECT_LT((out.places[i] - Vec3(1 + 0.1 * static_cast<double>(i), 2.5, 3.2)).norm(), 1e-6);
}

// Level across z it is a helix on another cylinder, of the same pitch. A frame that turns least turns against Frenet's
// by the torsion.
TEST(SplineOffset, OfAHelixIsAHelix) {
    const Host host;
    const double radius = 1, pitch = 0.3, turns = 2;  // metres a radian
    const MadeSpline made =
        given_nodes(host, shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE), 1025, false, [&](double t) {
            const double a = 2 * M_PI * turns * t;
            return Vec3(radius * std::cos(a), radius * std::sin(a), pitch * a);
        });
    FlgSplineOffsetDesc desc = beside(made, 0.4);
    desc.up[2] = 1;
    const Beside level = offset(host, desc);
    ASSERT_EQ(level.places.size(), 1025u);
    for (size_t i = 2; i + 2 < level.places.size(); ++i) {
        const double a = 2 * M_PI * turns * static_cast<double>(i) / 1024;
        EXPECT_LT((level.places[i] - Vec3(0.6 * std::cos(a), 0.6 * std::sin(a), pitch * a)).norm(), 1e-5) << i;
    }
    desc.turns_least = 1;
    const Beside turned = offset(host, desc);
    const double speed = std::hypot(radius, pitch), torsion = pitch / (speed * speed);
    const auto angle_at = [&](size_t i) {
        const double a = 2 * M_PI * turns * static_cast<double>(i) / 1024;
        const Vec3 normal(-std::cos(a), -std::sin(a), 0),
            way = Vec3(-radius * std::sin(a), radius * std::cos(a), pitch) / speed;
        return std::atan2(turned.normals[i].dot(way.cross(normal)), turned.normals[i].dot(normal));
    };
    for (size_t i = 64; i <= 960; i += 64) {
        const double length = speed * 2 * M_PI * turns * static_cast<double>(i - 32) / 1024;
        EXPECT_NEAR(std::remainder(angle_at(i) - angle_at(32) + torsion * length, 2 * M_PI), 0, 1e-3) << i;
    }
}

// A circle about the pole of a sphere, and one of the plane: beside a geodesic circle is a geodesic circle.
TEST(SplineOffset, OnASurfaceItStaysThere) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 2);
    const double polar = 0.9;
    const MadeSpline made = circle_of(host, sphere, 2 * std::sin(polar), 2 * std::cos(polar));
    for (const double left : {0.3, -1.0, 1.7}) {
        const Beside out = offset(host, beside(made, left, 0.1));
        ASSERT_EQ(out.places.size(), 256u);
        for (size_t i = 0; i < out.places.size(); ++i) {
            EXPECT_NEAR(out.places[i].norm(), 2.1, 1e-6);
            // Left of the way around the pole is the pole.
            EXPECT_NEAR(std::acos(out.places[i].z() / 2.1), polar - left / 2, 1e-6);
            EXPECT_NEAR(out.normals[i].dot(out.places[i]), 2.1, 1e-6);
        }
    }
    const MadeSpline flat = circle_of(host, shape_manifold(host, FLG_MANIFOLD_SHAPE_PLANE), 2);
    for (const Vec3& x : offset(host, beside(flat, 0.75)).places) EXPECT_NEAR(x.norm(), 1.25, 1e-6);
    // On a torus, from the outer equator upwards along the meridian.
    const MadeSpline ring = circle_of(host, shape_manifold(host, FLG_MANIFOLD_SHAPE_TORUS, 2, 0.5), 2.5);
    for (const Vec3& x : offset(host, beside(ring, 0.6)).places) {
        EXPECT_NEAR(std::hypot(x.x(), x.y()), 2 + 0.5 * std::cos(1.2), 1e-5);
        EXPECT_NEAR(x.z(), 0.5 * std::sin(1.2), 1e-5);
    }
}

// Around the outside of a torus of triangles.
MadeSpline equator_of_mesh(const Host& host) {
    const FlgManifold torus = mesh_manifold(host, torus_mesh(96, 48, 2, 0.5));
    std::vector<double> points;
    for (int i = 0; i < 12; ++i)
        points.insert(points.end(), {2.5 * std::cos(M_PI * i / 6), 2.5 * std::sin(M_PI * i / 6), 0});
    FlgSplineDesc desc = spline_desc(torus, points);
    desc.closed = 1;
    return make_spline(host, desc);
}

// On the smooth surface of a mesh, and to its end.
TEST(SplineOffset, OnAMeshItStaysThere) {
    const Host host;
    const MadeSpline made = equator_of_mesh(host);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    for (const Vec3& x : offset(host, beside(made, 0.6)).places) {
        EXPECT_NEAR(std::hypot(std::hypot(x.x(), x.y()) - 2, x.z()), 0.5, 2e-3);
        EXPECT_NEAR(std::atan2(x.z(), std::hypot(x.x(), x.y()) - 2), 1.2, 1e-2);
    }
}

// Over the triangles it is a level of the distance from the curve: to both sides, to where there is none.
TEST(SplineOffset, OverTrianglesItIsSoFarAway) {
    const Host host;
    const MadeSpline made = equator_of_mesh(host);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    FlgSplineTraceDesc trace = flgSplineTraceDefaults();
    trace.spline = made.spline;
    FlgSurfaceCurvesView view = flgSurfaceCurvesViewDefaults();
    for (const double side : {1.0, -1.0}) {
        FlgSurfaceCurves curves{};
        trace.offset = side * 0.6;
        ASSERT_EQ(flgSplineTrace(host.context, &trace, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        ASSERT_EQ(flgSurfaceCurvesGetView(host.context, curves, &view), FLG_OK) << flgErrorGetMessage();
        ASSERT_EQ(view.curve_count, 1u);
        EXPECT_EQ(view.curve_flags[0], FLG_CURVE_CLOSED);
        EXPECT_NEAR(view.curve_values[0], 2 * M_PI * (2 + 0.5 * std::cos(1.2)), 2e-2);
    }
    trace.offset = 100;
    FlgSurfaceCurves curves{};
    ASSERT_EQ(flgSplineTrace(host.context, &trace, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    expect_failure(flgSurfaceCurvesGetView(host.context, curves, &view), FLG_ERROR_INVALID_ARGUMENT,
                   "desc.offset is 100: nowhere on that side is the surface so far from the curve");
}

// y = x^2, whose least radius is 1/2: beside it at distance d > 1/2 the two branches meet on the axis, at 1/4 + d^2.
TEST(SplineOffset, LoopsAreCutWhereTheyCross) {
    const Host host;
    const MadeSpline made =
        given_nodes(host, shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE), 2001, false, [](double t) {
            const double x = 4 * t - 2;
            return Vec3(x, x * x, 0);
        });
    const double away = 1.2;
    FlgSplineOffsetDesc desc = beside(made, away);
    desc.up[2] = 1;
    const Beside out = offset(host, desc);
    EXPECT_LT(out.places.size(), 2001u);
    size_t corner = 0;
    for (size_t i = 1; i < out.places.size(); ++i)
        if (out.places[i].y() < out.places[corner].y()) corner = i;
    EXPECT_NEAR(out.places[corner].x(), 0, 1e-5);
    EXPECT_NEAR(out.places[corner].y(), 0.25 + away * away, 1e-5);
    EXPECT_GT(out.times[corner + 1] - out.times[corner], 1);
    for (size_t i = 1; i < out.places.size(); ++i) EXPECT_GT(out.places[i].x(), out.places[i - 1].x());
    // No place is nearer to the curve.
    for (const Vec3& x : out.places) {
        double nearest = 1e9;
        for (int k = -4000; k <= 4000; ++k)
            nearest = std::min(nearest, std::hypot(x.x() - k / 2000.0, x.y() - k * k / 4e6));
        EXPECT_GT(nearest, away - 1e-5);
    }
    desc.keeps_loops = 1;
    EXPECT_EQ(offset(host, desc).places.size(), 2001u);
    desc.keeps_loops = 0;
    desc.left = -away;
    EXPECT_EQ(offset(host, desc).places.size(), 2001u);
}

// A closed curve with four tight bends, the one it begins with among them: each is cut to a corner.
TEST(SplineOffset, AroundAClosedCurveTheBeginningIsNoDifferent) {
    const Host host;
    const FlgManifold space = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE);
    for (const double turn : {0.0, 0.1, 0.125}) {
        const MadeSpline made = given_nodes(host, space, 2000, true, [turn](double t) {
            const double a = 2 * M_PI * (t + turn),
                         r = 1 / std::pow(std::pow(std::cos(a), 8) + std::pow(std::sin(a), 8), 0.125);
            return Vec3(r * std::cos(a), r * std::sin(a), 0);
        });
        FlgSplineOffsetDesc desc = beside(made, 0.6);
        desc.up[2] = 1;
        const Beside out = offset(host, desc);
        uint32_t corners = 0;
        double length = 0;
        for (size_t i = 0; i < out.places.size(); ++i) {
            const Vec3 a = out.places[i] - out.places[(i + out.places.size() - 1) % out.places.size()],
                       b = out.places[(i + 1) % out.places.size()] - out.places[i];
            length += b.norm();
            if (a.dot(b) < 0.5 * a.norm() * b.norm()) ++corners;
        }
        EXPECT_EQ(corners, 4u) << turn;
        EXPECT_NEAR(length, 8 * 0.4, 2e-2) << turn;
    }
}

TEST(SplineOffset, SameBitsUnderAnyWorkersAndBudgets) {
    expect_same_bits([](const Host& host) {
        const std::vector<double> points = torus_points(5, 1, 0.4);
        const MadeSpline made = make_spline(host, spline_desc(mesh_manifold(host, torus_mesh(60, 30, 1, 0.4)), points));
        FlgSplineOffsetDesc desc = beside(made, 0.3);
        FlgCurveSet set{};
        EXPECT_EQ(flgSplineOffset(host.context, &desc, &set, nullptr), FLG_OK) << flgErrorGetMessage();
        return set;
    });
}

TEST(SplineOffset, BadOnesAreNamed) {
    const Host host;
    const std::vector<double> points = {0, 0, 0, 1, 0, 0, 2, 1, 0};
    const MadeSpline made = make_spline(host, spline_desc(shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE), points));
    const auto refuse = [&](const std::function<void(FlgSplineOffsetDesc&)>& spoil, const char* words) {
        FlgSplineOffsetDesc desc = beside(made, 0.1);
        spoil(desc);
        FlgCurveSet out{};
        EXPECT_LT(flgSplineOffset(host.context, &desc, &out, nullptr), 0) << words;
        EXPECT_NE(std::strstr(flgErrorGetMessage(), words), nullptr) << flgErrorGetMessage();
    };
    refuse([](FlgSplineOffsetDesc& d) { d.left = NAN; }, "desc.left");
    refuse([](FlgSplineOffsetDesc& d) { d.above = INFINITY; }, "desc.above");
    refuse([](FlgSplineOffsetDesc& d) { d.spacing = -1; }, "desc.spacing is -1");
    refuse([](FlgSplineOffsetDesc& d) { d.up[1] = INFINITY; }, "desc.up");
    refuse([](FlgSplineOffsetDesc& d) { d.reserved = 7; }, "desc.reserved is 7");
    refuse([](FlgSplineOffsetDesc& d) { d.spline = {}; }, "desc.spline");
    const std::vector<double> flat = {0, 0, 1, 0, 2, 1};
    const MadeSpline plane =
        make_spline(host, spline_desc(shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE, 1, 0.25, 2), flat, 2));
    refuse([&](FlgSplineOffsetDesc& d) { d.spline = plane.spline; }, "the number of coordinates of desc.spline is 2");
}

}  // namespace
}  // namespace flg::test
