// SPDX-License-Identifier: MIT
// Each kind of defect, and what becomes of it.
#include "surfaces/repair_inputs.h"

namespace flg::test {
namespace {

TEST(MeshRepair, LeavesAGoodMeshAsItIs) {
    const struct {
        Soup soup;
        uint32_t loops, genus;
    } cases[] = {{tetrahedron(), 0, 0},  {sphere(3), 0, 0},
                 {torus(12, 8), 0, 1},   {plane(7, 0.3), 1, 0},
                 {cylinder(9, 4), 2, 0}, {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 1, 0}};
    for (const auto& [soup, loops, genus] : cases) {
        const RepairedMesh repaired = repair(soup);
        EXPECT_TRUE(is_clean(repaired.report));
        EXPECT_TRUE(repaired.vertices.is_identity() && repaired.triangles.is_identity());
        EXPECT_TRUE(std::equal(soup.triangles.begin(), soup.triangles.end(), repaired.mesh.triangles.begin()));
        EXPECT_EQ(repaired.report.topology.components, 1u);
        EXPECT_EQ(repaired.report.topology.border_loops, loops);
        EXPECT_EQ(repaired.report.topology.genus, genus);
        EXPECT_EQ(repaired.report.flat_triangles, 0u);
    }
}

TEST(MeshRepair, ReadsStridedColumnsAndRegions) {
    const Soup soup = sphere(1);
    RepairInput input(soup);
    std::vector<float> values;  // a radius before each position
    for (const Position& p : soup.positions) values.insert(values.end(), {7, p[0], p[1], p[2]});
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_RADIUS, 1, values.data(), 16, 0},
                                 {FLG_ATTRIBUTE_POSITION, 3, values.data() + 1, 16, 0}};
    std::vector<uint32_t> regions;
    for (uint32_t t = 0; t < soup.triangles.size(); ++t) regions.push_back(t % 5);
    input.triangles[3][1] = input.triangles[3][0];
    input.view.columns = columns;
    input.view.column_count = 2;
    input.view.regions = regions.data();
    const RepairedMesh repaired = repair(input);
    EXPECT_EQ(repaired.report.degenerate_triangles, 1u);
    for (uint32_t t = 0; t < repaired.mesh.triangle_count(); ++t) {
        EXPECT_EQ(repaired.mesh.regions[t], (t < 3 ? t : t + 1) % 5);
    }
}

TEST(MeshRepair, HoldsAHundredComponents) {
    Soup soup;
    for (uint32_t i = 0; i < 100; ++i) append(soup, i % 2 ? sphere(1) : torus(5, 4), Vec3(3 * i, 0, 0));
    const RepairedMesh repaired = repair(soup);
    EXPECT_TRUE(is_clean(repaired.report));
    EXPECT_EQ(repaired.report.topology.components, 100u);
    EXPECT_EQ(repaired.report.topology.genus, 50u);
    EXPECT_EQ(repaired.report.topology.euler_number, 100);
}

TEST(MeshRepair, WeldsEqualPositionsOnlyWhenAsked) {
    const Soup whole = sphere(2), apart = exploded(whole);
    const RepairedMesh kept = repair(apart);
    EXPECT_EQ(kept.report.topology.components, whole.triangles.size());
    EXPECT_EQ(kept.report.welded_vertices, 0u);

    const RepairedMesh welded = repair(apart, {.weld_distance = 0.0f});
    EXPECT_EQ(welded.report.welded_vertices, apart.positions.size() - whole.positions.size());
    EXPECT_EQ(welded.report.unused_vertices, 0u);
    EXPECT_EQ(welded.mesh.positions.size(), whole.positions.size());
    EXPECT_EQ(welded.report.topology.euler_number, 2);
    EXPECT_EQ(welded.report.topology.border_edges, 0u);
    // What is welded leads to the vertex it was welded to.
    for (uint32_t from = 0; from < apart.positions.size(); ++from) {
        EXPECT_EQ(welded.mesh.positions[welded.vertices.of_input[from]], apart.positions[from]);
    }
}

TEST(MeshRepair, WeldsWithinADistance) {
    Soup soup = exploded(sphere(2));  // edges about 0.3 long
    for (uint32_t v = 0; v < soup.positions.size(); ++v) {
        for (uint32_t k = 0; k < 3; ++k) soup.positions[v][k] += static_cast<float>(1e-3 * random_unit(1, v, k));
    }
    EXPECT_EQ(repair(soup, {.weld_distance = 0.0f}).report.welded_vertices, 0u);
    const RepairedMesh welded = repair(soup, {.weld_distance = 2e-3f});
    EXPECT_EQ(welded.mesh.positions.size(), sphere(2).positions.size());
    EXPECT_EQ(welded.report.topology.euler_number, 2);
}

