// SPDX-License-Identifier: MIT
// Blocks of a surface that keeps to some regions: where the regions end, copies of the blocks in which the triangles
// outside are closed. Everywhere else no path leads out, so the surface's own blocks serve. Triangles that were flipped
// together (intrinsic_triangles.h) and reach a region's end are flipped anew, as if nothing lay beyond it.
#pragma once

#include <deque>

#include "surfaces/geodesics/geodesic_blocks.h"
#include "surfaces/mesh/index_table.h"
#include "surfaces/mesh/region_set.h"

namespace flg {

// Memory: 130 bytes a vertex where the regions end. As long as neither the mesh nor its blocks change.
class GeodesicRegion {
public:
    explicit GeodesicRegion(Memory* memory) : blocks_(memory) {}

    // The vertex's own blocks within the regions: the first, and behind it those it continues in; null: the surface's.
    const GeodesicBlock* find(uint32_t rank) const {
        const uint32_t first = first_of_rank_.find(rank);
        return first == no_index ? nullptr : &blocks_[first];
    }
    // The block behind one of find(): `number` counts from the vertex's first.
    const GeodesicBlock& block(uint32_t rank, uint32_t number) const {
        return blocks_[first_of_rank_.find(rank) + number];
    }
    // Metres, of the edges that its own blocks have.
    float longest_edge() const { return longest_edge_; }

private:
    friend class RegionBuilder;
    std::pmr::deque<GeodesicBlock> blocks_;
    IndexTable first_of_rank_;
    float longest_edge_ = 0;
};

// `positions`: those of the metric that the blocks have.
Task<GeodesicRegion> bound_region(Pace& pace, const Mesh& mesh, const GrowingBuffer<Position>& positions,
                                  const GeodesicBlocks& blocks, const RegionSet& within);

}  // namespace flg
