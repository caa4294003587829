// SPDX-License-Identifier: MIT
// Which vertices are the same place. In order of index, a vertex joins the first vertex before it that lies within the
// distance and was not itself joined to another; so that joining never runs along a chain of vertices.
//
// Vertices that others can join are kept in chains by the cell they lie in, cells of twice the distance wide, so that
// eight cells hold whatever is near. Chains start in a table of one entry a vertex, found by the cell's hash.
#pragma once

#include "surfaces/mesh.h"

namespace flg {

// A unit is a vertex: about 50 ns at distance 0, 300 ns else. Memory: 8 to 12 bytes a vertex, and 4 for the result.
class VertexWeldKernel {
public:
    // distance: metres, finite, >= 0; at 0 vertices are joined whose coordinates are equal. `positions` outlives the kernel.
    VertexWeldKernel(const GrowingBuffer<Position>& positions, float distance, Memory* memory);
    bool run(uint32_t count);

    // After run() returned true.
    uint32_t welded_count() const { return welded_count_; }
    // The vertex that each one is from now on; itself if it was not joined.
    Buffer<uint32_t> take() { return std::move(joined_to_); }

private:
    void weld(uint32_t vertex);
    // The least vertex of the cell's chain within the distance; `least` if that is less.
    uint32_t find(uint32_t cell, const Vec3& position, uint32_t least) const;
    uint32_t cell_of(const Vec3& cell) const;

    const GrowingBuffer<Position>& positions_;
    double distance_;
    Buffer<uint32_t> first_in_cell_;  // a power of two of them
    Buffer<uint32_t> next_in_cell_;
    Buffer<uint32_t> joined_to_;
    uint32_t cleared_ = 0;
    uint32_t at_ = 0;
    uint32_t welded_count_ = 0;
};

}  // namespace flg
