// SPDX-License-Identifier: MIT
#include "surfaces/mesh_repair_finish.h"

#include <algorithm>

namespace flg {

namespace {

// Twice the area is the height times the longest edge.
bool is_flat(const Mesh& mesh, const Triple& corners) {
    const Vec3 a = mesh.position(corners[0]), b = mesh.position(corners[1]), c = mesh.position(corners[2]);
    const double longest_sq = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return (b - a).cross(c - a).norm() <= FinishMeshKernel::flat_height * longest_sq;
}

}  // namespace

FinishMeshKernel::FinishMeshKernel(const FlgMeshView& input, const IndexMap& vertices, const IndexMap& triangles,
                                   uint32_t copy_count, Mesh& mesh, Memory* memory)
    : regions_(input.regions),
      vertices_(vertices),
      triangles_(triangles),
      input_vertices_(input.vertex_count),
      first_copy_(mesh.vertex_count() - copy_count),
      mesh_(mesh) {
    mesh.regions = GrowingBuffer<uint32_t>(mesh.triangle_count(), memory);
    mesh.corner_of_vertex = GrowingBuffer<uint32_t>(mesh.vertex_count(), memory);
}

uint32_t FinishMeshKernel::final_number(uint32_t vertex) const {
    if (vertices_.is_identity()) return vertex;
    return vertex < input_vertices_ ? vertices_.of_input[vertex] : vertex - input_vertices_ + first_copy_;
}

// A border vertex gets the corner where its border edge leaves, the first of its fan; others any.
void FinishMeshKernel::finish(uint32_t triangle) {
    Triple& corners = mesh_.triangles[triangle];
    Triple& neighbours = mesh_.neighbours[triangle];
    for (uint32_t k = 0; k < 3; ++k) {
        corners[k] = final_number(corners[k]);
        const bool is_open = neighbours[k] == no_index;
        uint32_t& corner = mesh_.corner_of_vertex[corners[k]];
        if (is_open || corner == no_index) corner = 3 * triangle + k;
        if (!is_open) neighbours[k] = triangle_of(neighbours[k]);
    }
    const uint32_t from = triangles_.is_identity() ? triangle : triangles_.to_input[triangle];
    mesh_.regions[triangle] = regions_ ? regions_[from] : 0;
    flat_count_ += is_flat(mesh_, corners);
}

bool FinishMeshKernel::run(uint32_t count) {
    for (; vertices_done_ < mesh_.vertex_count(); ++vertices_done_, --count) {
        if (count == 0) return false;
        mesh_.corner_of_vertex[vertices_done_] = no_index;
    }
    for (; triangles_done_ < mesh_.triangle_count(); ++triangles_done_, --count) {
        if (count == 0) return false;
        finish(triangles_done_);
    }
    return true;
}

}  // namespace flg
