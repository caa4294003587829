// SPDX-License-Identifier: MIT
#include <numbers>

#include "core/failure.h"
#include "runtime/run_now.h"
#include "surfaces/expect_valid.h"
#include "surfaces/mesh/mesh_measures.h"
#include "surfaces/repair/mesh_refine.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

MeshColumns no_columns() {
    return MeshColumns(test_memory());
}

// Each triangle's region is its index.
Mesh labelled(const Soup& soup) {
    Mesh mesh = make_mesh(soup);
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) mesh.regions[t] = t;
    return mesh;
}

void refine(Mesh& mesh, MeshColumns& columns, RefineRule rule, uint32_t levels, bool haltingly = false) {
    const auto make = [&](Pace& pace) { return refine_mesh(pace, mesh, columns, rule, levels); };
    run_now(test_memory(), make, haltingly);
}

Mesh refined(const Soup& soup, RefineRule rule, uint32_t levels) {
    Mesh mesh = labelled(soup);
    MeshColumns columns = no_columns();
    refine(mesh, columns, rule, levels);
    expect_valid(mesh);
    return mesh;
}

double area_of(const Mesh& mesh) {
    return run_now(test_memory(), [&](Pace& pace) { return measure_extent(pace, mesh); }).area;
}

// The mean of the positions of a vertex's neighbours, or at a border of the two along it.
Vec3 ring_mean(const Mesh& mesh, uint32_t vertex, uint32_t& valence) {
    Vec3 sum = Vec3::Zero();
    valence = 0;
    const Corner first = mesh.corner_of_vertex[vertex];
    Corner corner = first, last = first;
    while (corner != no_index && (valence == 0 || corner != first)) {
        sum += mesh.position(mesh.vertex_at(next_corner(corner)));
        ++valence;
        last = corner;
        corner = mesh.turn(corner);
    }
    if (corner == first) return sum / valence;
    return (mesh.position(mesh.vertex_at(next_corner(first))) + mesh.position(mesh.vertex_at(previous_corner(last)))) /
           2;
}

TEST(MeshRefine, KeepsTheTopology) {
    for (const Soup& soup : {tetrahedron(), sphere(0), torus(4, 3), plane(3, 0.3), cylinder(4, 2),
                             Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}}) {
        const Mesh coarse = make_mesh(soup);
        const int64_t edges = coarse.vertex_count() + coarse.triangle_count() - euler_number(coarse);
        for (RefineRule rule : {RefineRule::midpoint, RefineRule::loop}) {
            const Mesh once = refined(soup, rule, 1);
            EXPECT_EQ(once.vertex_count(), coarse.vertex_count() + edges);
            EXPECT_EQ(once.triangle_count(), 4 * coarse.triangle_count());
            EXPECT_EQ(euler_number(once), euler_number(coarse));
            const Mesh thrice = refined(soup, rule, 3);
            EXPECT_EQ(thrice.triangle_count(), 64 * coarse.triangle_count());
            EXPECT_EQ(euler_number(thrice), euler_number(coarse));
            for (uint32_t t = 0; t < thrice.triangle_count(); ++t) EXPECT_EQ(thrice.regions[t], t / 64);
        }
    }
}

TEST(MeshRefine, NoLevelsChangeNothing) {
    const Soup soup = plane(4, 0.3);
    const Mesh same = refined(soup, RefineRule::loop, 0);
    EXPECT_TRUE(std::equal(soup.positions.begin(), soup.positions.end(), same.positions.begin(), same.positions.end()));
}

TEST(MeshRefine, MidpointsStayOnTheSurface) {
    const Soup soup = sphere(1);
    const Mesh coarse = make_mesh(soup), fine = refined(soup, RefineRule::midpoint, 3);
    EXPECT_NEAR(area_of(fine), area_of(coarse), 1e-5);
    for (uint32_t v = 0; v < coarse.vertex_count(); ++v) EXPECT_EQ(fine.positions[v], coarse.positions[v]);
    for (uint32_t t = 0; t < fine.triangle_count(); ++t) {
        const Vec3 normal = triangle_normal(coarse, t / 64);
        const Vec3 origin = coarse.position(coarse.triangles[t / 64][0]);
        for (uint32_t v : fine.triangles[t]) EXPECT_NEAR(normal.dot(fine.position(v) - origin), 0, 1e-6);
        EXPECT_GT(triangle_normal(fine, t).dot(normal), 0.999);
    }
}

// A regular grid of valence 6 is reproduced, but for two rings that feel the rounding of the corners.
TEST(MeshRefine, LoopReproducesARegularPlane) {
    constexpr uint32_t cells = 8;
    const Mesh fine = refined(plane(cells), RefineRule::loop, 1);
    uint32_t checked = 0;
    for (uint32_t v = 0; v < (cells + 1) * (cells + 1); ++v) {
        EXPECT_EQ(fine.positions[v][2], 0.0f);
        const uint32_t i = v % (cells + 1), j = v / (cells + 1);
        if (i == 0 || i == cells || j == 0 || j == cells) continue;
        EXPECT_NEAR(fine.positions[v][0], double(i) / cells, 1e-6);
        EXPECT_NEAR(fine.positions[v][1], double(j) / cells, 1e-6);
        ++checked;
    }
    EXPECT_EQ(checked, (cells - 1) * (cells - 1));
    for (uint32_t v = 0; v < fine.vertex_count(); ++v) EXPECT_EQ(fine.positions[v][2], 0.0f);
}

