// SPDX-License-Identifier: MIT
// Values of the union of parts on a lattice of cubes, near its surface only: in blocks of 8 x 8 x 8 cells.
//
// Invariants
// - Each crossed edge of the lattice (one end inside, the other not) has its four cells in blocks that are there: blocks begin
//   where the parts' own surfaces are, and go on to the other side of each face that is not all inside or all outside. So no
//   surface ends at a block.
// - A corner that several blocks share has the same value in each, to the bit.
// - The lattice is symmetric about the middle of all parts.
#pragma once

#include <vector>

#include "inflation/dual_table.h"
#include "inflation/part_union.h"

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

    // Both outlive the grid. Throws if there were more than four million blocks to look at.
    SurfaceGrid(const PartUnion& parts, double spacing, Memory* memory);

    // A unit is about 1 us.
    bool run(uint32_t count);

    // Gives back the memory of some blocks; true if none is left. A thousand of them would take too long in one go.
    bool release(uint32_t count);

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
    enum class Pass { clear, seed, next, evaluate, spread, count, done };

    void step();
    void seed();
    void activate(const std::array<int64_t, 3>& at);
    void evaluate_row();
    void spread(uint32_t face);
    void count_row();

    const PartUnion& parts_;
    double spacing_;
    Memory* memory_;
    Vec3 middle_;
    std::array<uint32_t, 3> counts_{};  // of blocks
    std::array<double, 3> half_{};      // of cells
    Buffer<uint32_t> block_at_;
    std::pmr::vector<Block> blocks_;
    uint32_t vertex_count_ = 0, crossed_count_ = 0;
    uint32_t part_ = 0;
    uint32_t block_ = 0;
    Pass pass_ = Pass::clear;
    uint32_t at_ = 0;
};

}  // namespace flg
