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
#pragma once

#include <array>
#include <queue>
#include <vector>

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

class AxisGraphKernel {
public:
    // `collapse` is the share of the mean arc's length. All outlive the kernel; `out` is complete when run() returns
    // true.
    AxisGraphKernel(const Contour& contour, const StraightSkeleton& skeleton, double collapse, AxisGraph& out,
                    Memory* memory);

    // A unit is an arc looked at, moved, or held against 64 edges of the contour: at most about 0.3 us.
    bool run(uint32_t count);

private:
    enum class Pass { nodes, arcs, tree, lengths, contract, check, apply, number, write, done };
    struct Link {  // an arc at one of its nodes
        uint32_t arc;
        uint32_t next;  // the node's next link; no_link: none
    };
    struct Node {
        Point2 at;
        double clearance;
        uint32_t united;  // with this node, itself: none
        uint32_t first, last, degree;
    };
    struct Arc {
        uint32_t a, b;
        bool gone;
    };
    struct Ranked {
        double rank;
        uint32_t arc;
        // The largest comes first; then that with the lowest number.
        bool operator<(const Ranked& other) const { return rank != other.rank ? rank < other.rank : arc > other.arc; }
    };
    static constexpr uint32_t no_link = 0xffffffffu;

    void step();
    void enter(Pass pass) {
        pass_ = pass;
        at_ = 0;
    }
    uint32_t root(uint32_t node);
    double length(const Arc& arc);
    void link(uint32_t node, uint32_t slot);
    void add_arc(uint32_t arc);
    void add_tip(uint32_t tip, uint32_t inner);
    void choose();
    bool next_moved();
    void check();
    void apply();

    const Contour& contour_;
    const StraightSkeleton& skeleton_;
    double collapse_;
    AxisGraph& out_;
    std::pmr::vector<Node> nodes_;
    std::pmr::vector<Arc> arcs_;
    std::pmr::vector<Link> links_;  // two an arc
    std::pmr::vector<uint32_t> number_;
    std::priority_queue<Ranked, std::pmr::vector<Ranked>> queue_;
    double threshold_ = 0, sum_ = 0;
    uint32_t alive_ = 0;
    uint32_t arc_ = 0, kept_ = 0, dropped_ = 0;  // the arc that is contracted, and to which end
    uint32_t moved_ = no_link;                   // the link of the dropped end that is looked at
    Pass pass_ = Pass::nodes;
    uint32_t at_ = 0;
};

}  // namespace flg
