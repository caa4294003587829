// SPDX-License-Identifier: MIT
// What the refined solver walks on: for each vertex the fan of its neighbours in blocks of eight lanes, which one step of
// the solver takes at a time, and the positions beside them. Vertices stand in Morton order (along a space-filling curve:
// near in space is near in memory); a vertex's place in that order is its rank, and solvers count in ranks inside.
//
// Invariants
// - The lanes of a vertex are its neighbours counter-clockwise; lanes l and l + 1 span a triangle with it. A closed fan
//   repeats its first neighbour at the end. Lanes behind the fan's end are `nowhere`.
// - Fans of more than eight lanes go on in the overflow: each further block begins with the last lane of the one before.
//   The top bit of a block's last lane says that another follows: the first overflow block of a vertex is at
//   overflow_of_rank, further ones are behind it.
// - Rank 0 is `nowhere`: not a number in position, so that any test it takes part in fails.
// - Nothing here depends on the order in which blocks were made, but the ranks; and no distance depends on ranks. So blocks
//   that are updated give the distances of blocks built anew.
#pragma once

#include <array>
#include <deque>

#include "surfaces/mesh.h"

namespace flg {

constexpr uint32_t lane_count = 8;
constexpr uint32_t nowhere = 0;                 // a rank
constexpr uint32_t block_continues = 1u << 31;  // in the last lane

struct alignas(32) GeodesicBlock {
    std::array<uint32_t, lane_count> lanes;  // ranks
};

// A position in memory as vector registers take it.
struct alignas(16) RankedPosition {
    float x, y, z, unused;
};

// The lengths of edges, summed up so that sums do not depend on the order and edges can be taken out again: as the integers
// that floats are by their bits, which is their logarithm but for a linear piece in each octave.
class EdgeScale {
public:
    void add(float length);
    void remove(float length);
    // About the geometric mean, metres; 1 if there is no edge.
    float mean() const;
    // At least the longest, metres.
    float longest() const { return longest_; }

private:
    uint64_t sum_ = 0;
    uint64_t count_ = 0;
    float longest_ = 0;
};

// Mesh + 44 bytes a vertex, and 32 for every seven neighbours beyond eight.
class GeodesicBlocks {
public:
    explicit GeodesicBlocks(Memory* memory)
        : blocks(memory),
          overflow(memory),
          overflow_of_rank(memory),
          positions(memory),
          rank_of_vertex(memory),
          vertex_of_rank(memory) {}

    // Ranks run from 1 to rank_count() - 1.
    uint32_t rank_count() const { return static_cast<uint32_t>(blocks.size()); }
    uint32_t vertex_count() const { return static_cast<uint32_t>(rank_of_vertex.size()); }

    GrowingBuffer<GeodesicBlock> blocks;       // by rank
    std::pmr::deque<GeodesicBlock> overflow;   // grows without moving what is there
    GrowingBuffer<uint32_t> overflow_of_rank;  // set only where the block continues
    GrowingBuffer<RankedPosition> positions;   // by rank
    GrowingBuffer<uint32_t> rank_of_vertex;
    GrowingBuffer<uint32_t> vertex_of_rank;
    EdgeScale edges;  // each inner edge counts twice
};

// The neighbours of a vertex counter-clockwise, of a closed fan the first again at the end.
template <class Take>
void visit_fan(const Mesh& mesh, uint32_t vertex, Take take) {
    const Corner first = mesh.corner_of_vertex[vertex];
    Corner corner = first, last = first;
    do {
        take(mesh.vertex_at(next_corner(corner)));
        last = corner;
        corner = mesh.turn(corner);
    } while (corner != first && corner != no_index);
    take(mesh.vertex_at(previous_corner(last)));
}

// Fills the blocks of one vertex, lane by lane.
class FanWriter {
public:
    // `first` is the vertex's block; further ones are added at the end of `overflow`.
    FanWriter(GeodesicBlock& first, std::pmr::deque<GeodesicBlock>& overflow) : block_(&first), overflow_(overflow) {}

    void add(uint32_t rank) {
        if (used_ == lane_count) continue_block();
        block_->lanes[used_++] = rank;
    }
    void finish() {
        for (uint32_t lane = used_; lane < lane_count; ++lane) block_->lanes[lane] = nowhere;
    }

private:
    void continue_block() {
        const uint32_t shared = block_->lanes[lane_count - 1];
        block_->lanes[lane_count - 1] |= block_continues;
        block_ = &overflow_.emplace_back();
        block_->lanes[0] = shared;
        used_ = 1;
    }

    GeodesicBlock* block_;
    std::pmr::deque<GeodesicBlock>& overflow_;
    uint32_t used_ = 0;
};

// Builds blocks in slices; the mesh has adjacency. A unit is a vertex in one of seven passes, 10 to 60 ns.
class GeodesicBlocksKernel {
public:
    // `positions` in place of the mesh's, a value a vertex, make another metric on the same surface.
    GeodesicBlocksKernel(const Mesh& mesh, const GrowingBuffer<Position>& positions, GeodesicBlocks& blocks,
                         Memory* memory);
    GeodesicBlocksKernel(const Mesh& mesh, GeodesicBlocks& blocks, Memory* memory)
        : GeodesicBlocksKernel(mesh, mesh.positions, blocks, memory) {}

    bool run(uint32_t count);

private:
    enum class Pass { bounds, keys, sort_low, sort_middle, sort_high, place, fans, done };

    struct Key {
        uint32_t code;  // Morton: ten bits an axis, interleaved
        uint32_t vertex;
    };

    void extend_bounds(uint32_t vertex);
    void make_key(uint32_t vertex);
    void begin_sort();
    void sort(uint32_t pass, uint32_t i);
    void place(uint32_t i);
    void make_fan(uint32_t rank);

    const Mesh& mesh_;
    const GrowingBuffer<Position>& positions_;
    GeodesicBlocks& blocks_;
    Buffer<Key> keys_, sorted_;
    std::array<std::array<uint32_t, 1024>, 3> starts_{};  // of each digit; counts at first
    std::array<float, 3> low_, high_;
    float cells_per_metre_ = 0;
    Pass pass_ = Pass::bounds;
    uint32_t at_ = 0;
};

}  // namespace flg