TEST(MeshRepair, WeldsZerosOfEitherSign) {
    Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, 0, 0}, {1, -0.0f, 0}, {0, -1, 0}}, {{0, 1, 2}, {4, 3, 5}}};
    EXPECT_EQ(repair(soup, {.weld_distance = 0.0f}).report.welded_vertices, 2u);
}

TEST(MeshRepair, DropsTrianglesThatWeldingFolds) {
    const RepairedMesh repaired = repair(plane(10), {.weld_distance = 0.12f});  // cells are 0.1 wide
    EXPECT_GT(repaired.report.welded_vertices, 0u);
    EXPECT_GT(repaired.report.degenerate_triangles, 0u);
    EXPECT_EQ(failure_of(RepairInput(plane(10)), {.weld_distance = 3.0f}),
              "nothing is left of the mesh: each of its 200 triangles names a vertex twice");
}

TEST(MeshRepair, DropsDuplicatesHoweverWound) {
    Soup soup = sphere(2);
    const Triple a = soup.triangles[5], b = soup.triangles[9];
    soup.triangles.push_back({a[1], a[2], a[0]});
    soup.triangles.push_back({b[1], b[0], b[2]});
    soup.triangles.push_back(b);
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.duplicate_triangles, 3u);
    EXPECT_EQ(repaired.report.crowded_edges, 0u);
    EXPECT_EQ(repaired.report.flipped_triangles, 0u);
    EXPECT_EQ(repaired.report.topology.euler_number, 2);
    EXPECT_EQ(repaired.triangles.of_input[soup.triangles.size() - 1], no_index);

    // Two triangles back to back are one.
    EXPECT_EQ(repair({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}).mesh.triangle_count(), 1u);
}

TEST(MeshRepair, TurnsTheMinorityOver) {
    Soup soup = torus(12, 8);
    for (uint32_t t : {0u, 1u, 17u, 100u}) std::swap(soup.triangles[t][1], soup.triangles[t][2]);
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.flipped_triangles, 4u);
    EXPECT_EQ(repaired.report.cut_edges, 0u);
    EXPECT_EQ(repaired.report.topology.genus, 1u);
    const Soup good = torus(12, 8);
    const RepairedMesh expected = repair(good);
    for (uint32_t t = 0; t < good.triangles.size(); ++t) {
        const Triple& corners = repaired.mesh.triangles[t];
        EXPECT_EQ(std::find(corners.begin(), corners.end(), good.triangles[t][0]) - corners.begin(), 0);
        EXPECT_EQ(corners[1], good.triangles[t][1]);
    }
}

TEST(MeshRepair, OnATieTheFirstTrianglesWindingStays) {
    const Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 2, 3}}};
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.flipped_triangles, 1u);
    EXPECT_EQ(repaired.mesh.triangles[0], soup.triangles[0]);
}

TEST(MeshRepair, CutsAMoebiusStripOpen) {
    EXPECT_EQ(repair(band(20, false)).report.topology.border_loops, 2u);
    const RepairedMesh repaired = repair(band(20, true));
    EXPECT_EQ(repaired.report.cut_edges, 1u);
    EXPECT_EQ(repaired.report.split_vertices, 2u);
    EXPECT_EQ(repaired.report.topology.border_loops, 1u);
    EXPECT_EQ(repaired.report.topology.euler_number, 1);  // a disk
    EXPECT_EQ(repaired.mesh.triangle_count(), 40u);
}

// A closed surface that can't be oriented has no border to cut from: slits must still end somewhere.
TEST(MeshRepair, CutsAKleinBottleOpen) {
    constexpr uint32_t around = 12, tube = 8;
    Soup soup = torus(around, tube);
    for (Triple& corners : soup.triangles) {
        const auto on = [&](uint32_t ring) {
            return std::any_of(corners.begin(), corners.end(), [&](uint32_t v) { return v / tube == ring; });
        };
        if (!on(0) || !on(around - 1)) continue;
        for (uint32_t& v : corners) {
            if (v / tube == 0) v = (tube - v) % tube;
        }
    }
    const RepairedMesh repaired = repair(soup);
    EXPECT_GT(repaired.report.cut_edges, 0u);
    EXPECT_GE(repaired.report.topology.border_loops, 1u);
    EXPECT_EQ(repaired.mesh.triangle_count(), soup.triangles.size());
    EXPECT_EQ(repaired.report.topology.components, 1u);
}

