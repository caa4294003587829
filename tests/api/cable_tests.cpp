// SPDX-License-Identifier: MIT
// Cables through the C ABI: sag, rest, refusals. What they rest on, and how, is tested beside the solver.
#include <functional>

#include "api/spline_inputs.h"
#include "core/vec.h"

namespace flg::test {
namespace {

FlgCableHangDesc cable_desc(const std::vector<double>& points) {
    FlgCableHangDesc desc = flgCableHangDefaults();
    desc.points = points.data();
    desc.point_count = static_cast<uint32_t>(points.size() / 3);
    return desc;
}

FlgCurveSet hang(const Host& host, const FlgCableHangDesc& desc) {
    FlgCurveSet set{};
    EXPECT_EQ(flgCableHang(host.context, &desc, &set, nullptr), FLG_OK) << flgErrorGetMessage();
    return set;
}

FlgObstacle floor_of(double height) {
    FlgObstacle solid = flgObstacleDefaults();
    solid.kind = FLG_OBSTACLE_KIND_HALF_SPACE;
    solid.centre[2] = height;
    solid.to[2] = 1;
    return solid;
}

// Two cables, of three points and of two, each span with its own length.
TEST(Cables, HangBetweenTheirPoints) {
    const Host host;
    const std::vector<double> points = {0, 0, 3, 4, 0, 3, 8, 0, 4, 0, 5, 3, 4, 5, 3};
    const std::vector<uint32_t> offsets = {0, 3, 5};
    const double a = 3, length = 2 * a * std::sinh(2 / a);
    const std::vector<double> lengths = {length, 4.6, length};
    FlgCableHangDesc desc = cable_desc(points);
    desc.cable_offsets = offsets.data();
    desc.cable_count = 2;
    desc.lengths = lengths.data();
    desc.segments = 40;
    const FlgCurveSet set = hang(host, desc);
    host.finish();
    const FlgCurveSetView view = host.view_of(set);
    ASSERT_EQ(view.curve_count, 2u);
    ASSERT_EQ(view.curve_offsets[1], 81u);
    ASSERT_EQ(view.curve_offsets[2], 122u);
    const float* const at = find_column(view, FLG_ATTRIBUTE_POSITION)->data;
    const float* const along = find_column(view, FLG_ATTRIBUTE_TIME)->data;
    for (const uint32_t first : {0u, 81u}) {
        EXPECT_NEAR(at[3 * (first + 20) + 2], 3 - (a * std::cosh(2 / a) - a), 1e-6);
        EXPECT_NEAR(along[first + 40], length, 1e-6);
    }
    EXPECT_NEAR(along[80], length + 4.6, 1e-6);
    EXPECT_FLOAT_EQ(at[3 * 80], 8);
    EXPECT_FLOAT_EQ(at[3 * 80 + 2], 4);
}

TEST(Cables, SameBitsUnderAnyWorkersAndBudgets) {
    expect_same_bits([](const Host& host) {
        const std::vector<double> points = {-3, 0, 1, 3, 0.2, 1.2};
        FlgObstacle log = flgObstacleDefaults();
        log.kind = FLG_OBSTACLE_KIND_CAPSULE;
        log.centre[1] = -2;
        log.to[1] = 2;
        log.radius = 0.4;
        FlgCableHangDesc desc = cable_desc(points);
        desc.slack = 0.12;
        desc.obstacles = make_obstacles(host, {floor_of(0), log});
        return hang(host, desc);
    });
}

// A mesh is its triangles: a cable on a ball of them, in a groove that holds it.
TEST(Cables, RestOnMeshes) {
    const Host host;
    const std::vector<double> points = {-3, 0, 1.2, 3, 0, 1.2};
    FlgObstacle ring = flgObstacleDefaults();
    ring.kind = FLG_OBSTACLE_KIND_MESH;
    ring.surface = mesh_surface(host, torus_mesh(80, 32, 1, 0.6));
    FlgCableHangDesc desc = cable_desc(points);
    desc.slack = 0.1;
    desc.obstacles = make_obstacles(host, {ring});
    const FlgCurveSet set = hang(host, desc);
    host.finish();
    const FlgCurveSetView view = host.view_of(set);
    const float* const at = find_column(view, FLG_ATTRIBUTE_POSITION)->data;
    double nearest = 1e9, length = 0;
    for (uint32_t i = 0; i + 1 < view.curve_offsets[1]; ++i) {
        const Vec3 a = load_vec3(at + size_t{3} * i), b = load_vec3(at + size_t{3} * (i + 1));
        length += (b - a).norm();
        for (int s = 0; s <= 50; ++s) {
            const Vec3 x = a + s / 50.0 * (b - a);
            nearest = std::min(nearest, std::hypot(std::hypot(x.x(), x.y()) - 1, x.z()) - 0.6);
        }
    }
    EXPECT_NEAR(length, 6.6, 1e-5);
    // The triangles are within the torus.
    EXPECT_GT(nearest, -0.6 * (1 - std::cos(M_PI / 32)) - 1.6 * (1 - std::cos(M_PI / 80)));
    EXPECT_LT(nearest, 0.01);
}

TEST(Cables, BadOnesAreNamed) {
    const Host host;
    const std::vector<double> points = {0, 0, 3, 4, 0, 3, 8, 0, 4};
    const std::vector<double> lengths = {4.2, 4};
    const std::vector<uint32_t> offsets = {0, 1, 3};
    const auto refuse = [&](const std::function<void(FlgCableHangDesc&)>& spoil, const char* words) {
        FlgCableHangDesc desc = cable_desc(points);
        spoil(desc);
        FlgCurveSet out{};
        EXPECT_LT(flgCableHang(host.context, &desc, &out, nullptr), 0) << words;
        EXPECT_NE(std::strstr(flgErrorGetMessage(), words), nullptr) << flgErrorGetMessage();
    };
    refuse([](FlgCableHangDesc& d) { d.points = nullptr; }, "desc.points");
    refuse([](FlgCableHangDesc& d) { d.point_count = 1; }, "desc.point_count is 1");
    refuse([](FlgCableHangDesc& d) { d.segments = 3; }, "desc.segments is 3");
    refuse([](FlgCableHangDesc& d) { d.slack = -0.1; }, "desc.slack is -0.1");
    refuse([](FlgCableHangDesc& d) { d.slack = NAN; }, "desc.slack");
    refuse([](FlgCableHangDesc& d) { d.gravity[2] = 0; }, "desc.gravity is 0");
    refuse([](FlgCableHangDesc& d) { d.gravity[0] = INFINITY; }, "desc.gravity");
    refuse([](FlgCableHangDesc& d) { d.cable_count = 2; }, "desc.cable_count is 2");
    refuse(
        [&](FlgCableHangDesc& d) {
            d.cable_offsets = offsets.data();
            d.cable_count = 2;
        },
        "desc.cable_offsets[1] is 1");
    refuse([&](FlgCableHangDesc& d) { d.lengths = lengths.data(); },
           "desc.lengths[1] is 4, must be at least the distance of points 1 and 2, 4.12311");
    refuse([&](FlgCableHangDesc& d) { d.obstacles = make_obstacles(host, {flgObstacleDefaults()}, 2); },
           "the number of dimensions of desc.obstacles is 2");
    std::vector<double> twice = {0, 0, 1, 0, 0, 1};
    refuse(
        [&](FlgCableHangDesc& d) {
            d.points = twice.data();
            d.point_count = 2;
        },
        "points 0 and 1 are in one place");
    FlgCableHangDesc desc = cable_desc(points);
    desc.obstacles = make_obstacles(host, {floor_of(3.5)});
    const FlgCurveSet set = hang(host, desc);
    host.finish();
    FlgCurveSetView view = flgCurveSetViewDefaults();
    expect_failure(flgCurveSetGetView(host.context, set, &view), FLG_ERROR_INVALID_ARGUMENT,
                   "point 0 is 0.5 inside of obstacle 0");
}

}  // namespace
}  // namespace flg::test
