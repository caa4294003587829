// SPDX-License-Identifier: MIT
// From triangles around a vertex, some of which are flipped (intrinsic_triangles.h), to its blocks.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "surfaces/geodesics/geodesic_blocks.h"

namespace flg {

// Fills the blocks of a fan one after the other; next_block() gives them.
template <class NextBlock>
class FanWriter {
public:
    explicit FanWriter(NextBlock next_block) : next_block_(next_block), block_(&next_block_()) {}

    // `tangent` is that of the triangle before the neighbour.
    void add(uint32_t neighbour, float length, float tangent) {
        if (used_ == lane_count) {
            const uint32_t shared = block_->lanes[lane_count - 1];
            const float shared_length = block_->lengths[lane_count - 1];
            block_->lanes[lane_count - 1] |= block_continues;
            block_->tangents[lane_count - 1] = 0;
            block_ = &next_block_();
            block_->lanes[0] = shared;
            block_->lengths[0] = shared_length;
            used_ = 1;
        }
        if (used_ > 0) block_->tangents[used_ - 1] = tangent;
        block_->lanes[used_] = neighbour;
        block_->lengths[used_++] = length;
    }
    void end() {
        for (uint32_t lane = used_; lane < lane_count; ++lane) {
            block_->lanes[lane] = nowhere;
            block_->lengths[lane] = no_length;
        }
        std::fill(block_->tangents.begin() + used_ - 1, block_->tangents.end(), 0.0f);
    }

private:
    NextBlock next_block_;
    GeodesicBlock* block_;
    uint32_t used_ = 0;  // lanes of it
};

// The fan of a vertex in flipped triangles, as lanes.
class IntrinsicFan {
public:
    IntrinsicFan(const GeodesicBlocks& blocks, const IntrinsicSurface& surface, Memory* memory)
        : blocks_(blocks), surface_(surface), lanes_(memory), corners_(memory) {}

    // Of a vertex, from some of its corners, each of another stretch of triangles that hang together or of the same;
    // then the edges of the mesh that were flipped. False if none of the triangles is flipped.
    bool gather(uint32_t vertex, std::span<const Corner> corners);
    template <class Writer>
    void write(Writer& writer) const {
        for (const Lane& lane : lanes_) writer.add(lane.rank, lane.length, lane.tangent);
        writer.end();
    }

private:
    struct Lane {
        uint32_t rank;
        float length, tangent;  // the triangle's before it
    };
    void gather_stretch(Corner corner);
    void gather_edges(uint32_t vertex);

    const GeodesicBlocks& blocks_;
    const IntrinsicSurface& surface_;
    std::pmr::vector<Lane> lanes_;
    std::pmr::vector<Corner> corners_;
    bool is_flipped_ = false;
};

// Of triangles that were changed, the corners by vertex.
struct CornerOfVertex {
    uint32_t vertex;
    Corner corner;
};
Task<Buffer<CornerOfVertex>> corners_by_vertex(Pace& pace, const IntrinsicSurface& surface,
                                               const std::pmr::deque<uint32_t>& triangles);

}  // namespace flg
