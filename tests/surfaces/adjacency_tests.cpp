// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "surfaces/expect_valid.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

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
        expect_valid(mesh);
        EXPECT_EQ(border_edges(mesh), borders);
    }
}

TEST(Adjacency, DoesNotDependOnSlices) {
    const Mesh whole = make_mesh(torus(60, 40));
    Mesh sliced = make_mesh(torus(60, 40));
    run_haltingly(test_memory(), [&](Pace& pace) { return find_neighbours(pace, sliced); });
    EXPECT_TRUE(std::equal(whole.neighbours.begin(), whole.neighbours.end(), sliced.neighbours.begin()));
    EXPECT_TRUE(
        std::equal(whole.corner_of_vertex.begin(), whole.corner_of_vertex.end(), sliced.corner_of_vertex.begin()));
}

}  // namespace
}  // namespace flg::test
