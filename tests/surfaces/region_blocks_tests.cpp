// SPDX-License-Identifier: MIT
#include "surfaces/mesh/region_blocks.h"

#include <gtest/gtest.h>

#include <random>

#include "runtime/run_now.h"
#include "surfaces/mesh/mesh_edit.h"
#include "surfaces/mesh/region_cursor.h"
#include "surfaces/mesh/region_vertices.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

class RegionBlocksTest : public ::testing::Test {
protected:
    RegionBlocksTest() : mesh(make_mesh(sphere(5))), columns(test_memory()) {
        run_haltingly(test_memory(), [&](Pace& pace) { return RegionBlocks::begin(pace, mesh.region_blocks, 0); });
    }
    void restart(uint32_t first) {
        run_haltingly(test_memory(),
                      [&](Pace& pace) { return RegionBlocks::restart(pace, mesh.region_blocks, first); });
    }
    // Labels some stretches of triangles.
    void relabel(MeshEdit& edit, uint32_t first, uint32_t labels) {
        edit.begin(mesh);
        for (uint32_t i = 0; i < 3 * labels; ++i) {
            const uint32_t begin = random() % mesh.triangle_count(), label = first + random() % labels;
            for (uint32_t t = begin; t < std::min(begin + 40, mesh.triangle_count()); ++t)
                edit.set_region(mesh, t, label);
        }
        edit.end(mesh);
    }
    void replay(MeshEdit& edit, MeshEditReplay::Direction direction) {
        MeshEditReplay replayed(mesh, columns, edit, direction);
        while (!replayed.run(1000)) {}
    }
    // What cursors find of each pair of labels is what there is.
    void expect_found(uint32_t labels) {
        for (uint32_t label = 1; label < labels; ++label) {
            const std::array<uint32_t, 2> pair = {label, label / 2};
            const RegionSet regions(pair.data(), 2, test_memory());
            std::vector<uint32_t> found, expected;
            RegionCursor cursor(mesh, regions);
            while (!cursor.at_end()) cursor.next_64([&](uint32_t t) { found.push_back(t); });
            for (uint32_t t = 0; t < mesh.triangle_count(); ++t)
                if (regions.contains(mesh.regions[t])) expected.push_back(t);
            EXPECT_EQ(found, expected) << label;
        }
    }
    bool is_local(uint32_t label) {
        const RegionSet one(&label, 1, test_memory());
        return RegionCursor(mesh, one).is_local();
    }

    Mesh mesh;
    MeshColumns columns;
    std::mt19937 random{7};
};

TEST_F(RegionBlocksTest, HoldTheTrianglesOfEachLabelThroughUndoAndRedo) {
    std::pmr::deque<MeshEdit> edits(test_memory());
    for (uint32_t i = 0; i < 6; ++i) relabel(edits.emplace_back(test_memory()), 1 + 10 * i, 10);
    expect_found(61);
    for (uint32_t i = 6; i-- > 0;) {
        replay(edits[i], MeshEditReplay::Direction::undo);
        expect_found(61);
    }
    for (MeshEdit& edit : edits) replay(edit, MeshEditReplay::Direction::redo);
    expect_found(61);
    EXPECT_TRUE(is_local(5));
    EXPECT_FALSE(is_local(0));
}

TEST_F(RegionBlocksTest, AreThoseOfNewLabelsOnlyOnceRestarted) {
    for (uint32_t i = 0; i < 50; ++i) {
        MeshEdit edit(test_memory());
        restart(1);
        relabel(edit, 1, 4);
        expect_found(5);
        replay(edit, MeshEditReplay::Direction::abandon);
    }
    restart(1);
    uint32_t blocks = 0;
    EXPECT_TRUE(mesh.region_blocks.visit(1, [&](uint32_t) { ++blocks; }));
    EXPECT_EQ(blocks, 0u);
}

TEST_F(RegionBlocksTest, LeaveLabelsInDoubtAnywhere) {
    MeshEdit edit(test_memory());
    relabel(edit, 1, 8);
    mesh.region_blocks.doubt(5);
    EXPECT_TRUE(is_local(4));
    EXPECT_FALSE(is_local(5));
    expect_found(9);
    restart(6);
    EXPECT_FALSE(is_local(5));
    restart(5);
    EXPECT_TRUE(is_local(5));
}

TEST_F(RegionBlocksTest, GiveUpLabelsThatAreNearlyEverywhere) {
    RegionBlocks& blocks = mesh.region_blocks;
    for (uint32_t i = 0; i <= RegionBlocks::most_blocks; ++i) blocks.add(1, RegionBlocks::block_size * i);
    EXPECT_FALSE(blocks.visit(1, [](uint32_t) {}));
    blocks.add(2, 3);
    EXPECT_TRUE(blocks.visit(2, [](uint32_t block) { EXPECT_EQ(block, 0u); }));
}

TEST_F(RegionBlocksTest, LeadToTheVerticesOfRegionsAndTheirRim) {
    MeshEdit edit(test_memory());
    relabel(edit, 1, 5);
    for (uint32_t label = 1; label < 6; ++label) {
        const RegionSet one(&label, 1, test_memory());
        for (const RegionRim rim : {RegionRim::without, RegionRim::with}) {
            std::vector<uint8_t> inside(mesh.vertex_count(), 0);
            for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
                bool counts = mesh.regions[t] == label;
                for (const uint32_t across : mesh.neighbours[t])
                    counts |= rim == RegionRim::with && across != no_index && mesh.regions[across] == label;
                if (!counts) continue;
                for (const uint32_t vertex : mesh.triangles[t]) inside[vertex] = 1;
            }
            std::vector<uint32_t> expected;
            for (uint32_t v = 0; v < inside.size(); ++v)
                if (inside[v] != 0) expected.push_back(v);
            const Buffer<uint32_t> found =
                run_haltingly(test_memory(), [&](Pace& pace) { return vertices_of(pace, mesh, one, rim); });
            EXPECT_EQ(std::vector<uint32_t>(found.begin(), found.end()), expected);
        }
    }
}

}  // namespace
}  // namespace flg::test
