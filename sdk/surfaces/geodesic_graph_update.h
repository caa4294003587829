// SPDX-License-Identifier: MIT
// The geodesic graph after a cut, or after one was taken back, sec. 4.2 of Nazzaro, Puppo, Pellacini: geoTangle (2021): only
// the rows of vertices that were added or touched are made again, and are the same as in a graph built anew.
#pragma once

#include "surfaces/geodesic_graph.h"
#include "surfaces/mesh_edit_touched.h"

namespace flg {

class GeodesicGraphUpdateKernel {
public:
    // The graph is that of the mesh before the edit; `touched` by the edit that was made or taken back since. All outlive
    // the kernel. Fails with FLG_ERROR_LIMIT if there may be more than 2^32 arcs.
    GeodesicGraphUpdateKernel(const Mesh& mesh, const GrowingBuffer<Position>& positions,
                              const TouchedVertices& touched, GeodesicGraph& graph, Memory* memory);

    // A unit is at most 16 corners of a vertex, or a move of at most 256 arcs or rows when their room is used up: at most
    // 1 us. True when done.
    bool run(uint32_t count);

private:
    enum class Pass { shrink, grow, rows, done };
    enum class RowPass { begin, count, make_room, write };

    bool grow();
    uint32_t vertex_to_update() const;
    bool make_row();
    bool make_room();
    void keep_row();

    const Mesh& mesh_;
    const TouchedVertices& touched_;
    GeodesicGraph& graph_;
    Memory* memory_;
    RowWriter writer_;
    const uint32_t before_, after_;  // vertices
    Pass pass_ = Pass::shrink;
    RowPass row_pass_ = RowPass::begin;
    bool growing_ = false;
    uint32_t at_ = 0;

    uint32_t vertex_ = 0;  // whose row is made
    Corner corner_ = no_index;
    uint32_t corners_ = 0;  // of the vertex

    // Arcs on their way to a larger array, in the order of their nodes and without what is out of use.
    Buffer<GraphArc> moved_;
    uint32_t moved_end_ = 0;
    uint32_t node_ = 0, arc_ = 0;  // the next: of its row
};

}  // namespace flg
