// SPDX-License-Identifier: MIT
// Repairs of soups, each checked in full: the mesh by its invariants, the maps against the input.
#pragma once

#include <algorithm>

#include "surfaces/expect_valid.h"
#include "surfaces/mesh_repair.h"
#include "surfaces/run_task.h"

namespace flg::test {

struct RepairInput {
    explicit RepairInput(const Soup& soup) : triangles(soup.triangles), positions(soup.positions) {
        column.attribute = FLG_ATTRIBUTE_POSITION;
        column.components = 3;
        column.data = positions.empty() ? nullptr : positions.front().data();
        view.struct_size = sizeof view;
        view.vertex_count = static_cast<uint32_t>(positions.size());
        view.triangle_count = static_cast<uint32_t>(triangles.size());
        view.column_count = 1;
        view.columns = &column;
        view.triangles = triangles.empty() ? nullptr : triangles.front().data();
    }
    RepairInput(const RepairInput&) = delete;
    RepairInput& operator=(const RepairInput&) = delete;

    std::vector<Triple> triangles;
    std::vector<Position> positions;
    FlgColumn column{};
    FlgMeshView view{};
};

inline void expect_map(const IndexMap& map, size_t inputs, size_t results) {
    if (map.is_identity()) {
        EXPECT_EQ(inputs, results);
        return;
    }
    ASSERT_EQ(map.of_input.size(), inputs);
    ASSERT_EQ(map.to_input.size(), results);
    for (uint32_t from = 0; from < inputs; ++from) {
        EXPECT_TRUE(map.of_input[from] == no_index || map.of_input[from] < results) << from;
    }
    for (uint32_t from : map.to_input) ASSERT_LT(from, inputs);
}

// Vertices are where those they come from are; triangles have the corners of those they come from (near, if welded).
inline void expect_maps(const RepairInput& input, const RepairedMesh& repaired, float weld_distance) {
    const Mesh& mesh = repaired.mesh;
    expect_map(repaired.vertices, input.positions.size(), mesh.positions.size());
    expect_map(repaired.triangles, input.triangles.size(), mesh.triangles.size());
    if (::testing::Test::HasFatalFailure()) return;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const uint32_t from = repaired.vertices.is_identity() ? v : repaired.vertices.to_input[v];
        EXPECT_EQ(mesh.positions[v], input.positions[from]);
    }
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const uint32_t from = repaired.triangles.is_identity() ? t : repaired.triangles.to_input[t];
        EXPECT_TRUE(repaired.triangles.is_identity() || repaired.triangles.of_input[from] == t) << "triangle " << t;
        for (uint32_t vertex : mesh.triangles[t]) {
            const auto is_near = [&](uint32_t other) {
                const Vec3 apart = load_vec3(input.positions[other].data()) - mesh.position(vertex);
                return apart.norm() <= double{weld_distance};
            };
            EXPECT_TRUE(std::any_of(input.triangles[from].begin(), input.triangles[from].end(), is_near));
        }
    }
}

inline RepairedMesh repair(const RepairInput& input, RepairOptions options = {}, bool haltingly = false) {
    RepairedMesh repaired(test_memory());
    run_task([&](Pace& pace) { return repair_mesh(pace, input.view, options, repaired); }, haltingly);
    expect_valid(repaired.mesh);
    EXPECT_EQ(repaired.report.topology.euler_number, euler_number(repaired.mesh));
    expect_maps(input, repaired, options.weld_distance.value_or(0));
    return repaired;
}

inline RepairedMesh repair(const Soup& soup, RepairOptions options = {}) {
    return repair(RepairInput(soup), options);
}

}  // namespace flg::test
