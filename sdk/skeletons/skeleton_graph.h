// SPDX-License-Identifier: MIT
// A straight skeleton: where the wavefront of a contour, all of whose edges move inwards at unit speed, changes
// (nodes), what its vertices draw (arcs), and what each edge sweeps (faces).
#pragma once

#include <cstdint>
#include <vector>

#include "core/memory.h"
#include "skeletons/point2.h"

namespace flg {

struct SkeletonNode {
    Point2 at;
    // How far the front has come: the distance to the lines of all edges whose faces the node is a corner of.
    double time;
};

// From node a to node b, in which the front comes later or at the same time; on the way the face of edge `left` is
// left and that of edge `right` right.
struct SkeletonArc {
    uint32_t a, b, left, right;
};

// The contour's points are the first nodes, with time 0. Face i is that of the edge from point i to the next one of
// its ring: face_nodes[face_offsets[i]] is point i, the next one the edge's end, and so on counter-clockwise. An
// inner node has three arcs or more; two only where arcs of the same two faces follow each other.
struct StraightSkeleton {
    explicit StraightSkeleton(Memory* memory) : nodes(memory), arcs(memory), face_offsets(memory), face_nodes(memory) {}

    std::pmr::vector<SkeletonNode> nodes;
    std::pmr::vector<SkeletonArc> arcs;
    std::pmr::vector<uint32_t> face_offsets;  // one more than faces
    std::pmr::vector<uint32_t> face_nodes;
    // Both in shares of the diagonal of the contour's box. How far a node's time is off the distance to one of its
    // edges' lines, at most: 1e-13 as a rule, up to 1e-6 with edges that are nearly parallel.
    double residual = 0;
    // By how much the contour's points were moved to get it; 0 as a rule, else 1e-9 or 1e-7: changes too near to each
    // other could not be told apart. The first nodes are where the contour's points are all the same.
    double perturbation = 0;
};

}  // namespace flg
