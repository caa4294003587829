// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/distance_field.h"

#include <gtest/gtest.h>

#include "reference/literal_geodesics.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

TEST(FieldBlend, IsTheShareOfTheWay) {
    EXPECT_EQ(blend(0, 2), 0.0f);
    EXPECT_EQ(blend(2, 0), 1.0f);
    EXPECT_EQ(blend(1, 3), 0.25f);
    EXPECT_EQ(blend(3e38f, 3e38f), 0.5f);
}

TEST(FieldBlend, HasAValueWhereTheQuotientHasNone) {
    EXPECT_EQ(blend(0, 0), 0.5f);
    EXPECT_EQ(blend(unreachable, unreachable), unreachable);
    EXPECT_EQ(blend(unreachable, 5), 1.0f);
    EXPECT_EQ(blend(5, unreachable), 0.0f);
    EXPECT_EQ(blend(-1, 1), 0.0f);
    EXPECT_EQ(blend(-1, -1), 0.5f);
}

// On a strip between two of its borders the blend is the height, whatever the graph's error.
TEST(FieldBlend, IsLinearAcrossAStrip) {
    constexpr uint32_t around = 40, up = 10;
    const Mesh mesh = make_mesh(cylinder(around, up));
    const literal::GeodesicGraph graph = literal::geodesic_graph(mesh);
    std::vector<Seed> low, high;
    for (uint32_t i = 0; i < around; ++i) {
        low.push_back({i, 0, 0});
        high.push_back({up * around + i, 0, 0});
    }
    const std::vector<float> from = literal::GraphField(graph, low).distances;
    const std::vector<float> to = literal::GraphField(graph, high).distances;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_NEAR(blend(from[v], to[v]), 0.5 * mesh.position(v).z(), 1e-6);
    }
}

}  // namespace
}  // namespace flg::test
