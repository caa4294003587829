// SPDX-License-Identifier: MIT
// What the refined solver walks on: for each vertex the fan of its triangles, unfolded, in blocks of eight lanes, which
// one step of the solver takes at a time. Vertices stand in Morton order (along a space-filling curve: near in space is
// near in memory); a vertex's place in that order is its rank, and solvers count in ranks inside.
//
// Invariants
// - The lanes of a vertex are its neighbours counter-clockwise; lanes l and l + 1 span a triangle with it. A closed fan
//   repeats its first neighbour at the end. Lanes behind the fan's end are `nowhere`.
// - Where triangles are obtuse the fan is that of the flipped ones (intrinsic_triangles.h). Behind it then stand, with
//   no triangles between them, the neighbours along edges of the mesh that were flipped: no distance exceeds that along
//   edges.
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
#include "surfaces/geodesics/intrinsic_triangles.h"
#include "surfaces/mesh/mesh.h"

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
    // Metres; of lanes that are not `nowhere`.
    float longest_edge() const {
        float longest = 0;
        for (uint32_t lane = 0; lane < lane_count; ++lane) {
            if (rank(lane) != nowhere && lengths[lane] > longest) longest = lengths[lane];
        }
        return longest;
    }
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
    // From now on the mean is this, above 0. Orders of visits follow it, so distances in one place change in their last
    // digits where edges elsewhere do: where they must not, it is fixed.
    void fix_mean(float metres) { fixed_mean_ = metres; }

private:
    uint64_t sum_ = 0;
    uint64_t count_ = 0;
    float longest_ = 0;
    float fixed_mean_ = 0;  // 0: it is not
};

// 144 bytes a vertex, and 128 for every seven neighbours beyond eight.
struct GeodesicBlocks {
    explicit GeodesicBlocks(Memory* memory)
        : blocks(memory),
          overflow(memory),
          overflow_of_rank(memory),
          curvatures(memory),
          rank_of_vertex(memory),
          vertex_of_rank(memory),
          flipped(memory) {}

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
    IntrinsicTriangles flipped;
    uint32_t triangle_count = 0;  // of the mesh
};

// The triangles' curvatures in a block of a vertex; lanes are set.
void set_curvatures(const GeodesicBlocks& blocks, uint32_t rank, GeodesicBlock& block);

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

}  // namespace flg
