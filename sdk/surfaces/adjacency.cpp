// SPDX-License-Identifier: MIT
#include "surfaces/adjacency.h"

namespace flg {

AdjacencyKernel::AdjacencyKernel(Mesh& mesh, Memory* memory)
    : mesh_(mesh), first_(size_t{mesh.vertex_count()} + 1, memory), corners_(3 * mesh.triangles.size(), memory) {
    mesh.neighbours = GrowingBuffer<Triple>(mesh.triangles.size(), memory);
    mesh.corner_of_vertex = GrowingBuffer<uint32_t>(mesh.vertex_count(), memory);
}

// Edges that leave `vertex` meet those that come back from the same neighbour.
void AdjacencyKernel::join_edges_from(uint32_t vertex) {
    for (uint32_t i = first_[vertex]; i < first_[vertex + 1]; ++i) {
        const Corner leaving = corners_[i];
        const uint32_t end = mesh_.vertex_at(next_corner(leaving));
        uint32_t neighbour = no_index;
        for (uint32_t j = first_[vertex]; j < first_[vertex + 1]; ++j) {
            if (mesh_.vertex_at(previous_corner(corners_[j])) == end) neighbour = triangle_of(corners_[j]);
        }
        mesh_.neighbours[leaving / 3][leaving % 3] = neighbour;
    }
}

// Any corner, but at a border the one that nothing lies before, counter-clockwise.
void AdjacencyKernel::choose_corner(uint32_t vertex) {
    Corner chosen = corners_[first_[vertex]];
    for (uint32_t i = first_[vertex]; i < first_[vertex + 1]; ++i) {
        if (mesh_.neighbour_at(corners_[i]) == no_index) chosen = corners_[i];
    }
    mesh_.corner_of_vertex[vertex] = chosen;
}

bool AdjacencyKernel::run(uint32_t count) {
    const uint32_t vertices = mesh_.vertex_count(), triangles = mesh_.triangle_count();
    for (; count > 0 && pass_ != Pass::done; --count) {
        const uint32_t i = at_++;
        uint32_t size = vertices;
        switch (pass_) {
            case Pass::clear:
                first_[i] = 0;
                size = vertices + 1;
                break;
            case Pass::count:
                for (uint32_t vertex : mesh_.triangles[i]) ++first_[vertex];
                size = triangles;
                break;
            case Pass::sum:
                sum_ += first_[i];
                first_[i] = sum_;  // the end of the vertex's corners; filling counts it down to their beginning
                if (i + 1 == vertices) first_[vertices] = sum_;
                break;
            case Pass::fill:
                // From the last triangle to the first, so that each vertex has its corners in rising order.
                for (uint32_t k = 3; k-- > 0;) {
                    const uint32_t triangle = triangles - 1 - i;
                    corners_[--first_[mesh_.triangles[triangle][k]]] = 3 * triangle + k;
                }
                size = triangles;
                break;
            case Pass::join:
                join_edges_from(i);
                choose_corner(i);
                break;
            case Pass::done: break;
        }
        if (at_ >= size) {
            at_ = 0;
            pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
        }
    }
    return pass_ == Pass::done;
}

}  // namespace flg
