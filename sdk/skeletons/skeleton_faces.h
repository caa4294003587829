// SPDX-License-Identifier: MIT
// Faces of the arcs that a wavefront drew: arcs without length are contracted, and those of each face are chained from
// its edge's end to its beginning. It fails if the arcs of a face are not one such chain that uses each once, or if
// a node has no time.
#pragma once

#include <span>

#include "skeletons/node_clusters.h"
#include "skeletons/skeleton_graph.h"

namespace flg {

class SkeletonFaces {
public:
    // `points` are the contour's as they were given, which may have been moved for the wavefront, about the
    // wavefront's origin, with a diagonal of `size`. All outlive the kernel.
    SkeletonFaces(std::span<const SkeletonNode> nodes, std::span<const SkeletonArc> arcs,
                  std::span<const Point2> points, std::span<const uint32_t> next, double size, StraightSkeleton& out,
                  Memory* memory);

    // A unit is some nodes, some arcs or a part of a face: about 0.1 us. True at the end, or when it has failed.
    bool run(uint32_t count) {
        for (; count > 0 && pass_ != Pass::done; --count) step();
        return pass_ == Pass::done;
    }
    bool failed() const { return failed_; }

private:
    enum class Pass { nodes, join, number, arcs, sum, halves, link, walk, unlink, done };
    struct Half {
        uint32_t from, to;
    };
    static constexpr uint32_t batch = 8;

    void step();
    void enter(Pass pass) {
        pass_ = pass;
        at_ = 0;
    }
    void fail() {
        failed_ = true;
        pass_ = Pass::done;
    }
    // The next few of `count`, each given to `work`; when there are no more, `then`.
    template <class Work>
    void some(size_t count, Pass then, Work work) {
        const auto end = static_cast<uint32_t>(count < at_ + batch ? count : at_ + batch);
        while (at_ < end && !failed_) work(at_++);
        if (at_ == count && !failed_) enter(then);
    }
    void join(const SkeletonArc& arc);
    void number(uint32_t node);
    void add_arc(const SkeletonArc& arc);
    void add_halves(const SkeletonArc& arc);
    void begin_face();
    void link();
    void walk();
    void unlink();

    std::span<const SkeletonNode> nodes_;
    std::span<const SkeletonArc> arcs_;
    std::span<const Point2> points_;
    std::span<const uint32_t> next_;
    double size_;
    StraightSkeleton& out_;
    NodeClusters clusters_;
    Buffer<uint32_t> number_;
    Buffer<uint32_t> first_half_;  // by face
    Buffer<Half> halves_;
    Buffer<uint32_t> next_node_;  // on the face at hand
    Pass pass_ = Pass::nodes;
    uint32_t at_ = 0;
    uint32_t face_ = 0, node_ = 0, used_ = 0;
    bool failed_ = false;
};

}  // namespace flg
