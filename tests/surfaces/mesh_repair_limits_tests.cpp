// SPDX-License-Identifier: MIT
// What is refused, what is only just taken, all defects at once, and that results do not depend on slices.
#include <limits>

#include "surfaces/repair_inputs.h"

namespace flg::test {
namespace {

template <class Values>
void expect_same(const Values& a, const Values& b) {
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
}

// Cubes that fill space share faces as duplicates and edges with up to eight triangles: whatever becomes of it is
// valid.
TEST(MeshRepair, HoldsCrowdsOfCubes) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        Soup soup;
        for (uint32_t i = 0; i < 27; ++i) {
            if (random_unit(seed, i, 0) < 0.5) append_cube(soup, Vec3(i % 3, i / 3 % 3, i / 9));
        }
        if (!soup.triangles.empty()) repair(soup);
    }
}

// Triangles between few vertices, with every defect at once.
TEST(MeshRepair, HoldsRandomTriangles) {
    for (uint32_t seed = 0; seed < 300; ++seed) {
        Soup soup;
        const uint32_t vertices = 4 + random_below(seed, 0, 0, 12), triangles = 1 + random_below(seed, 0, 1, 60);
        for (uint32_t v = 0; v < vertices; ++v) {
            soup.positions.push_back(to_position(
                {random_unit(seed, v, 2), random_unit(seed, v, 3), v % 3 == 0 ? 0 : random_unit(seed, v, 4)}));
        }
        for (uint32_t t = 0; t < triangles; ++t) {
            soup.triangles.push_back({random_below(seed, t, 5, vertices), random_below(seed, t, 6, vertices),
                                      random_below(seed, t, 7, vertices)});
        }
        const bool any = std::any_of(soup.triangles.begin(), soup.triangles.end(),
                                     [](const Triple& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; });
        if (any) repair(soup);
        if (::testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

TEST(MeshRepair, IsDoneOnceAndForAll) {
    Soup soup = band(20, true);
    append_cube(soup, Vec3(5, 0, 0));
    append_cube(soup, Vec3(6, 1, 0));
    const RepairedMesh once = repair(soup);
    Soup again;
    again.positions.assign(once.mesh.positions.begin(), once.mesh.positions.end());
    again.triangles.assign(once.mesh.triangles.begin(), once.mesh.triangles.end());
    EXPECT_TRUE(is_clean(repair(again).report));
}

TEST(MeshRepair, HoldsAVertexOfManyTriangles) {
    constexpr uint32_t valence = 20'000;
    Soup soup;
    soup.positions.push_back({0, 0, 1});
    for (uint32_t i = 0; i < valence; ++i) {
        const double angle = 2 * std::numbers::pi * i / valence;
        soup.positions.push_back(to_position({std::cos(angle), std::sin(angle), 0}));
        soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % valence});
    }
    EXPECT_TRUE(is_clean(repair(soup).report));
}

TEST(MeshRepair, LimitsTheTrianglesAtAnEdge) {
    const auto book = [](uint32_t pages) {
        Soup soup{{{0, 0, 0}, {0, 0, 1}}, {}};
        for (uint32_t i = 0; i < pages; ++i) {
            soup.positions.push_back(to_position({std::cos(0.001 * i), std::sin(0.001 * i), 0}));
            soup.triangles.push_back({0, 1, 2 + i});
            if (i % 2) std::swap(soup.triangles.back()[0], soup.triangles.back()[1]);
        }
        return soup;
    };
    EXPECT_EQ(repair(book(32)).report.topology.components, 16u);
    EXPECT_EQ(repair(book(1000)).report.topology.components, 1000u);
    EXPECT_EQ(failure_of(RepairInput(book(1001))), "more than 1000 triangles share the edge from vertex 0 to vertex 1");
}

TEST(MeshRepair, RefusesWhatIsNoMesh) {
    EXPECT_EQ(failure_of(RepairInput(Soup{})), "the mesh is empty: it has 0 vertices and 0 triangles");
    EXPECT_EQ(failure_of(RepairInput(Soup{{{0, 0, 0}}, {}})), "the mesh is empty: it has 1 vertices and 0 triangles");
    EXPECT_EQ(failure_of(RepairInput(Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{1, 1, 2}}})),
              "nothing is left of the mesh: each of its 1 triangles names a vertex twice");

    Soup soup = sphere(1);
    soup.triangles[7][2] = 42;
    EXPECT_EQ(failure_of(RepairInput(soup)), "triangle 7 of the mesh names vertex 42; there are 42 vertices");

    for (float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -2e30f}) {
        soup = sphere(1);
        soup.positions[5] = {1, bad, 2};
        const std::string failure = failure_of(RepairInput(soup));
        EXPECT_NE(failure.find("vertex 5 of the mesh is at (1, "), std::string::npos) << failure;
    }
    soup.positions[5] = {1, 1e30f, 2};
    EXPECT_EQ(failure_of(RepairInput(soup)), "");

    RepairInput without(sphere(1));
    without.column.attribute = FLG_ATTRIBUTE_NORMAL;
    EXPECT_EQ(failure_of(without), "none of the mesh's 1 columns is FLG_ATTRIBUTE_POSITION");

    RepairInput large(sphere(1));
    large.view.triangle_count = 1u << 30;
    EXPECT_EQ(failure_of(large),
              "the mesh has 42 vertices and 1073741824 triangles, the limit is 2147483648 and 715827882");

    for (float bad : {-1.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        const std::string failure = failure_of(RepairInput(sphere(1)), {.weld_distance = bad});
        EXPECT_NE(failure.find("must be finite and not negative"), std::string::npos) << failure;
    }
}

