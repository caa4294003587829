// SPDX-License-Identifier: MIT
// Repairs of soups, each checked in full: the mesh by its invariants, the maps against the input. And soups to repair.
#pragma once

#include <algorithm>
#include <string>

#include "core/failure.h"
#include "runtime/run_now.h"
#include "surfaces/expect_valid.h"
#include "surfaces/repair/mesh_repair.h"
#include "surfaces/test_meshes.h"

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
    const auto make = [&](Pace& pace) { return repair_mesh(pace, input.view, options, repaired); };
    run_now(test_memory(), make, haltingly);
    expect_valid(repaired.mesh);
    EXPECT_EQ(repaired.report.topology.euler_number, euler_number(repaired.mesh));
    expect_maps(input, repaired, options.weld_distance.value_or(0));
    return repaired;
}

inline RepairedMesh repair(const Soup& soup, RepairOptions options = {}) {
    return repair(RepairInput(soup), options);
}

inline bool is_clean(const MeshReport& report) {
    return report.welded_vertices == 0 && report.degenerate_triangles == 0 && report.duplicate_triangles == 0 &&
           report.crowded_edges == 0 && report.flipped_triangles == 0 && report.cut_edges == 0 &&
           report.split_vertices == 0 && report.unused_vertices == 0;
}

inline void append(Soup& soup, const Soup& other, const Vec3& offset) {
    const uint32_t first = static_cast<uint32_t>(soup.positions.size());
    for (const Position& p : other.positions) soup.positions.push_back(to_position(load_vec3(p.data()) + offset));
    for (const Triple& t : other.triangles) soup.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

// Each triangle with three vertices of its own, as files without indices have them.
inline Soup exploded(const Soup& soup) {
    Soup apart;
    for (const Triple& t : soup.triangles) {
        const uint32_t first = static_cast<uint32_t>(apart.positions.size());
        for (uint32_t v : t) apart.positions.push_back(soup.positions[v]);
        apart.triangles.push_back({first, first + 1, first + 2});
    }
    return apart;
}

// A strip of `length` squares, the ends joined after half a turn if `twisted`.
inline Soup band(uint32_t length, bool twisted) {
    Soup soup;
    for (uint32_t i = 0; i < length; ++i) {
        const double angle = 2 * std::numbers::pi * i / length, tilt = twisted ? angle / 2 : 0;
        for (double side : {-0.3, 0.3}) {
            const double r = 1 + side * std::cos(tilt);
            soup.positions.push_back(
                to_position({r * std::cos(angle), r * std::sin(angle), side * std::sin(tilt) + (twisted ? 0 : side)}));
        }
    }
    for (uint32_t i = 0; i < length; ++i) {
        const bool last = i + 1 == length;
        const uint32_t a = 2 * i, b = 2 * i + 1;
        uint32_t c = last ? 0 : 2 * i + 2, d = last ? 1 : 2 * i + 3;
        if (last && twisted) std::swap(c, d);
        soup.triangles.push_back({a, c, b});
        soup.triangles.push_back({c, d, b});
    }
    return soup;
}

// The unit cube at `corner`, on vertices that are shared with what is there.
inline void append_cube(Soup& soup, const Vec3& corner) {
    uint32_t at[8];
    for (uint32_t i = 0; i < 8; ++i) {
        const Position place = to_position(corner + Vec3(i & 1, i >> 1 & 1, i >> 2 & 1));
        const auto found = std::find(soup.positions.begin(), soup.positions.end(), place);
        at[i] = static_cast<uint32_t>(found - soup.positions.begin());
        if (found == soup.positions.end()) soup.positions.push_back(place);
    }
    constexpr uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& q : quads) {
        soup.triangles.push_back({at[q[0]], at[q[1]], at[q[2]]});
        soup.triangles.push_back({at[q[0]], at[q[2]], at[q[3]]});
    }
}

inline std::string failure_of(const RepairInput& input, RepairOptions options = {}) {
    try {
        RepairedMesh repaired(test_memory());
        run_now(test_memory(), [&](Pace& pace) { return repair_mesh(pace, input.view, options, repaired); });
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "";
}

}  // namespace flg::test
