// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/perturbed_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "surfaces/geodesics.h"

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

// Word by word as the header has it, without anything kept.
double literal_noise(const Vec3& place, uint64_t seed) {
    const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double share = 1;
        std::array<double, 3> away;
        std::array<uint64_t, 3> cell;
        for (int axis = 0; axis < 3; ++axis) {
            const int upper = corner >> axis & 1;
            const double inside = place[axis] - std::floor(place[axis]), weight = fade(inside);
            share *= upper ? weight : 1 - weight;
            away[axis] = inside - upper;
            cell[axis] = static_cast<uint64_t>(static_cast<int64_t>(std::floor(place[axis])) + upper);
        }
        const auto choice =
            static_cast<uint32_t>(random_bits(seed, random_bits(seed, cell[0], cell[1]), cell[2]) >> 60);
        const double u = choice < 8 ? away[0] : away[1];
        const double v = choice < 4 ? away[1] : choice == 12 || choice == 14 ? away[0] : away[2];
        sum += share * (((choice & 1) != 0 ? -u : u) + ((choice & 2) != 0 ? -v : v));
    }
    return std::clamp(sum, -1.0, 1.0);
}

TEST(PerlinNoise, KeepsItsBitsWhateverItRemembers) {
    PerlinNoise noise(11);
    for (int i = 0; i < 20000; ++i) {
        // Sometimes in the cell before, sometimes elsewhere.
        const Vec3 place =
            i % 5 == 0 ? any_place(i) : Vec3(any_place(i / 5 * 5).array().floor() + random_unit(3, i, 0));
        EXPECT_EQ(noise(place), literal_noise(place, 11)) << i;
        EXPECT_EQ(perlin_noise(place, 11), literal_noise(place, 11));
    }
}

PerturbedMetric metric_of(const Mesh& mesh, const RegionSet& regions, Perturbation perturbation,
                          bool haltingly = false) {
    const Geodesics own(mesh);
    const std::pmr::deque<uint32_t> none;
    return run_now(
        test_memory(), [&](Pace& pace) { return perturb_metric(pace, mesh, own.blocks, regions, none, perturbation); },
        haltingly);
}

GrowingBuffer<Position> perturbed(const Mesh& mesh, float amount, float frequency, bool haltingly = false) {
    return std::move(metric_of(mesh, RegionSet(test_memory()), {amount, frequency, 5}, haltingly).positions);
}

// Distances from a region's border, within it.
std::vector<float> distances_within(const Mesh& mesh, const RegionSet& region, const PerturbedMetric& metric) {
    GeodesicSeeds border(mesh, metric.positions, region, test_memory(), &metric.blocks.flipped);
    run_now(test_memory(), [&](Pace& pace) { return add_border(pace, mesh, region, 0, border); });
    const GeodesicRegion bound = run_now(
        test_memory(), [&](Pace& pace) { return bound_region(pace, mesh, metric.positions, metric.blocks, region); });
    RefinedSolver solver(metric.blocks, test_memory());
    solve(solver, merged(border), {}, false, &bound);
    return read(solver);
}

// A part of a mesh, and of one of slivers, many of whose edges are flipped.
TEST(PerturbedMetric, HasTheSameBitsInARegionAsOnTheWhole) {
    for (const double stretch : {1.0, 12.0}) {
        Soup soup = torus(90, 40);
        for (Position& p : soup.positions) p[0] *= static_cast<float>(stretch);
        Mesh mesh = make_mesh(soup);
        for (uint32_t t = 0; t < mesh.triangle_count(); ++t)
            mesh.regions[t] =
                mesh.position(mesh.triangles[t][0]).x() + 0.3 * mesh.position(mesh.triangles[t][1]).y() > 0;
        const uint32_t label = 1;
        const RegionSet region(&label, 1, test_memory()), whole(test_memory());
        const Perturbation perturbation{0.1f, 3, 5};
        const PerturbedMetric local = metric_of(mesh, region, perturbation, true),
                              global = metric_of(mesh, whole, perturbation);
        EXPECT_LT(local.blocks.rank_count(), 0.7 * global.blocks.rank_count());
        for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            if (mesh.regions[t] != label) continue;
            for (const uint32_t v : mesh.triangles[t]) EXPECT_EQ(local.positions[v], global.positions[v]);
        }
        EXPECT_EQ(stretch > 1, !local.blocks.flipped.empty());
        const std::vector<float> near = distances_within(mesh, region, local),
                                 far = distances_within(mesh, region, global);
        EXPECT_GT(std::count_if(near.begin(), near.end(), [](float d) { return std::isfinite(d) && d > 0.3f; }), 100);
        if (stretch == 1) {
            EXPECT_EQ(near, far);
            continue;
        }
        // Beside the region's end edges are flipped anew in two ways; both are the region's own.
        double sum = 0;
        uint32_t count = 0;
        for (uint32_t v = 0; v < near.size(); ++v) {
            EXPECT_EQ(std::isfinite(near[v]), std::isfinite(far[v]));
            if (!std::isfinite(far[v]) || far[v] == 0) continue;
            sum += std::pow(near[v] / far[v] - 1, 2);
            ++count;
        }
        EXPECT_LT(std::sqrt(sum / count), 0.01);
    }
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
