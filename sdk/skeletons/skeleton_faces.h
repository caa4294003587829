// SPDX-License-Identifier: MIT
// Faces of the arcs that a wavefront drew, and whether they can be a straight skeleton's: arcs without length are
// contracted, those of each face are chained, and each face is measured against the line of its edge.
//
// What is checked: each face is one chain from its edge's end to its beginning that uses all its arcs once; its
// nodes' times are their distances to the line; it turns counter-clockwise and is monotone along its edge; arcs
// between two edges on one line are perpendicular to it; nodes have times above zero; nodes and arcs are as many as
// those of a plane graph with that many holes. (Each arc is of two faces by the way it is drawn; with monotone faces
// that makes a partition.)
#pragma once

#include <span>

#include "skeletons/skeleton_graph.h"

namespace flg {

class SkeletonFaces {
public:
    // `points` are the contour's as they were given, which may have been moved for the wavefront, about the
    // wavefront's origin, with a diagonal of `size`. All outlive the kernel.
    SkeletonFaces(std::span<const SkeletonNode> nodes, std::span<const SkeletonArc> arcs,
                  std::span<const Point2> points, std::span<const uint32_t> next, uint32_t ring_count, double size,
                  StraightSkeleton& out, Memory* memory);

    // A unit is a node, an arc or a face: about 0.1 us. True at the end, or when a check has failed.
    bool run(uint32_t count) {
        for (; count > 0 && pass_ != Pass::done; --count) step();
        return pass_ == Pass::done;
    }
    bool failed() const { return failed_; }

private:
    enum class Pass { nodes, unite, number, arcs, sum, halves, faces, measure, done };
    struct Half {
        uint32_t from, to;
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
    uint32_t root(uint32_t node);
    void unite(const SkeletonArc& arc);
    void number(uint32_t node);
    void add_arc(const SkeletonArc& arc);
    bool chain(uint32_t face);
    bool measure(uint32_t face);
    bool is_upright(const SkeletonArc& arc) const;
    Point2 direction(uint32_t edge) const;

    std::span<const SkeletonNode> nodes_;
    std::span<const SkeletonArc> arcs_;
    std::span<const Point2> points_;
    std::span<const uint32_t> next_;
    uint32_t ring_count_;
    double size_;
    StraightSkeleton& out_;
    Buffer<uint32_t> united_, number_;
    Buffer<uint32_t> first_half_;  // by face
    Buffer<Half> halves_;
    Buffer<uint32_t> next_node_;
    Pass pass_ = Pass::nodes;
    uint32_t at_ = 0;
    bool failed_ = false;
};

}  // namespace flg
