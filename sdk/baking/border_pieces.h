// SPDX-License-Identifier: MIT
// The borders that are seen, edge by edge, and which of them is nearest to each vertex along the surface: what
// distances in between are measured to. Distances are straight lines.
//
// - A vertex's nearest piece is found through its neighbours': each offers its own and those that go on from its ends,
//   and keeps looking along these for a nearer one itself.
// - Pieces are the mesh's edges in the order of their corners; of equally near ones the first that is offered stays. A
//   queue in the vertices' order makes that the same every time.
#pragma once

#include "baking/baked_shape.h"
#include "runtime/each.h"
#include "tangles/region_tree.h"

namespace flg {

struct BorderPiece {
    std::array<uint32_t, 2> ends;    // vertices
    std::array<uint32_t, 2> labels;  // of the triangles beside it
    Position from, along;            // metres: the first end, and from there to the second
    double inverse_length_sq;        // 0: both ends have one place
};

struct BorderPieces {
    Buffer<BorderPiece> pieces;
    Groups at_vertex;          // ends by vertex: 2 * piece and 2 * piece + 1
    Buffer<uint32_t> nearest;  // by vertex: a piece; no_index where there is none
};

// About 0.2 us a vertex.
Task<BorderPieces> find_border_pieces(Pace& pace, const Mesh& mesh, const RegionTree& tree,
                                      const Buffer<Position>& places);

}  // namespace flg
