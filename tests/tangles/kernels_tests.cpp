// SPDX-License-Identifier: MIT
// The kernels of operators by themselves: partitions, borders of cells, profiles, the tree.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "surfaces/test_meshes.h"
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
    std::vector<uint32_t> expected;
    for (uint32_t slice : {1000u, 1u, 7u}) {
        RegionPartitionKernel kernel(mesh, leaves, edges, test_memory());
        while (!kernel.run(slice)) {}
        EXPECT_EQ(kernel.components().size(), 5u) << "leaves 0 and 2 in two pieces each, leaf 1 whole";
        EXPECT_EQ(kernel.part_count(), 2u) << "left of the curve and right of it";
        std::vector<uint32_t> found;
        for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            ASSERT_EQ(kernel.is_within(t), mesh.regions[t] != 3);
            if (!kernel.is_within(t)) continue;
            found.push_back(kernel.component_of(t));
            const RegionComponent& component = kernel.components()[kernel.component_of(t)];
            EXPECT_EQ(component.label, mesh.regions[t]);
            EXPECT_EQ(component.part, centre(t).x() < 0.25 ? 0u : 1u);
        }
        if (expected.empty()) expected = found;
        EXPECT_EQ(found, expected) << "slices of " << slice;
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
    std::vector<float> expected;
    for (uint32_t slice : {1000u, 1u}) {
        SurfaceCurves curves(test_memory());
        VoronoiBordersKernel kernel(mesh, all, cells, curves, test_memory());
        while (!kernel.run(slice)) {}
        ASSERT_GT(curves.curve_count(), 20u);
        std::vector<float> found;
        for (const SurfacePoint& point : curves.points) {
            const Vec3 p = position_of(mesh, point);
            std::array<double, 3> distances;
            for (size_t i = 0; i < 3; ++i) distances[i] = (p - points[i]).norm();
            std::sort(distances.begin(), distances.end());
            // Distances are not linear along edges of 0.05: at most h^2 / 8 r off.
            EXPECT_LT(distances[1] - distances[0], 2e-3);
            found.insert(found.end(), {point.u, point.v});
        }
        if (expected.empty()) expected = found;
        EXPECT_EQ(found, expected);
    }
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
