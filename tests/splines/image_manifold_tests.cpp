// SPDX-License-Identifier: MIT
#include "splines/manifolds/image_manifold.h"

#include "splines/manifolds/implicit_surfaces.h"
#include "splines/sample_checks.h"

namespace flg::test {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Basis = Eigen::Matrix<double, 6, 2>;

Vec6 lifted(const ImageManifold& image, const Hypersurface& surface, const Vec3& start, std::vector<double>& hint) {
    Vec3 place = start;
    EXPECT_TRUE(surface.project(place.data(), hint.data()));
    Vec6 x;
    image.lift(place.data(), hint.data(), x.data());
    return x;
}

// The image of a sphere is a sphere, larger by sqrt(1 + (weight / R)^2).
TEST(ImageManifold, OfASphereIsASphere) {
    const SphereSurface sphere(2);
    const ImageManifold image(sphere, 1.5);
    EXPECT_EQ(image.ambient(), 6u);
    EXPECT_EQ(image.dimension(), 2u);
    std::vector<double> none;
    const Vec3 force(0.2, -0.5, 0.7), other(0.4, 0.1, -0.3);
    for (const Vec3& start : random_points(50, 1)) {
        const Vec6 x = lifted(image, sphere, start, none);
        EXPECT_NEAR(x.norm(), 2.5, 1e-14);
        EXPECT_LT((x.tail<3>() - 0.75 * x.head<3>()).norm(), 1e-14);
        Basis basis;
        image.tangent_basis(x.data(), none.data(), basis.data());
        EXPECT_LT((basis.transpose() * basis - Eigen::Matrix2d::Identity()).norm(), 1e-14);
        EXPECT_LT((basis.transpose() * x).norm(), 1e-14);
        Vec6 all;
        all << force, other;
        Eigen::Matrix2d form;
        image.second_form(x.data(), none.data(), basis.data(), all.data(), form.data());
        const Eigen::Matrix2d right = -all.dot(x) / (2.5 * 2.5) * Eigen::Matrix2d::Identity();
        EXPECT_LT((form - right).norm(), 1e-6);
    }
}

// Points beside the manifold, in a normal direction of R^6: back to where they came from, up to the square of the
// distance.
TEST(ImageManifold, ProjectsToTheNearestPoint) {
    const TorusSurface torus(1, 0.4);
    const ImageManifold image(torus, 0.3);
    double errors[2] = {};
    for (const Vec3& start : random_points(100, 1.5)) {
        std::vector<double> none;
        const Vec6 x = lifted(image, torus, start, none);
        Basis basis;
        image.tangent_basis(x.data(), none.data(), basis.data());
        Vec6 beside;
        beside << 0.3, 0.5, -0.4, -0.2, 0.6, 0.1;
        beside -= basis * (basis.transpose() * beside);
        for (int k = 0; k < 2; ++k) {
            Vec6 y = x + (k == 0 ? 0.02 : 0.01) * beside;
            ASSERT_TRUE(image.project(y.data(), none.data()));
            errors[k] = std::max(errors[k], (y - x).norm());
        }
        Vec6 same = x;
        ASSERT_TRUE(image.project(same.data(), none.data()));
        EXPECT_LT((same - x).norm(), 1e-13);
    }
    EXPECT_LT(errors[0], 5e-3);
    EXPECT_LT(errors[1], 0.3 * errors[0]);
}

// Tangents against differences of projected points; also where points remember neighbours.
TEST(ImageManifold, HasTangentsOfTheLiftedSurface) {
    const Mesh mesh = make_mesh(closed_torus(32));
    const SampledSurface sampled = sample(mesh);
    const ImageManifold image(sampled.surface, 0.25);
    EXPECT_EQ(image.hint_size(), sampled.surface.hint_size());
    for (const Vec3& start : points_on(mesh, 50)) {
        std::vector<double> hint = fresh_hint(image);
        const Vec6 x = lifted(image, sampled.surface, start, hint);
        Basis basis;
        image.tangent_basis(x.data(), hint.data(), basis.data());
        EXPECT_LT((basis.transpose() * basis - Eigen::Matrix2d::Identity()).norm(), 1e-13);
        const double step = 1e-5;
        for (int j = 0; j < 2; ++j) {
            Vec6 after = x + step * basis.col(j), before = x - step * basis.col(j);
            ASSERT_TRUE(image.project(after.data(), hint.data()));
            ASSERT_TRUE(image.project(before.data(), hint.data()));
            EXPECT_LT(((after - before) / (2 * step) - basis.col(j)).norm(), 1e-6);
        }
        Eigen::Matrix2d form;
        const Vec6 force = Vec6::Ones();
        image.second_form(x.data(), hint.data(), basis.data(), force.data(), form.data());
        EXPECT_TRUE(form.allFinite());
        EXPECT_NEAR(form(0, 1), form(1, 0), 0);
        EXPECT_LT(form.norm(), 100);
    }
}

// Without weight it is the surface.
TEST(ImageManifold, WithoutWeightIsTheSurface) {
    const TorusSurface torus(1, 0.4);
    const ImageManifold image(torus, 0);
    std::vector<double> none;
    for (const Vec3& start : random_points(30, 1.5)) {
        Vec6 x;
        x << start, 5, 6, 7;
        ASSERT_TRUE(image.project(x.data(), none.data()));
        Vec3 right = start;
        ASSERT_TRUE(torus.project(right.data(), none.data()));
        EXPECT_EQ(Vec3(x.head<3>()), right);
        EXPECT_EQ(x.tail<3>().norm(), 0);
        Basis basis;
        image.tangent_basis(x.data(), none.data(), basis.data());
        Eigen::Matrix2d form, flat;
        Vec6 force;
        force << 0.3, 0.7, -0.2, 1, 1, 1;
        Eigen::Matrix<double, 3, 2> head = basis.topRows<3>();
        image.second_form(x.data(), none.data(), basis.data(), force.data(), form.data());
        torus.second_form(x.data(), none.data(), head.data(), force.data(), flat.data());
        EXPECT_LT((form - flat).norm(), 1e-5);
    }
}

TEST(ImageManifold, WhereTheSurfaceHasNoPointNeitherHasIt) {
    const SphereSurface sphere(1);
    const ImageManifold image(sphere, 1);
    std::vector<double> none;
    Vec6 x = Vec6::Zero();
    x[4] = 1;
    const Vec6 before = x;
    EXPECT_FALSE(image.project(x.data(), none.data()));
    EXPECT_EQ(x, before);
}

}  // namespace
}  // namespace flg::test
