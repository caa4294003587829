// SPDX-License-Identifier: MIT
#include "splines/manifolds/mesh_samples.h"

#include "core/failure.h"
#include "splines/manifolds/implicit_surfaces.h"
#include "splines/sample_checks.h"

namespace flg::test {
namespace {

Soup moved(Soup soup, const Eigen::Matrix3d& turn, const Vec3& shift) {
    for (Position& position : soup.positions) position = to_position(turn * load_vec3(position.data()) + shift);
    return soup;
}

// Places to the fourth order in the distance of vertices (where they are even), normals and curvatures to lower ones.
TEST(MeshSamples, OfATorusComeNearItQuickly) {
    const TorusSurface exact(1, 0.4);
    const std::vector<Vec3> points = points_on(make_mesh(closed_torus(24)), 300);
    const SampledSurface coarse = sample(make_mesh(closed_torus(32))), fine = sample(make_mesh(closed_torus(64)));
    const SurfaceErrors first = errors_against(exact, coarse.surface, points);
    const SurfaceErrors second = errors_against(exact, fine.surface, points);
    EXPECT_EQ(fine.extras, 0u);
    EXPECT_LT(first.place, 2e-4);
    EXPECT_LT(second.place, first.place / 8);
    EXPECT_LT(second.normal, first.normal / 3.5);
    EXPECT_LT(second.form, first.form / 1.7);
    EXPECT_LT(second.form, 0.03);
}

TEST(MeshSamples, OfASphereComeNearItQuickly) {
    const SphereSurface exact(1);
    const std::vector<Vec3> points = random_points(300, 1);
    const SampledSurface coarse = sample(make_mesh(sphere(2))), fine = sample(make_mesh(sphere(3)));
    const SurfaceErrors first = errors_against(exact, coarse.surface, points);
    const SurfaceErrors second = errors_against(exact, fine.surface, points);
    EXPECT_LT(first.place, 2e-3);
    EXPECT_LT(second.place, first.place / 8);
    EXPECT_LT(second.normal, first.normal / 3);
    EXPECT_LT(second.form, 0.05);
}

// A scale loses what is smaller, and little of what is larger: noise of vertices falls, the sphere stays.
TEST(MeshSamples, SeenThroughAScaleLoseNoiseAndKeepTheShape) {
    const SphereSurface exact(1);
    const std::vector<Vec3> points = random_points(300, 1);
    const Soup smooth = sphere(5);
    Soup noisy = smooth;
    for (size_t v = 0; v < noisy.positions.size(); ++v) {
        const Vec3 at = load_vec3(noisy.positions[v].data());
        noisy.positions[v] = to_position((1 + 0.01 * (2 * random_unit(3, v, 0) - 1)) * at);
    }
    const double scale = 0.2;
    const SurfaceErrors kept = errors_against(exact, sample(make_mesh(smooth), false, scale).surface, points);
    EXPECT_LT(kept.place, 2e-3);
    EXPECT_LT(kept.normal, 1e-2);
    const SurfaceErrors rough = errors_against(exact, sample(make_mesh(noisy)).surface, points);
    const SurfaceErrors seen = errors_against(exact, sample(make_mesh(noisy), false, scale).surface, points);
    EXPECT_LT(seen.place, 0.4 * rough.place);
    EXPECT_LT(seen.normal, 0.1 * rough.normal);
    EXPECT_LT(seen.form, 0.1 * rough.form);
}

TEST(MeshSamples, SeenThroughAScaleHaveTheSameBitsWhereverTheyHalt) {
    const Mesh mesh = make_mesh(closed_torus(24));
    const SampledSurface at_once = sample(mesh, false, 0.15), haltingly = sample(mesh, true, 0.15);
    ASSERT_EQ(at_once.surface.sample_count(), haltingly.surface.sample_count());
    EXPECT_LT(at_once.surface.sample_count(), mesh.vertex_count() / 2);
    for (uint32_t i = 0; i < at_once.surface.sample_count(); ++i) {
        EXPECT_EQ(at_once.surface.sample(i).position, haltingly.surface.sample(i).position);
        EXPECT_EQ(at_once.surface.sample(i).bend, haltingly.surface.sample(i).bend);
    }
}

// Samples that lie farther apart than the scale stay as they are.
TEST(MeshSamples, OfACoarseMeshAreTheSameThroughAFineScale) {
    const Mesh mesh = make_mesh(closed_torus(24));
    const SampledSurface own = sample(mesh), seen = sample(mesh, false, 0.01);
    ASSERT_EQ(own.surface.sample_count(), seen.surface.sample_count());
    for (uint32_t i = 0; i < own.surface.sample_count(); ++i)
        EXPECT_EQ(own.surface.sample(i).position, seen.surface.sample(i).position);
}

TEST(MeshSamples, AScaleLargerThanTheSurfaceIsRefused) {
    try {
        sample(make_mesh(closed_torus(24)), false, 1e9);
        ADD_FAILURE() << "not refused";
    } catch (const Failure& failure) {
        EXPECT_NE(std::string(failure.what()).find("desc.smoothing_scale is 1e+09 m"), std::string::npos)
            << failure.what();
    }
}

TEST(MeshSamples, HoldWhatZeroSetsHold) {
    const Mesh mesh = make_mesh(closed_torus(24));
    const SampledSurface sampled = sample(mesh);
    for (const Vec3& start : points_on(mesh, 60)) {
        std::vector<double> hint = fresh_hint(sampled.surface);
        Vec3 x = start;
        ASSERT_TRUE(sampled.surface.project(x.data(), hint.data()));
        EXPECT_NEAR(evaluate_at(sampled.surface, x, hint).value, 0, 1e-14);
        expect_exact_derivatives(sampled.surface, x, 100);
        expect_tangent_basis(sampled.surface, x, hint);
        expect_second_form(sampled.surface, x, hint, 1e-4);
        Vec3 again = x;
        ASSERT_TRUE(sampled.surface.project(again.data(), hint.data()));
        EXPECT_LT((again - x).norm(), 1e-13);
    }
}

// Projection from a small distance goes to the nearest point, up to its square.
TEST(MeshSamples, ProjectToTheNearestPoint) {
    const Mesh mesh = make_mesh(closed_torus(48));
    const SampledSurface sampled = sample(mesh);
    double errors[2] = {};
    for (const Vec3& start : points_on(mesh, 100)) {
        std::vector<double> hint = fresh_hint(sampled.surface);
        Vec3 x = start;
        ASSERT_TRUE(sampled.surface.project(x.data(), hint.data()));
        const Vec3 normal = evaluate_at(sampled.surface, x, hint).gradient.normalized();
        for (int k = 0; k < 2; ++k) {
            Vec3 above = x + (k == 0 ? 0.02 : 0.01) * normal;
            ASSERT_TRUE(sampled.surface.project(above.data(), hint.data()));
            errors[k] = std::max(errors[k], (above - x).norm());
        }
    }
    EXPECT_LT(errors[0], 1e-4);
    EXPECT_LT(errors[1], 0.3 * errors[0]);
}

TEST(MeshSamples, TellHowFarTheyAreFromTheMesh) {
    const SampledSurface coarse = sample(make_mesh(sphere(2))), fine = sample(make_mesh(sphere(3)));
    EXPECT_EQ(coarse.deviation.uncovered, 0u);
    EXPECT_EQ(coarse.deviation.places, 2u * 320);
    EXPECT_LT(coarse.deviation.mean(), coarse.deviation.largest);
    EXPECT_NEAR(coarse.deviation.largest, 0.017, 0.003) << "what chords of the sphere are inside of it";
    EXPECT_LT(fine.deviation.largest, coarse.deviation.largest / 3);
    const SampledSurface flat = sample(make_mesh(plane(20, 0.3)));
    EXPECT_LT(flat.deviation.largest, 1e-7);
}

TEST(MeshSamples, OfACubeAreARoundedCube) {
    const SampledSurface cube = sample(make_mesh(box({1, 1, 1})));
    EXPECT_GT(cube.extras, 500u);
    EXPECT_EQ(cube.deviation.uncovered, 0u);
    // Flat in the middle of the faces, rounded along the edges, all on the surface from anywhere.
    for (const Vec3& direction : random_points(300, 1)) {
        const Vec3 x = 0.5 / direction.cwiseAbs().maxCoeff() * direction;
        std::vector<double> hint = fresh_hint(cube.surface);
        Vec3 foot = x;
        ASSERT_TRUE(cube.surface.project(foot.data(), hint.data()));
        EXPECT_NEAR(evaluate_at(cube.surface, foot, hint).value, 0, 1e-10);
        EXPECT_LT(foot.cwiseAbs().maxCoeff(), 0.504) << "it does not swell";
        const Vec3 sorted = x.cwiseAbs();
        const double second = sorted.sum() - sorted.maxCoeff() - sorted.minCoeff();
        if (second < 0.3) {
            EXPECT_LT((foot - x).norm(), 1e-6) << x.transpose();
        } else {
            EXPECT_LT((foot - x).norm(), 0.05) << x.transpose();
        }
    }
}

// Seen from inside, edges are concave, and rounded the same way.
TEST(MeshSamples, ConcaveEdgesAreRoundedAsConvexOnes) {
    Soup soup = box({1, 0.8, 0.6});
    const SampledSurface outside = sample(make_mesh(soup));
    for (Triple& triangle : soup.triangles) std::swap(triangle[1], triangle[2]);
    const SampledSurface inside = sample(make_mesh(soup));
    for (const Vec3& place : random_points(200, 0.5)) {
        std::vector<double> hint = fresh_hint(outside.surface), other = hint;
        Vec3 x = Vec3(1, 0.8, 0.6).cwiseProduct(0.5 / place.cwiseAbs().maxCoeff() * place), y = x;
        ASSERT_TRUE(outside.surface.project(x.data(), hint.data()));
        ASSERT_TRUE(inside.surface.project(y.data(), other.data()));
        EXPECT_LT((x - y).norm(), 5e-3);
        EXPECT_LT(evaluate_at(outside.surface, x).gradient.dot(evaluate_at(inside.surface, x).gradient), 0);
    }
}

TEST(MeshSamples, OfLongTrianglesStayACylinder) {
    const Mesh mesh = make_mesh(cylinder(32, 1));
    const SampledSurface sampled = sample(mesh);
    EXPECT_GT(sampled.extras, 100u);
    for (const Vec3& start : points_on(mesh, 200)) {
        std::vector<double> hint = fresh_hint(sampled.surface);
        Vec3 x = start;
        ASSERT_TRUE(sampled.surface.project(x.data(), hint.data()));
        EXPECT_NEAR(std::hypot(x.x(), x.y()), 1, 0.01);
        const Vec3 normal = evaluate_at(sampled.surface, x, hint).gradient.normalized();
        EXPECT_LT((normal - Vec3(x.x(), x.y(), 0).normalized()).norm(), 0.05);
    }
}

// Both sides of a plate that is much thinner than its triangles stay apart.
TEST(MeshSamples, SidesOfAThinPlateStayApart) {
    const SampledSurface plate = sample(make_mesh(box({1, 1, 0.01})));
    for (const Vec3& place : random_points(200, 0.35)) {
        for (const double side : {1.0, -1.0}) {
            std::vector<double> hint = fresh_hint(plate.surface);
            Vec3 x(place.x(), place.y(), side * 0.0065);
            ASSERT_TRUE(plate.surface.project(x.data(), hint.data()));
            EXPECT_NEAR(x.z(), side * 0.005, 1e-9);
            EXPECT_GT(side * evaluate_at(plate.surface, x, hint).gradient.z(), 0.99);
            expect_second_form(plate.surface, x, hint);
        }
    }
}

// A plane cut into triangles of very different sizes is a plane.
TEST(MeshSamples, OfUnevenTrianglesAreCovered) {
    const Mesh flat = make_mesh(grid(24, 24, [](double u, double v) { return Vec3(u * u * u, v * v * v, 0); }));
    const SampledSurface sampled = sample(flat);
    EXPECT_EQ(sampled.deviation.uncovered, 0u);
    EXPECT_LT(sampled.deviation.largest, 1e-12);
    const TorusSurface exact(1, 0.4);
    const double tau = 2 * std::numbers::pi;
    const Mesh uneven = make_mesh(grid(
        96, 96,
        [&](double u, double v) {
            const double b = tau * v * v * v, out = 1 + 0.4 * std::cos(b), a = tau * (u + 0.12 * std::sin(tau * u));
            return Vec3(out * std::cos(a), out * std::sin(a), 0.4 * std::sin(b));
        },
        true));
    const SampledSurface torus = sample(uneven);
    EXPECT_EQ(torus.deviation.uncovered, 0u);
    const SurfaceErrors errors = errors_against(exact, torus.surface, points_on(uneven, 300));
    EXPECT_LT(errors.place, 2e-3);
    EXPECT_LT(errors.normal, 0.05);
}

// Around a globe's poles vertices crowd: most of them are left out, and nothing is lost.
TEST(MeshSamples, OfAGlobeDoNotCrowdAtItsPoles) {
    const uint32_t around = 500, up = 40;
    Soup soup;
    for (uint32_t j = 1; j < up; ++j) {
        for (uint32_t i = 0; i < around; ++i) {
            const double a = 2 * std::numbers::pi * i / around, b = std::numbers::pi * j / up;
            soup.positions.push_back(to_position({std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), -std::cos(b)}));
        }
    }
    soup.positions.push_back({0, 0, -1});
    soup.positions.push_back({0, 0, 1});
    const uint32_t south = static_cast<uint32_t>(soup.positions.size()) - 2, north = south + 1;
    for (uint32_t i = 0; i < around; ++i) {
        const uint32_t next = (i + 1) % around, top = (up - 2) * around;
        soup.triangles.push_back({south, next, i});
        soup.triangles.push_back({north, top + i, top + next});
        for (uint32_t j = 0; j + 2 < up; ++j) {
            const uint32_t low = j * around, high = low + around;
            soup.triangles.push_back({low + i, low + next, high + next});
            soup.triangles.push_back({low + i, high + next, high + i});
        }
    }
    const SampledSurface globe = sample(make_mesh(soup));
    EXPECT_EQ(globe.deviation.uncovered, 0u);
    EXPECT_LT(globe.surface.sample_count(), soup.positions.size());
    for (const Vec3& pole : {Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
        uint32_t reaching = 0;
        for (uint32_t i = 0; i < globe.surface.sample_count(); ++i) {
            const OrientedSample& sample = globe.surface.sample(i);
            reaching += (Vec3(sample.position.data()) - pole).norm() < sample.radius;
        }
        EXPECT_LT(reaching, 90u);
        EXPECT_GT(reaching, 5u);
    }
    std::vector<Vec3> points = random_points(200, 1);
    for (size_t i = 0; i < 100; ++i) points[i] = Vec3(0.1 * points[i].x(), 0.1 * points[i].y(), i % 2 == 0 ? 1 : -1);
    const SurfaceErrors errors = errors_against(SphereSurface(1), globe.surface, points);
    EXPECT_LT(errors.place, 2e-4);
    EXPECT_LT(errors.normal, 5e-3);
    EXPECT_LT(errors.form, 0.1);
}

TEST(MeshSamples, TurnWithTheMesh) {
    const Soup soup = closed_torus(20);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    const Vec3 shift(0.3, -0.2, 0.5);
    const SampledSurface before = sample(make_mesh(soup)), after = sample(make_mesh(moved(soup, turn, shift)));
    for (const Vec3& start : points_on(make_mesh(soup), 100)) {
        std::vector<double> hint = fresh_hint(before.surface), other = hint;
        Vec3 x = start, y = turn * start + shift;
        ASSERT_TRUE(before.surface.project(x.data(), hint.data()));
        ASSERT_TRUE(after.surface.project(y.data(), other.data()));
        EXPECT_LT((turn * x + shift - y).norm(), 2e-6) << "positions of meshes are floats";
    }
}

TEST(MeshSamples, GoOnALittleBeyondBorders) {
    const SampledSurface square = sample(make_mesh(plane(10)));
    std::vector<double> hint = fresh_hint(square.surface);
    Vec3 x(1.03, 0.5, 0.02);
    ASSERT_TRUE(square.surface.project(x.data(), hint.data()));
    EXPECT_LT((x - Vec3(1.03, 0.5, 0)).norm(), 1e-9) << "straight down";
    Vec3 away(3, 0.5, 0.2);
    ASSERT_TRUE(square.surface.project(away.data(), hint.data()));
    EXPECT_NEAR(away.z(), 0, 1e-9);
    EXPECT_NEAR(away.x(), 1, 0.15) << "near the border";
}

TEST(MeshSamples, TakeTheSameBitsInAnySlices) {
    for (const Soup& soup : {box({1, 0.5, 0.3}), closed_torus(12), plane(7, 0.3)}) {
        const Mesh mesh = make_mesh(soup);
        const SampledSurface whole = sample(mesh), sliced = sample(mesh, true);
        ASSERT_EQ(whole.surface.sample_count(), sliced.surface.sample_count());
        for (uint32_t i = 0; i < whole.surface.sample_count(); ++i) {
            const OrientedSample &a = whole.surface.sample(i), &b = sliced.surface.sample(i);
            EXPECT_EQ(a.position, b.position);
            EXPECT_EQ(a.normal, b.normal);
            EXPECT_EQ(a.bend, b.bend);
            EXPECT_EQ(a.radius, b.radius);
        }
        EXPECT_EQ(whole.deviation.largest, sliced.deviation.largest);
        EXPECT_EQ(whole.deviation.mean(), sliced.deviation.mean());
    }
}

TEST(MeshSamples, OfTooLittleFail) {
    EXPECT_THROW(sample(make_mesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}})), Failure) << "three samples";
    EXPECT_THROW(sample(make_mesh({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2}, {0, 2, 3}}})), Failure)
        << "no normals";
    EXPECT_NO_THROW(sample(make_mesh({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}})));
}

