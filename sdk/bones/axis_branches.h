// SPDX-License-Identifier: MIT
// The branches of an axis as smooth curves, and the slices across them (Ma, Wang, Li, Zhang 2021, sec. 3.1, Fig. 2e and
// f): through a branch's nodes goes a centripetal Catmull-Rom spline, which is sampled at equal distances; the line at
// right angles to the axis ends where it meets the contour first, on either side.
//
// Departures: a branch whose spline leaves the shape keeps its polyline, which doesn't. At junctions the line may run
// along another limb; so slices end at twice the clearance, which the axis' nodes have and which is linear between
// them.
#pragma once

#include "bones/part_skeleton.h"

namespace flg {

class AxisBranchesKernel {
public:
    // Uses and completes part.graph, and makes the rest; samples are `spacing` apart at most. All outlive the kernel.
    AxisBranchesKernel(const Contour& contour, double spacing, PartSkeleton& part, Memory* memory);

    // A unit is a node, a sample, or 64 edges of the contour held against a slice: at most about 0.3 us.
    bool run(uint32_t count);

private:
    enum class Pass { count, sum, links, begin, walk, curve, samples, slices, done };
    struct CurvePoint {
        Point2 at;
        double along, clearance;
    };

    void step();
    void enter(Pass pass) {
        pass_ = pass;
        at_ = 0;
    }
    uint32_t degree(uint32_t node) const { return first_link_[node + 1] - first_link_[node]; }
    void begin_branch();
    void begin_curve();
    void walk();
    Point2 spline(uint32_t piece, double share) const;
    void add_curve_point();
    void add_sample();
    void begin_slice();
    void slice();
    uint32_t next_point();
    void end_sample();

    const Contour& contour_;
    double spacing_;
    PartSkeleton& part_;
    std::pmr::vector<uint32_t> first_link_, links_;  // a node's neighbours
    std::pmr::vector<uint32_t> path_;                // the branch's nodes
    std::pmr::vector<CurvePoint> curve_;             // the curve, finer than its samples
    bool is_smooth_ = true;
    bool is_outside_ = false;
    uint32_t crossings_ = 0;  // of the slice's line to the left of the sample
    Point2 before_{};         // the sample before it
    double reach_ = 0;        // the distance to that
    uint32_t ring_ = 0;       // of the edges that it is held against
    uint32_t sample_ = 0, wanted_ = 0;
    uint32_t piece_ = 0, steps_ = 0;  // of the curve, and of the piece
    uint32_t node_ = 0, side_ = 0;    // where the next branch is looked for
    Pass pass_ = Pass::count;
    uint32_t at_ = 0;
};

}  // namespace flg
