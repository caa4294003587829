// SPDX-License-Identifier: MIT
// The clean axis of a shape (Ma, Wang, Li, Zhang 2021, sec. 3.1): of its straight skeleton the peripheral arcs, which
// end on the contour, are removed, and arcs shorter than a share of their mean length are contracted, the shortest
// first.
//
// Invariants
// - A tree, also of shapes with holes: around each hole the way is cut at its narrowest arc, since bones can't go in
//   circles.
// - It stays inside of the shape. An arc is contracted to one of its ends (of more arcs; else the end of the axis; else
//   the one with more room around), and only if the arcs that are moved don't leave the shape: a disc of a node's
//   clearance is in it, and where two discs don't cover an arc it is held against the contour's edges.
//
// Departures: the paper does not say where contracted arcs go, nor what to do about holes. It removes all peripheral
// arcs; but those that lead into a sharp tip, as of a star or an ear, are most of its length: an arc longer than 2.5
// times the clearance at its inner end stays, but for its last quarter.
//
// Then its branches as smooth curves, and the slices across them (Fig. 2e and f): through a branch's nodes goes a
// centripetal Catmull-Rom spline, which is sampled at equal distances; the line at right angles to the axis ends where
// it meets the contour first, on either side.
//
// Departures: a branch whose spline leaves the shape keeps its polyline, which doesn't. At junctions the line may run
// along another limb; so slices end at twice the clearance, which the axis' nodes have and which is linear between
// them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "runtime/task.h"
#include "skeletons/contour.h"
#include "skeletons/skeleton_graph.h"

namespace flg {

struct AxisNode {
    Point2 at;
    double clearance;  // when the front came there: a disc of this radius is inside of the shape
};

struct AxisGraph {
    explicit AxisGraph(Memory* memory) : nodes(memory), arcs(memory) {}

    std::pmr::vector<AxisNode> nodes;
    std::pmr::vector<std::array<uint32_t, 2>> arcs;  // one less than nodes
};

// `collapse` is the share of the mean arc's length.
Task<AxisGraph> axis_graph(Pace& pace, const Contour& contour, const StraightSkeleton& skeleton, double collapse);

// A point of a branch's axis, with the slice through it at right angles to the axis.
struct AxisSample {
    Point2 at;
    Point2 left_of;      // the unit vector to the left of the axis
    double left, right;  // how far the slice goes: to the contour, or to twice the clearance
};

// From one junction or end of the axis to the next. Samples are at equal distances, its ends included.
struct AxisBranch {
    uint32_t from, to;    // nodes of the graph
    uint32_t begin, end;  // samples
};

struct PartSkeleton {
    explicit PartSkeleton(Memory* memory) : graph(memory), branches(memory), samples(memory), twins(memory) {}

    AxisGraph graph;
    std::pmr::vector<AxisBranch> branches;  // none where the axis is a single node
    std::pmr::vector<AxisSample> samples;
    // Where the shape is its own mirror image: by branch its image, itself: on the mirror axis. None: it is not.
    std::pmr::vector<uint32_t> twins;
};

// Samples are `spacing` apart at most. A branch ends also where `stops` has 1 for a node; none: nowhere else. Takes
// about 5 ns a sample and edge of the contour.
Task<PartSkeleton> axis_branches(Pace& pace, const Contour& contour, AxisGraph graph, double spacing,
                                 std::span<const uint8_t> stops = {});

}  // namespace flg
