// SPDX-License-Identifier: MIT
// What operators are made of, by itself: partitions, borders of cells and of looks, profiles, the tree.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "runtime/run_now.h"
#include "surfaces/test_meshes.h"
#include "tangles/look_borders.h"
#include "tangles/region_partition.h"
#include "tangles/region_tree.h"
#include "tangles/tangle_displacement.h"
#include "tangles/voronoi_borders.h"

namespace flg::test {
namespace {

TEST(RegionPartition, ComponentsAndPartsOfAChequeredPlane) {
    // 8 x 8 cells in four quadrants; a curve of edges at x = 0.25.
    Mesh mesh = make_mesh(plane(8));
    const auto centre = [&](uint32_t t) {
        Vec3 sum = Vec3::Zero();
        for (uint32_t v : mesh.triangles[t]) sum += mesh.position(v) / 3;
        return sum;
    };
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        mesh.regions[t] = (centre(t).x() < 0.5 ? 0u : 1u) + (centre(t).y() < 0.5 ? 0u : 2u);
    }
    std::pmr::deque<Corner> edges(test_memory());
    for (Corner c = 0; c < 3 * mesh.triangle_count(); ++c) {
        const double a = mesh.position(mesh.vertex_at(c)).x(), b = mesh.position(mesh.vertex_at(next_corner(c))).x();
        if (std::abs(a - 0.25) < 1e-6 && std::abs(b - 0.25) < 1e-6) edges.push_back(c);
    }
    const uint32_t labels[] = {0, 1, 2};
    const RegionSet leaves(labels, 3, test_memory());
    const RegionPartition partition =
        run_now(test_memory(), [&](Pace& pace) { return partition_regions(pace, mesh, leaves, edges); });
    EXPECT_EQ(partition.components.size(), 5u) << "leaves 0 and 2 in two pieces each, leaf 1 whole";
    EXPECT_EQ(partition.part_count, 2u) << "left of the curve and right of it";
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        ASSERT_EQ(partition.is_within(t), mesh.regions[t] != 3);
        if (!partition.is_within(t)) continue;
        const RegionComponent& component = partition.components[partition.component_of(t)];
        EXPECT_EQ(component.label, mesh.regions[t]);
        EXPECT_EQ(component.part, centre(t).x() < 0.25 ? 0u : 1u);
    }
}

// Stripes of four labels, one of them outside; a curve of edges across them all.
TEST(RegionPartition, SameBitsWithPauses) {
    Mesh mesh = make_mesh(plane(100));
    std::pmr::deque<Corner> edges(test_memory());
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto x_of = [&](Corner c) { return mesh.position(mesh.vertex_at(c)).x(); };
        mesh.regions[t] = static_cast<uint32_t>(mesh.position(mesh.triangles[t][0]).y() * 7) % 4;
        for (Corner c = 3 * t; c < 3 * t + 3; ++c)
            if (std::abs(x_of(c) - 0.5) < 1e-6 && std::abs(x_of(next_corner(c)) - 0.5) < 1e-6) edges.push_back(c);
    }
    const uint32_t labels[] = {0, 1, 2};
    const RegionSet leaves(labels, 3, test_memory());
    const auto make = [&](Pace& pace) { return partition_regions(pace, mesh, leaves, edges); };
    const RegionPartition whole = run_now(test_memory(), make);
    uint32_t pauses = 0;
    const RegionPartition halting = run_haltingly(test_memory(), make, [&](const auto& slice) {
        ++pauses;
        slice();
    });
    EXPECT_GT(pauses, 50u);
    EXPECT_GT(whole.part_count, 2u);
    ASSERT_EQ(halting.components.size(), whole.components.size());
    for (size_t c = 0; c < whole.components.size(); ++c) {
        EXPECT_EQ(halting.components[c].label, whole.components[c].label);
        EXPECT_EQ(halting.components[c].part, whole.components[c].part);
        EXPECT_EQ(halting.components[c].first_triangle, whole.components[c].first_triangle);
    }
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        if (!whole.is_within(t)) continue;
        ASSERT_EQ(halting.component_of(t), whole.component_of(t));
    }
}

// Exact distances to points of the plane, with their cells.
DistanceField cells_of(const Mesh& mesh, const std::vector<Vec3>& points) {
    DistanceField field;
    field.distances = Buffer<float>(mesh.vertex_count(), test_memory());
    field.labels = Buffer<uint32_t>(mesh.vertex_count(), test_memory());
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        field.distances[v] = INFINITY;
        for (uint32_t i = 0; i < points.size(); ++i) {
            const auto distance = static_cast<float>((mesh.position(v) - points[i]).norm());
            if (distance >= field.distances[v]) continue;
            field.distances[v] = distance;
            field.labels[v] = i;
        }
    }
    return field;
}

TEST(VoronoiBorders, AreEquallyFarFromTheirPoints) {
    const Mesh mesh = make_mesh(plane(20, 0.3));
    const std::vector<Vec3> points = {{0.2, 0.3, 0}, {0.8, 0.2, 0}, {0.5, 0.75, 0}};
    const DistanceField cells = cells_of(mesh, points);
    const RegionSet all(test_memory());
    const SurfaceCurves curves =
        run_now(test_memory(), [&](Pace& pace) { return voronoi_borders(pace, mesh, all, cells); });
    ASSERT_GT(curves.curve_count(), 20u);
    for (const SurfacePoint& point : curves.points) {
        const Vec3 p = position_of(mesh, point);
        std::array<double, 3> distances;
        for (size_t i = 0; i < 3; ++i) distances[i] = (p - points[i]).norm();
        std::sort(distances.begin(), distances.end());
        // Distances are not linear along edges of 0.05: at most h^2 / 8 r off.
        EXPECT_LT(distances[1] - distances[0], 2e-3);
    }
}

