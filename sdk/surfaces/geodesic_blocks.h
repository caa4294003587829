// SPDX-License-Identifier: MIT
// What the refined solver walks on: for each vertex the fan of its triangles, unfolded, in blocks of eight lanes, which one
// step of the solver takes at a time. Vertices stand in Morton order (along a space-filling curve: near in space is near in
// memory); a vertex's place in that order is its rank, and solvers count in ranks inside.
//
// Invariants
// - The lanes of a vertex are its neighbours counter-clockwise; lanes l and l + 1 span a triangle with it. A closed fan
//   repeats its first neighbour at the end. Lanes behind the fan's end are `nowhere`.
// - Fans of more than eight lanes go on in the overflow: each further block begins with the last lane of the one before.
//   The top bit of a block's last lane says that another follows: the first overflow block of a vertex is at
//   overflow_of_rank, further ones are behind it.
// - No distance depends on ranks, nor on which blocks were made first. So blocks that are updated give the distances of
//   blocks built anew.
#pragma once

#include <array>
#include <deque>

#include "surfaces/fan_walk.h"
#include "surfaces/spatial_order.h"

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
    // By rank, 1/metres^2: Gaussian curvature, what the angles lack to a full turn over a third of the triangles' area; 0 at
    // borders.
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

// Angles below a half turn added up without their values: as a point on the unit circle, and how often it has passed half a
// turn.
class AngleSum {
public:
    void add(double cosine, double sine);
    double value() const;

private:
    double cosine_ = 1, sine_ = 0;
    uint32_t half_turns_ = 0;
};

// Makes the blocks of one vertex after the other.
class FanBuilder {
public:
    // Positions, a value a vertex of the mesh, need not be the mesh's own.
    FanBuilder(const Mesh& mesh, const GrowingBuffer<Position>& positions, GeodesicBlocks& blocks)
        : mesh_(mesh), positions_(positions), blocks_(blocks) {}

    // All of the vertex but the triangles' curvatures, which want its neighbours'. Its block is zero, or what was built
    // before: then the overflow it has is used again.
    void build(uint32_t rank);
    // The triangles' curvatures.
    void finish(uint32_t rank);

private:
    void add(uint32_t neighbour, float length, float tangent);
    GeodesicBlock& next_block();
    void finish(float own, GeodesicBlock& block);

    const Mesh& mesh_;
    const GrowingBuffer<Position>& positions_;
    GeodesicBlocks& blocks_;
    GeodesicBlock* block_ = nullptr;  // that is being filled
    uint32_t used_ = 0;               // lanes of it
    // The vertex's stretch of the overflow, and how many blocks of it are filled.
    size_t overflow_begin_ = 0, overflow_size_ = 0, overflow_used_ = 0;
};

// Builds blocks in slices; the mesh has adjacency. A unit is a vertex in one of four passes (of the first, four
// vertices), 10 to 200 ns.
class GeodesicBlocksKernel {
public:
    // `positions` in place of the mesh's, a value a vertex, make another metric on the same surface.
    GeodesicBlocksKernel(const Mesh& mesh, const GrowingBuffer<Position>& positions, GeodesicBlocks& blocks,
                         Memory* memory);
    GeodesicBlocksKernel(const Mesh& mesh, GeodesicBlocks& blocks, Memory* memory)
        : GeodesicBlocksKernel(mesh, mesh.positions, blocks, memory) {}

    bool run(uint32_t count);

private:
    enum class Pass { order, place, fans, curvatures, done };

    void place(uint32_t i);
    void fetch() const;

    const Mesh& mesh_;
    const GrowingBuffer<Position>& positions_;
    GeodesicBlocks& blocks_;
    FanBuilder fans_;
    SpatialOrderKernel order_;
    Pass pass_ = Pass::order;
    uint32_t at_ = 0;
};

}  // namespace flg
