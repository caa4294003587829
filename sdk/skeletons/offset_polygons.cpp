// SPDX-License-Identifier: MIT
#include "skeletons/offset_polygons.h"

namespace flg {

namespace {

constexpr uint32_t none = ~0u;

}  // namespace

OffsetPolygons::OffsetPolygons(const StraightSkeleton& skeleton, double distance, OffsetRings& out, Memory* memory)
    : skeleton_(skeleton),
      distance_(distance),
      out_(out),
      first_arc_(skeleton.nodes.size() + 2, memory),
      arcs_of_(skeleton.arcs.size(), memory),
      next_(skeleton.arcs.size(), memory),
      edge_(skeleton.arcs.size(), memory),
      sides_(skeleton.arcs.size(), memory) {
    out_.points.clear();
    out_.edges.clear();
    out_.offsets.assign(1, 0);
}

void OffsetPolygons::step() {
    const auto& arcs = skeleton_.arcs;
    switch (pass_) {
        case Pass::zero: some(first_arc_.size(), Pass::count, [&](uint32_t i) { first_arc_[i] = 0; }); break;
        case Pass::count:
            some(arcs.size(), Pass::sum, [&](uint32_t i) {
                next_[i] = none;
                if (is_crossed(i)) ++first_arc_[arcs[i].a + 2];
            });
            break;
        case Pass::sum:
            some(first_arc_.size() - 1, Pass::list, [&](uint32_t i) { first_arc_[i + 1] += first_arc_[i]; });
            break;
        case Pass::list:
            // Counted one place further on, the sums are each node's beginning; they move on to its end.
            some(arcs.size(), Pass::faces, [&](uint32_t i) {
                if (is_crossed(i)) arcs_of_[first_arc_[arcs[i].a + 1]++] = i;
            });
            break;
        case Pass::faces: some(skeleton_.face_nodes.size(), Pass::rings, [&](uint32_t i) { add_corner(i); }); break;
        case Pass::rings:
            for (uint32_t i = 0; i < batch && pass_ == Pass::rings; ++i) {
                if (is_in_ring_) {
                    add_point(ring_at_);
                } else if (at_ == side_count_) {
                    pass_ = Pass::done;
                } else if (next_[sides_[at_]] != none) {
                    begun_ = ring_at_ = sides_[at_];
                    is_in_ring_ = true;
                } else {
                    ++at_;
                }
            }
            break;
        case Pass::done: break;
    }
}

// One that is crossed, between two nodes of which it begins at either.
uint32_t OffsetPolygons::arc_between(uint32_t a, uint32_t b) const {
    for (const uint32_t from : {a, b}) {
        for (uint32_t i = first_arc_[from]; i < first_arc_[from + 1]; ++i) {
            if (skeleton_.arcs[arcs_of_[i]].b == (from == a ? b : a)) return arcs_of_[i];
        }
    }
    return none;
}

void OffsetPolygons::add_corner(uint32_t i) {
    const auto& offsets = skeleton_.face_offsets;
    while (i == offsets[face_ + 1]) ++face_;
    const uint32_t from = skeleton_.face_nodes[i];
    const uint32_t to = skeleton_.face_nodes[i + 1 == offsets[face_ + 1] ? offsets[face_] : i + 1];
    if (is_above(from) == is_above(to)) return;
    const uint32_t arc = arc_between(from, to);
    if (is_above(to)) {
        risen_ = arc;
    } else {
        next_[arc] = risen_;
        edge_[arc] = face_;
        sides_[side_count_++] = arc;
    }
}

void OffsetPolygons::add_point(uint32_t arc) {
    const SkeletonNode &a = skeleton_.nodes[skeleton_.arcs[arc].a], &b = skeleton_.nodes[skeleton_.arcs[arc].b];
    const double share = (distance_ - a.time) / (b.time - a.time);
    out_.points.push_back({a.at.x + share * (b.at.x - a.at.x), a.at.y + share * (b.at.y - a.at.y)});
    out_.edges.push_back(edge_[arc]);
    ring_at_ = next_[arc];
    next_[arc] = none;
    if (ring_at_ != begun_) return;
    out_.offsets.push_back(static_cast<uint32_t>(out_.points.size()));
    is_in_ring_ = false;
}

}  // namespace flg
