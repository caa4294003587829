// SPDX-License-Identifier: MIT
#include "surfaces/tracing/surface_walk.h"

#include <gtest/gtest.h>

#include "runtime/run_now.h"
#include "surfaces/curve_checks.h"
#include "surfaces/mesh/nearest_points.h"
#include "surfaces/tracing/geodesic_path.h"

namespace flg::test {
namespace {

SurfacePoint nearest_to(const Mesh& mesh, const Vec3& place) {
    NearestPoints nearest(mesh);
    run_now(test_memory(), [&](Pace& pace) { return build(pace, nearest); });
    nearest.begin(to_position(place));
    while (!nearest.find(10'000)) {}
    return nearest.found();
}

struct Walk {
    SurfaceCurves curves{test_memory()};
    bool found = false;
    double length = 0;
};

void walk_on(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to, Walk& walk, bool haltingly = false) {
    const SurfaceWalk found = run_now(
        test_memory(), [&](Pace& pace) { return add_surface_walk(pace, mesh, from, to, walk.curves); }, haltingly);
    walk.found = found.found;
    walk.length += found.length;
}

// As a curve that is complete.
Walk walk_between(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to, bool haltingly = false) {
    Walk walk;
    walk_on(mesh, from, to, walk, haltingly);
    if (walk.found) end_polyline(walk.curves, false, walk.length);
    return walk;
}

Vec3 random_place(uint64_t seed, uint32_t which) {
    return {random_unit(seed, which, 0), random_unit(seed, which, 1), 0};
}

TEST(SurfaceWalk, StraightInThePlane) {
    for (double jitter : {0.0, 0.15}) {
        const Mesh mesh = make_mesh(plane(20, jitter));
        for (uint64_t seed = 0; seed < 200; ++seed) {
            const SurfacePoint from = nearest_to(mesh, random_place(seed, 0)),
                               to = nearest_to(mesh, random_place(seed, 1));
            const Vec3 a = position_of(mesh, from), b = position_of(mesh, to);
            const Walk walk = walk_between(mesh, from, to);
            ASSERT_TRUE(walk.found) << seed;
            expect_valid(mesh, walk.curves);
            ASSERT_EQ(walk.curves.curve_count(), 1u);
            EXPECT_NEAR(walk.length, (b - a).norm(), 1e-6);
            EXPECT_NEAR(length_of(mesh, walk.curves, 0), (b - a).norm(), 1e-6);
            for (const SurfacePoint& point : walk.curves.points) {
                const Vec3 p = position_of(mesh, point);
                EXPECT_LT((p - a).cross(b - a).norm(), 1e-6 * (b - a).norm());
            }
        }
    }
}

// Lattice points: ways along edges, and through the vertices of others' diagonals.
TEST(SurfaceWalk, ThroughVerticesAndAlongEdges) {
    const Mesh mesh = make_mesh(plane(8));
    for (uint64_t seed = 0; seed < 300; ++seed) {
        const auto lattice = [&](uint32_t which) {
            return Vec3(random_below(seed, which, 0, 17) / 16.0, random_below(seed, which, 1, 17) / 16.0, 0);
        };
        const Vec3 a = lattice(0), b = lattice(1);
        const Walk walk = walk_between(mesh, nearest_to(mesh, a), nearest_to(mesh, b));
        ASSERT_TRUE(walk.found) << seed;
        EXPECT_NEAR(walk.length, (b - a).norm(), 1e-6) << seed;
        expect_valid(mesh, walk.curves);
        EXPECT_EQ(walk.curves.curve_count(), a == b ? 0u : 1u);
    }
}

TEST(SurfaceWalk, FollowsGreatCircles) {
    const Mesh mesh = make_mesh(sphere(4));
    for (uint64_t seed = 0; seed < 100; ++seed) {
        const auto direction = [&](uint32_t which) {
            Vec3 d;
            for (uint32_t k = 0; k < 3; ++k) d[k] = random_unit(seed, which, k) - 0.5;
            return Vec3(d.normalized());
        };
        const Vec3 a = direction(0), b = direction(1);
        if (a.dot(b) < -0.5) continue;  // the farther apart, the less sure the plane is
        const SurfacePoint from = nearest_to(mesh, a), to = nearest_to(mesh, b);
        const Walk walk = walk_between(mesh, from, to);
        ASSERT_TRUE(walk.found) << seed;
        expect_valid(mesh, walk.curves);
        // Chords of edges of 0.07 are so much shorter than arcs.
        EXPECT_NEAR(walk.length, std::acos(a.dot(b)), 1e-3 * walk.length);
        const Vec3 across = a.cross(b).normalized();
        for (const SurfacePoint& point : walk.curves.points) {
            EXPECT_LT(std::abs(position_of(mesh, point).dot(across)), 2e-3);
        }
    }
}

TEST(SurfaceWalk, SameBitsInSlices) {
    const Mesh mesh = make_mesh(sphere(4));
    const SurfacePoint from = nearest_to(mesh, {1, 0.1, 0.2}), to = nearest_to(mesh, {-0.3, 1, -0.5});
    const Walk whole = walk_between(mesh, from, to), sliced = walk_between(mesh, from, to, true);
    ASSERT_TRUE(whole.found);
    EXPECT_GT(whole.curves.points.size(), 20u);
    expect_same(whole.curves, sliced.curves);
}

TEST(SurfaceWalk, LeavesTheCurveAsItWasAtBorders) {
    // A square with a hole in its middle.
    Soup soup = plane(20);
    std::erase_if(soup.triangles, [&](const Triple& t) {
        const Vec3 p = load_vec3(soup.positions[t[0]].data());
        return std::abs(p.x() - 0.5) < 0.2 && std::abs(p.y() - 0.5) < 0.2;
    });
    std::vector<uint32_t> number(soup.positions.size(), no_index);
    Soup holed;
    for (Triple t : soup.triangles) {
        for (uint32_t& v : t) {
            if (number[v] == no_index) {
                number[v] = static_cast<uint32_t>(holed.positions.size());
                holed.positions.push_back(soup.positions[v]);
            }
            v = number[v];
        }
        holed.triangles.push_back(t);
    }
    const Mesh mesh = make_mesh(holed);
    Walk walk;
    const SurfacePoint first = nearest_to(mesh, {0.05, 0.3, 0}), left = nearest_to(mesh, {0.1, 0.52, 0}),
                       right = nearest_to(mesh, {0.9, 0.48, 0});
    walk_on(mesh, first, left, walk);
    ASSERT_TRUE(walk.found);
    const std::vector<SurfacePoint> before(walk.curves.points.begin(), walk.curves.points.end());
    walk_on(mesh, left, right, walk);
    EXPECT_FALSE(walk.found);
    ASSERT_EQ(walk.curves.points.size(), before.size());
    EXPECT_EQ(walk.curves.points.back().triangle, before.back().triangle);
    EXPECT_EQ(walk.curves.points.back().u, before.back().u);
}

// A valley: straight over it is near, down and up again is far.
TEST(SurfaceWalk, GivesUpLongWays) {
    const Mesh mesh =
        make_mesh(grid(200, 4, [](double u, double v) { return Vec3(0.2 * u - 0.1, v, 4 * (u - 0.5) * (u - 0.5)); }));
    const auto across = [&](double x) {
        const double z = 100 * x * x;
        return walk_between(mesh, nearest_to(mesh, {-x, 0.5, z}), nearest_to(mesh, {x, 0.5, z}));
    };
    EXPECT_FALSE(across(0.08).found);
    const Walk walk = across(0.01);
    ASSERT_TRUE(walk.found);
    expect_valid(mesh, walk.curves);
    // The arc of z = 100 x^2 from -0.01 to 0.01.
    EXPECT_NEAR(walk.length, (2 * std::sqrt(5) + std::asinh(2)) / 200, 1e-4);
}

TEST(SurfaceWalk, TakesDegenerateTriangles) {
    Soup soup = plane(10);
    // A column of triangles without area.
    for (Position& p : soup.positions) {
        if (p[0] > 0.45f && p[0] < 0.65f) p[0] = 0.5f;
    }
    const Mesh mesh = make_mesh(soup);
    for (uint64_t seed = 0; seed < 100; ++seed) {
        const SurfacePoint from = nearest_to(mesh, random_place(seed, 0)), to = nearest_to(mesh, random_place(seed, 1));
        const Walk walk = walk_between(mesh, from, to);
        if (!walk.found) continue;
        expect_valid(mesh, walk.curves);
        EXPECT_NEAR(walk.length, (position_of(mesh, to) - position_of(mesh, from)).norm(), 1e-4);
    }
}

}  // namespace
}  // namespace flg::test
