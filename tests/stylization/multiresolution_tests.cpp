// SPDX-License-Identifier: MIT
// Several patch sizes at once (Minarcik, Fiser, Sykora, sec. 4.5.4).
#include <gtest/gtest.h>

#include "stylization/scene_inputs.h"

namespace flg {
namespace {

using test::Scene;

TEST(Multiresolution, IsTheLiteralWeightedSum) {
    test::expect_literal({{0, 300}, {{5, 1}, {20, 0.5f}}});
    test::expect_literal({{0, 300}, {{30, 2}, {2, 1}, {9, 0.25f}}});
    test::expect_literal({{0, 120, 200, 420}, {{4, 1}, {16, 1}}});
    test::expect_literal({{0, 300}, {{10, 3}}});
}

TEST(Multiresolution, WithAttributes) {
    test::expect_literal(Scene{{0, 150, 162, 300}, {{3, 1}, {12, 0.5f}}}.with_channel(0.3, 0).with_channel(0.2, M_PI));
}

TEST(Multiresolution, OneSizeOfWeightOneIsThePlainPatch) {
    const Scene scene{{0, 200, 500}, {{10, 1}}};
    const PatchGraph plain = test::graph_of(test::displacement_of(scene.vectors), scene.boundaries, 10);
    EXPECT_TRUE(test::same_bits(test::graph_of(scene), plain));
}

TEST(Multiresolution, NodesNeedTheLargestPatch) {
    const PatchGraph graph = test::graph_of(Scene{{0, 100}, {{5, 1}, {30, 1}}});
    EXPECT_EQ(graph.patch, 30u);
    ASSERT_EQ(graph.destinations.size(), 39u);
    EXPECT_EQ(graph.destinations[0], 31);
    EXPECT_EQ(graph.destinations[38], 69);
}

TEST(Multiresolution, DoesNotDependOnTheSlices) {
    const Scene scene = Scene{{0, 200, 500}, {{10, 1}, {4, 2}}}.with_channel(0.3, 2 * M_PI);
    const PatchGraph whole = test::graph_of(scene);
    EXPECT_TRUE(test::same_bits(test::graph_of(scene, true), whole));
}

}  // namespace
}  // namespace flg
