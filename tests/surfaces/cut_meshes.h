// SPDX-License-Identifier: MIT
// What the tests of cutting share: cutting in one call, and what must not change by it.
#pragma once

#include <bit>

#include "runtime/run_now.h"
#include "surfaces/cutting/cut_isolines.h"
#include "surfaces/cutting/cut_pieces.h"
#include "surfaces/expect_valid.h"
#include "surfaces/mesh/mesh_edit.h"
#include "surfaces/test_meshes.h"

namespace flg::test {

inline MeshColumn make_column(const Mesh& mesh, const std::function<double(const Vec3&)>& value) {
    MeshColumn column{1, GrowingBuffer<float>(mesh.vertex_count(), test_memory())};
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) column.values[v] = static_cast<float>(value(mesh.position(v)));
    return column;
}

// Cuts along the isolines of column `field`; in all regions that there are if none are listed, with the interval as
// label.
inline void cut_isolines(Mesh& mesh, MeshColumns& columns, uint32_t field, const std::vector<float>& levels,
                         MeshEdit& edit, const std::vector<RegionLevels>& regions = {{0, 0}}, bool haltingly = false) {
    const CutLevels cut_levels(levels, regions);
    run_now(
        test_memory(), [&](Pace& pace) { return embed_isolines(pace, mesh, columns, field, cut_levels, edit); },
        haltingly);
}

inline Vec3 area_vector(const Mesh& mesh, uint32_t triangle) {
    const auto [a, b, c] = mesh.triangles[triangle];
    return 0.5 * (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a));
}

inline double area_of(const Mesh& mesh) {
    double area = 0;
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) area += area_vector(mesh, t).norm();
    return area;
}

inline double area_of(const Mesh& mesh, uint32_t region) {
    double area = 0;
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        if (mesh.regions[t] == region) area += area_vector(mesh, t).norm();
    }
    return area;
}

// All arrays, as words.
inline std::vector<uint32_t> bits_of(const Mesh& mesh, const MeshColumns& columns) {
    std::vector<uint32_t> words;
    const auto append = [&](const auto& buffer) {
        for (const auto& item : buffer) {
            if constexpr (sizeof item == 4) {
                words.push_back(std::bit_cast<uint32_t>(item));
            } else {
                for (const auto& word : item) words.push_back(std::bit_cast<uint32_t>(word));
            }
        }
        words.push_back(static_cast<uint32_t>(buffer.size()));
    };
    append(mesh.positions);
    append(mesh.triangles);
    append(mesh.neighbours);
    append(mesh.regions);
    append(mesh.corner_of_vertex);
    for (const MeshColumn& column : columns) append(column.values);
    return words;
}

inline void replay(Mesh& mesh, MeshColumns& columns, MeshEdit& edit, MeshEditReplay::Direction direction,
                   uint32_t slice = 1000) {
    MeshEditReplay kernel(mesh, columns, edit, direction);
    while (!kernel.run(slice)) {}
}

}  // namespace flg::test
