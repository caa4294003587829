// SPDX-License-Identifier: MIT
#include "inflation/sharp_corners.h"

#include <gtest/gtest.h>

#include "inflation/closed_mesh.h"
#include "inflation/mesh_simplification.h"
#include "inflation/models.h"

namespace flg::test {
namespace {

constexpr double angle = 0.7;  // 40 degrees

double nearest(const MergedMesh& mesh, const Vec3& to) {
    double least = HUGE_VAL;
    for (const Vec3& p : mesh.positions) least = std::min(least, (p - to).norm());
    return least;
}

// A star with five points has ten corners, and they are where they are drawn, to the last bit but for the placement.
TEST(SharpCorners, OfAStarStay) {
    Ring star;
    for (uint32_t i = 0; i < 10; ++i) {
        const double radius = i % 2 == 0 ? 1 : 0.5, turn = std::numbers::pi * i / 5;
        star.push_back({radius * std::sin(turn), radius * std::cos(turn)});
    }
    Model model;
    model.add({star}, placement({0.5, 0, 0}));
    const MergedMesh round = merged(model, {.vertices = 3000}),
                     sharp = merged(model, {.vertices = 3000, .corner_angle = angle});
    const ClosedMesh closed = check_closed(sharp.positions, {sharp.triangles.data(), sharp.triangles.size()});
    EXPECT_EQ(closed.fault, "");
    EXPECT_EQ(closed.euler, 2);
    for (uint32_t i = 0; i < 10; ++i) {
        const Vec3 corner(star[i].x + 0.5, star[i].y, 0);
        EXPECT_LT(nearest(sharp, corner), 1e-6) << i;
        if (i % 2 == 0) {
            EXPECT_GT(nearest(round, corner), 0.3 * round.spacing) << i;
        }
    }
    const BoneWeights none;
    const SimplifiedMesh fewer =
        run_now(test_memory(), [&](Pace& pace) { return simplify_mesh(pace, sharp, none, 300); });
    for (uint32_t i = 0; i < 10; ++i) EXPECT_LT(nearest(fewer.mesh, Vec3(star[i].x + 0.5, star[i].y, 0)), 1e-6) << i;
}

std::pmr::vector<SharpCorner> corners_of(const Model& model, double length) {
    const PartUnion parts = run_now(test_memory(), [&](Pace& pace) { return PartUnion::make(pace, model.parts, -1); });
    return run_now(test_memory(), [&](Pace& pace) { return sharp_corners(pace, parts, angle, length); });
}

TEST(SharpCorners, RoundContoursHaveNone) {
    Model model;
    model.add({ellipse(0, 0, 1, 0.7, 400)}, placement({0, 0, 0}));
    EXPECT_TRUE(corners_of(model, 0.1).empty());
}

// Drawn over several points, a corner is still one, and a wobble of the pen is none.
TEST(SharpCorners, DrawnByHand) {
    Ring ring;
    const auto line = [&](const Point2& a, const Point2& b) {
        for (uint32_t i = 0; i < 100; ++i) {
            const double t = (i + 0.5) / 100, wobble = 0.002 * std::sin(2.0 * i);
            ring.push_back({a.x + t * (b.x - a.x) + wobble, a.y + t * (b.y - a.y) - wobble});
        }
    };
    line({0, 0}, {2, 0});
    line({2, 0}, {1, 1.5});
    line({1, 1.5}, {0, 0});
    Model model;
    model.add({ring}, placement({0, 0, 0}));
    EXPECT_EQ(corners_of(model, 0.15).size(), 3u);
}

TEST(SharpCorners, BuriedOnesDoNotCount) {
    Model model;
    model.add({ellipse(0, 0, 1, 1, 400)}, placement({0, 0, 0}));
    model.add({{{0, -0.2}, {2, -0.2}, {2, 0.2}, {0, 0.2}}}, placement({0, 0, 0}));
    EXPECT_EQ(corners_of(model, 0.1).size(), 2u);
}

}  // namespace
}  // namespace flg::test
