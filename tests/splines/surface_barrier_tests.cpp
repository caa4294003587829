// SPDX-License-Identifier: MIT
#include "splines/obstacles/surface_barrier.h"

#include "core/failure.h"
#include "splines/manifolds/implicit_surfaces.h"
#include "splines/obstacle_checks.h"
#include "splines/obstacles/mesh_distance.h"
#include "splines/obstacles/obstacle_mesh.h"
#include "splines/obstacles/obstacle_shapes.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

// The unit sphere with a cap cut off by a ball, and a bar across.
struct Scene {
    SphereSurface sphere{1};
    BallObstacle ball{3, std::array{1.0, 0.0, 0.2}.data(), 0.5};
    CapsuleObstacle bar{3, std::array{-0.8, -0.6, 0.6}.data(), std::array{-0.8, 0.6, 0.6}.data(), 0.2};
    const Obstacle* all[2] = {&ball, &bar};
    ObstacleSet set{all, 0.02, heap()};
};

void expect_on(const Scene& scene, double radius, const double* x) {
    double value, gradient[4];
    EXPECT_NEAR(std::hypot(x[0], x[1], x[2]), 1, 1e-12);
    value = BarrierSurface::evaluate(scene.set, radius, x, gradient, nullptr);
    EXPECT_NEAR(value, 0, 1e-12);
    EXPECT_GT(scene.set.distance(x), -1e-12);
}

TEST(SurfaceBarrier, ProjectedPointsAreOnTheSurfaceAndOutside) {
    const Scene scene;
    SurfaceBarrier barrier(scene.sphere, scene.set, 0.2);
    for (const double radius : {0.2, 0.02, 0.001}) {
        barrier.set_radius(radius);
        uint32_t inside = 0, failed = 0;
        for (uint64_t item = 0; item < 2000; ++item) {
            Numbers x = random_numbers(item);
            const double length = std::hypot(x[0], x[1], x[2]);
            for (uint32_t k = 0; k < 3; ++k) x[k] *= (1 + 0.1 * x[3]) / length;
            x[3] *= 0.05;
            inside += scene.set.distance(x.data()) < 0;
            if (!barrier.project(x.data(), nullptr)) {
                ++failed;
                continue;
            }
            expect_on(scene, radius, x.data());
        }
        EXPECT_GT(inside, 100u);
        EXPECT_LT(failed, inside / 10);  // where a solid's depth has no direction along the surface
    }
}

TEST(SurfaceBarrier, TheBasisIsTangent) {
    const Scene scene;
    const SurfaceBarrier barrier(scene.sphere, scene.set, 0.2);
    for (uint64_t item = 0; item < 300; ++item) {
        Numbers x = random_numbers(item);
        x[3] = 0;
        if (!barrier.project(x.data(), nullptr)) continue;
        double basis[8], gradient[4];
        barrier.tangent_basis(x.data(), nullptr, basis);
        BarrierSurface::evaluate(scene.set, 0.2, x.data(), gradient, nullptr);
        double products[3] = {};
        for (int a = 0; a < 2; ++a) {
            double radial = 0, along = 0;
            for (int k = 0; k < 4; ++k) {
                if (k < 3) radial += basis[4 * a + k] * x[static_cast<size_t>(k)];
                along += basis[4 * a + k] * gradient[k];
                products[a] += basis[4 * a + k] * basis[4 * a + k];
                if (a == 0) products[2] += basis[k] * basis[4 + k];
            }
            EXPECT_NEAR(radial, 0, 1e-10);
            EXPECT_NEAR(along, 0, 1e-10);
        }
        EXPECT_NEAR(products[0], 1, 1e-12);
        EXPECT_NEAR(products[1], 1, 1e-12);
        EXPECT_NEAR(products[2], 0, 1e-12);
    }
}

