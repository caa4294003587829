// SPDX-License-Identifier: MIT
#include "core/moving_frame.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "curves/curve_inputs.h"
#include "reference/literal_frames.h"

namespace flg {
namespace {

using test::Points;
using test::points_of;
using test::Resampled;

void expect_orthonormal(const Resampled& r) {
    for (size_t i = 0; i < r.size(); ++i) {
        EXPECT_NEAR(r.tangent(i).norm(), 1, 1e-6);
        EXPECT_NEAR(r.normal(i).norm(), 1, 1e-6);
        EXPECT_NEAR(r.normal(i).dot(r.tangent(i)), 0, 1e-6);
    }
}

// Exact samples of a helix of radius 2 and pitch 4/3 a turn.
struct Helix {
    static constexpr double radius = 2, turns = 3, height = 4;
    static constexpr double angle = turns * test::two_pi;
    static double length() { return std::hypot(radius * angle, height); }
    static double torsion() {
        const double rise = height / angle;
        return rise / (radius * radius + rise * rise);
    }
    static Vec3 tangent(double u) {
        return Vec3(-radius * angle * std::sin(angle * u), radius * angle * std::cos(angle * u), height) / length();
    }
    static Vec3 frenet_normal(double u) { return Vec3(-std::cos(angle * u), -std::sin(angle * u), 0); }
};

TEST(RotationMinimizingFrame, OnAHelixTurnsAtMinusTorsionAgainstFrenet) {
    double before = 0;
    for (int steps : {100, 200}) {
        RotationMinimizingFrame frame(test::helix(0), Helix::tangent(0), Helix::frenet_normal(0));
        for (int i = 1; i <= steps; ++i) {
            const double u = static_cast<double>(i) / steps;
            frame.step(test::helix(u), Helix::tangent(u));
        }
        const double angle = angle_about(Helix::tangent(1), Helix::frenet_normal(1), frame.normal());
        const double expected = std::remainder(-Helix::torsion() * Helix::length(), test::two_pi);
        const double error = std::abs(std::remainder(angle - expected, test::two_pi));
        EXPECT_LT(error, 1e-4);
        if (before > 0) {
            EXPECT_GT(before / error, 14.0);
        }  // fourth order
        before = error;
    }
}

TEST(RotationMinimizingFrame, AgreesWithTinyRotations) {
    const auto tangent = [](double u) -> Vec3 {
        const double h = 1e-6;
        return (test::wild(u + h) - test::wild(u - h)).normalized();
    };
    const Vec3 normal = tangent(0).unitOrthogonal();
    RotationMinimizingFrame frame(test::wild(0), tangent(0), normal);
    for (int i = 1; i <= 2000; ++i) frame.step(test::wild(i / 2000.0), tangent(i / 2000.0));
    EXPECT_LT((frame.normal() - literal::transport(tangent, 0, 1, 100000, normal)).norm(), 1e-5);
}

TEST(RotationMinimizingFrame, PlanarCurvesKeepTheirPlanesNormal) {
    RotationMinimizingFrame frame(Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1));
    for (int i = 1; i <= 1000; ++i) {
        const double a = 0.1 * i;
        frame.step(Vec3(std::cos(a), std::sin(a), 0), Vec3(-std::sin(a), std::cos(a), 0));
        ASSERT_LT((frame.normal() - Vec3(0, 0, 1)).norm(), 1e-12);
    }
}

TEST(RotationMinimizingFrame, StepsWithoutLength) {
    RotationMinimizingFrame frame(Vec3(1, 2, 3), Vec3(1, 0, 0), Vec3(0, 1, 0));
    frame.step(Vec3(1, 2, 3), Vec3(1, 0, 0));
    EXPECT_LT((frame.normal() - Vec3(0, 1, 0)).norm(), 1e-12);
    // Turned in place: the smallest rotation, about z.
    frame.step(Vec3(1, 2, 3), Vec3(0, 1, 0));
    EXPECT_LT((frame.normal() - Vec3(-1, 0, 0)).norm(), 1e-12);
}

TEST(RotationMinimizingFrame, ReversalsAndSidewaysSteps) {
    RotationMinimizingFrame frame(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    frame.step(Vec3(0, 0, 0), Vec3(-1, 0, 0));
    EXPECT_LT((frame.normal() - Vec3(0, 1, 0)).norm(), 1e-12);
    frame.step(Vec3(0, 0, 5), Vec3(-1, 0, 0));  // across the tangent, which stays
    EXPECT_LT((frame.normal() - Vec3(0, 1, 0)).norm(), 1e-12);
    frame.step(Vec3(1, 0, 5), Vec3(1, 0, 0));  // backwards
    EXPECT_NEAR(frame.normal().dot(frame.tangent()), 0, 1e-12);
    EXPECT_NEAR(frame.normal().norm(), 1, 1e-12);
}

TEST(RotationMinimizingFrame, StaysOrthonormalOverAMillionSteps) {
    RotationMinimizingFrame frame(test::helix(0), Helix::tangent(0), Helix::frenet_normal(0));
    for (int i = 1; i <= 1000000; ++i) frame.step(test::helix(i * 1e-3), Helix::tangent(i * 1e-3));
    EXPECT_NEAR(frame.normal().norm(), 1, 1e-12);
    EXPECT_NEAR(frame.normal().dot(frame.tangent()), 0, 1e-12);
}

TEST(MovingFrame, ClosedCurvesSpreadTheirTwist) {
    // A torus knot: the frame doesn't close by itself.
    const auto knot = [](double u) {
        const double a = test::two_pi * u;
        const double r = 2 + std::cos(3 * a);
        return Vec3(r * std::cos(2 * a), r * std::sin(2 * a), std::sin(3 * a));
    };
    const Points points = test::sampled(knot, 400, true);
    const Resampled r = test::resample(points, 1000);
    ASSERT_EQ(r.size(), 1000u);
    expect_orthonormal(r);
    // Over the seam the normal turns as much, against one that doesn't twist, as everywhere else.
    const auto twist = [&](size_t i, size_t j) {
        RotationMinimizingFrame frame(r.position(i), r.tangent(i), r.normal(i));
        frame.step(r.position(j), r.tangent(j));
        return angle_about(r.tangent(j), frame.normal(), r.normal(j));
    };
    for (size_t i = 0; i < 1000; ++i) EXPECT_NEAR(twist(i, (i + 1) % 1000), twist(499, 500), 2e-5) << i;
    // Against the frame carried once around without correction: a rotation that grows evenly.
    std::vector<Vec3> vectors = points.vectors();
    const auto literal = literal::resample(vectors, true, 1000, r.normal(0));
    const double total = angle_about(literal[1000].tangent, literal[1000].normal, r.normal(0));
    EXPECT_GT(std::abs(total), 0.05);
    for (size_t i : {100u, 250u, 500u, 900u}) {
        const double angle = angle_about(literal[i].tangent, literal[i].normal, r.normal(i));
        EXPECT_NEAR(std::remainder(angle - total * i / 1000, test::two_pi), 0, 2e-3);
    }
}

TEST(MovingFrame, FrenetNormalsOfAHelix) {
    const Resampled r = test::resample(test::sampled(test::helix, 600), 900, FLG_FRAME_METHOD_FRENET);
    expect_orthonormal(r);
    for (size_t i = 5; i + 5 < r.size(); ++i) {
        const Vec3 p = r.position(i);
        EXPECT_LT((r.normal(i) - Vec3(-p.x(), -p.y(), 0).normalized()).norm(), 2e-2) << i;
    }
}

TEST(MovingFrame, FrenetNormalsAreCarriedAlongStraightParts) {
    // A quarter circle in the xy plane, then a straight line.
    std::vector<Vec3> points;
    for (int i = 0; i <= 40; ++i)
        points.emplace_back(std::sin(i * 0.025 * 1.5708), 1 - std::cos(i * 0.025 * 1.5708), 0);
    for (int i = 1; i <= 40; ++i) points.emplace_back(1, 1 + 0.1 * i, 0);
    const Resampled r = test::resample(points_of(points), 400, FLG_FRAME_METHOD_FRENET);
    expect_orthonormal(r);
    // The transition is an inflection, where Frenet normals may flip; from there on nothing turns.
    EXPECT_NEAR(std::abs(r.normal(300).x()), 1, 1e-5);
    EXPECT_LT((r.normal(390) - r.normal(300)).norm(), 1e-5);
}

// Normals in a fixed direction, one a point.
SamplingPlan supplied(const Points& points, uint32_t steps, const std::vector<float>& normals) {
    SamplingPlan plan = test::plan_of(points, steps, FLG_FRAME_METHOD_SUPPLIED);
    plan.normals = normals.data();
    return plan;
}

TEST(MovingFrame, SuppliedNormalsAreInterpolatedAndMadePerpendicular) {
    // Up and tangential at once, of length 3, on a circle: what is left of it is up.
    for (bool closed : {false, true}) {
        const auto circle = [](double u) { return Vec3(std::cos(test::two_pi * u), std::sin(test::two_pi * u), 0); };
        const Points points = test::sampled(circle, 50, closed);
        std::vector<float> normals;
        for (size_t i = 0; i < points.floats.size() / 3; ++i) {
            const double a = test::two_pi * static_cast<double>(i) / 50;
            for (double v : {-3 * std::sin(a), 3 * std::cos(a), 3.0}) normals.push_back(static_cast<float>(v));
        }
        const Resampled r = test::resample(supplied(points, 333, normals));
        expect_orthonormal(r);
        for (size_t i = 0; i < r.size(); ++i) EXPECT_LT((r.normal(i) - Vec3::UnitZ()).norm(), 2e-2);
    }
    // Between two points that are given y and z: the direction of the linear mix.
    const std::vector<float> normals{0, 1, 0, 0, 0, 1};
    const Resampled r = test::resample(supplied(points_of({{0, 0, 0}, {1, 0, 0}}), 4, normals));
    EXPECT_LT((r.normal(1) - Vec3(0, 3, 1).normalized()).norm(), 1e-6);
}

TEST(MovingFrame, SuppliedNormalsThatPointAlongTheCurveAreCarriedOn) {
    const Points line = points_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
    const std::vector<float> normals{1, 0, 0, 0, 0, 2, 7, 0, 0, 7, 0, 0, 0, -1, 0};
    const Resampled r = test::resample(supplied(line, 40, normals));
    expect_orthonormal(r);
    EXPECT_LT((r.normal(10) - Vec3(0, 0, 1)).norm(), 1e-6);
    for (size_t i = 20; i <= 30; ++i) EXPECT_LT((r.normal(i) - Vec3(0, 0, 1)).norm(), 1e-6) << i;
    EXPECT_LT((r.normal(40) - Vec3(0, -1, 0)).norm(), 1e-6);
    // Zero and opposite ones.
    const std::vector<float> none(15, 0.0f);
    expect_orthonormal(test::resample(supplied(line, 40, none)));
    const std::vector<float> opposite{0, 1, 0, 0, -1, 0, 0, 1, 0, 0, -1, 0, 0, 1, 0};
    expect_orthonormal(test::resample(supplied(line, 40, opposite)));
}

// In the xy plane but for its far side, which is arched, so that the curve's mean is off the plane; begins on a
// straight part.
Points arched_track() {
    std::vector<Vec3> points;
    for (int i = 0; i < 10; ++i) points.emplace_back(0.1 * i, 0, 0);
    for (int i = 0; i < 20; ++i) {
        const double a = test::two_pi * i / 40;
        points.emplace_back(1 + std::sin(a), 1 - std::cos(a), 0);
    }
    for (int i = 0; i < 20; ++i) points.emplace_back(1 - 0.1 * i, 2, 0.5 * std::sin(test::two_pi * i / 40));
    for (int i = 0; i < 20; ++i) {
        const double a = test::two_pi * i / 40;
        points.emplace_back(-1 - std::sin(a), 1 + std::cos(a), 0);
    }
    for (int i = 0; i < 10; ++i) points.emplace_back(-1 + 0.1 * i, 0, 0);
    return points_of(points, true);
}

TEST(MovingFrame, FrenetNormalsAreCarriedOverTheFirstPointOfClosedCurves) {
    const Points track = arched_track();
    const Resampled r = test::resample(track, 1000, FLG_FRAME_METHOD_FRENET);
    expect_orthonormal(r);
    // The last bend before is in the xy plane.
    EXPECT_NEAR(std::abs(r.normal(0).y()), 1, 1e-5);
    for (size_t i = 1; i < 60; ++i) {
        EXPECT_LT((r.normal(i) - r.normal(0)).norm(), 1e-5) << i;
        EXPECT_LT((r.normal(1000 - i) - r.normal(0)).norm(), 1e-5) << i;
    }
    EXPECT_EQ(test::resample(track, 1000, FLG_FRAME_METHOD_FRENET, 1).normals, r.normals);
}

TEST(MovingFrame, SuppliedNormalsAreCarriedOverTheFirstPointOfClosedCurves) {
    const auto circle = [](double u) { return Vec3(std::cos(test::two_pi * u), std::sin(test::two_pi * u), 0); };
    const Points points = test::sampled(circle, 50, true);
    std::vector<float> normals(150, 0.0f);
    for (size_t i = 10; i < 40; ++i) normals[3 * i + 2] = 1;
    const Resampled r = test::resample(supplied(points, 200, normals));
    for (size_t i = 0; i < r.size(); ++i) EXPECT_LT((r.normal(i) - Vec3::UnitZ()).norm(), 1e-6) << i;
}

TEST(MovingFrame, ClosedCurvesWithoutANormalHaveRotationMinimizingFrames) {
    const Points track = arched_track();
    const std::vector<float> none(track.floats.size(), 0.0f);
    EXPECT_EQ(test::resample(supplied(track, 500, none)).normals, test::resample(track, 500).normals);
}

TEST(MovingFrame, RigidMotionOfTheCurveMovesTheFrames) {
    const Eigen::Quaterniond rotation = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
    const Vec3 shift(0.3, -1.2, 2.1);
    const auto s_shape = [](double u) { return Vec3(u, std::sin(test::two_pi * u), 0); };  // its mean cancels out
    for (const auto& curve : {std::function<Vec3(double)>(test::wild), std::function<Vec3(double)>(test::helix),
                              std::function<Vec3(double)>(s_shape)}) {
        const Resampled r = test::resample(test::sampled(curve, 300), 500);
        const Resampled moved =
            test::resample(test::sampled([&](double u) -> Vec3 { return rotation * curve(u) + shift; }, 300), 500);
        for (size_t i = 0; i < r.size(); ++i) {
            EXPECT_LT((moved.position(i) - (rotation * r.position(i) + shift)).norm(), 3e-6);
            EXPECT_LT((moved.normal(i) - rotation * r.normal(i)).norm(), 1e-3);
        }
    }
}

TEST(MovingFrame, StraightCurvesTakeTheLeastAlignedAxis) {
    const Resampled r = test::resample(points_of({{0, 0, 0}, {3, 0.5, 1}, {6, 1, 2}}), 10);
    expect_orthonormal(r);
    const Vec3 t = Vec3(6, 1, 2).normalized();
    EXPECT_LT((r.normal(10) - (Vec3::UnitY() - t.y() * t).normalized()).norm(), 1e-6);
}

}  // namespace
}  // namespace flg
