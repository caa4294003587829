// SPDX-License-Identifier: MIT
// Joins the triangles of each edge two by two.
// - Of triangles with the same three vertices, however wound, only the first counts.
// - Two triangles are joined, however wound.
// - Of more, those pass through each other or touch: triangles that are wound against each other are joined, the flattest
//   pair first, and of pairs as flat as each other (two boxes that touch in an edge) the convex one, so that solids come
//   apart rather than grow together. What is left over stays open.
#pragma once

#include <deque>
#include <vector>

#include "surfaces/adjacency_edges.h"
#include "surfaces/mesh_repair_mates.h"

namespace flg {

// A unit is a corner: a few nanoseconds, at most 50 us at a crowded edge.
class PairingKernel {
public:
    // An edge of more triangles than this is refused: it takes more than a chunk to sort them.
    static constexpr uint32_t edge_triangles_max = 1000;
    // Of more triangles than this, duplicates not counted, all are left open.
    static constexpr uint32_t paired_triangles_max = 32;

    // `sorted` is what EdgeSortKernel says of the triangles. All but `memory` outlive the kernel.
    PairingKernel(const GrowingBuffer<Position>& positions, const GrowingBuffer<Triple>& triangles,
                  const Buffer<Corner>& sorted, Mates& mates, Memory* memory);
    bool run(uint32_t count);

    // After run() returned true.
    uint32_t crowded_count() const { return crowded_count_; }
    // Some joined triangles are wound against each other's sense.
    bool winding_differs() const { return winding_differs_; }
    // Triangles that have the vertices of an earlier one, each up to three times.
    const std::pmr::deque<uint32_t>& duplicates() const { return duplicates_; }

private:
    struct Sheet {
        Corner corner;
        Vec3 away;     // from the edge, unit length; 0 for triangles without area
        bool forward;  // along the edge from its lesser to its greater vertex
    };
    uint32_t start_of(Corner corner) const { return triangles_[corner / 3][corner % 3]; }
    uint32_t apex_of(Corner corner) const { return triangles_[corner / 3][(corner + 2) % 3]; }
    void join_two(Corner a, Corner b);
    void pair_run(uint32_t begin, uint32_t end);
    void drop_duplicates();
    void pair_sheets(const Edge& edge);

    const GrowingBuffer<Position>& positions_;
    const GrowingBuffer<Triple>& triangles_;
    const Buffer<Corner>& sorted_;
    Mates& mates_;
    uint32_t at_ = 0;
    std::pmr::vector<Corner> corners_;  // of a crowded edge
    std::pmr::vector<Sheet> sheets_;    // of them, those not joined yet
    std::pmr::deque<uint32_t> duplicates_;
    uint32_t crowded_count_ = 0;
    bool winding_differs_ = false;
};

}  // namespace flg
