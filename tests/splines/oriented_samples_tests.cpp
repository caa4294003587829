// SPDX-License-Identifier: MIT
#include "splines/manifolds/oriented_samples.h"

#include "core/failure.h"
#include "runtime/run_now.h"
#include "splines/sample_checks.h"

namespace flg::test {
namespace {

OrientedSamples make_samples(const std::vector<OrientedSample>& list, bool haltingly = false) {
    GrowingBuffer<OrientedSample> samples(list.size(), test_memory());
    std::copy(list.begin(), list.end(), samples.begin());
    return run_now(
        test_memory(), [&](Pace& pace) { return oriented_samples(pace, samples); }, haltingly);
}

// On the sphere of radius 2, with the bend of another one.
std::vector<OrientedSample> on_a_sphere(size_t count, double radius, double bend) {
    std::vector<OrientedSample> list;
    for (const Vec3& x : random_points(count, 1)) {
        const Vec3 n = x.normalized();
        list.push_back({{2 * n.x(), 2 * n.y(), 2 * n.z()}, {n.x(), n.y(), n.z()}, {bend, 0, 0, bend, 0, bend}, radius});
    }
    return list;
}

double literal_weight(const OrientedSample& s, const Vec3& x) {
    const double t = (x - Vec3(s.position.data())).squaredNorm() / (s.radius * s.radius);
    return t < 1 ? std::pow((1 - t) / s.radius, 4) : 0;
}

double literal_level(const OrientedSample& s, const Vec3& x) {
    const Vec3 d = x - Vec3(s.position.data());
    const auto& b = s.bend;
    Eigen::Matrix3d bend;
    bend << b[0], b[1], b[2], b[1], b[3], b[4], b[2], b[4], b[5];
    return Vec3(s.normal.data()).dot(d) + 0.5 * d.dot(bend * d);
}

TEST(OrientedSamples, AreTheWeightedMeanOfTheirSamples) {
    auto list = on_a_sphere(400, 0.9, 0.2);
    for (size_t i = 0; i < list.size(); ++i) list[i].radius *= 1 + 0.3 * static_cast<double>(i % 3);
    const OrientedSamples surface = make_samples(list);
    for (const Vec3& direction : random_points(100, 1, 3)) {
        const Vec3 x = 2.1 * direction.normalized();
        double sum = 0, weights = 0;
        for (uint32_t i = 0; i < surface.sample_count(); ++i) {
            const OrientedSample& s = surface.sample(i);
            sum += literal_weight(s, x) * literal_level(s, x);
            weights += literal_weight(s, x);
        }
        const SurfaceValue here = evaluate_at(surface, x);
        ASSERT_TRUE(here.defined);
        EXPECT_NEAR(here.value, sum / weights, 1e-14);
        expect_exact_derivatives(surface, x, 100);
    }
}

TEST(OrientedSamples, WithTheRightBendASphereComesOutExactly) {
    const OrientedSamples surface = make_samples(on_a_sphere(300, 1, 0.5));
    for (const Vec3& start : random_points(100, 3, 4)) {
        std::vector<double> hint = fresh_hint(surface);
        Vec3 x = start;
        ASSERT_TRUE(surface.project(x.data(), hint.data()));
        EXPECT_NEAR(x.norm(), 2, 1e-14);
        expect_tangent_basis(surface, x, hint);
        expect_second_form(surface, x, hint);
    }
}

TEST(OrientedSamples, FindTheNearestSample) {
    const auto list = on_a_sphere(1000, 0.3, 0);
    const OrientedSamples surface = make_samples(list);
    EXPECT_GT(surface.sample_count(), 900u);
    for (const Vec3& x : random_points(200, 4, 5)) {
        double nearest = 1e300;
        for (uint32_t i = 0; i < surface.sample_count(); ++i) {
            nearest = std::min(nearest, (Vec3(surface.sample(i).position.data()) - x).norm());
        }
        const OrientedSample& found = surface.sample(surface.nearest_sample(x));
        EXPECT_DOUBLE_EQ((Vec3(found.position.data()) - x).norm(), nearest);
    }
    const Vec3 far(1e30, -1e30, 1e30);
    EXPECT_LT(surface.nearest_sample(far), surface.sample_count());
}

// A point that wanders keeps what it remembers; a point that begins there knows nothing.
TEST(OrientedSamples, WhatAPointRemembersMakesNoDifference) {
    const OrientedSamples surface = make_samples(on_a_sphere(2000, 0.4, 0.1));
    std::vector<double> hint = fresh_hint(surface);
    size_t kept = 0;
    std::vector<double> before = hint;
    for (int step = 0; step < 2000; ++step) {
        const double angle = 0.004 * step;
        const Vec3 x = 2.02 * Vec3(std::cos(angle), std::sin(angle) * std::cos(angle), std::sin(angle)).normalized();
        const SurfaceValue warm = evaluate_at(surface, x, hint), cold = evaluate_at(surface, x);
        ASSERT_TRUE(warm.defined);
        EXPECT_EQ(warm.value, cold.value);
        EXPECT_EQ(warm.gradient, cold.gradient);
        EXPECT_EQ(warm.second, cold.second);
        kept += hint == before;
        before = hint;
    }
    EXPECT_GT(kept, 1500u) << "and saves most searches";
}

// More than a point remembers, and more than count: a stated part of them, always the same.
TEST(OrientedSamples, TooManyToRememberAreFoundEachTime) {
    for (const size_t count : {100u, 1000u}) {
        const OrientedSamples surface = make_samples(on_a_sphere(count, 5, 0.5));
        std::vector<double> hint = fresh_hint(surface);
        Vec3 x(1.5, 1, 1);
        ASSERT_TRUE(surface.project(x.data(), hint.data()));
        EXPECT_NEAR(x.norm(), 2, 1e-13);
        EXPECT_EQ(evaluate_at(surface, x).value, evaluate_at(surface, x, hint).value);
    }
}

TEST(OrientedSamples, HaveNoValueWhereNoneReaches) {
    const OrientedSamples surface = make_samples(on_a_sphere(300, 0.5, 0.5));
    EXPECT_FALSE(evaluate_at(surface, Vec3(0, 0, 0)).defined);
    EXPECT_FALSE(evaluate_at(surface, Vec3(1e300, 0, 0)).defined);
    std::vector<double> hint = fresh_hint(surface);
    Vec3 x(1e12, 0, 0);
    ASSERT_TRUE(surface.project(x.data(), hint.data())) << "but a nearest sample";
    EXPECT_NEAR(x.norm(), 2, 0.1);
    EXPECT_GT(x.x(), 1.9);
}

TEST(OrientedSamples, TakeTheSameBitsInAnySlices) {
    const auto list = on_a_sphere(777, 0.5, 0.3);
    const OrientedSamples whole = make_samples(list), sliced = make_samples(list, true);
    ASSERT_EQ(whole.sample_count(), sliced.sample_count());
    for (uint32_t i = 0; i < whole.sample_count(); ++i) EXPECT_EQ(whole.sample(i).position, sliced.sample(i).position);
    for (const Vec3& x : random_points(50, 2.5)) {
        std::vector<double> hint = fresh_hint(whole), other = hint;
        Vec3 a = x, b = x;
        ASSERT_TRUE(whole.project(a.data(), hint.data()));
        ASSERT_TRUE(sliced.project(b.data(), other.data()));
        EXPECT_EQ(a, b);
    }
}

TEST(OrientedSamples, NeedFour) {
    for (size_t count = 0; count < 4; ++count) {
        EXPECT_THROW(make_samples(on_a_sphere(count, 1, 0)), Failure) << count;
    }
    EXPECT_EQ(make_samples(on_a_sphere(4, 1, 0)).sample_count(), 4u);
}

TEST(OrientedSamples, AllInOnePlaceAreStillASurface) {
    const OrientedSample one{{1, 2, 3}, {0, 0, 1}, {}, 1};
    const OrientedSamples surface = make_samples(std::vector<OrientedSample>(1000, one));
    std::vector<double> hint = fresh_hint(surface);
    Vec3 x(1.2, 2.1, 3.3);
    ASSERT_TRUE(surface.project(x.data(), hint.data()));
    EXPECT_LT((x - Vec3(1.2, 2.1, 3)).norm(), 1e-14);
}

}  // namespace
}  // namespace flg::test
