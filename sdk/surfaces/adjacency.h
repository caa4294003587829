// SPDX-License-Identifier: MIT
// The neighbours of each triangle and a corner of each vertex, from the triangles alone; without a hash map: corners are
// sorted by vertex (by counting), then each vertex finds the edges that leave it among its few corners.
#pragma once

#include "surfaces/mesh.h"

namespace flg {

// Needs a manifold mesh whose winding is consistent (mesh_repair.h makes it so). Memory: 4 bytes a corner and vertex while
// it runs.
class AdjacencyKernel {
public:
    AdjacencyKernel(Mesh& mesh, Memory* memory);

    // Advances by `count` triangles or vertices; true when done. Four passes over the triangles or vertices.
    bool run(uint32_t count);

private:
    enum class Pass { clear, count, sum, fill, join, done };

    void join_edges_from(uint32_t vertex);
    void choose_corner(uint32_t vertex);

    Mesh& mesh_;
    Buffer<uint32_t> first_;  // where the corners of a vertex begin; while filling, where its next one goes
    Buffer<Corner> corners_;  // sorted by vertex
    Pass pass_ = Pass::clear;
    uint32_t at_ = 0;
    uint32_t sum_ = 0;
};

}  // namespace flg
