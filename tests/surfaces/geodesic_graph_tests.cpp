// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_graph.h"

#include <gtest/gtest.h>

#include "surfaces/graph_checks.h"

namespace flg::test {
namespace {

// A cone of `count` triangles about one vertex.
Soup wheel(uint32_t count) {
    Soup soup{{{0, 0, 0.1f}}, {}};
    for (uint32_t i = 0; i < count; ++i) {
        const double turn = 2 * std::numbers::pi * i / count;
        soup.positions.push_back(to_position({std::cos(turn), std::sin(turn), 0}));
        soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
    }
    return soup;
}

TEST(GeodesicGraph, HasTheArcsOfTheLiteralOne) {
    for (const Soup& soup : {plane(9, 0.3), sphere(2), torus(12, 8), cylinder(9, 4), tetrahedron(), wheel(1000),
                             Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}}) {
        const Mesh mesh = make_mesh(soup);
        const literal::GeodesicGraph arcs = literal_form(make_graph(mesh));
        const literal::GeodesicGraph expected = sorted_rows(literal::geodesic_graph(mesh));
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            ASSERT_EQ(arcs[v].size(), expected[v].size()) << "vertex " << v;
            for (size_t i = 0; i < arcs[v].size(); ++i) {
                EXPECT_EQ(arcs[v][i].target, expected[v][i].target);
                EXPECT_NEAR(arcs[v][i].length, expected[v][i].length, 2e-7 * expected[v][i].length);
            }
        }
    }
}

TEST(GeodesicGraph, ArcsHaveTheSameLengthAtBothEnds) {
    const literal::GeodesicGraph arcs = literal_form(make_graph(make_mesh(sphere(3))));
    literal::GeodesicGraph reversed(arcs.size());
    for (uint32_t v = 0; v < arcs.size(); ++v) {
        for (const literal::Arc& arc : arcs[v]) reversed[arc.target].push_back({v, arc.length});
    }
    reversed = sorted_rows(reversed);
    for (uint32_t v = 0; v < arcs.size(); ++v) {
        ASSERT_EQ(arcs[v].size(), reversed[v].size());
        for (size_t i = 0; i < arcs[v].size(); ++i) EXPECT_EQ(arcs[v][i].length, reversed[v][i].length);
    }
}

TEST(GeodesicGraph, DoesNotDependOnSlices) {
    const Mesh mesh = make_mesh(torus(12, 8));
    const GeodesicGraph whole = make_graph(mesh), sliced = make_graph(mesh, 1);
    ASSERT_EQ(whole.arcs_end, sliced.arcs_end);
    for (uint32_t node = 0; node < whole.node_count(); ++node) {
        EXPECT_EQ(whole.vertex_of(node), sliced.vertex_of(node));
        EXPECT_EQ(whole.node_of(whole.vertex_of(node)), node);
        ASSERT_EQ(whole.rows[node].first, sliced.rows[node].first);
        ASSERT_EQ(whole.rows[node].count, sliced.rows[node].count);
        for (uint32_t i = 0; i < whole.rows[node].count; ++i) {
            const uint32_t arc = whole.rows[node].first + i;
            EXPECT_EQ(whole.arcs[arc].target, sliced.arcs[arc].target);
            EXPECT_EQ(whole.arcs[arc].length, sliced.arcs[arc].length);
        }
    }
    EXPECT_EQ(whole.mean_length, sliced.mean_length);
    EXPECT_EQ(whole.longest, sliced.longest);
}

TEST(GeodesicGraph, HasNoArcsAcrossEdgesWithoutLengthOrArea) {
    // Two vertices in one place; three on a line; all in one place; positions whose distance is no float.
    const float far = 3e38f;
    for (const Soup& soup : {Soup{{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}}},
                             Soup{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2}, {1, 0, 3}}},
                             Soup{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}, {1, 0, 3}}},
                             Soup{{{far, 0, 0}, {-far, 0, 0}, {0, far, 0}, {0, -far, 0}}, {{0, 1, 2}, {1, 0, 3}}}}) {
        const Mesh mesh = make_mesh(soup);
        const GeodesicGraph graph = make_graph(mesh);
        for (const auto& row : literal_form(graph)) {
            for (const literal::Arc& arc : row) EXPECT_GE(arc.length, 0.0f);
        }
        const GraphField field = solve_graph(mesh, graph, {{2, 0, 0}});
        for (uint32_t v = 0; v < 4; ++v) EXPECT_GE(field.distances[v], 0.0f);
        EXPECT_EQ(field.distances[2], 0.0f);
    }
    const Mesh flat = make_mesh({{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}}});
    EXPECT_EQ(solve_graph(flat, make_graph(flat), {{2, 0, 0}}).distances[3], 2.0f);
}

TEST(GeodesicGraph, OfNoVerticesIsEmpty) {
    const Mesh mesh(test_memory());
    EXPECT_EQ(make_graph(mesh).node_count(), 0u);
}

}  // namespace
}  // namespace flg::test
