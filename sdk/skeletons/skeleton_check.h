// SPDX-License-Identifier: MIT
// Whether faces can be those of a straight skeleton, by what has to hold of one:
//
// - Nodes are as far from the lines of their faces' edges as their time says.
// - Each face turns counter-clockwise and is monotone along its edge. With arcs that are of two faces each, as they
//   were drawn, that makes a partition.
// - Arcs between two edges on one line, of which distances say nothing, are perpendicular to it.
// - Nodes and arcs are as many as those of a plane graph with that many holes.
// - At each node the front goes on as it has to, which is what tells the straight skeleton from other roofs over the
//   same walls: of two arcs of a face that rise from a node with less than a half turn between them something would
//   stay unswept, and so it would of two that do not rise with more; level arcs run against their face's edge.
// - No face is pinched: no node of it is on another of its arcs. (There a front edge without length did not vanish.)
#pragma once

#include <span>

#include "skeletons/node_clusters.h"
#include "skeletons/skeleton_graph.h"

namespace flg {

class SkeletonCheck {
public:
    // Of what SkeletonFaces made of the same points, which may have been moved by up to `perturbation`, a share of
    // `size`, the contour's diagonal. All outlive the kernel; the skeleton's residual is measured.
    SkeletonCheck(std::span<const Point2> points, std::span<const uint32_t> next, uint32_t ring_count, double size,
                  double perturbation, StraightSkeleton& skeleton, Memory* memory);

    // A unit is some nodes, some arcs or a part of a face: about 0.2 us. True at the end, or when a check has failed.
    bool run(uint32_t count) {
        for (; count > 0 && pass_ != Pass::done; --count) step();
        return pass_ == Pass::done;
    }
    bool failed() const { return failed_; }

private:
    enum class Pass { directions, upright, measure, nodes, join, corners, place, sweep, done };
    static constexpr uint32_t batch = 8;
    // Which way a face's walk around has gone since it last turned back.
    struct Walk {
        double area = 0, previous_s = 0, previous_t = 0, furthest = 0;
        int turns = 0, way = 1;
    };
    struct Place {
        double s, t;  // along a face's edge, from its beginning, and above its line
    };

    void step();
    void enter(Pass pass) {
        pass_ = pass;
        at_ = 0;
    }
    void fail() {
        failed_ = true;
        pass_ = Pass::done;
    }
    template <class Work>
    void some(size_t count, Pass then, Work work) {
        const auto end = static_cast<uint32_t>(count < at_ + batch ? count : at_ + batch);
        while (at_ < end && !failed_) work(at_++);
        if (at_ == count && !failed_) enter(then);
    }
    uint32_t face_begin() const { return skeleton_.face_offsets[face_]; }
    uint32_t face_size() const { return skeleton_.face_offsets[face_ + 1] - face_begin(); }
    uint32_t ring_node(uint32_t i) const { return skeleton_.face_nodes[face_begin() + i]; }
    bool is_contour(uint32_t node) const { return node < points_.size(); }
    Place place_of(uint32_t node) const;
    void find_direction(uint32_t edge);
    bool is_upright(const SkeletonArc& arc) const;
    void end_counts();
    void measure();
    bool measure_node(const SkeletonNode& node);
    void join(const SkeletonArc& arc);
    void corners();
    bool is_swept(uint32_t before, uint32_t first, uint32_t last, uint32_t after);
    void place();
    void sweep();
    bool is_on(uint32_t i, uint32_t from, uint32_t to) const;
    void begin_sweep(bool forwards);
    void end_sweep();
    uint32_t beyond(uint32_t i, bool forwards) const;

    std::span<const Point2> points_;
    std::span<const uint32_t> next_;
    uint32_t ring_count_;
    double size_;
    double most_slant_;
    double shortest_;  // arcs up to this length say nothing of how the front goes on
    double pinch_;
    double slack_ = 0;  // of a face's order along its edge
    StraightSkeleton& skeleton_;
    Buffer<Point2> directions_;  // of the edges
    NodeClusters clusters_;
    Buffer<Place> places_;  // of the nodes of the face at hand
    Pass pass_ = Pass::directions;
    uint32_t at_ = 0;
    uint32_t face_ = 0;
    Walk walk_;
    // The last two clusters on the way around a face: the first's last node, and both ends of the second.
    uint32_t before_ = 0, first_ = 0, last_ = 0;
    uint32_t lowest_ = 0, highest_ = 0;         // of the face's nodes, along its edge
    uint32_t own_ = 0, other_ = 0, probe_ = 0;  // the node at hand, and where on the other side arcs are tried
    bool forwards_ = true;
    bool failed_ = false;
};

}  // namespace flg
