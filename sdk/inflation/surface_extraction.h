// SPDX-License-Identifier: MIT
// The surface of the union of parts as triangles, in two steps: values on a lattice, and the lattice's dual surface.
//
// Values are on a lattice of cubes, near the surface only: in blocks of 8 x 8 x 8 cells. Invariants
// - Each crossed edge of the lattice (one end inside, the other not) has its four cells in blocks that are there:
//   blocks begin where the parts' own surfaces are, and go on to the other side of each face that is not all inside or
//   all outside. So no surface ends at a block.
// - A corner that several blocks share has the same value in each, to the bit.
// - The lattice is symmetric about the middle of all parts.
//
// The dual surface of a lattice: a vertex for each sheet of the surface in a cell, a polygon for each crossed edge
// (Nielson: Dual marching cubes, 2004; vertices at the mean of the crossings: Gibson, Constrained elastic surface nets,
// 1998).
//
// Why it is closed and a manifold, whatever the values. Sheets are loops of segments on the faces of a cell; both cells
// of a face cut it the same way. So each segment is passed by one edge of the dual surface, between the sheets on its
// two sides, and joins two crossed edges, whose polygons meet there; and the polygons of a sheet follow each other
// around its loop. Two cells may have two segments of one face in common within one sheet each (the known flaw of dual
// marching cubes): then both edges get a vertex in their middle. Polygons with such a vertex get one in their centre,
// others are cut along the shorter diagonal.
#pragma once

#include <vector>

#include "inflation/implicit_parts.h"
#include "runtime/task.h"

namespace flg {

class SurfaceGrid {
public:
    static constexpr uint32_t cells = 8, corners = cells + 1;  // of a block, along each axis
    static constexpr uint32_t no_block = UINT32_MAX;

    struct Block {
        std::array<uint32_t, 3> at;  // in blocks
        Buffer<float> values;        // by corner, x first
        Buffer<uint32_t> vertices;   // by cell, the first of its vertices; for cells with some
    };

    // The parts outlive the grid. Takes about 80 us a block. Throws if there were more than four million blocks to look
    // at.
    static Task<SurfaceGrid> make(Pace& pace, const PartUnion& parts, double spacing);
    // Gives the blocks' memory back: a thousand of them would take too long in one go.
    static Task<void> clear(Pace& pace, SurfaceGrid& grid);

    double spacing() const { return spacing_; }
    const PartUnion& parts() const { return parts_; }
    // Vertices that the dual surface gets, and edges of the lattice that it crosses.
    uint32_t vertex_count() const { return vertex_count_; }
    uint32_t crossed_count() const { return crossed_count_; }
    const std::pmr::vector<Block>& blocks() const { return blocks_; }
    uint32_t block_at(uint32_t x, uint32_t y, uint32_t z) const {
        return block_at_[(size_t{z} * counts_[1] + y) * counts_[0] + x];
    }
    // Of a corner, counted from the first of all.
    Vec3 place(uint32_t x, uint32_t y, uint32_t z) const {
        return middle_ + spacing_ * Vec3(x - half_[0], y - half_[1], z - half_[2]);
    }
    // Which corners of a cell are inside, a bit each.
    static uint32_t inside_corners(const Block& block, uint32_t x, uint32_t y, uint32_t z) {
        const float* v = &block.values[(z * corners + y) * corners + x];
        const auto bit = [&](uint32_t offset, uint32_t place) { return (v[offset] >= 0 ? 1u : 0u) << place; };
        constexpr uint32_t row = corners, layer = corners * corners;
        return bit(0, 0) | bit(1, 1) | bit(row, 2) | bit(row + 1, 3) | bit(layer, 4) | bit(layer + 1, 5) |
               bit(layer + row, 6) | bit(layer + row + 1, 7);
    }

private:
    SurfaceGrid(const PartUnion& parts, double spacing, Memory* memory);
    void seed(const ImplicitPart& part, uint32_t vertex);
    void activate(const std::array<int64_t, 3>& at);
    void evaluate_row(Block& block, uint32_t row) const;
    void spread(uint32_t number, uint32_t face);
    void count_row(Block& block, uint32_t row);

    const PartUnion& parts_;
    double spacing_;
    Memory* memory_;
    Vec3 middle_;
    std::array<uint32_t, 3> counts_{};  // of blocks
    std::array<double, 3> half_{};      // of cells
    Buffer<uint32_t> block_at_;
    std::pmr::vector<Block> blocks_;
    uint32_t vertex_count_ = 0, crossed_count_ = 0;
};

struct DualSurface {
    std::pmr::vector<Vec3> positions;
    std::pmr::vector<TriangleVertices> triangles;
};

// The grid outlives the task. Takes about 0.5 us for each row of eight cells.
Task<DualSurface> extract_surface(Pace& pace, const SurfaceGrid& grid);

}  // namespace flg
