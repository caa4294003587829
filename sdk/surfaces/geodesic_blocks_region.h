// SPDX-License-Identifier: MIT
// Blocks of a surface that keeps to some regions: where the regions end, copies of the blocks in which the triangles outside
// are closed. Everywhere else no path leads out, so the surface's own blocks serve.
#pragma once

#include "surfaces/geodesic_blocks.h"
#include "surfaces/region_cursor.h"

namespace flg {

// Memory: 130 bytes a vertex where the regions end. As long as neither the mesh nor its blocks change.
class GeodesicRegion {
public:
    explicit GeodesicRegion(Memory* memory) : blocks_(memory) {}

    // The vertex's own blocks within the regions: the first, and behind it those it continues in; null: the surface's.
    const GeodesicBlock* find(uint32_t rank) const {
        if (slots_.empty()) return nullptr;
        for (uint32_t slot = slot_of(rank);; ++slot) {
            const Slot& found = slots_[slot & mask_];
            if (found.rank == rank) return &blocks_[found.block];
            if (found.rank == nowhere) return nullptr;
        }
    }
    // The block behind one of find(): `number` counts from the vertex's first.
    const GeodesicBlock& block(uint32_t rank, uint32_t number) const {
        uint32_t slot = slot_of(rank);
        while (slots_[slot & mask_].rank != rank) ++slot;
        return blocks_[slots_[slot & mask_].block + number];
    }

private:
    friend class GeodesicRegionKernel;
    struct Slot {
        uint32_t rank, block;
    };
    uint32_t slot_of(uint32_t rank) const { return (rank * 0x9e3779b1u) >> 8; }

    std::pmr::deque<GeodesicBlock> blocks_;
    Buffer<Slot> slots_;  // a hash table, at most half full; its size is a power of two
    uint32_t mask_ = 0;
};

// A unit is 64 triangles outside, a triangle within, or a vertex where the regions end.
class GeodesicRegionKernel {
public:
    // All outlive the kernel.
    GeodesicRegionKernel(const Mesh& mesh, const GeodesicBlocks& blocks, const RegionSet& within,
                         GeodesicRegion& region, Memory* memory);
    bool run(uint32_t count);

private:
    enum class Pass { find, clear, close, done };

    void find_ends(uint32_t triangle);
    void close(uint32_t vertex);
    bool at_end() const;

    const Mesh& mesh_;
    const GeodesicBlocks& surface_;
    const RegionSet& within_;
    GeodesicRegion& region_;
    Memory* memory_;
    std::pmr::deque<uint32_t> ends_;  // vertices where the regions end, some more than once
    RegionCursor cursor_;
    Pass pass_ = Pass::find;
    size_t at_ = 0;
};

}  // namespace flg