TEST(SurfaceBarrier, SecondFormIsThatOfProjections) {
    const Scene scene;
    const double radius = 0.25;
    const SurfaceBarrier barrier(scene.sphere, scene.set, radius);
    uint32_t blended = 0;
    for (uint64_t item = 0; item < 1000; ++item) {
        Numbers x = random_numbers(item);
        x[3] = 0.1;
        if (!barrier.project(x.data(), nullptr)) continue;
        const double away = scene.set.distance(x.data());
        if (std::abs(away - radius) < 3e-3 || away < 0.02) continue;
        double basis[8], form[4], generic[4];
        barrier.tangent_basis(x.data(), nullptr, basis);
        const Numbers force = random_numbers(item + 5000);
        barrier.second_form(x.data(), nullptr, basis, force.data(), form);
        barrier.Manifold::second_form(x.data(), nullptr, basis, force.data(), generic);
        double most = 1;
        for (const double f : form) most = std::max(most, std::abs(f));
        if (most > 30) continue;
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(form[i], generic[i], 1e-3 * most);
        blended += away < radius;
    }
    EXPECT_GT(blended, 30u);
}

TEST(SurfaceBarrier, LiftingIsOntoTheSurfaceAndUp) {
    const Scene scene;
    const SurfaceBarrier barrier(scene.sphere, scene.set, 0.2);
    const double free[3] = {0, 0, -2}, inside[3] = {1.1, 0.1, 0}, near[3] = {0.5, 0.8, 0.2};
    double x[4];
    EXPECT_TRUE(barrier.lift(free, nullptr, x));
    EXPECT_NEAR(x[2], -1, 1e-12);
    EXPECT_EQ(x[3], 0);
    EXPECT_FALSE(barrier.lift(inside, nullptr, x));
    expect_on(scene, 0.2, x);
    EXPECT_TRUE(barrier.lift(near, nullptr, x));
    expect_on(scene, 0.2, x);
}

// The plane that goes on around the unit square, which has a boundary: what is beyond it is left out.
TEST(SurfaceBarrier, StaysWithinAMeshsBoundary) {
    const Mesh mesh = make_mesh(plane(8));
    const SampledDistance distance =
        run_now(heap(), [&](Pace& pace) { return mesh_distance(pace, mesh, 0.3, 96, false); });
    const double epsilon = 0.1;
    const LayerObstacle layer(distance, epsilon);
    const Obstacle* one[] = {&layer};
    const ObstacleSet set(one, 0, heap());
    const PlaneSurface surface(1);
    SurfaceBarrier barrier(surface, set, 0.04);
    uint32_t beyond = 0;
    for (const double radius : {0.04, 0.001}) {
        barrier.set_radius(radius);
        for (uint64_t item = 0; item < 500; ++item) {
            Numbers x = random_numbers(item);
            for (uint32_t k = 0; k < 2; ++k) x[k] = 0.5 + 0.75 * x[k];
            x[2] = 0;
            x[3] = 0;
            const auto out = [&](uint32_t k) { return std::max({-x[k], x[k] - 1, 0.0}); };
            beyond += std::hypot(out(0), out(1)) > epsilon;
            ASSERT_TRUE(barrier.project(x.data(), nullptr));
            EXPECT_NEAR(x[2], 0, 1e-12);
            EXPECT_LT(std::hypot(out(0), out(1)), epsilon + 2e-3);
        }
    }
    EXPECT_GT(beyond, 100u);
}

TEST(SurfaceBarrier, OnlyInSpace) {
    const Scene scene;
    const double centre[2] = {0, 0};
    const BallObstacle disc(2, centre, 1);
    const Obstacle* one[] = {&disc};
    const ObstacleSet flat(one, 0, heap());
    EXPECT_THROW(SurfaceBarrier(scene.sphere, flat, 0.1), Failure);
    EXPECT_THROW(SurfaceBarrier(scene.sphere, scene.set, 0), Failure);
}

}  // namespace
}  // namespace flg::test
