// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

void expect_consistent(const Mesh& mesh) {
    std::vector<uint32_t> corners(mesh.vertex_count(), 0);
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        for (uint32_t vertex : mesh.triangles[t]) ++corners[vertex];
    }
    for (Corner corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
        const Corner across = mesh.opposite(corner);
        if (across == no_index) continue;
        EXPECT_EQ(mesh.vertex_at(across), mesh.vertex_at(next_corner(corner)));
        EXPECT_EQ(mesh.vertex_at(next_corner(across)), mesh.vertex_at(corner));
        EXPECT_EQ(mesh.opposite(across), corner);
    }
    // Turning from corner_of_vertex meets every corner of the vertex once.
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const Corner start = mesh.corner_of_vertex[v];
        uint32_t met = 0;
        Corner corner = start;
        do {
            ASSERT_EQ(mesh.vertex_at(corner), v);
            ++met;
            corner = mesh.turn(corner);
        } while (corner != start && corner != no_index);
        EXPECT_EQ(met, corners[v]) << "vertex " << v;
    }
}

uint32_t border_edges(const Mesh& mesh) {
    uint32_t count = 0;
    for (const Triple& neighbours : mesh.neighbours) {
        for (uint32_t neighbour : neighbours) count += neighbour == no_index;
    }
    return count;
}

TEST(Adjacency, JoinsEveryInnerEdgeAndNoOther) {
    const struct {
        Soup soup;
        uint32_t borders;
    } cases[] = {{tetrahedron(), 0},      {sphere(3), 0},
                 {torus(12, 8), 0},       {plane(7, 0.3), 4 * 7},
                 {cylinder(9, 4), 2 * 9}, {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 3}};
    for (const auto& [soup, borders] : cases) {
        const Mesh mesh = make_mesh(soup);
        expect_consistent(mesh);
        EXPECT_EQ(border_edges(mesh), borders);
    }
}

TEST(Adjacency, DoesNotDependOnSlices) {
    const Mesh whole = make_mesh(torus(12, 8));
    Mesh sliced = make_mesh(torus(12, 8));
    AdjacencyKernel kernel(sliced, test_memory());
    while (!kernel.run(1)) {}
    EXPECT_TRUE(std::equal(whole.neighbours.begin(), whole.neighbours.end(), sliced.neighbours.begin()));
    EXPECT_TRUE(
        std::equal(whole.corner_of_vertex.begin(), whole.corner_of_vertex.end(), sliced.corner_of_vertex.begin()));
}

}  // namespace
}  // namespace flg::test
