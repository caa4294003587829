// SPDX-License-Identifier: MIT
// The neighbours of each triangle and a corner of each vertex, from the triangles alone; without a hash map: corners are
// sorted by their edges.
#pragma once

#include "surfaces/adjacency_edges.h"

namespace flg {

// Needs a manifold mesh whose winding is consistent (mesh_repair.h makes it so). A unit is a triangle, a corner or a
// vertex: a few nanoseconds. Memory: as EdgeSortKernel.
class AdjacencyKernel {
public:
    AdjacencyKernel(Mesh& mesh, Memory* memory);
    bool run(uint32_t count);

private:
    enum class Stage { corners, sort, join, done };
    void join(Corner corner, Corner other);

    Mesh& mesh_;
    EdgeSortKernel sort_;
    Buffer<Corner> sorted_;
    Stage stage_ = Stage::corners;
    uint32_t at_ = 0;
};

}  // namespace flg
