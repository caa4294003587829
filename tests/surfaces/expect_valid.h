// SPDX-License-Identifier: MIT
// All invariants of mesh.h, checked from the triangles alone; slow and plain.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "surfaces/mesh/mesh.h"

namespace flg::test {

namespace valid {

using Edge = std::pair<uint32_t, uint32_t>;

inline void expect_sizes(const Mesh& mesh) {
    EXPECT_EQ(mesh.neighbours.size(), mesh.triangles.size());
    EXPECT_EQ(mesh.regions.size(), mesh.triangles.size());
    EXPECT_EQ(mesh.corner_of_vertex.size(), mesh.positions.size());
}

// No directed edge twice, neither beside its reverse in the same triangle; neighbours are what the edges say.
inline void expect_edges(const Mesh& mesh) {
    std::map<Edge, uint32_t> triangle_with;
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const Triple& corners = mesh.triangles[t];
        for (uint32_t k = 0; k < 3; ++k) {
            ASSERT_LT(corners[k], mesh.vertex_count()) << "triangle " << t;
            ASSERT_NE(corners[k], corners[(k + 1) % 3]) << "triangle " << t;
            const bool is_new = triangle_with.try_emplace({corners[k], corners[(k + 1) % 3]}, t).second;
            EXPECT_TRUE(is_new) << "edge " << corners[k] << "-" << corners[(k + 1) % 3] << " of triangle " << t;
        }
    }
    for (const auto& [edge, t] : triangle_with) {
        const auto across = triangle_with.find({edge.second, edge.first});
        const uint32_t expected = across == triangle_with.end() ? no_index : across->second;
        const Triple& corners = mesh.triangles[t];
        const uint32_t k = corners[0] == edge.first ? 0 : corners[1] == edge.first ? 1 : 2;
        EXPECT_EQ(mesh.neighbours[t][k], expected) << "triangle " << t << ", edge " << k;
    }
}

// Turning from corner_of_vertex meets every corner of the vertex once, at a border too.
inline void expect_fans(const Mesh& mesh) {
    std::vector<uint32_t> corners(mesh.vertex_count(), 0);
    for (const Triple& triangle : mesh.triangles) {
        for (uint32_t vertex : triangle) ++corners[vertex];
    }
    for (uint32_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
        ASSERT_GT(corners[vertex], 0u) << "vertex " << vertex;
        const Corner first = mesh.corner_of_vertex[vertex];
        ASSERT_LT(first, 3 * mesh.triangle_count()) << "vertex " << vertex;
        Corner corner = first;
        uint32_t met = 0;
        do {
            ASSERT_EQ(mesh.vertex_at(corner), vertex);
            corner = mesh.turn(corner);
            ++met;
        } while (corner != first && corner != no_index && met <= corners[vertex]);
        EXPECT_EQ(met, corners[vertex]) << "vertex " << vertex;
    }
}

}  // namespace valid

inline void expect_valid(const Mesh& mesh) {
    valid::expect_sizes(mesh);
    valid::expect_edges(mesh);
    if (::testing::Test::HasFatalFailure()) return;
    valid::expect_fans(mesh);
    for (uint32_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
        for (float x : mesh.positions[vertex]) EXPECT_TRUE(std::isfinite(x)) << "vertex " << vertex;
    }
}

// V - E + F, from the triangles alone.
inline int64_t euler_number(const Mesh& mesh) {
    std::map<valid::Edge, bool> edges;
    for (const Triple& corners : mesh.triangles) {
        for (uint32_t k = 0; k < 3; ++k) edges[std::minmax(corners[k], corners[(k + 1) % 3])] = true;
    }
    return int64_t{mesh.vertex_count()} - static_cast<int64_t>(edges.size()) + mesh.triangle_count();
}

}  // namespace flg::test
