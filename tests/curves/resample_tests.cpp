// SPDX-License-Identifier: MIT
#include "curves/resample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "curves/curve_inputs.h"
#include "reference/literal_frames.h"

namespace flg {
namespace {

using test::Points;
using test::points_of;
using test::Resampled;

Points circle(int count, bool closed) {
    return test::sampled([](double u) { return Vec3(std::cos(test::two_pi * u), std::sin(test::two_pi * u), 0.5); },
                         count, closed);
}

double worst_step_error(const Resampled& r) {
    double least = INFINITY, most = 0;
    for (size_t i = 1; i < r.size(); ++i) {
        const double step = (r.position(i) - r.position(i - 1)).norm();
        least = std::min(least, step);
        most = std::max(most, step);
    }
    return most / least - 1;
}

TEST(Resample, CirclesComeOutRound) {
    // A cubic with the right tangents leaves a circle by 2.7e-4 in a quarter turn, and by the sixth power of the turn.
    const Resampled eight = test::resample(circle(8, true), 1000);
    for (size_t i = 0; i < eight.size(); ++i) {
        EXPECT_NEAR(std::hypot(eight.position(i).x(), eight.position(i).y()), 1.0, 6e-6);
    }
    EXPECT_NEAR(test::measure(circle(8, true)).length / test::two_pi, 1.0, 1e-5);
    EXPECT_NEAR(test::measure(circle(16, true)).length / test::two_pi, 1.0, 3e-7);
    const Resampled r = test::resample(circle(24, true), 100);
    ASSERT_EQ(r.size(), 100u);
    for (size_t i = 0; i < r.size(); ++i) {
        const Vec3 p = r.position(i);
        EXPECT_NEAR(std::hypot(p.x(), p.y()), 1.0, 2e-6);
        EXPECT_NEAR(r.tangent(i).dot(Vec3(p.x(), p.y(), 0)), 0.0, 2e-4);
    }
    EXPECT_LT(worst_step_error(r), 1e-4);
}

TEST(Resample, OpenArcsAreCirclesToTheirEnds) {
    const Resampled r = test::resample(circle(24, false), 97);
    for (size_t i = 0; i < r.size(); ++i) {
        EXPECT_NEAR(std::hypot(r.position(i).x(), r.position(i).y()), 1.0, 2e-6);
    }
}

TEST(Resample, StraightRunsStayStraight) {
    const Points line = points_of({{0, 0, 0}, {1, 2, 4}, {1.5, 3, 6}, {8, 16, 32}});
    const Resampled r = test::resample(line, 64);
    const double length = Vec3(8, 16, 32).norm();
    EXPECT_DOUBLE_EQ(test::measure(line).length, length);
    for (size_t i = 0; i < r.size(); ++i) {
        EXPECT_LT((r.position(i) - Vec3(8, 16, 32) * (static_cast<double>(i) / 64)).norm(), 4e-6);
        EXPECT_LT((r.tangent(i) - Vec3(1, 2, 4).normalized()).norm(), 1e-6);
    }
}

TEST(Resample, CornersStaySharp) {
    // A square's length is exact only if no rounding takes place at its corners.
    const Points square = points_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, true);
    EXPECT_DOUBLE_EQ(test::measure(square).length, 4.0);
    const Resampled r = test::resample(square, 8);
    EXPECT_LT((r.position(1) - Vec3(0.5, 0, 0)).norm(), 1e-6);
    EXPECT_LT((r.position(2) - Vec3(1, 0, 0)).norm(), 1e-6);
    EXPECT_LT((r.position(7) - Vec3(0, 0.5, 0)).norm(), 1e-6);
}

TEST(Resample, AgreesWithTheLiteralVersion) {
    for (int count : {3, 9, 40, 200}) {
        for (bool closed : {false, true}) {
            const Points points = test::sampled(test::wild, count, closed);
            const auto literal_length = literal::curve_length(points.vectors(), closed);
            const CurveMeasure measure = test::measure(points);
            // Three Gauss points against a fine sum: coarse polylines bend much in a segment.
            EXPECT_NEAR(measure.length / literal_length, 1.0, count < 40 ? 1e-3 : 5e-6) << count;
            if (closed) continue;
            const uint32_t steps = 333;
            const Resampled fast = test::resample(points, steps);
            const auto slow = literal::resample(points.vectors(), closed, steps, measure.initial_normal());
            for (size_t i = 0; i <= steps; ++i) {
                const double tolerance = measure.length * (count < 40 ? 2e-3 : 2e-6);
                EXPECT_LT((fast.position(i) - slow[i].position).norm(), tolerance) << count << " " << i;
                if (count < 40) continue;
                EXPECT_LT((fast.tangent(i) - slow[i].tangent).norm(), 1e-4) << count << " " << i;
                EXPECT_LT((fast.normal(i) - slow[i].normal).norm(), 2e-3) << count << " " << i;
            }
        }
    }
}

TEST(Resample, StepsAreEvenAndEndsExact) {
    const Points points = test::sampled(test::wild, 150);
    const Resampled r = test::resample(points, 5000);
    EXPECT_LT(worst_step_error(r), 2e-3);  // float coordinates: 1e-7 in 1e-3
    EXPECT_EQ(r.position(0), points.view().point(0));
    EXPECT_EQ(r.position(5000), points.view().point(150));
}

TEST(Resample, UnevenPointsGiveEvenSteps) {
    // Points crowd where cos is 0: chords differ by a factor of hundreds.
    const Points points = test::sampled([](double u) { return test::helix(0.5 - 0.5 * std::cos(3.14159 * u)); }, 300);
    EXPECT_LT(worst_step_error(test::resample(points, 400)), 2e-4);
}

TEST(Resample, RepeatedPointsCountOnce) {
    std::vector<Vec3> once, repeated;
    for (int i = 0; i <= 50; ++i) {
        once.push_back(test::wild(i / 50.0));
        for (int k = 0; k < 1 + (i % 7) * 40; ++k) repeated.push_back(once.back());
    }
    for (bool closed : {false, true}) {
        const Resampled a = test::resample(points_of(once, closed), 77);
        const Resampled b = test::resample(points_of(repeated, closed), 77);
        EXPECT_EQ(a.positions, b.positions);
        EXPECT_EQ(a.normals, b.normals);
    }
    // A closed curve that ends with its first point.
    std::vector<Vec3> ring = once;
    ring.insert(ring.end(), 100, once.front());
    EXPECT_EQ(test::resample(points_of(once, true), 77).positions, test::resample(points_of(ring, true), 77).positions);
}

TEST(Resample, ResultsDoNotDependOnTheSlices) {
    for (bool closed : {false, true}) {
        for (FlgFrameMethod frame :
             {FLG_FRAME_METHOD_ROTATION_MINIMIZING, FLG_FRAME_METHOD_FRENET, FLG_FRAME_METHOD_SUPPLIED}) {
            const Points points = test::sampled(test::wild, 500, closed);
            SamplingPlan plan = test::plan_of(points, 700, frame);
            plan.normals = points.floats.data();
            const Resampled whole = test::resample(plan);
            {
                EXPECT_EQ(test::measure(points, true).length, test::measure(points).length);
                const Resampled sliced = test::resample(plan, true);
                EXPECT_EQ(sliced.positions, whole.positions);
                EXPECT_EQ(sliced.tangents, whole.tangents);
                EXPECT_EQ(sliced.normals, whole.normals);
            }
        }
    }
}

TEST(Resample, OnePointAndZeroLength) {
    for (const Points& points :
         {points_of({{3, 4, 5}}), points_of({{3, 4, 5}}, true), points_of(std::vector<Vec3>(500, Vec3(3, 4, 5))),
          points_of(std::vector<Vec3>(500, Vec3(3, 4, 5)), true)}) {
        const CurveMeasure measure = test::measure(points);
        EXPECT_EQ(measure.length, 0.0);
        EXPECT_EQ(even_step_count(measure.length, 0.1, points.closed), 0.0);
        const Resampled r = test::resample(points, 0);
        ASSERT_EQ(r.size(), 1u);
        EXPECT_EQ(r.position(0), Vec3(3, 4, 5));
        EXPECT_NEAR(r.tangent(0).norm(), 1, 1e-6);
        EXPECT_NEAR(r.normal(0).norm(), 1, 1e-6);
        EXPECT_NEAR(r.normal(0).dot(r.tangent(0)), 0, 1e-6);
    }
}

TEST(Resample, TwoPoints) {
    const Points points = points_of({{1, 1, 1}, {1, 1, 3}});
    EXPECT_DOUBLE_EQ(test::measure(points).length, 2.0);
    const Resampled r = test::resample(points, 4);
    for (size_t i = 0; i <= 4; ++i) EXPECT_LT((r.position(i) - Vec3(1, 1, 1 + 0.5 * i)).norm(), 1e-6);
    // There and back.
    const Points back = points_of({{1, 1, 1}, {1, 1, 3}}, true);
    EXPECT_DOUBLE_EQ(test::measure(back).length, 4.0);
    const Resampled b = test::resample(back, 4);
    EXPECT_LT((b.position(3) - Vec3(1, 1, 2)).norm(), 1e-6);
    for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(b.normal(i).dot(b.tangent(i)), 0, 1e-6);
}

TEST(Resample, HugeAndTinyCoordinates) {
    for (double size : {1e30, 1e12, 1e-30}) {
        const Points points = test::sampled([size](double u) -> Vec3 { return size * test::wild(u); }, 60);
        const Points unit = test::sampled(test::wild, 60);
        EXPECT_NEAR(test::measure(points).length / test::measure(unit).length / size, 1.0, 1e-6);
        const Resampled r = test::resample(points, 100), expected = test::resample(unit, 100);
        for (size_t i = 0; i <= 100; ++i) {
            EXPECT_LT((r.position(i) / size - expected.position(i)).norm(), 1e-5);
            EXPECT_LT((r.normal(i) - expected.normal(i)).norm(), 1e-3);
        }
    }
    // Far away: the float coordinates leave steps of 65536.
    const Points far = test::sampled([](double u) -> Vec3 { return Vec3(1e12, 1e12, 1e12) + 1e6 * test::wild(u); }, 60);
    const Resampled r = test::resample(far, 100);
    for (size_t i = 0; i <= 100; ++i) EXPECT_NEAR(r.normal(i).dot(r.tangent(i)), 0, 1e-6);
}

TEST(Resample, StepCounts) {
    EXPECT_EQ(even_step_count(1.0, 0.4, false), 3);  // 2.5 is rounded up
    EXPECT_EQ(even_step_count(1.0, 0.41, false), 2);
    EXPECT_EQ(even_step_count(1.0, 100, false), 1);
    EXPECT_EQ(even_step_count(1.0, 100, true), 3);
    EXPECT_EQ(even_step_count(0.0, 1, true), 0);
    EXPECT_EQ(even_step_count(1e30, 1e-30, false), 0x1.0p53);
}

TEST(Resample, ColumnsFollowThePoints) {
    // Radius and time as linear functions of x: they must stay so.
    std::vector<Vec3> line;
    std::vector<float> radius, quaternions;
    for (int i = 0; i < 20; ++i) {
        line.emplace_back(i * i * 0.25, 0, 0);
        radius.push_back(static_cast<float>(3 * line.back().x() + 1));
        // Turning about x; every second with its sign reversed, which is the same orientation.
        const double half = 0.1 * i;
        const double sign = i % 2 ? -1 : 1;
        for (double v : {sign * std::sin(half), 0.0, 0.0, sign * std::cos(half)}) {
            quaternions.push_back(static_cast<float>(v));
        }
    }
    const Points points = points_of(line);
    const uint32_t steps = 333;
    std::vector<float> radius_out(steps + 1), quaternions_out(4 * (steps + 1));
    const ColumnPair columns[] = {{radius.data(), radius_out.data(), 1, false},
                                  {quaternions.data(), quaternions_out.data(), 4, true}};
    const Resampled r = test::resample(test::plan_of(points, steps), 13, columns);
    for (uint32_t i = 0; i <= steps; ++i) {
        EXPECT_NEAR(radius_out[i], 3 * r.position(i).x() + 1, 2e-4);
        const float* q = &quaternions_out[4 * i];
        EXPECT_NEAR(std::hypot(q[0], q[3]), 1.0, 1e-6);
    }
    // Half way between two orientations 0.2 apart.
    float half[4];
    const SamplePlace place{3, 0.5f};
    interpolate_column({quaternions.data(), half, 4, true}, points.view(), {&place, 1}, 0);
    EXPECT_NEAR(std::abs(half[0]), std::sin(0.35), 1e-6);
}

TEST(Resample, ColumnsOfClosedCurvesGoAround) {
    const Points square = points_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, true);
    const float values[] = {0, 10, 20, 30};
    float out[8];
    const ColumnPair column{values, out, 1, false};
    test::resample(test::plan_of(square, 8), 5, {&column, 1});
    const float expected[] = {0, 5, 10, 15, 20, 25, 30, 15};
    for (int i = 0; i < 8; ++i) EXPECT_NEAR(out[i], expected[i], 1e-5);
}

}  // namespace
}  // namespace flg
