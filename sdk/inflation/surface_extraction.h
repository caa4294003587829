// SPDX-License-Identifier: MIT
// The dual surface of a lattice: a vertex for each sheet of the surface in a cell, a polygon for each crossed edge (Nielson:
// Dual marching cubes, 2004; vertices at the mean of the crossings: Gibson, Constrained elastic surface nets, 1998).
//
// Why it is closed and a manifold, whatever the values. Sheets are loops of segments on the faces of a cell; both cells of a face
// cut it the same way. So each segment is passed by one edge of the dual surface, between the sheets on its two sides, and joins
// two crossed edges, whose polygons meet there; and the polygons of a sheet follow each other around its loop. Two cells may
// have two segments of one face in common within one sheet each (the known flaw of dual marching cubes): then both edges get a
// vertex in their middle. Polygons with such a vertex get one in their centre, others are cut along the shorter diagonal.
#pragma once

#include <map>
#include <vector>

#include "inflation/surface_grid.h"

namespace flg {

class SurfaceExtraction {
public:
    // Of a grid that is done. All outlive the kernel.
    SurfaceExtraction(const SurfaceGrid& grid, std::pmr::vector<Vec3>& positions,
                      std::pmr::vector<TriangleVertices>& triangles, Memory* memory);

    // A unit is about 0.5 us: a row of cells.
    bool run(uint32_t count);

private:
    enum class Pass { vertices, polygons, done };

    struct Cell {
        uint32_t block = 0;
        std::array<uint32_t, 3> at{};  // in the block
        uint32_t inside = 0;           // its corners
    };

    const SurfaceGrid::Block& block(uint32_t index) const { return blocks_[index]; }
    void place_vertices(uint32_t x, uint32_t y, uint32_t z);
    void add_polygon(uint32_t axis, uint32_t x, uint32_t y, uint32_t z);
    Cell cell_at(std::array<uint32_t, 3> at) const;
    uint32_t vertex_of(const Cell& cell, uint32_t edge) const;

    const SurfaceGrid& grid_;
    const std::pmr::vector<SurfaceGrid::Block>& blocks_;
    std::pmr::vector<Vec3>& positions_;
    std::pmr::vector<TriangleVertices>& triangles_;
    std::pmr::map<std::array<uint32_t, 5>, uint32_t> middles_;  // by face and the corner outside that is cut off
    Pass pass_ = Pass::vertices;
    uint32_t block_ = 0, at_ = 0;
};

}  // namespace flg