TEST(MeshRepair, DoesNotDependOnPauses) {
    Soup soup = exploded(band(20, true));
    append(soup, torus(30, 20), Vec3(5, 0, 0));
    append_cube(soup, Vec3(10, 0, 0));
    append_cube(soup, Vec3(11, 1, 0));
    const RepairInput input(soup);
    const RepairedMesh whole = repair(input, {.weld_distance = 0.0f});
    const RepairedMesh sliced = repair(input, {.weld_distance = 0.0f}, true);
    expect_same(whole.mesh.positions, sliced.mesh.positions);
    expect_same(whole.mesh.triangles, sliced.mesh.triangles);
    expect_same(whole.mesh.neighbours, sliced.mesh.neighbours);
    expect_same(whole.mesh.corner_of_vertex, sliced.mesh.corner_of_vertex);
    expect_same(whole.vertices.to_input, sliced.vertices.to_input);
}

TEST(MeshRepair, OfAllDefectsDoesNotDependOnPauses) {
    Soup soup = exploded(band(2000, true));
    append_cube(soup, Vec3(10, 0, 0));
    append_cube(soup, Vec3(11, 1, 0));
    for (uint32_t t = 0; t < soup.triangles.size(); t += 7) std::swap(soup.triangles[t][0], soup.triangles[t][1]);
    const RepairInput input(soup);
    const RepairOptions options{.weld_distance = 1e-3f};
    const RepairedMesh whole = repair(input, options), sliced = repair(input, options, true);
    EXPECT_GT(whole.report.flipped_triangles, 0u);
    EXPECT_EQ(whole.report.cut_edges, 1u);
    expect_same(whole.mesh.positions, sliced.mesh.positions);
    expect_same(whole.mesh.triangles, sliced.mesh.triangles);
    expect_same(whole.mesh.neighbours, sliced.mesh.neighbours);
    expect_same(whole.mesh.corner_of_vertex, sliced.mesh.corner_of_vertex);
    expect_same(whole.vertices.to_input, sliced.vertices.to_input);
}

}  // namespace
}  // namespace flg::test
