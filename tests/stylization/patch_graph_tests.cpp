// SPDX-License-Identifier: MIT
#include "stylization/patch_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "reference/literal_shortest_path.h"
#include "stylization/style_inputs.h"

namespace flg {
namespace {

struct Case {
    std::vector<uint32_t> boundaries;
    uint32_t patch;

    std::vector<int> as_int() const { return {boundaries.begin(), boundaries.end()}; }
    std::vector<Vec3> vectors() const { return test::wiggles(static_cast<int>(boundaries.back())); }
};

// One curve, the shortest ones, several curves, one of which is too short for a patch.
const Case cases[] = {{{0, 300}, 1},  {{0, 300}, 10},           {{0, 300}, 100},        {{0, 16}, 7},
                      {{0, 16}, 1},   {{0, 120, 200, 420}, 10}, {{0, 9, 150, 300}, 10}, {{0, 150, 162, 300}, 10},
                      {{0, 600}, 299}};

void sort_edges(literal::Graph& graph) {
    for (auto& edges : graph) {
        std::sort(edges.begin(), edges.end(), [](auto& a, auto& b) { return a.target < b.target; });
    }
}

TEST(PatchMatrix, EqualTheLiteralSums) {
    for (const Case& c : cases) {
        const std::vector<Vec3> vectors = c.vectors();
        const Displacement displacement = test::displacement_of(vectors);
        const std::vector<double> expected =
            literal::patch_distances_sq(vectors, c.as_int(), static_cast<int>(c.patch));
        double largest = 0;
        for (double v : expected) {
            if (v < INFINITY) largest = std::max(largest, v);
        }
        const size_t n = vectors.size();
        std::vector<bool> seen(n, false);
        PatchMatrix rows({&displacement, c.boundaries, c.patch}, test::memory());
        run_haltingly(test::memory(), [&](Pace& pace) { return begin_matrix(pace, rows); });
        while (rows.next_row()) {
            while (!rows.make_part()) {}
            seen[rows.index()] = true;
            for (size_t k = 0; k < n; ++k) {
                const double v = expected[rows.index() * n + k];
                if (v < INFINITY) {
                    ASSERT_NEAR(rows.row()[k], v, 1e-9 * largest) << rows.index() << " " << k;
                } else {
                    ASSERT_EQ(rows.row()[k], v) << rows.index() << " " << k;
                }
            }
        }
        for (size_t i = 0; i < n; ++i) {
            const auto row = expected.begin() + static_cast<ptrdiff_t>(i * n);
            EXPECT_EQ(seen[i],
                      std::any_of(row, row + static_cast<ptrdiff_t>(n), [](double v) { return v < INFINITY; }));
        }
    }
}

TEST(PatchGraph, JumpsAreTheLiteralOnes) {
    for (const Case& c : cases) {
        const std::vector<Vec3> vectors = c.vectors();
        const Displacement displacement = test::displacement_of(vectors);
        literal::Graph expected =
            literal::sparse_jumps(literal::patch_distances_sq(vectors, c.as_int(), static_cast<int>(c.patch)),
                                  c.as_int(), static_cast<int>(c.patch), static_cast<int>(successors_kept));
        const PatchGraph graph = test::graph_of(displacement, c.boundaries, c.patch);
        literal::Graph jumps = test::jumps_of(graph);
        sort_edges(expected);
        sort_edges(jumps);
        uint32_t count = 0;
        std::vector<float> cheapest;
        for (size_t i = 0; i < expected.size(); ++i) {
            ASSERT_EQ(jumps[i].size(), expected[i].size()) << "node " << i << " p " << c.patch;
            for (size_t k = 0; k < expected[i].size(); ++k) {
                EXPECT_EQ(jumps[i][k].target, expected[i][k].target);
                EXPECT_NEAR(jumps[i][k].cost, expected[i][k].cost, 1e-5);
            }
            count += static_cast<uint32_t>(expected[i].size());
            if (expected[i].empty()) continue;
            cheapest.push_back(std::min_element(expected[i].begin(), expected[i].end(), [](auto& a, auto& b) {
                                   return a.cost < b.cost;
                               })->cost);
        }
        EXPECT_EQ(graph.jump_count(), count);
        EXPECT_EQ(graph.edge_count(), count + graph.node_count - graph.curve_count);
        std::sort(cheapest.begin(), cheapest.end());
        EXPECT_NEAR(graph.temperature_unit, 0.1 * cheapest[(cheapest.size() - 1) / 2], 1e-6);
    }
}

TEST(PatchGraph, EveryDestinationIsReachedFromEveryPatch) {
    for (const Case& c : cases) {
        const Displacement displacement = test::displacement_of(c.vectors());
        const PatchGraph graph = test::graph_of(displacement, c.boundaries, c.patch);
        const literal::Graph into = literal::reversed(test::edges_of(graph, 0.1f));
        size_t expected_destinations = 0;
        for (size_t b = 0; b + 1 < c.boundaries.size(); ++b) {
            const int patches = static_cast<int>(c.boundaries[b + 1] - c.boundaries[b]) - 2 * static_cast<int>(c.patch);
            expected_destinations += static_cast<size_t>(std::max(patches - 1, 0));
        }
        ASSERT_EQ(graph.destinations.size(), expected_destinations);
        for (size_t k = 0; k < graph.destinations.size(); k += 13) {
            const literal::PathTree tree = literal::shortest_paths(into, graph.destinations[k]);
            for (size_t b = 0; b + 1 < c.boundaries.size(); ++b) {
                if (c.boundaries[b + 1] - c.boundaries[b] < 2 * c.patch + 1) continue;
                for (uint32_t i = c.boundaries[b]; i + c.patch < c.boundaries[b + 1]; ++i) {
                    ASSERT_GE(tree.next_hop[i], 0) << i << " to " << graph.destinations[k];
                }
            }
        }
    }
}

TEST(PatchGraph, DoesNotDependOnTheSlices) {
    const Displacement displacement = test::displacement_of(test::wiggles(500));
    const PatchGraph whole = test::graph_of(displacement, {0, 200, 500}, 10);
    const PatchGraph sliced = test::graph_of(displacement, {0, 200, 500}, 10, true);
    EXPECT_TRUE(std::equal(whole.in_begin.begin(), whole.in_begin.end(), sliced.in_begin.begin()));
    ASSERT_EQ(whole.jump_count(), sliced.jump_count());
    EXPECT_TRUE(std::equal(whole.in_source.begin(), whole.in_source.end(), sliced.in_source.begin()));
    EXPECT_TRUE(std::equal(whole.in_cost.begin(), whole.in_cost.end(), sliced.in_cost.begin()));
    EXPECT_EQ(whole.temperature_unit, sliced.temperature_unit);
}

TEST(PatchGraph, MovingAllDisplacementsChangesNothing) {
    std::vector<Vec3> vectors = test::wiggles(300);
    const Displacement before = test::displacement_of(vectors);
    for (Vec3& v : vectors) v += Vec3(0.5, -0.25, 1);
    const Displacement after = test::displacement_of(vectors);
    EXPECT_NEAR(test::graph_of(before, 10).temperature_unit, test::graph_of(after, 10).temperature_unit, 1e-6);
}

TEST(PatchGraph, StylesWithoutDisplacementHaveFreeJumps) {
    const Displacement displacement = test::displacement_of(std::vector<Vec3>(100, Vec3(0, 0, 0)));
    const PatchGraph graph = test::graph_of(displacement, 10);
    EXPECT_EQ(graph.temperature_unit, 0);
    for (float cost : graph.in_cost) EXPECT_EQ(cost, 0);
}

TEST(Median, IsTheOneInTheMiddle) {
    std::vector<float> values;
    for (uint32_t count : {1u, 2u, 3u, 256u, 257u, 1000u}) {
        values.clear();
        for (uint32_t i = 0; i < count; ++i) {
            values.push_back(static_cast<float>(std::exp(20 * random_unit(count, i, 0) - 10)));
        }
        values[0] = 0;
        const float found = run_haltingly(test::memory(), [&](Pace& pace) { return median(pace, values); });
        std::sort(values.begin(), values.end());
        EXPECT_EQ(found, values[(count - 1) / 2]);
    }
}

}  // namespace
}  // namespace flg
