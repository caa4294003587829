// SPDX-License-Identifier: MIT
#include "splines/manifolds/cloud_samples.h"

#include "core/failure.h"
#include "splines/manifolds/implicit_surfaces.h"
#include "splines/sample_checks.h"

namespace flg::test {
namespace {

struct Cloud {
    std::vector<Position> points, normals;
};

// Where points that repel each other would lie, about (a Fibonacci lattice), and a little random noise along the
// normal.
Cloud cloud_of(const Hypersurface& surface, const std::vector<Vec3>& places, double noise = 0) {
    Cloud cloud;
    uint64_t index = 0;
    for (Vec3 x : places) {
        std::vector<double> hint = fresh_hint(surface);
        EXPECT_TRUE(surface.project(x.data(), hint.data()));
        const Vec3 n = evaluate_at(surface, x).gradient.normalized();
        cloud.points.push_back(to_position(x + noise * (2 * random_unit(3, index++, 0) - 1) * n));
        cloud.normals.push_back(to_position(3 * n));
    }
    return cloud;
}

std::vector<Vec3> spread_on_a_sphere(uint32_t count) {
    std::vector<Vec3> places;
    for (uint32_t i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count, out = std::sqrt(1 - z * z),
                     a = 2 * std::numbers::pi * i / std::numbers::phi;
        places.emplace_back(out * std::cos(a), out * std::sin(a), z);
    }
    return places;
}

std::vector<Vec3> vertices_of(const Soup& soup) {
    std::vector<Vec3> places;
    for (const Position& position : soup.positions) places.push_back(load_vec3(position.data()));
    return places;
}

SampledSurface sample(const Cloud& cloud, bool with_normals, bool haltingly = false, uint32_t neighbours = 16) {
    const auto normals = with_normals ? std::span<const Position>(cloud.normals) : std::span<const Position>();
    return run_now(
        test_memory(),
        [&](Pace& pace) { return sample_cloud(pace, cloud.points, normals, {.neighbours = neighbours}); }, haltingly);
}

class CloudSamples : public testing::TestWithParam<bool> {};

TEST_P(CloudSamples, OfASphereComeNearItQuickly) {
    const SphereSurface exact(1);
    const std::vector<Vec3> points = random_points(200, 1);
    const SampledSurface coarse = sample(cloud_of(exact, spread_on_a_sphere(500)), GetParam());
    const SampledSurface fine = sample(cloud_of(exact, spread_on_a_sphere(2000)), GetParam());
    const SurfaceErrors first = errors_against(exact, coarse.surface, points);
    const SurfaceErrors second = errors_against(exact, fine.surface, points);
    EXPECT_LT(first.place, 2e-3);
    EXPECT_LT(second.place, first.place / 6);
    EXPECT_LT(second.normal, first.normal / 2);
    EXPECT_EQ(fine.deviation.uncovered, 0u);
}

TEST_P(CloudSamples, OfATorusComeNearItQuickly) {
    const TorusSurface exact(1, 0.4);
    const std::vector<Vec3> points = points_on(make_mesh(closed_torus(24)), 200);
    const SampledSurface coarse = sample(cloud_of(exact, vertices_of(closed_torus(24))), GetParam());
    const SampledSurface fine = sample(cloud_of(exact, vertices_of(closed_torus(48))), GetParam());
    const SurfaceErrors first = errors_against(exact, coarse.surface, points);
    const SurfaceErrors second = errors_against(exact, fine.surface, points);
    EXPECT_LT(first.place, 1e-2);
    EXPECT_LT(second.place, first.place / 5);
    EXPECT_LT(second.normal, first.normal / 2);
    EXPECT_EQ(coarse.parts, GetParam() ? 0u : 1u) << "and all normals point outwards, or the errors would be large";
}

// What is noise of the points is less on the surface, and told.
TEST_P(CloudSamples, SmoothNoise) {
    const SphereSurface exact(1);
    const double noise = 0.01;
    const Cloud cloud = cloud_of(exact, spread_on_a_sphere(4000), noise);
    const SampledSurface sampled = sample(cloud, GetParam(), false, 24);
    double off = 0, rough = 0;
    constexpr size_t looks = 3000;  // of a few hundred, the mean depends on where they are
    for (Vec3 x : random_points(looks, 1)) {
        std::vector<double> hint = fresh_hint(sampled.surface);
        ASSERT_TRUE(sampled.surface.project(x.data(), hint.data()));
        off += (x.norm() - 1) * (x.norm() - 1) / looks;
        rough = std::max(rough, (evaluate_at(sampled.surface, x).gradient.normalized() - x.normalized()).norm());
    }
    const double of_points = noise / std::sqrt(3.0);
    EXPECT_LT(std::sqrt(off), of_points / 2);
    EXPECT_LT(rough, 0.2);
    EXPECT_NEAR(sampled.deviation.mean(), noise / 2, noise / 6) << "what is even has half its range for a mean";
}

TEST_P(CloudSamples, TakeTheSameBitsInAnySlices) {
    const Cloud cloud = cloud_of(SphereSurface(1), random_points(600, 1));
    const SampledSurface whole = sample(cloud, GetParam()), sliced = sample(cloud, GetParam(), true);
    ASSERT_EQ(whole.surface.sample_count(), sliced.surface.sample_count());
    for (uint32_t i = 0; i < whole.surface.sample_count(); ++i) {
        const OrientedSample &a = whole.surface.sample(i), &b = sliced.surface.sample(i);
        EXPECT_EQ(a.position, b.position);
        EXPECT_EQ(a.normal, b.normal);
        EXPECT_EQ(a.bend, b.bend);
        EXPECT_EQ(a.radius, b.radius);
    }
    EXPECT_EQ(whole.deviation.mean(), sliced.deviation.mean());
}

// Far points have no neighbours near them, and do not reach over the others.
TEST_P(CloudSamples, LeaveOutliersAlone) {
    const SphereSurface exact(1);
    Cloud cloud = cloud_of(exact, spread_on_a_sphere(1000));
    const SurfaceErrors before = errors_against(exact, sample(cloud, GetParam()).surface, random_points(100, 1));
    for (const Vec3& place : {Vec3(4, 0, 0), Vec3(0, -5, 1), Vec3(0, 0, 100)}) {
        cloud.points.push_back(to_position(place));
        cloud.normals.push_back({0, 0, 1});
    }
    const SurfaceErrors after = errors_against(exact, sample(cloud, GetParam()).surface, random_points(100, 1));
    EXPECT_NEAR(after.place, before.place, 1e-9);
}

TEST_P(CloudSamples, OfTooLittleFail) {
    Cloud cloud;
    for (int i = 0; i < 3; ++i) {
        EXPECT_THROW(sample(cloud, GetParam()), Failure) << i;
        cloud.points.push_back({float(i), float(i * i), 0});
        cloud.normals.push_back({0, 0, 1});
    }
    EXPECT_THROW(sample(cloud, GetParam()), Failure);
    cloud.points.push_back({0, 1, 0});
    cloud.normals.push_back({0, 0, 1});
    const SampledSurface four = sample(cloud, GetParam());
    std::vector<double> hint = fresh_hint(four.surface);
    Vec3 x(0.5, 0.6, 0.1);
    ASSERT_TRUE(four.surface.project(x.data(), hint.data()));
    EXPECT_NEAR(x.z(), 0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(All, CloudSamples, testing::Bool(),
                         [](const auto& parameter) { return parameter.param ? "WithNormals" : "WithoutNormals"; });

TEST(CloudSamplesDegenerate, PointsInOnePlaceOrOnALineAreNoSurface) {
    Cloud one, line;
    for (int i = 0; i < 6000; ++i) {
        one.points.push_back({1, 2, 3});
        if (i < 100) line.points.push_back({float(i), float(2 * i), float(-i)});
    }
    EXPECT_THROW(sample(one, false), Failure);
    EXPECT_THROW(sample(line, false), Failure);
    one.normals.assign(one.points.size(), {0, 0, 1});
    EXPECT_THROW(sample(one, true), Failure) << "they reach nowhere";
    line.normals.assign(line.points.size(), {0, 0, 0});
    EXPECT_THROW(sample(line, true), Failure) << "normals without a direction";
}

// Copies count once.
TEST(CloudSamplesDegenerate, CopiesOfPointsDoNoHarm) {
    const SphereSurface exact(1);
    Cloud cloud = cloud_of(exact, spread_on_a_sphere(1000));
    cloud.points.insert(cloud.points.end(), cloud.points.begin(), cloud.points.begin() + 500);
    const SampledSurface sampled = sample(cloud, false);
    EXPECT_LT(errors_against(exact, sampled.surface, random_points(200, 1)).place, 3e-3);
}

// Two spheres: each part's normals point outwards.
TEST(CloudSamplesOrientation, EachPartIsTurnedByItsTop) {
    Cloud cloud = cloud_of(SphereSurface(1), spread_on_a_sphere(800));
    const size_t count = cloud.points.size();
    for (size_t i = 0; i < count; ++i) {
        Position moved = cloud.points[i];
        moved[0] += 3;
        cloud.points.push_back(moved);
    }
    const SampledSurface sampled = sample(cloud, false);
    EXPECT_EQ(sampled.parts, 2u);
    for (uint32_t i = 0; i < sampled.surface.sample_count(); ++i) {
        const OrientedSample& sample = sampled.surface.sample(i);
        const Vec3 middle(sample.position[0] > 1.5 ? 3 : 0, 0, 0);
        EXPECT_GT(Vec3(sample.normal.data()).dot(Vec3(sample.position.data()) - middle), 0.9);
    }
}

TEST(CloudSamplesOrientation, TurnsWithTheCloud) {
    const Cloud cloud = cloud_of(TorusSurface(1, 0.4), vertices_of(closed_torus(24)));
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, -2, 1).normalized()).toRotationMatrix();
    Cloud other = cloud;
    for (Position& p : other.points) p = to_position(turn * load_vec3(p.data()));
    const SampledSurface before = sample(cloud, false), after = sample(other, false);
    for (const Vec3& start : points_on(make_mesh(closed_torus(24)), 100)) {
        std::vector<double> hint = fresh_hint(before.surface), more = hint;
        Vec3 x = start, y = turn * start;
        ASSERT_TRUE(before.surface.project(x.data(), hint.data()));
        ASSERT_TRUE(after.surface.project(y.data(), more.data()));
        EXPECT_LT((turn * x - y).norm(), 3e-6);
    }
}

}  // namespace
}  // namespace flg::test
