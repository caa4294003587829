// SPDX-License-Identifier: MIT
#include "surfaces/adjacency.h"

namespace flg {

namespace {

GrowingBuffer<Triple>& room_for_neighbours(Mesh& mesh, Memory* memory) {
    mesh.neighbours = GrowingBuffer<Triple>(mesh.triangles.size(), memory);
    return mesh.neighbours;
}

}  // namespace

AdjacencyKernel::AdjacencyKernel(Mesh& mesh, Memory* memory)
    : mesh_(mesh), sort_(mesh.triangles, mesh.vertex_count(), room_for_neighbours(mesh, memory), memory) {
    mesh.corner_of_vertex = GrowingBuffer<uint32_t>(mesh.vertex_count(), memory);
}

// At a border (no other corner) the vertex is given the first corner of its fan.
void AdjacencyKernel::join(Corner corner, Corner other) {
    if (other == no_index) {
        mesh_.neighbours[corner / 3][corner % 3] = no_index;
        mesh_.corner_of_vertex[mesh_.vertex_at(corner)] = corner;
    } else {
        mesh_.neighbours[corner / 3][corner % 3] = triangle_of(other);
        mesh_.neighbours[other / 3][other % 3] = triangle_of(corner);
    }
}

bool AdjacencyKernel::run(uint32_t count) {
    if (stage_ == Stage::corners) {
        for (; at_ < mesh_.triangle_count(); ++at_, --count) {
            if (count == 0) return false;
            for (uint32_t k = 0; k < 3; ++k) mesh_.corner_of_vertex[mesh_.triangles[at_][k]] = 3 * at_ + k;
        }
        stage_ = Stage::sort;
    }
    if (stage_ == Stage::sort) {
        if (!sort_.run(count)) return false;
        sorted_ = sort_.take();
        at_ = 0;
        stage_ = Stage::join;
        return false;
    }
    if (stage_ == Stage::join) {
        for (; at_ < sorted_.size(); --count) {
            if (count == 0) return false;
            const Corner corner = sorted_[at_++];
            const bool shared =
                at_ < sorted_.size() && edge_at(mesh_.triangles, sorted_[at_]) == edge_at(mesh_.triangles, corner);
            join(corner, shared ? sorted_[at_++] : no_index);
        }
        sorted_ = {};
        stage_ = Stage::done;
    }
    return true;
}

}  // namespace flg