// Where an inner vertex of valence n ends: (1 - n w) v + w (sum of neighbours), w = 1 / (3 / (8 b) + n) with Loop's
// weight b of a neighbour (Hoppe et al. 1994, appendix A); b n = 5/8 - (3/8 + cos(2 pi / n) / 4)^2.
TEST(MeshRefine, LoopConvergesToItsLimit) {
    for (const Soup& soup : {tetrahedron(), sphere(0), torus(5, 4), cylinder(3, 2)}) {
        const Mesh coarse = make_mesh(soup), fine = refined(soup, RefineRule::loop, 5);
        for (uint32_t v = 0; v < coarse.vertex_count(); ++v) {
            uint32_t n = 0;
            const Vec3 mean = ring_mean(coarse, v, n);
            const bool border = coarse.neighbour_at(coarse.corner_of_vertex[v]) == no_index;
            const double root = 3.0 / 8 + std::cos(2 * std::numbers::pi / n) / 4;
            const double all = 5.0 / 8 - root * root;
            // A border is a cubic B-spline: 2/3 of the vertex, 1/6 of each neighbour.
            const double weight = border ? 1.0 / 3 : n / (3 * n / (8 * all) + n);
            const Vec3 limit = (1 - weight) * coarse.position(v) + weight * mean;
            EXPECT_LT((fine.position(v) - limit).norm(), 5e-3) << "vertex " << v;
            EXPECT_GT((coarse.position(v) - limit).norm(), 0.02) << "vertex " << v;
        }
    }
}

TEST(MeshRefine, LoopMakesABallOfAnIcosahedron) {
    const auto spread = [](const Mesh& mesh) {
        double least = 10, most = 0;
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            least = std::min(least, mesh.position(v).norm());
            most = std::max(most, mesh.position(v).norm());
        }
        return most / least;
    };
    EXPECT_GT(spread(refined(sphere(0), RefineRule::midpoint, 3)), 1.2);
    EXPECT_LT(spread(refined(sphere(0), RefineRule::loop, 3)), 1.05);
}

// Borders depend on borders alone.
TEST(MeshRefine, LoopBordersFitTogether) {
    Soup flat = plane(4), steep = plane(4);
    for (Position& p : steep.positions) {
        if (p[0] > 0) p[2] = 3 * p[0];
    }
    const Mesh a = refined(flat, RefineRule::loop, 2), b = refined(steep, RefineRule::loop, 2);
    uint32_t on_border = 0;
    for (uint32_t v = 0; v < a.vertex_count(); ++v) {
        if (a.neighbour_at(a.corner_of_vertex[v]) != no_index || a.positions[v][0] > 0.01f) continue;
        if (a.positions[v][1] < 0.2f || a.positions[v][1] > 0.8f) continue;
        EXPECT_EQ(a.positions[v], b.positions[v]);
        ++on_border;
    }
    EXPECT_GT(on_border, 4u);
}

TEST(MeshRefine, ColumnsFollowPositions) {
    for (RefineRule rule : {RefineRule::midpoint, RefineRule::loop}) {
        Mesh mesh = make_mesh(plane(5, 0.3));
        MeshColumns columns = no_columns();
        columns.push_back({1, GrowingBuffer<float>(mesh.positions.size(), test_memory())});
        columns.push_back({3, GrowingBuffer<float>(3 * mesh.positions.size(), test_memory())});
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            columns[0].values[v] = mesh.positions[v][1];
            std::copy_n(mesh.positions[v].begin(), 3, columns[1].values.begin() + 3 * v);
        }
        refine(mesh, columns, rule, 2);
        ASSERT_EQ(columns[0].values.size(), mesh.positions.size());
        ASSERT_EQ(columns[1].values.size(), 3 * mesh.positions.size());
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            EXPECT_EQ(columns[0].values[v], mesh.positions[v][1]);
            for (uint32_t k = 0; k < 3; ++k) EXPECT_EQ(columns[1].values[3 * v + k], mesh.positions[v][k]);
        }
    }
}

TEST(MeshRefine, RefusesWhatWouldBeTooLarge) {
    Mesh mesh = make_mesh(tetrahedron());
    MeshColumns columns = no_columns();
    for (uint32_t levels : {14u, 64u, UINT32_MAX}) {  // 4 * 4^14 * 3 > 2^31
        try {
            refine(mesh, columns, RefineRule::midpoint, levels);
            FAIL();
        } catch (const Failure& failure) {
            EXPECT_EQ(failure.result(), FLG_ERROR_LIMIT);
            EXPECT_NE(std::string(failure.what()).find("4 triangles refined"), std::string::npos);
        }
    }
    EXPECT_EQ(mesh.triangle_count(), 4u);
}

TEST(MeshRefine, DoesNotDependOnSlices) {
    const auto refine_in = [](bool haltingly) {
        Mesh mesh = labelled(plane(20, 0.3));
        MeshColumns columns = no_columns();
        refine(mesh, columns, RefineRule::loop, 1, haltingly);
        return mesh;
    };
    const Mesh whole = refine_in(false), sliced = refine_in(true);
    EXPECT_TRUE(std::equal(whole.positions.begin(), whole.positions.end(), sliced.positions.begin()));
    EXPECT_TRUE(std::equal(whole.triangles.begin(), whole.triangles.end(), sliced.triangles.begin()));
    EXPECT_TRUE(std::equal(whole.neighbours.begin(), whole.neighbours.end(), sliced.neighbours.begin()));
    EXPECT_TRUE(
        std::equal(whole.corner_of_vertex.begin(), whole.corner_of_vertex.end(), sliced.corner_of_vertex.begin()));
}

}  // namespace
}  // namespace flg::test
