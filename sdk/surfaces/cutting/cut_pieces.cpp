// SPDX-License-Identifier: MIT
#include "surfaces/cutting/cut_pieces.h"

namespace flg {

// `corner`: of the piece at edge k of the triangle, which had these `corners`; its edge there begins at the corner.
void PieceWriter::write_outer(CutTriangle& slot, const Triple& corners, uint32_t k, Corner corner) {
    CutTriangle::Edge& edge = slot.edges[k];
    const uint32_t start = mesh_.vertex_at(corner), end = mesh_.vertex_at(next_corner(corner));
    const bool owner = edge.twin == no_index;
    if (start != corners[k]) {
        if (owner) mesh_.corner_of_vertex[start] = corner;  // a new vertex
    } else {
        edge.start = corner;
        const Corner old = 3 * slot.triangle + k;
        if (mesh_.corner_of_vertex[start] == old && corner != old) edit_.set_corner(mesh_, start, corner);
    }
    const uint32_t piece = triangle_of(corner);
    if (edge.points != 0 && !owner) {
        const CutTriangle::Edge& twin = slots_[edge.twin / 3].edges[edge.twin % 3];
        const Corner across = end == corners[(k + 1) % 3] ? twin.start : mesh_.corner_of_vertex[end];
        edit_.set_neighbour(mesh_, corner, triangle_of(across));
        edit_.set_neighbour(mesh_, across, piece);
        return;
    }
    // The owner of a split edge leaves what was across for the other side to join, if there is one.
    edit_.set_neighbour(mesh_, corner, across_[k]);
    if (edge.points != 0 || across_[k] == no_index) return;
    const Triple& other = mesh_.triangles[across_[k]];
    edit_.set_neighbour(mesh_, 3 * across_[k] + (other[0] == end ? 0 : other[1] == end ? 1 : 2), piece);
}

void PieceWriter::write(CutTriangle& slot, const Pieces& pieces) {
    const Triple corners = mesh_.triangles[slot.triangle];
    across_ = mesh_.neighbours[slot.triangle];
    const auto place = [&](uint32_t piece) { return piece == 0 ? slot.triangle : slot.first_added + piece - 1; };
    for (uint32_t i = 0; i < pieces.size(); ++i) {
        const uint32_t triangle = place(i);
        edit_.set_triangle(mesh_, triangle, pieces.triangles[i]);
        edit_.set_region(mesh_, triangle, pieces.regions[i]);
        edit_.set_source(mesh_, triangle, slot.triangle);
    }
    for (uint32_t i = 0; i < pieces.size(); ++i) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t neighbour = pieces.neighbours[i][k];
            const Corner corner = 3 * place(i) + k;
            if (neighbour >= Pieces::outer_edge) {
                write_outer(slot, corners, neighbour - Pieces::outer_edge, corner);
            } else {
                edit_.set_neighbour(mesh_, corner, place(neighbour));
            }
        }
    }
}

}  // namespace flg
