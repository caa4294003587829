// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_graph_update.h"

#include <gtest/gtest.h>

#include "surfaces/cut_meshes.h"
#include "surfaces/graph_checks.h"

namespace flg::test {
namespace {

using Direction = MeshEditReplay::Direction;

void update(const Mesh& mesh, const TouchedVertices& touched, GeodesicGraph& graph, uint32_t slice) {
    GeodesicGraphUpdateKernel kernel(mesh, mesh.positions, touched, graph, test_memory());
    while (!kernel.run(slice)) {}
}

void expect_as_new(const Mesh& mesh, const GeodesicGraph& graph) {
    const GeodesicGraph anew = make_graph(mesh);
    const literal::GeodesicGraph rows = literal_form(graph), expected = literal_form(anew);
    ASSERT_EQ(rows.size(), expected.size());
    uint32_t room = 0;
    for (uint32_t v = 0; v < rows.size(); ++v) {
        ASSERT_EQ(rows[v].size(), expected[v].size()) << "vertex " << v;
        for (size_t i = 0; i < rows[v].size(); ++i) {
            ASSERT_EQ(rows[v][i].target, expected[v][i].target);
            ASSERT_EQ(rows[v][i].length, expected[v][i].length);
        }
        room += row_capacity(static_cast<uint32_t>(rows[v].size()));
    }
    EXPECT_EQ(graph.arcs_in_use, room);
    EXPECT_LE(graph.arcs_end, graph.arcs.size());
    const std::vector<Seed> seeds = {{mesh.vertex_count() - 1, 0, 0}, {3, 0, 1}};
    EXPECT_EQ(solve_graph(mesh, graph, seeds).distances, solve_graph(mesh, anew, seeds).distances);
}

TEST(GeodesicGraphUpdate, IsAsBuiltAnewAfterCutsAndTheirReplay) {
    for (const Soup& soup : {sphere(3), torus(20, 12), plane(12, 0.3)}) {
        for (uint32_t slice : {1u, 1000u}) {
            Mesh mesh = make_mesh(soup);
            GeodesicGraph graph = make_graph(mesh);
            MeshColumns columns{test_memory()};
            columns.push_back(make_column(mesh, [](const Vec3& p) { return p.x() + p.y(); }));
            columns.push_back(make_column(mesh, [](const Vec3& p) { return p.x() - 0.6 * p.y() + 0.1; }));
            std::deque<MeshEdit> edits;
            std::deque<TouchedVertices> touched;
            for (uint32_t i = 0; i < 4; ++i) {
                edits.emplace_back(test_memory());
                touched.emplace_back(test_memory());
                cut_isolines(mesh, columns, i % 2, {0.1f * static_cast<float>(i), 0.7f}, edits.back());
                TouchedVertexSearch search(mesh, edits.back(), touched.back(), test_memory());
                while (!search.run(1000)) {}
                update(mesh, touched.back(), graph, slice);
                expect_as_new(mesh, graph);
            }
            for (size_t i = edits.size(); i-- > 0;) {
                replay(mesh, columns, edits[i], Direction::undo, 1000);
                update(mesh, touched[i], graph, slice);
                expect_as_new(mesh, graph);
            }
            for (size_t i = 0; i < edits.size(); ++i) {
                replay(mesh, columns, edits[i], Direction::redo, 1000);
                update(mesh, touched[i], graph, slice);
                expect_as_new(mesh, graph);
            }
        }
    }
}

// Rows leave their room and come back for ever; the arcs do not.
TEST(GeodesicGraphUpdate, DoesNotGrowWithTheNumberOfChanges) {
    Mesh mesh = make_mesh(sphere(3));
    GeodesicGraph graph = make_graph(mesh);
    MeshColumns columns{test_memory()};
    columns.push_back(make_column(mesh, [](const Vec3& p) { return p.x() + p.y(); }));
    MeshEdit edit(test_memory());
    TouchedVertices touched(test_memory());
    cut_isolines(mesh, columns, 0, {0.1f, 0.7f}, edit);
    TouchedVertexSearch search(mesh, edit, touched, test_memory());
    while (!search.run(1000)) {}
    update(mesh, touched, graph, 1000);
    for (uint32_t i = 0; i < 100; ++i) {
        replay(mesh, columns, edit, i % 2 == 0 ? Direction::undo : Direction::redo, 1000);
        update(mesh, touched, graph, 1000);
    }
    expect_as_new(mesh, graph);
    EXPECT_LT(graph.arcs.size(), 3u * graph.arcs_in_use / 2);
}

}  // namespace
}  // namespace flg::test
