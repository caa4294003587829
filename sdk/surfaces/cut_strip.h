// SPDX-License-Identifier: MIT
// Triangulates a triangle with points on its edges, taken as two chains that rise side by side. Points of the same value
// are joined, so that each piece lies between two values that follow one another.
//
// Invariants
// - Both chains begin with the same vertex, or with two that edge `first_edge` joins; they end likewise, with `last_edge`.
// - Values rise along each chain. The chains share no vertex but the first and the last, and if they share both, each
//   has another between.
#pragma once

#include "surfaces/cut_pieces.h"

namespace flg {

struct Strip {
    struct Point {
        uint32_t vertex;
        uint32_t edge;  // of the triangle: where the way from the point before leads along
        float value;
    };

    explicit Strip(Memory* memory) : left(memory), right(memory) {}

    // Appends the pieces. Of two ways to halve a quad it takes the one with the shorter diagonal.
    void triangulate(const Mesh& mesh, uint32_t region, Pieces& pieces) const;

    std::pmr::vector<Point> left, right;  // as seen from outside by one who climbs
    uint32_t first_edge, last_edge;       // only where the chains begin, or end, apart
};

// Joins the points `first` to `first` + `count` - 1 (`step` 1), or downwards from there (`step` -1), to the corner opposite
// the edge on which they lie: `edge` of the triangle, still unbroken in the last piece.
void fan_last_piece(Pieces& pieces, uint32_t edge, uint32_t first, uint32_t count, int step);

}  // namespace flg
