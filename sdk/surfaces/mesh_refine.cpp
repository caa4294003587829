// SPDX-License-Identifier: MIT
#include "surfaces/mesh_refine.h"

#include "core/failure.h"
#include "surfaces/mesh_repair_input.h"

namespace flg {

namespace {

constexpr uint32_t triangles_chunk = 300;  // triangles, about 10 us
constexpr uint32_t values_chunk = 100;     // corners, about 10 us

}  // namespace

RefineTrianglesKernel::RefineTrianglesKernel(const Mesh& coarse, Mesh& fine, Memory* memory)
    : coarse_(coarse), fine_(fine), memory_(memory), next_vertex_(coarse.vertex_count()) {}

void RefineTrianglesKernel::make_room() {
    const size_t triangles = coarse_.triangles.size();
    const size_t edges = (3 * triangles + border_edges_) / 2;
    fine_.positions = GrowingBuffer<Position>(coarse_.positions.size() + edges, memory_);
    fine_.corner_of_vertex = GrowingBuffer<uint32_t>(coarse_.positions.size() + edges, memory_);
    fine_.triangles = GrowingBuffer<Triple>(4 * triangles, memory_);
    fine_.neighbours = GrowingBuffer<Triple>(4 * triangles, memory_);
    fine_.regions = GrowingBuffer<uint32_t>(4 * triangles, memory_);
}

void RefineTrianglesKernel::split(uint32_t triangle) {
    const uint32_t middle = 4 * triangle + 3;
    Triple& halves = fine_.triangles[middle];  // the vertices on the edges
    Triple across[3];                          // beyond the first half of each edge, and beyond the second
    for (uint32_t k = 0; k < 3; ++k) {
        const Corner other = coarse_.opposite(3 * triangle + k);
        if (is_edge_owner(coarse_, 3 * triangle + k)) {
            // The first corner of the new vertex's fan, should this be a border.
            fine_.corner_of_vertex[next_vertex_] = 3 * (4 * triangle + (k + 1) % 3) + 2;
            halves[k] = next_vertex_++;
        } else {
            halves[k] = fine_.triangles[4 * triangle_of(other) + 3][other % 3];
        }
        const bool is_open = other == no_index;
        across[k][0] = is_open ? no_index : 4 * triangle_of(other) + next_corner(other) % 3;
        across[k][1] = is_open ? no_index : 4 * triangle_of(other) + other % 3;
    }
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t before = (k + 2) % 3, part = 4 * triangle + k, vertex = coarse_.triangles[triangle][k];
        fine_.triangles[part] = {vertex, halves[k], halves[before]};
        fine_.neighbours[part] = {across[k][0], middle, across[before][1]};
        fine_.neighbours[middle][before] = part;
        if (coarse_.corner_of_vertex[vertex] == 3 * triangle + k) fine_.corner_of_vertex[vertex] = 3 * part;
    }
    for (uint32_t k = 0; k < 4; ++k) fine_.regions[4 * triangle + k] = coarse_.regions[triangle];
}

bool RefineTrianglesKernel::run(uint32_t count) {
    for (; counted_ < coarse_.triangle_count(); --count) {
        if (count == 0) return false;
        for (uint32_t neighbour : coarse_.neighbours[counted_]) border_edges_ += neighbour == no_index;
        if (++counted_ == coarse_.triangle_count()) make_room();
    }
    for (; at_ < coarse_.triangle_count(); --count) {
        if (count == 0) return false;
        split(at_++);
    }
    return true;
}

Task<void> refine_mesh(Pace& pace, Mesh& mesh, MeshColumns& columns, RefineRule rule, uint32_t levels) {
    uint64_t corners = uint64_t{3} * mesh.triangle_count();
    for (uint32_t level = 0; level < levels; ++level) {
        corners *= 4;
        if (corners > mesh_corners_max) {
            throw Failure(FLG_ERROR_LIMIT, "%u triangles refined %u times would be more than the limit of %u",
                          mesh.triangle_count(), levels, mesh_corners_max / 3);
        }
    }
    for (uint32_t level = 0; level < levels; ++level) {
        Mesh fine(pace.memory());
        RefineTrianglesKernel triangles(mesh, fine, pace.memory());
        while (!triangles.run(triangles_chunk)) co_await pace;
        MeshColumns fine_columns(pace.memory());
        RefineValuesKernel values(mesh, columns, rule, fine, fine_columns, pace.memory());
        while (!values.run(values_chunk)) co_await pace;
        mesh = std::move(fine);
        columns = std::move(fine_columns);
    }
}

}  // namespace flg
