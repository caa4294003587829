// SPDX-License-Identifier: MIT
// Offset polygons: where the front of a straight skeleton is at a time, which is the contour moved inwards by a
// distance with its corners kept sharp. Each arc on which that time lies is one of its points; in each face, walked
// around from its edge, an arc that rises through the time and the next one that falls through it are the ends of a
// side.
//
// Invariants
// - Each such arc rises in one of its faces and falls in the other: so the sides make closed rings, without a search.
// - At time 0 the rings are the contour's; above the last node's there are none.
#pragma once

#include <cstdint>
#include <vector>

#include "core/memory.h"
#include "skeletons/skeleton_graph.h"

namespace flg {

// Rings with what is inside on their left: those around a part turn counter-clockwise, those around holes clockwise.
// Each begins with the side of its edge of least number, and they come in the order of these.
struct OffsetRings {
    explicit OffsetRings(Memory* memory) : points(memory), edges(memory), offsets(memory) {}

    std::pmr::vector<Point2> points;
    std::pmr::vector<uint32_t> edges;    // one a point: the contour's edge that the side from it to the next is of
    std::pmr::vector<uint32_t> offsets;  // where each ring begins, and the end
};

class OffsetPolygons {
public:
    // `distance` is not below 0. All outlive the kernel; `out` is complete when run() returns true.
    OffsetPolygons(const StraightSkeleton& skeleton, double distance, OffsetRings& out, Memory* memory);

    // A unit is some nodes, arcs or corners of faces: about 0.1 us. About 4 units a face.
    bool run(uint32_t count) {
        for (; count > 0 && pass_ != Pass::done; --count) step();
        return pass_ == Pass::done;
    }

private:
    enum class Pass { zero, count, sum, list, faces, rings, done };
    static constexpr uint32_t batch = 8;

    void step();
    template <class Work>
    void some(size_t count, Pass then, Work work) {
        for (uint32_t i = 0; i < batch && at_ < count; ++i) work(at_++);
        if (at_ < count) return;
        pass_ = then;
        at_ = 0;
    }
    bool is_above(uint32_t node) const { return skeleton_.nodes[node].time > distance_; }
    bool is_crossed(uint32_t arc) const { return is_above(skeleton_.arcs[arc].a) != is_above(skeleton_.arcs[arc].b); }
    uint32_t arc_between(uint32_t a, uint32_t b) const;
    void add_corner(uint32_t i);
    void add_point(uint32_t arc);

    const StraightSkeleton& skeleton_;
    double distance_;
    OffsetRings& out_;
    Buffer<uint32_t> first_arc_, arcs_of_;  // by the node that an arc begins at
    Buffer<uint32_t> next_,
        edge_;                // by arc, of those that are crossed: the next point of the ring, by way of which face
    Buffer<uint32_t> sides_;  // the arcs that fall, by face
    uint32_t side_count_ = 0;
    Pass pass_ = Pass::zero;
    uint32_t at_ = 0;
    uint32_t face_ = 0, risen_ = 0;
    uint32_t begun_ = 0, ring_at_ = 0;
    bool is_in_ring_ = false;
};

}  // namespace flg
