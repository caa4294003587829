// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_blocks_update.h"

#include <algorithm>

namespace flg {

GeodesicBlocksUpdateKernel::GeodesicBlocksUpdateKernel(const Mesh& mesh, const GrowingBuffer<Position>& positions,
                                                       std::span<const uint32_t> touched, GeodesicBlocks& blocks)
    : touched_(touched),
      blocks_(blocks),
      fans_(mesh, positions, blocks),
      before_(blocks.vertex_count()),
      after_(mesh.vertex_count()) {
    const size_t ranks = blocks.blocks.size() + (after_ > before_ ? after_ - before_ : 0);
    if (ranks <= blocks.blocks.capacity()) return;
    growing_ = true;
    room_ = ranks + ranks / 8;
    blocks.blocks.begin_growth(room_);
    blocks.overflow_of_rank.begin_growth(room_);
    blocks.curvatures.begin_growth(room_);
    blocks.vertex_of_rank.begin_growth(room_);
    blocks.rank_of_vertex.begin_growth(room_);
}

uint32_t GeodesicBlocksUpdateKernel::pass_size() const {
    const uint32_t touched = static_cast<uint32_t>(touched_.size());
    const uint32_t added = after_ > before_ ? after_ - before_ : 0;
    switch (pass_) {
        case Pass::grow: return growing_ ? UINT32_MAX : 0;
        case Pass::remove: return before_ > after_ ? before_ - after_ : 0;
        case Pass::add:
        case Pass::build_added:
        case Pass::finish_added: return added;
        default: return touched;
    }
}

bool GeodesicBlocksUpdateKernel::run(uint32_t count) {
    while (pass_ != Pass::done) {
        if (at_ >= pass_size()) {
            at_ = 0;
            pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
            continue;
        }
        if (count-- == 0) return false;
        step(at_++);
    }
    return true;
}

void GeodesicBlocksUpdateKernel::step(uint32_t i) {
    switch (pass_) {
        case Pass::grow: grow(); break;
        case Pass::remove: {
            const uint32_t rank = blocks_.rank_of_vertex[before_ - 1 - i];
            forget(rank);
            blocks_.blocks[rank] = {};
            blocks_.vertex_of_rank[rank] = no_index;
            blocks_.rank_of_vertex.resize(before_ - 1 - i);
            break;
        }
        case Pass::add: {
            const uint32_t rank = blocks_.rank_count();
            blocks_.blocks.resize(rank + 1);
            blocks_.blocks[rank] = {};
            blocks_.overflow_of_rank.push_back(no_index);
            blocks_.curvatures.push_back(0);
            blocks_.vertex_of_rank.push_back(before_ + i);
            blocks_.rank_of_vertex.push_back(rank);
            break;
        }
        case Pass::forget:
            if (touched_[i] < before_) forget(blocks_.rank_of_vertex[touched_[i]]);
            break;
        case Pass::build_touched:
            if (touched_[i] < before_) fans_.build(blocks_.rank_of_vertex[touched_[i]]);
            break;
        case Pass::build_added: fans_.build(blocks_.rank_of_vertex[before_ + i]); break;
        case Pass::finish_touched:
            if (touched_[i] < before_) finish_around(blocks_.rank_of_vertex[touched_[i]]);
            break;
        case Pass::finish_added: finish_around(blocks_.rank_of_vertex[before_ + i]); break;
        case Pass::done: break;
    }
}

// One element of each array.
void GeodesicBlocksUpdateKernel::grow() {
    bool moved = true;
    const auto grow = [&](auto& array) {
        if (array.capacity() < room_) moved &= array.grow(1);
    };
    grow(blocks_.blocks);
    grow(blocks_.overflow_of_rank);
    grow(blocks_.curvatures);
    grow(blocks_.vertex_of_rank);
    grow(blocks_.rank_of_vertex);
    growing_ = !moved;
}

// Takes the vertex's edges out of the scale.
void GeodesicBlocksUpdateKernel::forget(uint32_t rank) {
    visit_blocks(blocks_, rank, [&](const GeodesicBlock& block, uint32_t first_lane) {
        for (uint32_t lane = first_lane; lane < lane_count; ++lane) {
            if (block.rank(lane) != nowhere) blocks_.edges.remove(block.lengths[lane]);
        }
    });
}

void GeodesicBlocksUpdateKernel::finish_around(uint32_t rank) {
    fans_.finish(rank);
    visit_blocks(blocks_, rank, [&](const GeodesicBlock& block, uint32_t) {
        for (uint32_t lane = 0; lane < lane_count; ++lane) {
            if (block.rank(lane) != nowhere) fans_.finish(block.rank(lane));
        }
    });
}

}  // namespace flg
