// SPDX-License-Identifier: MIT
#include "surfaces/cutting/cut_regions.h"

#include "surfaces/cut_meshes.h"

namespace flg::test {
namespace {

// Of a plane of n x n cells: the edges x = column / n from row `first` up to row `end`, as corners of the triangles to
// the left.
std::pmr::deque<Corner> column_edges(const Mesh& mesh, uint32_t cells, uint32_t column, uint32_t first, uint32_t end) {
    std::pmr::deque<Corner> edges;
    for (uint32_t row = first; row < end; ++row) {
        const uint32_t bottom = row * (cells + 1) + column, top = bottom + cells + 1;
        for (Corner corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
            if (mesh.vertex_at(corner) == bottom && mesh.vertex_at(next_corner(corner)) == top) edges.push_back(corner);
        }
    }
    return edges;
}

struct Division {
    explicit Division(uint32_t cells) : mesh(make_mesh(plane(cells))) { edit.begin(mesh); }
    void run(const std::pmr::deque<Corner>& edges, uint32_t first_label, bool haltingly = false) {
        run_now(
            test_memory(), [&](Pace& pace) { return divide_regions(pace, mesh, edges, first_label, edit, parts); },
            haltingly);
        edit.end(mesh);
    }

    Mesh mesh;
    MeshColumns columns{test_memory()};
    MeshEdit edit{test_memory()};
    std::pmr::deque<RegionPart> parts;
};

TEST(RegionDivider, GivesEachPartALabel) {
    for (bool haltingly : {true, false}) {
        Division division(8);
        std::pmr::deque<Corner> edges = column_edges(division.mesh, 8, 2, 0, 8);
        const std::pmr::deque<Corner> more = column_edges(division.mesh, 8, 5, 0, 8);
        edges.insert(edges.end(), more.begin(), more.end());
        const std::vector<uint32_t> before = bits_of(division.mesh, division.columns);
        division.run(edges, 7, haltingly);
        ASSERT_EQ(division.parts.size(), 3u);
        EXPECT_DOUBLE_EQ(area_of(division.mesh, 7), 2.0 / 8);
        EXPECT_DOUBLE_EQ(area_of(division.mesh, 8), 3.0 / 8);
        EXPECT_DOUBLE_EQ(area_of(division.mesh, 9), 3.0 / 8);
        replay(division.mesh, division.columns, division.edit, MeshEditReplay::Direction::undo);
        EXPECT_EQ(bits_of(division.mesh, division.columns), before);
    }
}

TEST(RegionDivider, AnEdgeChainThatEndsInsideDividesNothing) {
    Division division(8);
    division.run(column_edges(division.mesh, 8, 3, 0, 7), 7);
    EXPECT_TRUE(division.parts.empty());
    EXPECT_DOUBLE_EQ(area_of(division.mesh, 0), 1);
    EXPECT_TRUE(division.edit.labels().empty());
}

// Region 5 lies left and right of region 0: only the part that the chain crosses falls apart, and region 0 stays.
TEST(RegionDivider, LooksAtWhatWasApartByItself) {
    Division division(8);
    for (uint32_t t = 0; t < division.mesh.triangle_count(); ++t) {
        const uint32_t column = t / 2 % 8;
        division.mesh.regions[t] = column < 3 || column > 4 ? 5 : 0;
    }
    std::pmr::deque<Corner> edges = column_edges(division.mesh, 8, 1, 0, 8);
    const std::pmr::deque<Corner> border = column_edges(division.mesh, 8, 5, 0, 8);
    edges.insert(edges.end(), border.begin(), border.end());
    division.run(edges, 7);
    ASSERT_EQ(division.parts.size(), 2u);
    EXPECT_EQ(division.parts[0].old_label, 5u);
    EXPECT_EQ(division.parts[1].old_label, 5u);
    EXPECT_DOUBLE_EQ(area_of(division.mesh, 7), 1.0 / 8);
    EXPECT_DOUBLE_EQ(area_of(division.mesh, 8), 2.0 / 8);
    EXPECT_DOUBLE_EQ(area_of(division.mesh, 5), 3.0 / 8);
    EXPECT_DOUBLE_EQ(area_of(division.mesh, 0), 2.0 / 8);
}

}  // namespace
}  // namespace flg::test
