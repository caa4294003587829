// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/perturbed_metric.h"

#include <gtest/gtest.h>

#include "runtime/run_now.h"
#include "surfaces/mesh/mesh_measures.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

Vec3 any_place(uint64_t i) {
    return 40 * Vec3(random_unit(2, i, 0) - 0.5, random_unit(2, i, 1) - 0.5, random_unit(2, i, 2) - 0.5);
}

TEST(PerlinNoise, IsZeroAtTheLatticeAndBounded) {
    double most = 0, sum = 0;
    constexpr int samples = 20000;
    for (int i = 0; i < samples; ++i) {
        const Vec3 place = any_place(i);
        EXPECT_EQ(perlin_noise(place.array().floor().matrix(), 7), 0.0);
        const double noise = perlin_noise(place, 7);
        EXPECT_LE(std::abs(noise), 1.0);
        most = std::max(most, std::abs(noise));
        sum += noise;
    }
    EXPECT_GT(most, 0.6);
    EXPECT_NEAR(sum / samples, 0, 0.01);
}

// Its slope is that of the gradients at most: two components of length 1, blended with weights of slope 15/8 at most.
TEST(PerlinNoise, IsSmooth) {
    constexpr double step = 1e-4;
    for (int i = 0; i < 5000; ++i) {
        // Across a face of the cells, where other gradients take over: value and slope go on.
        Vec3 place = any_place(i);
        place[i % 3] = std::floor(place[i % 3]);
        const Vec3 aside = step * Vec3::Unit(i % 3);
        const double before = perlin_noise(place - aside, 3), at = perlin_noise(place, 3),
                     after = perlin_noise(place + aside, 3);
        EXPECT_NEAR(after - at, at - before, 100 * step * step);
        EXPECT_LT(std::abs(after - at), 10 * step);
    }
}

TEST(PerlinNoise, DependsOnItsSeedAndTakesAnyPlace) {
    int same = 0;
    for (int i = 0; i < 100; ++i) same += perlin_noise(any_place(i), 1) == perlin_noise(any_place(i), 2);
    EXPECT_LT(same, 3);
    for (double far : {1e20, -1e20, 1e300, 3e9, -3e9}) {
        EXPECT_LE(std::abs(perlin_noise({far, 0.5, far / 3}, 1)), 1.0);
    }
}

GrowingBuffer<Position> perturbed(const Mesh& mesh, float amount, float frequency, bool haltingly = false) {
    const Buffer<Position> normals =
        run_now(test_memory(), [&](Pace& pace) { return find_vertex_normals(pace, mesh); });
    return run_now(
        test_memory(),
        [&](Pace& pace) {
            return perturb_positions(pace, mesh, normals, {amount, frequency, 5});
        },
        haltingly);
}

TEST(PerturbedMetric, MovesVerticesAlongTheirNormals) {
    const Mesh mesh = make_mesh(sphere(3));
    const GrowingBuffer<Position> positions = perturbed(mesh, 0.2f, 3.7f), sliced = perturbed(mesh, 0.2f, 3.7f, true);
    double most = 0;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const Vec3 moved = load_vec3(positions[v].data());
        EXPECT_NEAR(moved.normalized().dot(mesh.position(v)), 1, 1e-3);
        EXPECT_LE(std::abs(moved.norm() - 1), 0.2 + 1e-6);
        most = std::max(most, std::abs(moved.norm() - 1));
        EXPECT_EQ(positions[v], sliced[v]);
    }
    EXPECT_GT(most, 0.05);
}

TEST(PerturbedMetric, LeavesTheMeshAsItIsAndItsPositionsFinite) {
    const Soup soup = torus(12, 8);
    const Mesh mesh = make_mesh(soup);
    const GrowingBuffer<Position> same = perturbed(mesh, 0, 1);
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_EQ(same[v], soup.positions[v]);
        EXPECT_EQ(mesh.positions[v], soup.positions[v]);
    }
    for (const Position& p : perturbed(mesh, 3.4e38f, 3e38f)) {
        for (float x : p) EXPECT_TRUE(std::isfinite(x));
    }
}

}  // namespace
}  // namespace flg::test