// A triangle without area among others does no harm.
TEST(MeshSamples, LeaveOutTrianglesWithoutArea) {
    Soup soup = plane(8);
    for (size_t i = 0; i < soup.positions.size(); ++i) {
        if (i % 9 == 4) soup.positions[i][0] = soup.positions[i + 1][0];
    }
    const SampledSurface sampled = sample(make_mesh(soup));
    EXPECT_LT(sampled.deviation.largest, 1e-12);
    EXPECT_EQ(sampled.deviation.uncovered, 0u);
}

// No more samples than were promised, however thin the triangles.
TEST(MeshSamples, OfNeedlesAreNotTooMany) {
    Soup soup;
    soup.positions = {{0, 0, 0}};
    for (int i = 0; i < 400; ++i) {
        const double angle = 2 * std::numbers::pi * i / 400;
        soup.positions.push_back(to_position({std::cos(angle), std::sin(angle), i % 2 == 0 ? 3.0 : 0.0}));
    }
    for (uint32_t i = 0; i < 400; ++i) soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % 400});
    const SampledSurface sampled = sample(make_mesh(soup));
    EXPECT_LE(sampled.extras, 20000u);
    std::vector<double> hint = fresh_hint(sampled.surface);
    for (Vec3 x : random_points(100, 2)) {
        const Vec3 start = x;
        if (!sampled.surface.project(x.data(), hint.data())) {
            EXPECT_EQ(x, start);
        }
        EXPECT_TRUE(x.allFinite());
    }
}

}  // namespace
}  // namespace flg::test
