// SPDX-License-Identifier: MIT
// Which points of curves are corners, and samples that come to them.
#include <gtest/gtest.h>

#include "curves/corners.h"
#include "curves/curve_inputs.h"

namespace flg::test {
namespace {

constexpr double degree = two_pi / 360;
constexpr double fifty_degrees = 50 * degree;

CornerCount corners_of(const Points& points, double angle = fifty_degrees) {
    return run_now(
        std::pmr::new_delete_resource(), [&](Pace& pace) { return count_corners(pace, points.view(), angle); }, true);
}

// Unit steps, each turned by so many degrees against the one before.
Points turning(const std::vector<double>& turns_deg, bool closed = false) {
    std::vector<Vec3> points = {Vec3::Zero(), Vec3::UnitX()};
    double angle = 0;
    for (const double turn : turns_deg) {
        angle += turn * degree;
        points.push_back(points.back() + Vec3(std::cos(angle), std::sin(angle), 0));
    }
    return points_of(points, closed);
}

Points polygon(int corners, int points_a_side, int first = 0) {
    std::vector<Vec3> points;
    const auto corner = [&](int i) { return Vec3(std::cos(two_pi * i / corners), std::sin(two_pi * i / corners), 0); };
    const int count = corners * points_a_side;
    for (int k = first; k < first + count; ++k) {
        const int side = k / points_a_side;
        const double t = static_cast<double>(k % points_a_side) / points_a_side;
        points.push_back((1 - t) * corner(side) + t * corner(side + 1));
    }
    return points_of(points, true);
}

TEST(Corners, StandOut) {
    EXPECT_EQ(corners_of(turning({0, 60, 0, 0})).corners, 1u);
    EXPECT_EQ(corners_of(turning({60})).corners, 1u);
    EXPECT_EQ(corners_of(turning({0, 45, 0})).corners, 0u);
    // A bend that is sampled coarsely, as hands draw it.
    EXPECT_EQ(corners_of(turning({25, 56, 46, 79, 53})).corners, 0u);
    // The same turns to and fro: a zigzag.
    EXPECT_EQ(corners_of(turning({60, -60, 60, -60})).corners, 4u);
    // A sharp turn at the end of a bend.
    EXPECT_EQ(corners_of(turning({30, 30, 120, 30})).corners, 1u);
    EXPECT_EQ(corners_of(turning({0, 90, 90, 0})).corners, 2u);
    EXPECT_EQ(corners_of(turning({0, 180, 0})).corners, 1u);
    EXPECT_EQ(corners_of(turning({0, 30, 0}), 20 * degree).corners, 1u);
}

TEST(Corners, OfPolygons) {
    for (const int points : {1, 2, 9}) {
        EXPECT_EQ(corners_of(polygon(3, points)).corners, 3u) << points;
        EXPECT_EQ(corners_of(polygon(4, points)).corners, 4u) << points;
        EXPECT_EQ(corners_of(polygon(8, points)).corners, 0u) << points;
        // Between others, corners need not stand out of each other.
        EXPECT_EQ(corners_of(polygon(6, points)).corners, points == 1 ? 0u : 6u) << points;
    }
}

TEST(Corners, OfSmoothCurvesAreNone) {
    for (const int points : {8, 12, 50}) {
        const auto circle = [](double u) { return Vec3(std::cos(two_pi * u), std::sin(two_pi * u), 0); };
        EXPECT_EQ(corners_of(sampled(circle, points, true)).corners, 0u) << points;
    }
    EXPECT_EQ(corners_of(sampled(helix, 40)).corners, 0u);
    EXPECT_EQ(corners_of(points_of({Vec3::Zero()})).corners, 0u);
    EXPECT_EQ(corners_of(points_of({Vec3::Zero(), Vec3::Zero()}, true)).corners, 0u);
    EXPECT_EQ(corners_of(points_of({Vec3::Zero(), Vec3::UnitX()})).corners, 0u);
}

TEST(Corners, AreFoundWhereverAClosedCurveBegins) {
    for (int first = 0; first < 7; ++first) {
        const CornerCount count = corners_of(polygon(4, 7, first));
        EXPECT_EQ(count.corners, 4u) << first;
        EXPECT_EQ(count.first_segment, static_cast<uint32_t>((7 - first) % 7)) << first;
    }
}

// Repeated points are one.
TEST(Corners, AreMetByASampleEach) {
    const std::vector<Vec3> corners = {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(3, 0, 0), Vec3(3, 1, 0), Vec3(-2, 1, 4)};
    const Points points = points_of(corners);
    ASSERT_EQ(corners_of(points).corners, 2u);
    std::vector<CurvePiece> pieces(3);
    run_now(
        std::pmr::new_delete_resource(),
        [&](Pace& pace) { return split_at_corners(pace, points.view(), nullptr, fifty_degrees, pieces); }, true);
    EXPECT_NEAR(pieces[0].length, 3, 1e-6);
    EXPECT_NEAR(pieces[1].length, 1, 1e-6);
    const uint32_t steps[] = {7, 1, 20};
    uint32_t end = 0;
    for (int p = 0; p < 3; ++p) {
        end += steps[p];
        pieces[p].end_step = end;
        pieces[p].step = pieces[p].length / steps[p];
    }
    SamplingPlan plan = plan_of(points, end);
    plan.pieces = pieces;
    const Resampled samples = resample(plan, true);
    EXPECT_EQ(samples.position(0), corners[0]);
    EXPECT_EQ(samples.position(7), corners[1]);
    EXPECT_EQ(samples.position(8), corners[3]);
    EXPECT_EQ(samples.position(end), corners[4]);
    for (uint32_t i = 1; i < 7; ++i) EXPECT_NEAR(samples.position(i).x(), i * 3.0 / 7, 1e-5);
    // A corner's sample goes the way behind it.
    EXPECT_NEAR(samples.tangent(7).y(), 1, 1e-5);
}

}  // namespace
}  // namespace flg::test
