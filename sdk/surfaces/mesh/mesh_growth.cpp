// SPDX-License-Identifier: MIT
#include "surfaces/mesh/mesh_growth.h"

namespace flg {

void resize_mesh(Mesh& mesh, MeshColumns& columns, uint32_t vertices, uint32_t triangles) {
    mesh.positions.resize(vertices);
    mesh.corner_of_vertex.resize(vertices);
    mesh.triangles.resize(triangles);
    mesh.neighbours.resize(triangles);
    mesh.regions.resize(triangles);
    if (mesh.source_triangles.size() != 0) mesh.source_triangles.resize(triangles);
    for (MeshColumn& column : columns) column.values.resize(size_t{column.components} * vertices);
}

Task<void> give_back(Pace& pace, Mesh& mesh, MeshColumns& columns) {
    mesh.positions = {};
    co_await pace;
    mesh.triangles = {};
    co_await pace;
    mesh.neighbours = {};
    co_await pace;
    mesh.regions = {};
    co_await pace;
    mesh.source_triangles = {};
    co_await pace;
    mesh.corner_of_vertex = {};
    while (mesh.region_blocks.give_back()) co_await pace;
    for (; !columns.empty(); columns.pop_back()) co_await pace;
}

template <class T>
bool MeshGrowth::grow(GrowingBuffer<T>& buffer, size_t needed, uint32_t count) {
    if (!growing_) {
        if (buffer.capacity() >= needed) return true;
        buffer.begin_growth(needed + needed / 4);
        growing_ = true;
    }
    growing_ = !buffer.grow(count);
    return !growing_;
}

bool MeshGrowth::run(uint32_t count) {
    bool grown = false;
    switch (array_) {
        case 0: grown = grow(mesh_.positions, vertices_, count); break;
        case 1: grown = grow(mesh_.corner_of_vertex, vertices_, count); break;
        case 2: grown = grow(mesh_.triangles, triangles_, count); break;
        case 3: grown = grow(mesh_.neighbours, triangles_, count); break;
        case 4: grown = grow(mesh_.regions, triangles_, count); break;
        case 5: grown = mesh_.source_triangles.size() == 0 || grow(mesh_.source_triangles, triangles_, count); break;
        default:
            if (array_ - 6 == columns_.size()) return true;
            MeshColumn& column = columns_[array_ - 6];
            grown = grow(column.values, size_t{column.components} * vertices_, count);
    }
    if (grown) ++array_;
    return array_ - 6 == columns_.size();
}

}  // namespace flg
