// SPDX-License-Identifier: MIT
// Handles at given points, points and segments of their own softness and tension, and curves as few cubic pieces.
#include "api/spline_inputs.h"

namespace flg::test {
namespace {

const std::vector<double> zigzag = {0, 0, 0, 1, 0.6, 0.2, 1.8, -0.3, 0.4, 3, 0.5, -0.1, 4.1, 0.1, 0.3};
const std::vector<double> times = {0, 1, 2.2, 3, 4.5};

FlgManifold space(const Host& host) {
    return shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE);
}

FlgSplineHandle handle_at(uint32_t point, const double* slope = nullptr) {
    FlgSplineHandle handle = flgSplineHandleDefaults();
    handle.point = point;
    handle.slope = slope;
    return handle;
}

double node_distance(const MadeSpline& a, uint32_t i, const MadeSpline& b, uint32_t j) {
    return distance(a.node(i), b.node(j));
}

TEST(SplineHandles, ACornerIsTwoSplinesThatShareAPoint) {
    const Host host;
    const FlgManifold manifold = space(host);
    FlgSplineDesc desc = spline_desc(manifold, zigzag);
    const double steady[5] = {0, 1, 2, 3, 4};
    desc.parameters = steady;
    const FlgSplineHandle corner = handle_at(2);
    desc.handles = &corner;
    desc.handle_count = 1;
    const MadeSpline whole = make_spline(host, desc);
    ASSERT_EQ(whole.result, FLG_OK) << whole.error;
    EXPECT_EQ(whole.view.ending, FLG_SPLINE_ENDING_CONVERGED);
    const std::vector<double> left(zigzag.begin(), zigzag.begin() + 9), right(zigzag.begin() + 6, zigzag.end());
    FlgSplineDesc first = spline_desc(manifold, left), second = spline_desc(manifold, right);
    first.parameters = steady;
    second.parameters = steady + 2;
    const MadeSpline a = make_spline(host, first), b = make_spline(host, second);
    const uint32_t middle = whole.view.point_nodes[2];
    ASSERT_EQ(whole.view.node_count, 129u);
    ASSERT_EQ(middle + 1, a.view.node_count);
    ASSERT_EQ(middle + b.view.node_count, whole.view.node_count);
    for (uint32_t i = 0; i < a.view.node_count; ++i) EXPECT_LT(node_distance(whole, i, a, i), 1e-7);
    for (uint32_t i = 0; i < b.view.node_count; ++i) {
        EXPECT_LT(node_distance(whole, middle + i, b, i), 1e-7);
        EXPECT_NEAR(whole.view.parameters[middle + i], b.view.parameters[i], 1e-9);
    }
    EXPECT_NEAR(whole.view.bending, a.view.bending + b.view.bending, 1e-6 * whole.view.bending);
}

// In closed form: from (0, 0) to (1, 0) with slopes (1, 1) and (1, -1) the curve is x = t, y = t - t^2; the slope in
// the middle is prescribed as what it is anyway, and then as something else.
TEST(SplineHandles, ATangentIsClampedOnBothSides) {
    const Host host;
    const FlgManifold manifold = space(host);
    const std::vector<double> points = {0, 0, 0, 0.5, 0.25, 0, 1, 0, 0};
    const double parameters[3] = {0, 0.5, 1}, begin[3] = {1, 1, 0}, end[3] = {1, -1, 0}, level[3] = {1, 0, 0},
                 steep[3] = {1, 0, 2};
    FlgSplineDesc desc = spline_desc(manifold, points);
    desc.parameters = parameters;
    desc.begin_slope = begin;
    desc.end_slope = end;
    FlgSplineHandle handle = handle_at(1, level);
    desc.handles = &handle;
    desc.handle_count = 1;
    const MadeSpline parabola = make_spline(host, desc);
    ASSERT_EQ(parabola.result, FLG_OK) << parabola.error;
    for (uint32_t i = 0; i < parabola.view.node_count; ++i) {
        const double t = parabola.view.parameters[i];
        EXPECT_LT(distance(parabola.node(i), {t, t - t * t, 0}), 1e-8);
    }
    handle.slope = steep;
    const MadeSpline raised = make_spline(host, desc);
    // z is the cubic through 0 and 0 with slopes 0 and 2, over half: 2 t'^2 (t' - 1/2) / (1/4), t' in [0, 1/2].
    for (uint32_t i = 0; i <= raised.view.point_nodes[1]; ++i) {
        const double t = raised.view.parameters[i];
        EXPECT_NEAR(raised.node(i)[2], 8 * t * t * (t - 0.5), 1e-8);
    }
}

TEST(SplineHandles, OnASurfaceOnlyTheTangentPartCountsAndClosedCurvesMayHaveThem) {
    const Host host;
    const FlgManifold sphere = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE, 1);
    const std::vector<double> points = {1, 0, 0, 0, 1, 0, -1, 0.2, 0.3, 0, -1, 0.1};
    const double slope[3] = {0.5, 3, 1}, upright[3] = {0, 2, 0};
    FlgSplineDesc desc = spline_desc(sphere, points);
    desc.closed = 1;
    desc.node_count = 1280;
    FlgSplineHandle handles[2] = {handle_at(3), handle_at(1, slope)};
    desc.handles = handles;
    desc.handle_count = 2;
    const MadeSpline made = make_spline(host, desc);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    EXPECT_EQ(made.view.ending, FLG_SPLINE_ENDING_CONVERGED);
    ASSERT_EQ(made.view.node_count, 1280u);
    for (uint32_t p = 0; p < 4; ++p) {
        const uint32_t node = made.view.point_nodes[p];
        const Point given = {points[3 * p], points[3 * p + 1], points[3 * p + 2]};
        EXPECT_NEAR(distance(made.node(node), given), std::abs(distance(given, {0, 0, 0}) - 1), 1e-12);
        if (p > 0) {
            EXPECT_GT(node, made.view.point_nodes[p - 1]);
        }
    }
    EXPECT_EQ(made.view.point_nodes[0], 0u);
    for (uint32_t i = 0; i < 1280; ++i) {
        EXPECT_NEAR(distance(made.node(i), {0, 0, 0}), 1, 1e-12);
        EXPECT_GT(made.view.parameters[i + 1], made.view.parameters[i]);
    }
    // At the point (0, 1, 0): along (0.5, 0, 1).
    const uint32_t node = made.view.point_nodes[1];
    for (const uint32_t beside : {node - 1, node + 1}) {
        const Point a = made.node(beside), b = made.node(node);
        EXPECT_NEAR((b[2] - a[2]) / (b[0] - a[0]), 2, 0.1);
    }
    handles[1].slope = upright;
    const MadeSpline refused = make_spline(host, desc);
    EXPECT_EQ(refused.result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(refused.error.find("desc.handles[1].slope stands upright on the manifold at point 1"), std::string::npos);
}

TEST(SplineHandles, AreCheckedAtOnce) {
    const Host host;
    const FlgManifold manifold = space(host);
    FlgSplineDesc desc = spline_desc(manifold, zigzag);
    const double nothing[3] = {0, 0, 0}, softness[5] = {0, 1, -1, 0, 0}, tensions[4] = {1, 1, 1, 1};
    FlgSplineHandle handles[2] = {handle_at(1), handle_at(1)};
    desc.handles = handles;
    FlgSpline spline{};
    const auto refuses = [&](const char* sentence) {
        EXPECT_EQ(flgSplineCreate(host.context, &desc, &spline, nullptr), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::string(flgErrorGetMessage()).find(sentence), std::string::npos) << flgErrorGetMessage();
    };
    desc.handle_count = 2;
    refuses("desc.handles[0] and desc.handles[1] are both at point 1");
    desc.handle_count = 1;
    handles[0].slope = nothing;
    refuses("desc.handles[0].slope is 0, so it has no direction");
    handles[0] = handle_at(5);
    refuses("desc.handles[0].point is 5, must be below desc.point_count, 5");
    desc.handle_count = 0;
    desc.softness = softness;
    refuses("desc.softness[2] is -1");
    desc.softness = nullptr;
    desc.tensions = tensions;
    refuses("desc.tensions: desc.energy must be FLG_SPLINE_ENERGY_ET");
    desc.energy = FLG_SPLINE_ENERGY_ET;
    EXPECT_EQ(flgSplineCreate(host.context, &desc, &spline, nullptr), FLG_OK) << flgErrorGetMessage();
    desc.key_tolerance = -1;
    refuses("desc.key_tolerance is -1");
}

TEST(SplineSoftness, LetsOnePointGoAndKeepsTheOthers) {
    const Host host;
    FlgSplineDesc desc = spline_desc(space(host), zigzag);
    desc.parameters = times.data();
    const double softness[5] = {0, 0, 0.5, 0, 0};
    const MadeSpline hard = make_spline(host, desc);
    desc.softness = softness;
    const MadeSpline soft = make_spline(host, desc);
    ASSERT_EQ(soft.result, FLG_OK) << soft.error;
    EXPECT_LT(soft.view.bending, hard.view.bending);
    for (uint32_t p = 0; p < 5; ++p) {
        const double off = node_distance(hard, hard.view.point_nodes[p], soft, soft.view.point_nodes[p]);
        EXPECT_EQ(off > 0, p == 2) << off;
    }
}

// The pieces from key to key, evaluated as engines do, against the cubic spline through the nodes, which passes them.
TEST(SplineKeys, StayWithinTheirToleranceAndSayHowFarTheyAre) {
    const Host host;
    const FlgManifold torus = shape_manifold(host, FLG_MANIFOLD_SHAPE_TORUS, 2, 0.8);
    const std::vector<double> points = torus_points(7, 2, 0.8);
    for (const bool closed : {false, true}) {
        uint32_t last_count = 0;
        for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
            FlgSplineDesc desc = spline_desc(torus, points);
            desc.closed = closed;
            desc.key_tolerance = tolerance;
            const MadeSpline made = make_spline(host, desc);
            ASSERT_EQ(made.result, FLG_OK) << made.error;
            const FlgSplineView& view = made.view;
            ASSERT_GE(view.key_count, 7u + closed);
            EXPECT_GT(view.key_count, last_count);
            last_count = view.key_count;
            EXPECT_LE(view.largest_key_error, tolerance);
            EXPECT_GT(view.largest_key_error, 0);
            double largest = 0;
            uint32_t key = 0;
            for (uint32_t i = 0; i < view.node_count; ++i) {
                const double t = view.parameters[i];
                while (key + 2 < view.key_count && view.key_parameters[key + 1] < t) ++key;
                const double h = view.key_parameters[key + 1] - view.key_parameters[key];
                const double s = (t - view.key_parameters[key]) / h, w = 1 - s;
                Point p;
                for (size_t c = 0; c < 3; ++c) {
                    p[c] = w * w * (1 + 2 * s) * view.key_points[3 * key + c] +
                           s * s * (1 + 2 * w) * view.key_points[3 * key + 3 + c] +
                           h * s * w * (w * view.key_leaving[3 * key + c] - s * view.key_arriving[3 * key + 3 + c]);
                }
                largest = std::max(largest, distance(p, made.node(i)));
            }
            EXPECT_LE(largest, 1.0001 * view.largest_key_error);
            for (uint32_t k = 0; k < 3 * view.key_count; ++k) EXPECT_EQ(view.key_arriving[k], view.key_leaving[k]);
            if (closed) {
                for (uint32_t c = 0; c < 3; ++c)
                    EXPECT_NEAR(view.key_points[c], view.key_points[3 * view.key_count - 3 + c], 1e-12);
            }
        }
        EXPECT_LT(last_count, 7u * 32);
    }
}

TEST(SplineKeys, HaveTwoSlopesAtCorners) {
    const Host host;
    FlgSplineDesc desc = spline_desc(space(host), zigzag);
    const FlgSplineHandle corner = handle_at(2);
    desc.handles = &corner;
    desc.handle_count = 1;
    desc.key_tolerance = 1;
    const MadeSpline made = make_spline(host, desc);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    ASSERT_EQ(made.view.key_count, 5u);
    for (uint32_t k = 0; k < 5; ++k) {
        for (uint32_t c = 0; c < 3; ++c) {
            EXPECT_EQ(made.view.key_points[3 * k + c], zigzag[3 * k + c]);
            EXPECT_EQ(made.view.key_arriving[3 * k + c] != made.view.key_leaving[3 * k + c], k == 2);
        }
    }
}

}  // namespace
}  // namespace flg::test