TEST(MeshRepair, SplitsABowTie) {
    const Soup soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.split_vertices, 1u);
    EXPECT_EQ(repaired.report.topology.components, 2u);
    ASSERT_EQ(repaired.mesh.vertex_count(), 6u);
    EXPECT_EQ(repaired.vertices.to_input[5], 0u);
    EXPECT_EQ(repaired.vertices.of_input[0], 0u);
}

TEST(MeshRepair, SplitsBallsThatTouchInAPoint) {
    Soup soup = tetrahedron();
    for (int i = 0; i < 2; ++i) {
        const uint32_t first = static_cast<uint32_t>(soup.positions.size());
        append(soup, tetrahedron(), Vec3(2 + 2 * i, 2, 2));
        for (Triple& t : soup.triangles) std::replace(t.begin(), t.end(), first, 0u);
    }
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.split_vertices, 2u);
    EXPECT_EQ(repaired.report.unused_vertices, 2u);
    EXPECT_EQ(repaired.report.topology.components, 3u);
    EXPECT_EQ(repaired.report.topology.border_edges, 0u);
}

TEST(MeshRepair, LeavesAThirdTriangleOpen) {
    // Two go straight on, the third stands on their edge.
    const Soup soup{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}}, {{1, 0, 4}, {1, 0, 2}, {0, 1, 3}}};
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.crowded_edges, 1u);
    EXPECT_EQ(repaired.report.split_vertices, 2u);
    EXPECT_EQ(repaired.mesh.neighbours[1][0], 2u);
    EXPECT_EQ(repaired.mesh.neighbours[0][0], no_index);
    EXPECT_EQ(repaired.report.topology.components, 2u);
}

TEST(MeshRepair, TakesAWallOutOfABall) {
    // The wall shares the equator: the ball stays closed.
    Soup soup;
    soup.positions = {{0, 0, 1}, {0, 0, -1}, {0, 0, 0}};
    for (uint32_t i = 0; i < 6; ++i) {
        const double angle = std::numbers::pi * i / 3;
        soup.positions.push_back(to_position({std::cos(angle), std::sin(angle), 0}));
        const uint32_t a = 3 + i, b = 3 + (i + 1) % 6;
        soup.triangles.insert(soup.triangles.end(), {{a, b, 2}, {a, b, 0}, {b, a, 1}});
    }
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.crowded_edges, 6u);
    EXPECT_EQ(repaired.report.topology.components, 2u);
    EXPECT_EQ(repaired.report.topology.border_edges, 6u);
    EXPECT_EQ(repaired.report.topology.euler_number, 3);
}

TEST(MeshRepair, KeepsSolidsThatTouchInAnEdgeClosedAndApart) {
    for (const Vec3& other : {Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(0, 1, 1), Vec3(-1, 0, 1)}) {
        Soup soup;
        append_cube(soup, Vec3(0, 0, 0));
        append_cube(soup, other);
        const RepairedMesh repaired = repair(soup);
        EXPECT_EQ(repaired.report.crowded_edges, 1u);
        EXPECT_EQ(repaired.report.split_vertices, 2u);
        EXPECT_EQ(repaired.report.topology.components, 2u);
        EXPECT_EQ(repaired.report.topology.border_edges, 0u);
        EXPECT_EQ(repaired.report.topology.euler_number, 4);
    }
}

// A leaf goes straight on from one side of a roof's ridge: the other side is left, open along an edge whose ends hang
// together all around. One of its triangles is detached there, and nothing else.
TEST(MeshRepair, OpensNoMoreThanTheEdgeThatIsLeft) {
    Soup soup = grid(4, 4, [](double x, double y) { return Vec3(x, y, -4 * std::abs(x - 0.5)); });
    soup.triangles.push_back({12, 7, 25});  // on the ridge from (0.5, 0.25) to (0.5, 0.5)
    soup.positions.push_back({0.75f, 0.375f, 1});
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.crowded_edges, 1u);
    EXPECT_EQ(repaired.report.cut_edges, 1u);
    EXPECT_EQ(repaired.report.split_vertices, 1u);
    EXPECT_EQ(repaired.report.topology.components, 1u);
}

TEST(MeshRepair, DropsUnusedVerticesAndCountsFlatTriangles) {
    const Soup soup{{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {8, 8, 8}}, {{1, 2, 3}, {3, 2, 4}}};
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.unused_vertices, 2u);
    EXPECT_EQ(repaired.report.flat_triangles, 1u);
    EXPECT_EQ(repaired.mesh.triangle_count(), 2u);
    EXPECT_EQ(repaired.vertices.of_input[0], no_index);
    EXPECT_EQ(repaired.vertices.of_input[1], 0u);
}

}  // namespace
}  // namespace flg::test