void expect_same(const SurfaceCurves& a, const SurfaceCurves& b) {
    EXPECT_EQ(a.offsets, b.offsets);
    EXPECT_EQ(a.closed, b.closed);
    EXPECT_EQ(a.values, b.values);
    ASSERT_EQ(a.points.size(), b.points.size());
    for (size_t i = 0; i < a.points.size(); ++i) {
        EXPECT_EQ(a.points[i].triangle, b.points[i].triangle);
        EXPECT_EQ(a.points[i].u, b.points[i].u);
        EXPECT_EQ(a.points[i].v, b.points[i].v);
    }
}

TEST(VoronoiBorders, SameBitsWithPauses) {
    const Mesh mesh = make_mesh(plane(60, 0.3));
    const DistanceField cells = cells_of(mesh, {{0.2, 0.3, 0}, {0.8, 0.2, 0}, {0.5, 0.75, 0}, {0.1, 0.9, 0}});
    const RegionSet all(test_memory());
    const auto make = [&](Pace& pace) { return voronoi_borders(pace, mesh, all, cells); };
    expect_same(run_now(test_memory(), make), run_haltingly(test_memory(), make));
}

// Four quadrants of which two look the same, and a fifth region in the middle.
TEST(LookBorders, RunWhereLooksDifferSameBitsWithPauses) {
    Mesh mesh = make_mesh(plane(40));
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        Vec3 sum = Vec3::Zero();
        for (uint32_t v : mesh.triangles[t]) sum += mesh.position(v) / 3;
        const bool middle = std::abs(sum.x() - 0.25) < 0.1 && std::abs(sum.y() - 0.25) < 0.1;
        mesh.regions[t] = middle ? 5 : 1 + (sum.x() < 0.5 ? 0u : 1u) + (sum.y() < 0.5 ? 0u : 2u);
    }
    RegionTree tree(test_memory());
    TreeEdit edit(test_memory());
    tree.begin(edit);
    for (const uint32_t look : {1u, 2u, 3u, 3u, 4u}) tree.add_child(edit, 0, {.look = look});
    const auto make = [&](Pace& pace) { return look_borders(pace, mesh, tree); };
    const SurfaceCurves curves = run_now(test_memory(), make);
    ASSERT_EQ(curves.curve_count(), 4u) << "three chains from the middle to borders, and a loop";
    EXPECT_NEAR(curves.values[0], 0.5, 1e-6);
    EXPECT_NEAR(curves.values[1], 0.5, 1e-6);
    EXPECT_NEAR(curves.values[2], 0.5, 1e-6);
    EXPECT_TRUE(curves.closed[3]);
    expect_same(curves, run_haltingly(test_memory(), make));
}

TEST(Displacement, ProfilesAreSchlicks) {
    for (double value : {0.1, 0.35, 0.5, 0.9}) {
        EXPECT_NEAR(schlick_bias(0.5, value), value, 1e-12);
        EXPECT_NEAR(schlick_gain(0.5, value), 0.5, 1e-12);
        for (double end : {0.0, 1.0}) {
            EXPECT_NEAR(schlick_bias(end, value), end, 1e-12);
            EXPECT_NEAR(schlick_gain(end, value), end, 1e-12);
        }
        double last = 0;
        for (double t = 0.01; t <= 1; t += 0.01) {
            EXPECT_NEAR(schlick_gain(t, value) + schlick_gain(1 - t, value), 1, 1e-12) << "symmetric";
            EXPECT_GT(schlick_gain(schlick_bias(t, value), value), last);
            last = schlick_gain(schlick_bias(t, value), value);
        }
    }
    for (double t : {0.0, 0.2, 0.7, 1.0}) {
        EXPECT_NEAR(schlick_bias(t, 0.5), t, 1e-12);
        EXPECT_NEAR(schlick_gain(t, 0.5), t, 1e-12);
    }
}

TEST(RegionTree, LeavesOfJoinedRegionsAreMetUnderEachName) {
    RegionTree tree(test_memory());
    TreeEdit divide(test_memory()), join(test_memory()), again(test_memory());
    tree.begin(divide);
    for (uint32_t part = 0; part < 4; ++part) tree.add_child(divide, 0, {.part = part});
    tree.end(divide);
    const auto leaves = [&](RegionId region) {
        std::vector<RegionId> found;
        RegionTree::Leaves walk(tree, region, test_memory());
        for (RegionId leaf = walk.next(); leaf != no_region; leaf = walk.next()) found.push_back(leaf);
        return found;
    };
    EXPECT_EQ(leaves(0), (std::vector<RegionId>{1, 2, 3, 4}));
    const std::vector<RegionId> pair = {2, 4};
    tree.begin(join);
    tree.join(join, pair);
    tree.end(join);
    EXPECT_EQ(leaves(0), (std::vector<RegionId>{1, 2, 3, 2}));
    EXPECT_EQ(leaves(4), (std::vector<RegionId>{2}));
    tree.begin(again);
    tree.add_child(again, 2, {});
    tree.add_child(again, 2, {});
    tree.end(again);
    EXPECT_EQ(leaves(4), (std::vector<RegionId>{5, 6}));
    tree.take_back(again);
    tree.take_back(join);
    EXPECT_EQ(leaves(0), (std::vector<RegionId>{1, 2, 3, 4}));
    EXPECT_EQ(tree.size(), 5u);
    tree.make_again(join);
    tree.make_again(again);
    EXPECT_EQ(leaves(4), (std::vector<RegionId>{5, 6}));
}

}  // namespace
}  // namespace flg::test
