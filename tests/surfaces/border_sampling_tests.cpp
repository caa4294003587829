// SPDX-License-Identifier: MIT
#include "surfaces/sampling/border_sampling.h"

#include <gtest/gtest.h>

#include "core/failure.h"
#include "runtime/run_now.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

SurfaceCurves sample(const Mesh& mesh, const std::vector<uint32_t>& labels, float spacing, bool haltingly = false,
                     uint32_t multiple = 1) {
    SurfaceCurves curves(test_memory());
    const RegionSet regions = labels.empty()
                                  ? RegionSet(test_memory())
                                  : RegionSet(labels.data(), static_cast<uint32_t>(labels.size()), test_memory());
    const auto find = [&](Pace& pace) { return find_region_loops(pace, mesh, regions); };
    const RegionLoops loops = run_now(test_memory(), find, haltingly);
    std::vector<BorderStretch> stretches(loops.count());
    for (uint32_t l = 0; l < loops.count(); ++l) stretches[l] = {.loop = l};
    run_now(
        test_memory(),
        [&](Pace& pace) { return sample_stretches(pace, mesh, loops, stretches, spacing, multiple, curves); },
        haltingly);
    return curves;
}

std::vector<Vec3> places(const Mesh& mesh, const SurfaceCurves& curves, uint32_t curve) {
    std::vector<Vec3> points;
    for (uint32_t i = curves.offsets[curve]; i < curves.offsets[curve + 1]; ++i) {
        points.push_back(position_of(mesh, curves.points[i]));
    }
    return points;
}

TEST(BorderSampling, StepsEvenlyAroundASquare) {
    const Mesh mesh = make_mesh(plane(7, 0.2));
    for (const auto& [spacing, count] :
         {std::pair{0.25f, 16u}, {0.1f, 40u}, {0.099f, 40u}, {0.01f, 400u}, {1.0f, 4u}, {4.0f, 3u}, {100.0f, 3u}}) {
        const SurfaceCurves curves = sample(mesh, {}, spacing);
        ASSERT_EQ(curves.curve_count(), 1u);
        EXPECT_TRUE(curves.closed[0]);
        EXPECT_NEAR(curves.values[0], 4, 1e-5);
        const std::vector<Vec3> points = places(mesh, curves, 0);
        ASSERT_EQ(points.size(), count);
        // Where along the square's outline, counter-clockwise from the origin.
        const auto along = [](const Vec3& p) {
            if (std::abs(p.y()) < 1e-6) return p.x();
            if (std::abs(p.x() - 1) < 1e-6) return 1 + p.y();
            if (std::abs(p.y() - 1) < 1e-6) return 3 - p.x();
            EXPECT_NEAR(p.x(), 0, 1e-6);
            return 4 - p.y();
        };
        for (uint32_t i = 0; i < count; ++i) {
            double step = along(points[(i + 1) % count]) - along(points[i]);
            if (step < 0) step += 4;
            EXPECT_NEAR(step, 4.0 / count, 1e-5) << "point " << i << " of " << count;
        }
    }
}

TEST(BorderSampling, PointsLieOnBorderEdgesOfTheRegion) {
    Mesh mesh = make_mesh(sphere(3));
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        double height = 0;
        for (uint32_t v : mesh.triangles[t]) height += mesh.position(v).z() / 3;
        mesh.regions[t] = height > 0.5 ? 9 : height > -0.5 ? 4 : 2;
    }
    const SurfaceCurves band = sample(mesh, {4}, 0.1f), cap = sample(mesh, {9}, 0.1f),
                        both = sample(mesh, {4, 9}, 0.1f);
    EXPECT_EQ(band.curve_count(), 2u);
    EXPECT_EQ(cap.curve_count(), 1u);
    EXPECT_EQ(both.curve_count(), 1u);
    EXPECT_EQ(sample(mesh, {}, 0.1f).curve_count(), 0u);
    EXPECT_EQ(sample(mesh, {77}, 0.1f).curve_count(), 0u);
    for (const SurfacePoint& p : band.points) {
        EXPECT_EQ(mesh.regions[p.triangle], 4u);
        // On an edge, or at a vertex, whose other triangle is not of the region.
        const float weights[3] = {1 - p.u - p.v, p.u, p.v};
        bool on_border = false;
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t across = mesh.neighbours[p.triangle][k];
            on_border |= weights[(k + 2) % 3] == 0 && mesh.regions[across] != 4;
        }
        EXPECT_TRUE(on_border);
    }
}

