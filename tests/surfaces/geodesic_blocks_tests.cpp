// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "surfaces/geodesics.h"
#include "surfaces/mesh/fan_walk.h"

namespace flg::test {
namespace {

// A mesh that has room to grow.
Mesh roomy(const Soup& soup, size_t more) {
    Mesh mesh = make_mesh(soup);
    const auto grow = [&](auto& buffer) {
        buffer.begin_growth(buffer.size() + more);
        buffer.grow(buffer.size());
    };
    grow(mesh.positions);
    grow(mesh.triangles);
    grow(mesh.neighbours);
    grow(mesh.regions);
    grow(mesh.corner_of_vertex);
    return mesh;
}

// Splits a triangle in three at a point above its middle; the vertices that the change touches.
std::set<uint32_t> split(Mesh& mesh, uint32_t triangle) {
    const Triple corners = mesh.triangles[triangle], around = mesh.neighbours[triangle];
    const uint32_t vertex = mesh.vertex_count(), second = mesh.triangle_count(), third = second + 1;
    mesh.positions.push_back(
        to_position(1.01 * (mesh.position(corners[0]) + mesh.position(corners[1]) + mesh.position(corners[2])) / 3));
    mesh.triangles[triangle] = {corners[0], corners[1], vertex};
    mesh.triangles.push_back({corners[1], corners[2], vertex});
    mesh.triangles.push_back({corners[2], corners[0], vertex});
    mesh.neighbours[triangle] = {around[0], second, third};
    mesh.neighbours.push_back({around[1], third, triangle});
    mesh.neighbours.push_back({around[2], triangle, second});
    for (uint32_t k = 1; k < 3; ++k) {
        for (uint32_t& neighbour : mesh.neighbours[around[k]]) {
            if (neighbour == triangle) neighbour = k == 1 ? second : third;
        }
    }
    mesh.regions.push_back(0);
    mesh.regions.push_back(0);
    mesh.corner_of_vertex.push_back(3 * triangle + 2);
    for (uint32_t k = 0; k < 3; ++k) {
        mesh.corner_of_vertex[corners[k]] = k < 2 ? 3 * triangle + k : 3 * second + 1;
    }
    return {corners.begin(), corners.end()};
}

void update(const Mesh& mesh, const std::set<uint32_t>& touched, GeodesicBlocks& blocks) {
    const std::pmr::deque<uint32_t> list(touched.begin(), touched.end(), test_memory());
    run_haltingly(test_memory(), [&](Pace& pace) { return update_blocks(pace, mesh, list, blocks); });
}

void expect_like_new(const Mesh& mesh, Geodesics& updated) {
    Geodesics anew(mesh);
    EXPECT_EQ(updated.blocks.edges.mean(), anew.blocks.edges.mean());
    for (uint32_t source : {0u, 77u, mesh.vertex_count() - 1}) {
        EXPECT_EQ(updated.distances({{source, 0, 0}}), anew.distances({{source, 0, 0}}));
    }
}

TEST(GeodesicBlocks, HoldEachVertexOnceAndItsFanInOrder) {
    const Mesh mesh = make_mesh(torus(20, 12));
    const Geodesics geodesics(mesh);
    const GeodesicBlocks& blocks = geodesics.blocks;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const uint32_t rank = blocks.rank_of_vertex[v];
        EXPECT_EQ(blocks.vertex_of_rank[rank], v);
        uint32_t lane = 0;
        visit_fan(mesh, v, [&](uint32_t neighbour, Corner) {
            EXPECT_EQ(blocks.blocks[rank].rank(lane), blocks.rank_of_vertex[neighbour]);
            EXPECT_NEAR(blocks.blocks[rank].lengths[lane], (mesh.position(v) - mesh.position(neighbour)).norm(), 1e-6);
            ++lane;
        });
        EXPECT_EQ(lane, 7u);
        EXPECT_EQ(blocks.blocks[rank].rank(7), nowhere);
    }
}

// Gauss and Bonnet: curvature sums up to 2 pi times Euler's number, here 2 and 0.
TEST(GeodesicBlocks, KnowTheCurvature) {
    const auto total = [](const Mesh& mesh) {
        const Geodesics geodesics(mesh);
        double sum = 0;
        for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            const Triple& corners = mesh.triangles[t];
            const Vec3 a = mesh.position(corners[0]), b = mesh.position(corners[1]), c = mesh.position(corners[2]);
            for (uint32_t vertex : corners) {
                sum += geodesics.blocks.curvatures[geodesics.blocks.rank_of_vertex[vertex]] *
                       (b - a).cross(c - a).norm() / 6;
            }
        }
        return sum;
    };
    EXPECT_NEAR(total(make_mesh(sphere(3))), 4 * std::numbers::pi, 1e-4);
    EXPECT_NEAR(total(make_mesh(tetrahedron())), 4 * std::numbers::pi, 1e-4);
    EXPECT_NEAR(total(make_mesh(torus(30, 20))), 0, 1e-4);
}

void expect_same_updated_and_built_anew(const Soup& soup) {
    Mesh mesh = roomy(soup, 4000);
    Geodesics geodesics(mesh);
    // Again and again around the same vertices: their fans outgrow one block, then two; and more vertices than there is
    // room.
    for (uint32_t round = 0; round < 8; ++round) {
        std::set<uint32_t> touched;
        for (uint32_t i = 0; i < 60; ++i) {
            const uint32_t triangle = round % 2 == 0 ? random_below(3, i, round, mesh.triangle_count()) : i;
            touched.merge(split(mesh, triangle));
        }
        update(mesh, touched, geodesics.blocks);
        expect_like_new(mesh, geodesics);
    }
}

TEST(GeodesicBlocks, AreTheSameUpdatedAndBuiltAnew) {
    expect_same_updated_and_built_anew(torus(30, 20));
}

TEST(GeodesicBlocks, AreTheSameUpdatedAndBuiltAnewOnStretchedTriangles) {
    expect_same_updated_and_built_anew(stretched(torus(30, 20), {1, 20, 1}));
    expect_same_updated_and_built_anew(stretched(torus(30, 20), {1, 1.5, 1}));
}

void expect_a_cut_is_taken_back(const Soup& soup) {
    Mesh mesh = roomy(soup, 400);
    Geodesics geodesics(mesh);
    std::set<uint32_t> touched;
    for (uint32_t i = 0; i < 50; ++i) touched.merge(split(mesh, 7 * i));
    update(mesh, touched, geodesics.blocks);
    const Mesh before = make_mesh(soup);
    std::erase_if(touched, [&](uint32_t vertex) { return vertex >= before.vertex_count(); });
    update(before, touched, geodesics.blocks);
    expect_like_new(before, geodesics);
}

TEST(GeodesicBlocks, FollowACutThatIsTakenBack) {
    expect_a_cut_is_taken_back(torus(30, 20));
    expect_a_cut_is_taken_back(stretched(torus(30, 20), {1, 20, 1}));
    expect_a_cut_is_taken_back(stretched(torus(30, 20), {1, 1.5, 1}));
}

}  // namespace
}  // namespace flg::test
