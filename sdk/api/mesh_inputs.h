// SPDX-License-Identifier: MIT
// Hosts' meshes, copied for jobs.
#pragma once

#include <algorithm>

#include "api/columns.h"
#include "api/inputs.h"
#include "surfaces/surface_jobs.h"

namespace flg {

inline Buffer<uint32_t> copy_words(const uint32_t* words, size_t count, Memory* memory) {
    Buffer<uint32_t> copy(count, memory);
    std::copy_n(words, count, copy.data());
    return copy;
}

// Counts that are no mesh's, but a mistake: before arrays are read that far.
inline void check_counts(const FlgMeshView& mesh) {
    constexpr uint32_t max_vertices = 1u << 31, max_triangles = 1u << 30;
    if (mesh.vertex_count > max_vertices) {
        throw Failure(FLG_ERROR_LIMIT, "desc.mesh.vertex_count is %u, more than the limit of 2^31", mesh.vertex_count);
    }
    if (mesh.triangle_count > max_triangles) {
        throw Failure(FLG_ERROR_LIMIT, "desc.mesh.triangle_count is %u, more than the limit of 2^30",
                      mesh.triangle_count);
    }
}

// The host's arrays, checked as far as one pass can and packed; refuse(column, bad) throws. The job checks indices and
// positions.
template <class Refuse>
std::shared_ptr<MeshInput> copy_mesh(Memory* memory, const FlgMeshView& mesh, const Refuse& refuse) {
    check_counts(mesh);
    if (mesh.triangle_count > 0) require(mesh.triangles, "desc.mesh.triangles");
    check_columns(mesh.columns, mesh.column_count, "desc.mesh");
    auto input = make_object<MeshInput>(memory, memory);
    input->view = mesh;
    input->triangles = copy_words(mesh.triangles, size_t{3} * mesh.triangle_count, memory);
    input->view.triangles = input->triangles.data();
    if (mesh.regions) {
        input->regions = copy_words(mesh.regions, mesh.triangle_count, memory);
        input->view.regions = input->regions.data();
        const uint32_t* largest = std::max_element(input->regions.begin(), input->regions.end());
        if (largest != input->regions.end() && *largest > FLG_REGION_MAX) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.mesh.regions[%td] is %u, the largest label is %u",
                          largest - input->regions.begin(), *largest, FLG_REGION_MAX);
        }
    }
    for (uint32_t c = 0; c < mesh.column_count; ++c) {
        FlgColumn column = mesh.columns[c];
        input->values.emplace_back(size_t{mesh.vertex_count} * column.components, memory);
        const BadValue bad = copy_column(column, 0, mesh.vertex_count, input->values.back().data());
        if (bad.rule) refuse(c, bad);
        column.data = input->values.back().data();
        column.stride = 0;
        input->columns.push_back(column);
    }
    input->view.columns = input->columns.data();
    return input;
}

// What a descriptor's `mesh` shows.
inline std::shared_ptr<MeshInput> copy_described_mesh(Memory* memory, const FlgMeshView& mesh) {
    return copy_mesh(memory, mesh, [](uint32_t column, const BadValue& bad) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.mesh.columns[%u] holds %g at vertex %u, %s", column,
                      static_cast<double>(bad.value), bad.row, bad.rule);
    });
}

}  // namespace flg