// To the nearest multiple; the outline is 4 m long.
TEST(BorderSampling, WholeLoopsGetAMultiple) {
    const Mesh mesh = make_mesh(plane(7, 0.2));
    for (const auto& [spacing, multiple, count] : {std::tuple{0.36f, 2u, 12u},
                                                   {0.31f, 2u, 12u},
                                                   {0.3f, 2u, 14u},
                                                   {0.3f, 3u, 12u},
                                                   {0.3f, 5u, 15u},
                                                   {2.0f, 2u, 4u},
                                                   {100.0f, 2u, 4u},
                                                   {100.0f, 3u, 3u},
                                                   {100.0f, 7u, 3u},
                                                   {0.3f, 20u, 20u},
                                                   {0.3f, 40u, 13u}}) {
        EXPECT_EQ(sample(mesh, {}, spacing, false, multiple).points.size(), count) << spacing << " " << multiple;
    }
}

// Two triangles of a fan that share only its vertex: two borders pass there, each around its own triangle.
TEST(BorderSampling, KeepsToItsOwnTrianglesWhereBordersTouch) {
    Soup soup{{{0, 0, 0}}, {}};
    for (uint32_t i = 0; i < 6; ++i) {
        const double turn = std::numbers::pi / 3 * i;
        soup.positions.push_back(to_position({std::cos(turn), std::sin(turn), 0}));
        soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % 6});
    }
    Mesh mesh = make_mesh(soup);
    mesh.regions[1] = mesh.regions[4] = 3;
    const SurfaceCurves curves = sample(mesh, {3}, 1);
    ASSERT_EQ(curves.curve_count(), 2u);
    for (uint32_t curve = 0; curve < 2; ++curve) {
        EXPECT_NEAR(curves.values[curve], 3, 1e-6);
        EXPECT_EQ(places(mesh, curves, curve).size(), 3u);
        for (uint32_t i = 0; i < 3; ++i) {
            EXPECT_EQ(curves.points[curves.offsets[curve] + i].triangle, curve == 0 ? 1u : 4u);
        }
    }
    const SurfaceCurves others = sample(mesh, {0}, 1);
    ASSERT_EQ(others.curve_count(), 2u);
    for (uint32_t curve = 0; curve < 2; ++curve) EXPECT_NEAR(others.values[curve], 4, 1e-6);
}

TEST(BorderSampling, DoesNotDependOnSlices) {
    const Mesh mesh = make_mesh(cylinder(11, 3));
    const SurfaceCurves whole = sample(mesh, {}, 0.3f), sliced = sample(mesh, {}, 0.3f, true);
    ASSERT_EQ(whole.curve_count(), 2u);
    EXPECT_EQ(whole.offsets, sliced.offsets);
    ASSERT_EQ(whole.points.size(), sliced.points.size());
    for (size_t i = 0; i < whole.points.size(); ++i) {
        EXPECT_EQ(whole.points[i].triangle, sliced.points[i].triangle);
        EXPECT_EQ(whole.points[i].u, sliced.points[i].u);
        EXPECT_EQ(whole.points[i].v, sliced.points[i].v);
    }
}

TEST(BorderSampling, TakesBordersWithoutLengthAndRefusesTooManyPoints) {
    const Mesh point = make_mesh({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}});
    const SurfaceCurves curves = sample(point, {}, 0.5f);
    ASSERT_EQ(curves.curve_count(), 1u);
    EXPECT_EQ(curves.points.size(), 3u);
    EXPECT_THROW(sample(make_mesh(plane(3)), {}, 1e-8f), Failure);
}

}  // namespace
}  // namespace flg::test
