// SPDX-License-Identifier: MIT
#include "stylization/path_tree.h"

#include <gtest/gtest.h>

#include "reference/literal_shortest_path.h"
#include "stylization/path_trees.h"
#include "stylization/style_inputs.h"

namespace flg {
namespace {

struct Tree {
    std::vector<uint16_t> hops;
    std::vector<float> distances;
};

Tree tree_of(const PatchGraph& graph, float temperature, uint32_t destination, uint32_t slice = 1u << 30) {
    Tree tree;
    tree.hops.resize(graph.node_count);
    PathTreeKernel kernel(test::memory());
    kernel.begin(graph, temperature, destination, tree.hops.data());
    for (;;) {
        uint32_t units = slice;
        if (kernel.run(units)) break;
        EXPECT_EQ(units, 0u);
    }
    tree.distances.assign(kernel.distances(), kernel.distances() + graph.node_count);
    return tree;
}

void expect_literal(const PatchGraph& graph, float temperature, uint32_t step) {
    const literal::Graph into = literal::reversed(test::edges_of(graph, temperature));
    for (uint32_t k = 0; k < graph.destinations.size(); k += step) {
        const uint32_t destination = graph.destinations[k];
        const Tree fast = tree_of(graph, temperature, destination);
        const literal::PathTree slow = literal::shortest_paths(into, static_cast<int>(destination));
        for (uint32_t i = 0; i < graph.node_count; ++i) {
            ASSERT_EQ(fast.distances[i], slow.distance[i]) << i << " to " << destination;
            ASSERT_EQ(fast.hops[i], slow.next_hop[i] < 0 ? no_hop : slow.next_hop[i]) << i << " to " << destination;
        }
    }
}

TEST(PathTree, CostsAndHopsAreTheLiteralDijkstras) {
    const Displacement displacement = test::displacement_of(test::wiggles(400));
    for (const std::vector<uint32_t>& boundaries : {std::vector<uint32_t>{0, 400}, {0, 130, 142, 400}}) {
        const PatchGraph graph = test::graph_of(displacement, boundaries, 10);
        for (float tau : {0.0f, 0.1f, 0.5f, 2.0f, 100.0f}) expect_literal(graph, tau * graph.temperature_unit, 37);
    }
}

TEST(PathTree, TiesAreResolvedAsInTheLiteralDijkstra) {
    // Displacements that repeat exactly, and none at all: nothing but ties.
    std::vector<Vec3> repeating;
    for (int i = 0; i < 200; ++i) repeating.emplace_back((i % 8) * 0.25, ((i / 2) % 4) * 0.5, 0);
    for (const auto& vectors : {repeating, std::vector<Vec3>(200, Vec3(1, 1, 1))}) {
        const Displacement displacement = test::displacement_of(vectors);
        const PatchGraph graph = test::graph_of(displacement, 5);
        for (float temperature : {0.0f, -0.0f, 0.25f}) expect_literal(graph, temperature, 17);
    }
}

TEST(PathTree, HopsLeadToTheDestinationAtTheStatedCost) {
    const Displacement displacement = test::displacement_of(test::wiggles(600));
    const PatchGraph graph = test::graph_of(displacement, 10);
    const float temperature = 0.3f * graph.temperature_unit;
    const literal::Graph edges = test::edges_of(graph, temperature);
    const Tree tree = tree_of(graph, temperature, 300);
    for (uint32_t start = 0; start + 10 < 600; start += 7) {
        double cost = 0;
        uint32_t node = start;
        for (int hops = 0; node != 300 && hops < 1000; ++hops) {
            const uint32_t next = tree.hops[node];
            float cheapest = INFINITY;
            for (const literal::Edge& edge : edges[node]) {
                if (edge.target == static_cast<int>(next)) cheapest = std::min(cheapest, edge.cost);
            }
            cost += cheapest;
            node = next;
        }
        EXPECT_EQ(node, 300u);
        EXPECT_NEAR(cost, tree.distances[start], 1e-3);
    }
    for (uint32_t i = 590; i < 600; ++i) EXPECT_EQ(tree.hops[i], no_hop);
}

TEST(PathTree, DoesNotDependOnTheSlices) {
    const Displacement displacement = test::displacement_of(test::wiggles(600));
    const PatchGraph graph = test::graph_of(displacement, 10);
    const Tree whole = tree_of(graph, 0.01f, 77);
    for (uint32_t slice : {1u, 7u, 256u}) {
        const Tree sliced = tree_of(graph, 0.01f, 77, slice);
        EXPECT_EQ(sliced.hops, whole.hops);
        EXPECT_EQ(sliced.distances, whole.distances);
    }
}

TEST(PathTree, KernelsAreUsedAgain) {
    const Displacement displacement = test::displacement_of(test::wiggles(600));
    const PatchGraph large = test::graph_of(displacement, 10);
    const Displacement few = test::displacement_of(test::wiggles(50));
    const PatchGraph small = test::graph_of(few, 3);
    PathTreeKernel kernel(test::memory());
    for (const PatchGraph* graph : {&small, &large, &small}) {
        std::vector<uint16_t> hops(graph->node_count);
        kernel.begin(*graph, 0.02f, graph->destinations[5], hops.data());
        uint32_t units = 1u << 30;
        ASSERT_TRUE(kernel.run(units));
        EXPECT_EQ(hops, tree_of(*graph, 0.02f, graph->destinations[5]).hops);
    }
}

TEST(PathTrees, DestinationsRiseFromFirstToLast) {
    for (int count : {22, 23, 60, 276, 277, 2000}) {
        const Displacement displacement = test::displacement_of(test::wiggles(count));
        const PatchGraph graph = test::graph_of(displacement, 10);
        const PathTrees trees(graph, 0, test::memory());
        const auto all = static_cast<uint32_t>(count) - 21;
        ASSERT_EQ(trees.destination_count(), std::min(all, PathTrees::destinations_max));
        if (trees.destination_count() > 1) {
            EXPECT_EQ(trees.destination(0), 11u);
        }
        EXPECT_EQ(trees.destination(trees.destination_count() - 1), static_cast<uint32_t>(count) - 11);
        for (uint32_t k = 1; k < trees.destination_count(); ++k) {
            EXPECT_LT(trees.destination(k - 1), trees.destination(k));
        }
    }
}

TEST(PathTrees, KeepTheFirstTreeAndFreeTheRest) {
    const Displacement displacement = test::displacement_of(test::wiggles(60));
    const PatchGraph graph = test::graph_of(displacement, 10);
    PathTrees trees(graph, 0, test::memory());
    EXPECT_EQ(trees.find(3), nullptr);
    uint16_t* first = trees.allocate();
    uint16_t* second = trees.allocate();
    EXPECT_EQ(trees.publish(3, first), first);
    EXPECT_EQ(trees.publish(3, second), first);
    EXPECT_EQ(trees.find(3), first);
    EXPECT_EQ(trees.find(2), nullptr);
}

}  // namespace
}  // namespace flg
