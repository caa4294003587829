// SPDX-License-Identifier: MIT
// The borders that are seen, edge by edge, and which of them is nearest to each vertex along the surface: what
// distances in between are measured to. Distances are straight lines.
//
// - A vertex's nearest piece is found through its neighbours': each offers its own and those that go on from its ends.
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
};

struct BorderPieces {
    Buffer<BorderPiece> pieces;
    Groups at_vertex;          // ends by vertex: 2 * piece and 2 * piece + 1
    Buffer<uint32_t> nearest;  // by vertex: a piece; no_index where there is none

    // visit(piece) for all that may be nearest beside a vertex, some of them twice.
    template <class Visit>
    void visit_near(uint32_t vertex, Visit visit) const {
        const auto ends_here = at_vertex.of(vertex);
        for (const uint32_t end : ends_here) visit(end / 2);
        if (!ends_here.empty() || nearest[vertex] == no_index) return;
        for (const uint32_t end : pieces[nearest[vertex]].ends)
            for (const uint32_t other : at_vertex.of(end)) visit(other / 2);
    }
};

// About 0.2 us a vertex.
Task<BorderPieces> find_border_pieces(Pace& pace, const Mesh& mesh, const RegionTree& tree,
                                      const Buffer<Position>& places);

}  // namespace flg
