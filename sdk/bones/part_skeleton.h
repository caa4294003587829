// SPDX-License-Identifier: MIT
// What a drawn part has inside: its axis, in branches, and the shape along them.
#pragma once

#include <vector>

#include "bones/axis_graph.h"

namespace flg {

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
    explicit PartSkeleton(Memory* memory) : graph(memory), branches(memory), samples(memory) {}

    AxisGraph graph;
    std::pmr::vector<AxisBranch> branches;  // none where the axis is a single node
    std::pmr::vector<AxisSample> samples;
};

}  // namespace flg
