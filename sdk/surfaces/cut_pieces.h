// SPDX-License-Identifier: MIT
// Puts the pieces of a cut triangle in its place: the first overwrites it, the others are appended; neighbours, corners
// of vertices and regions follow, here and across the edges.
#pragma once

#include <vector>

#include "surfaces/cut_triangles.h"
#include "surfaces/mesh_edit.h"

namespace flg {

// A triangulation of one triangle. Its neighbours are pieces, or outer_edge | k: the piece's edge lies on edge k of the
// triangle.
struct Pieces {
    static constexpr uint32_t outer_edge = 0xfffffffcu;

    explicit Pieces(Memory* memory) : triangles(memory), neighbours(memory), regions(memory) {}
    void clear() {
        triangles.clear();
        neighbours.clear();
        regions.clear();
    }
    void add(const Triple& vertices, const Triple& across, uint32_t region) {
        triangles.push_back(vertices);
        neighbours.push_back(across);
        regions.push_back(region);
    }
    uint32_t size() const { return static_cast<uint32_t>(triangles.size()); }

    std::pmr::vector<Triple> triangles;  // vertices of the mesh, counter-clockwise
    std::pmr::vector<Triple> neighbours;
    std::pmr::vector<uint32_t> regions;
};

class PieceWriter {
public:
    // Slots are written in rising order; the mesh has room for all.
    PieceWriter(Mesh& mesh, MeshEdit& edit, Buffer<CutTriangle>& slots) : mesh_(mesh), edit_(edit), slots_(slots) {}

    void write(CutTriangle& slot, const Pieces& pieces);

private:
    void write_outer(CutTriangle& slot, const Triple& corners, uint32_t k, Corner corner);

    Mesh& mesh_;
    MeshEdit& edit_;
    Buffer<CutTriangle>& slots_;
    Triple across_{};  // of the triangle being replaced
};

}  // namespace flg
