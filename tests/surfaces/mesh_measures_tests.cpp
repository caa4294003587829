// SPDX-License-Identifier: MIT
#include "surfaces/mesh/mesh_measures.h"

#include <gtest/gtest.h>

#include <numbers>

#include "surfaces/expect_valid.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

MeshTopology topology_of(const Mesh& mesh, bool haltingly = false) {
    return run_now(
        test_memory(), [&](Pace& pace) { return find_topology(pace, mesh); }, haltingly);
}

MeshComponents components_of(const Mesh& mesh, bool haltingly = false) {
    return run_now(
        test_memory(), [&](Pace& pace) { return find_components(pace, mesh); }, haltingly);
}

BorderLoops borders_of(const Mesh& mesh, bool haltingly = false) {
    return run_now(
        test_memory(), [&](Pace& pace) { return find_borders(pace, mesh); }, haltingly);
}

Buffer<Position> normals_of(const Mesh& mesh, bool haltingly = false) {
    return run_now(
        test_memory(), [&](Pace& pace) { return find_vertex_normals(pace, mesh); }, haltingly);
}

MeshExtent extent_of(const Mesh& mesh) {
    return run_now(test_memory(), [&](Pace& pace) { return measure_extent(pace, mesh); });
}

// Three parts of several kinds: a torus, an open cylinder, a square.
Soup three_parts() {
    Soup soup = torus(9, 6);
    for (const Soup& part : {cylinder(7, 3), plane(3)}) {
        const uint32_t first = static_cast<uint32_t>(soup.positions.size());
        soup.positions.insert(soup.positions.end(), part.positions.begin(), part.positions.end());
        for (const Triple& t : part.triangles) soup.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    return soup;
}

TEST(MeshMeasures, Topology) {
    const Mesh mesh = make_mesh(three_parts());
    for (const bool haltingly : {false, true}) {
        const MeshTopology topology = topology_of(mesh, haltingly);
        EXPECT_EQ(topology.components, 3u);
        EXPECT_EQ(topology.border_loops, 3u);
        EXPECT_EQ(topology.border_edges, 7u + 7 + 12);
        EXPECT_EQ(topology.genus, 1u);
        EXPECT_EQ(topology.euler_number, 0 + 0 + 1);
        EXPECT_EQ(topology.euler_number, euler_number(mesh));
    }
}

TEST(MeshMeasures, ComponentsAreNumberedByTheirLeastVertices) {
    Soup soup = three_parts();
    Mesh mesh = make_mesh(soup);
    const MeshComponents components = components_of(mesh, true);
    EXPECT_EQ(components.count, 3u);
    const Buffer<uint32_t>& labels = components.of_vertex;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) EXPECT_EQ(labels[v], v < 54 ? 0u : v < 54 + 28 ? 1u : 2u);

    // The same vertices in the opposite order.
    const uint32_t last = mesh.vertex_count() - 1;
    for (Triple& t : soup.triangles) {
        for (uint32_t& v : t) v = last - v;
    }
    std::reverse(soup.positions.begin(), soup.positions.end());
    const Buffer<uint32_t> reversed_labels = components_of(make_mesh(soup)).of_vertex;
    for (uint32_t v = 0; v <= last; ++v) EXPECT_EQ(reversed_labels[last - v], 2 - labels[v]);
}

TEST(MeshMeasures, BordersRunAlongTheTriangles) {
    const Mesh mesh = make_mesh(three_parts());
    const BorderLoops loops = borders_of(mesh);
    ASSERT_EQ(loops.loop_count(), 3u);
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> open;  // directed border edges
    for (Corner corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
        if (mesh.neighbour_at(corner) == no_index) open[{mesh.vertex_at(corner), mesh.vertex_at(next_corner(corner))}];
    }
    uint32_t min_before = 0;
    for (uint32_t l = 0; l < 3; ++l) {
        const uint32_t begin = loops.offsets[l], end = loops.offsets[l + 1];
        for (uint32_t i = begin; i < end; ++i) {
            const auto edge = open.find({loops.vertices[i], loops.vertices[i + 1 == end ? begin : i + 1]});
            ASSERT_NE(edge, open.end());
            EXPECT_EQ(edge->second++, 0u);
            EXPECT_GE(loops.vertices[i], loops.vertices[begin]);
        }
        EXPECT_GT(loops.vertices[begin], min_before);
        min_before = loops.vertices[begin];
    }
    EXPECT_EQ(loops.vertex_count(), open.size());
    const BorderLoops sliced = borders_of(mesh, true);
    EXPECT_EQ(sliced.vertices, loops.vertices);
    EXPECT_EQ(sliced.offsets, loops.offsets);

    EXPECT_EQ(borders_of(make_mesh(sphere(2))).loop_count(), 0u);
}

TEST(MeshMeasures, Extent) {
    const MeshExtent square = extent_of(make_mesh(plane(9, 0.4)));
    EXPECT_NEAR(square.area, 1, 1e-6);
    EXPECT_EQ(square.lower, Vec3(0, 0, 0));
    EXPECT_EQ(square.upper, Vec3(1, 1, 0));
    const MeshExtent ball = extent_of(make_mesh(sphere(5)));
    EXPECT_NEAR(ball.area, 4 * std::numbers::pi, 0.01);
    EXPECT_NEAR(ball.upper.y(), 1, 0.01);
    // A prism of n sides: 2 high, perimeter 2 n sin(pi / n).
    EXPECT_NEAR(extent_of(make_mesh(cylinder(11, 4))).area, 2 * 22 * std::sin(std::numbers::pi / 11), 1e-5);
}

TEST(MeshMeasures, NormalsOfASphereAreItsRadii) {
    const Mesh mesh = make_mesh(sphere(4));
    const Buffer<Position> normals = normals_of(mesh);
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_NEAR(load_vec3(normals[v].data()).dot(mesh.position(v)), 1, 1e-4);
    }
    const Buffer<Position> sliced = normals_of(mesh, true);
    EXPECT_TRUE(std::equal(normals.begin(), normals.end(), sliced.begin()));
}

// At the corner of a cube all sides count alike, however they are cut into triangles.
TEST(MeshMeasures, NormalsDoNotDependOnTheTriangles) {
    const Soup corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0}, {0.8f, 0.2f, 0}},
                      {{0, 2, 4}, {0, 4, 5}, {0, 5, 1}, {0, 3, 2}, {0, 1, 3}}};
    const Buffer<Position> normals = normals_of(make_mesh(corner));
    for (float x : normals[0]) EXPECT_NEAR(x, -1 / std::sqrt(3.0), 1e-6);
}

TEST(MeshMeasures, NormalsOfFlatTrianglesAreZeroNotNan) {
    const Soup line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    const Mesh mesh = make_mesh(line);
    for (const Position& normal : normals_of(mesh)) EXPECT_EQ(normal, (Position{0, 0, 0}));
    EXPECT_EQ(triangle_normal(mesh, 0), Vec3(0, 0, 0));
    EXPECT_EQ(extent_of(mesh).area, 0);

    // Sizes at the ends of what positions can be.
    for (float size : {1e-30f, 1e30f}) {
        const Mesh triangle = make_mesh({{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}});
        for (const Position& normal : normals_of(triangle)) EXPECT_NEAR(normal[2], 1, 1e-6);
    }
}

}  // namespace
}  // namespace flg::test
