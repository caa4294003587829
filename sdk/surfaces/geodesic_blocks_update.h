// SPDX-License-Identifier: MIT
// Blocks after a local change of the mesh: vertices and triangles were added at the end, or taken back from there, and some
// triangles rewritten. Only fans of vertices that the change touched are built again, and the triangles' curvatures around
// them; new vertices get ranks behind all others. Distances are those of blocks built anew.
#pragma once

#include <span>

#include "surfaces/geodesic_blocks.h"

namespace flg {

class GeodesicBlocksUpdateKernel {
public:
    // `touched`: the vertices of all triangles that were rewritten or taken back, as far as they still are, in any order, each
    // once; if positions changed, also the neighbours of those that moved. Added vertices may be among them. All outlive the
    // kernel. Cost: about 1 us a vertex that is touched or added, and a copy of the blocks, in slices, when their room is used
    // up.
    GeodesicBlocksUpdateKernel(const Mesh& mesh, const GrowingBuffer<Position>& positions,
                               std::span<const uint32_t> touched, GeodesicBlocks& blocks);
    GeodesicBlocksUpdateKernel(const Mesh& mesh, std::span<const uint32_t> touched, GeodesicBlocks& blocks)
        : GeodesicBlocksUpdateKernel(mesh, mesh.positions, touched, blocks) {}

    // A unit is a vertex, or the move of one.
    bool run(uint32_t count);

private:
    enum class Pass { grow, remove, add, forget, build_touched, build_added, finish_touched, finish_added, done };

    uint32_t pass_size() const;
    void step(uint32_t i);
    void grow();
    void forget(uint32_t rank);
    void finish_around(uint32_t rank);

    std::span<const uint32_t> touched_;
    GeodesicBlocks& blocks_;
    FanBuilder fans_;
    uint32_t before_, after_;  // vertices
    bool growing_ = false;
    size_t room_ = 0;  // ranks, when it has grown
    Pass pass_ = Pass::grow;
    uint32_t at_ = 0;
};

}  // namespace flg
