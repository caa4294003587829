// SPDX-License-Identifier: MIT
// Blocks of some of a mesh's vertices: for a metric that only regions are measured with.
#pragma once

#include "surfaces/geodesics/geodesic_blocks.h"
#include "surfaces/mesh/region_set.h"

namespace flg {

// A vertex that gets a rank, and a block if its fan is wanted.
struct BlockVertex {
    uint32_t vertex;
    bool has_fan;
};

// Ranks are in this order; other vertices have none. Those with a fan have all their neighbours among the others. Edges
// are flipped within `regions` only.
Task<GeodesicBlocks> make_blocks(Pace& pace, const Mesh& mesh, const GrowingBuffer<Position>& positions,
                                 const Buffer<BlockVertex>& vertices, const RegionSet& regions);

}  // namespace flg
