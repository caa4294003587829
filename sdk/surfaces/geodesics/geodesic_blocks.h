// SPDX-License-Identifier: MIT
// What the refined solver walks on: for each vertex the fan of its triangles, unfolded, in blocks of eight lanes, which
// one step of the solver takes at a time. Vertices stand in Morton order (along a space-filling curve: near in space is
// near in memory); a vertex's place in that order is its rank, and solvers count in ranks inside.
//
// Invariants
// - The lanes of a vertex are its neighbours counter-clockwise; lanes l and l + 1 span a triangle with it. A closed fan
//   repeats its first neighbour at the end. Lanes behind the fan's end are `nowhere`.
// - Fans of more than eight lanes go on in the overflow: each further block begins with the last lane of the one
//   before. The top bit of a block's last lane says that another follows: the first overflow block of a vertex is at
//   overflow_of_rank, further ones are behind it.
// - No distance depends on ranks, nor on which blocks were made first. So blocks that are updated give the distances of
//   blocks built anew.
#pragma once

#include <array>
#include <deque>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh.h"
#include "surfaces/mesh/region_set.h"

namespace flg {

constexpr uint32_t lane_count = 8;
constexpr uint32_t nowhere = 0;                 // a rank
constexpr uint32_t block_continues = 1u << 31;  // in the last lane

constexpr float no_length = 1e15f;  // metres, of lanes that are `nowhere`

struct alignas(64) GeodesicBlock {
    std::array<uint32_t, lane_count> lanes;  // ranks
    std::array<float, lane_count> lengths;   // metres, of the edges to them
    std::array<float, lane_count>
        tangents;  // of half the angle between lanes l and l + 1; 0 where there is no triangle
    std::array<float, lane_count> curvatures;  // of that triangle, 1/metres^2: the mean of its vertices'

    bool continues() const { return (lanes[lane_count - 1] & block_continues) != 0; }
    uint32_t rank(uint32_t lane) const { return lanes[lane] & ~block_continues; }
    // Nobody is reached through the lane any more.
    void close(uint32_t lane) {
        lanes[lane] = nowhere | (lanes[lane] & block_continues);
        lengths[lane] = no_length;
    }
};

// The lengths of edges, summed up so that sums do not depend on the order and edges can be taken out again: as the
// integers that floats are by their bits, which is their logarithm but for a linear piece in each octave.
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

// 144 bytes a vertex, and 128 for every seven neighbours beyond eight.
struct GeodesicBlocks {
    explicit GeodesicBlocks(Memory* memory)
        : blocks(memory),
          overflow(memory),
          overflow_of_rank(memory),
          curvatures(memory),
          rank_of_vertex(memory),
          vertex_of_rank(memory) {}

    // Ranks run from 1 to rank_count() - 1. (Vertices that were taken back leave theirs unused.)
    uint32_t rank_count() const { return static_cast<uint32_t>(blocks.size()); }
    uint32_t vertex_count() const { return static_cast<uint32_t>(rank_of_vertex.size()); }

    GrowingBuffer<GeodesicBlock> blocks;       // by rank
    std::pmr::deque<GeodesicBlock> overflow;   // grows without moving what is there
    GrowingBuffer<uint32_t> overflow_of_rank;  // set only where the block continues
    // By rank, 1/metres^2: Gaussian curvature, what the angles lack to a full turn over a third of the triangles' area;
    // 0 at borders.
    GrowingBuffer<float> curvatures;
    GrowingBuffer<uint32_t> rank_of_vertex;
    GrowingBuffer<uint32_t> vertex_of_rank;
    EdgeScale edges;  // each inner edge counts at least twice
};

// The blocks of a vertex, each with its first lane that no block before it has.
template <class Visit>
void visit_blocks(const GeodesicBlocks& blocks, uint32_t rank, Visit visit) {
    visit(blocks.blocks[rank], 0);
    if (!blocks.blocks[rank].continues()) return;
    for (size_t i = blocks.overflow_of_rank[rank];; ++i) {
        visit(blocks.overflow[i], 1);
        if (!blocks.overflow[i].continues()) return;
    }
}

// The mesh has adjacency. `positions`, a value a vertex, in place of the mesh's make another metric on the same
// surface.
Task<GeodesicBlocks> make_blocks(Pace& pace, const Mesh& mesh, const GrowingBuffer<Position>& positions);

// Brings blocks up to date after a local change of the mesh: vertices and triangles were added at the end, or taken
// back from there, and some triangles rewritten. Only fans of vertices that the change touched are built again, and the
// triangles' curvatures around them; new vertices get ranks behind all others. Distances are those of blocks built
// anew.
// `touched`: the vertices of all triangles that were rewritten or taken back, as far as they still are, in any order,
// each once; if positions changed, also the neighbours of those that moved. Added vertices may be among them. Cost:
// about 1 us a vertex that is touched or added, and a copy of the blocks when their room is used up.
Task<void> update_blocks(Pace& pace, const Mesh& mesh, const std::pmr::deque<uint32_t>& touched,
                         GeodesicBlocks& blocks);

// Blocks of a surface that keeps to some regions: where the regions end, copies of the blocks in which the triangles
// outside are closed. Everywhere else no path leads out, so the surface's own blocks serve.
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
    friend Task<GeodesicRegion> bound_region(Pace&, const Mesh&, const GeodesicBlocks&, const RegionSet&);
    struct Slot {
        uint32_t rank, block;
    };
    uint32_t slot_of(uint32_t rank) const { return (rank * 0x9e3779b1u) >> 8; }
    // Closes the triangles of the vertex that lie outside.
    void close(const Mesh& mesh, const GeodesicBlocks& blocks, const RegionSet& within, uint32_t vertex);

    std::pmr::deque<GeodesicBlock> blocks_;
    Buffer<Slot> slots_;  // a hash table, at most half full; its size is a power of two
    uint32_t mask_ = 0;
};

Task<GeodesicRegion> bound_region(Pace& pace, const Mesh& mesh, const GeodesicBlocks& blocks, const RegionSet& within);

}  // namespace flg
