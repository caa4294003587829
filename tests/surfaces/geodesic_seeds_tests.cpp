// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/geodesic_seeds.h"

#include <gtest/gtest.h>

#include "surfaces/geodesics.h"

namespace flg::test {
namespace {

struct Plane {
    explicit Plane(uint32_t cells, double jitter = 0)
        : mesh(make_mesh(plane(cells, jitter))),
          everywhere(test_memory()),
          seeds(mesh, mesh.positions, everywhere, test_memory()) {}

    Mesh mesh;
    RegionSet everywhere;
    GeodesicSeeds seeds;
};

TEST(GeodesicSeeds, OfAPointAreStraightDistances) {
    Plane at(10, 0.3);
    for (uint32_t i = 0; i < 50; ++i) {
        GeodesicSeeds seeds(at.mesh, at.mesh.positions, at.everywhere, test_memory());
        const float u = static_cast<float>(random_unit(1, i, 0)),
                    v = static_cast<float>(random_unit(1, i, 1)) * (1 - u);
        const SurfacePoint point{random_below(1, i, 2, at.mesh.triangle_count()), u, v};
        seeds.add_point(point, 4);
        const auto found = merged(seeds, true);
        EXPECT_GE(found.size(), 3u);
        for (const Seed& seed : found) {
            EXPECT_NEAR(seed.distance, (at.mesh.position(seed.vertex) - position_of(at.mesh, point)).norm(), 1e-6);
            EXPECT_EQ(seed.label, 4u);
            EXPECT_FALSE(seed.straight);
        }
    }
}

TEST(GeodesicSeeds, OfAPointLeadToItsDistances) {
    Plane at(60, 0.3);
    const SurfacePoint point{3333, 0.2f, 0.5f};
    at.seeds.add_point(point, 0);
    const auto distances = Geodesics(at.mesh).distances(merged(at.seeds));
    const auto expected = [&](uint32_t v) { return (at.mesh.position(v) - position_of(at.mesh, point)).norm(); };
    EXPECT_LT(rms_error(distances, expected), 0.0005);
}

// The front from a line is straight: exact but where no triangle lets the upright way through.
TEST(GeodesicSeeds, OfABorderLeadToParallels) {
    Plane at(40, 0.3);
    for (Corner corner = 0; corner < 3 * at.mesh.triangle_count(); ++corner) {
        const Vec3 a = at.mesh.position(at.mesh.vertex_at(corner));
        const Vec3 b = at.mesh.position(at.mesh.vertex_at(next_corner(corner)));
        if (a.y() == 0 && b.y() == 0) at.seeds.add_edge(corner, 0);
    }
    const auto distances = Geodesics(at.mesh).distances(merged(at.seeds));
    for (uint32_t v = 0; v < distances.size(); ++v) EXPECT_NEAR(distances[v], at.mesh.position(v).y(), 0.1 / 40);
}

TEST(GeodesicSeeds, OfACurveAreDistancesFromItsSegments) {
    Plane at(20);
    // From the middle of the left side to that of the right, along a row of cells: each has its diagonal.
    SurfaceCurves curves(test_memory());
    for (uint32_t cell = 0; cell < 20; ++cell) {
        const uint32_t lower = 2 * (10 * 20 + cell);
        // At half a cell's height: on the left edge of the upper triangle, then on its diagonal.
        curves.points.push_back({lower + 1, 0, 0.5f});
        curves.points.push_back({lower, 0, 0.5f});
    }
    curves.points.push_back({2 * (10 * 20 + 19), 0.5f, 0.5f});
    curves.offsets.push_back(static_cast<uint32_t>(curves.points.size()));
    curves.closed.push_back(false);
    run_haltingly(test_memory(), [&](Pace& pace) { return add_curve(pace, curves, 0, 0, at.seeds); });
    const auto found = merged(at.seeds);
    EXPECT_GE(found.size(), 42u);
    // Exact at the triangles that the curve crosses; across one edge more only what the nearest segment tells.
    for (const Seed& seed : found) {
        const double expected = std::abs(at.mesh.position(seed.vertex).y() - 0.525);
        EXPECT_GE(seed.distance, expected - 1e-6);
        EXPECT_LE(seed.distance, expected < 0.026 ? expected + 1e-6 : expected * 1.1);
        EXPECT_TRUE(seed.straight || at.mesh.position(seed.vertex).x() < 1e-6 ||
                    at.mesh.position(seed.vertex).x() > 0.9999);
    }
    const auto distances = Geodesics(at.mesh).distances(found);
    for (uint32_t v = 0; v < distances.size(); ++v) {
        EXPECT_NEAR(distances[v], std::abs(at.mesh.position(v).y() - 0.525), 0.1 / 20);
    }
}

TEST(GeodesicSeeds, OfBordersLieOnThem) {
    Plane at(20);
    for (uint32_t t = 0; t < at.mesh.triangle_count(); ++t) at.mesh.regions[t] = t % 40 < 20 ? 3 : 5;
    const uint32_t left[] = {3};
    const RegionSet regions(left, 1, test_memory());
    run_haltingly(test_memory(), [&](Pace& pace) { return add_border(pace, at.mesh, regions, 1, at.seeds); });
    const auto found = merged(at.seeds);
    uint32_t on_border = 0;
    for (const Seed& seed : found) {
        const Vec3 p = at.mesh.position(seed.vertex);
        const double expected =
            std::min({p.x(), std::abs(p.x() - 0.5), p.x() < 0.51 ? std::min(p.y(), 1 - p.y()) : 1.0});
        EXPECT_NEAR(seed.distance, expected, 1e-6);
        on_border += seed.distance == 0;
    }
    EXPECT_EQ(on_border, 60u);

    // Kept to the other regions, the outer border has no part in it.
    const uint32_t right[] = {5};
    const RegionSet within(right, 1, test_memory());
    GeodesicSeeds inside(at.mesh, at.mesh.positions, within, test_memory());
    run_haltingly(test_memory(), [&](Pace& pace) { return add_border(pace, at.mesh, regions, 1, inside); });
    for (const Seed& seed : merged(inside)) EXPECT_GE(at.mesh.position(seed.vertex).x(), 0.4999);
}

TEST(GeodesicSeeds, KeepTheNearestOfAVertexSorted) {
    Plane at(4);
    std::pmr::deque<Seed> found(test_memory());
    for (const Seed& seed :
         {Seed{70000, 1, 0}, {3, 2, 0}, {70000, 0.5f, 1}, {3, 2, 1}, {300, 0, 2}, {70000, 0.7f, 2}}) {
        found.push_back(seed);
    }
    const auto seeds = merged(found, true);
    ASSERT_EQ(seeds.size(), 3u);
    EXPECT_EQ(seeds[0].vertex, 3u);
    EXPECT_EQ(seeds[0].label, 0u);
    EXPECT_EQ(seeds[1].vertex, 300u);
    EXPECT_EQ(seeds[2].vertex, 70000u);
    EXPECT_EQ(seeds[2].distance, 0.5f);

    EXPECT_TRUE(merged(at.seeds).empty());
}

}  // namespace
}  // namespace flg::test
