// SPDX-License-Identifier: MIT
#include "skeletons/offset_polygons.h"

#include <algorithm>

namespace flg {

namespace {

constexpr uint32_t none = ~0u;

class Offset {
public:
    Offset(const StraightSkeleton& skeleton, double distance, Memory* memory)
        : skeleton_(skeleton),
          distance_(distance),
          first_arc_(skeleton.nodes.size(), memory),
          next_arc_(skeleton.arcs.size(), memory),
          next_(skeleton.arcs.size(), memory),
          edge_(skeleton.arcs.size(), memory),
          sides_(skeleton.arcs.size(), memory) {}

    void list_arcs() {
        std::fill(first_arc_.begin(), first_arc_.end(), none);
        for (auto i = static_cast<uint32_t>(skeleton_.arcs.size()); i-- > 0;) {
            const SkeletonArc& arc = skeleton_.arcs[i];
            next_[i] = none;
            if (is_above(arc.a) == is_above(arc.b)) continue;
            next_arc_[i] = first_arc_[arc.a];
            first_arc_[arc.a] = i;
        }
    }

    void add_sides() {
        const auto& offsets = skeleton_.face_offsets;
        uint32_t risen = none;
        for (uint32_t face = 0; face + 1 < offsets.size(); ++face) {
            for (uint32_t i = offsets[face]; i < offsets[face + 1]; ++i) {
                const uint32_t from = skeleton_.face_nodes[i];
                const uint32_t to = skeleton_.face_nodes[i + 1 == offsets[face + 1] ? offsets[face] : i + 1];
                if (is_above(from) == is_above(to)) continue;
                const uint32_t arc = arc_between(from, to);
                if (is_above(to)) {
                    risen = arc;
                } else {
                    next_[arc] = risen;
                    edge_[arc] = face;
                    sides_[side_count_++] = arc;
                }
            }
        }
    }

    void write(OffsetRings& out) {
        for (uint32_t side = 0; side < side_count_; ++side) {
            if (next_[sides_[side]] == none) continue;
            for (uint32_t arc = sides_[side]; next_[arc] != none;) {
                add_point(arc, out);
                const uint32_t after = next_[arc];
                next_[arc] = none;
                arc = after;
            }
            out.offsets.push_back(static_cast<uint32_t>(out.points.size()));
        }
    }

private:
    bool is_above(uint32_t node) const { return skeleton_.nodes[node].time > distance_; }

    // One that is crossed, between two nodes of which it begins at either.
    uint32_t arc_between(uint32_t a, uint32_t b) const {
        for (uint32_t i = first_arc_[a]; i != none; i = next_arc_[i])
            if (skeleton_.arcs[i].b == b) return i;
        for (uint32_t i = first_arc_[b]; i != none; i = next_arc_[i])
            if (skeleton_.arcs[i].b == a) return i;
        return none;
    }

    void add_point(uint32_t arc, OffsetRings& out) const {
        const SkeletonNode &a = skeleton_.nodes[skeleton_.arcs[arc].a], &b = skeleton_.nodes[skeleton_.arcs[arc].b];
        const double share = (distance_ - a.time) / (b.time - a.time);
        out.points.push_back({a.at.x + share * (b.at.x - a.at.x), a.at.y + share * (b.at.y - a.at.y)});
        out.edges.push_back(edge_[arc]);
    }

    const StraightSkeleton& skeleton_;
    double distance_;
    Buffer<uint32_t> first_arc_, next_arc_;  // those that are crossed, by the node that they begin at
    Buffer<uint32_t> next_, edge_;           // by arc that is crossed: the next point of the ring, by way of which face
    Buffer<uint32_t> sides_;                 // the arcs that fall, by face
    uint32_t side_count_ = 0;
};

}  // namespace

void offset_polygons(const StraightSkeleton& skeleton, double distance, OffsetRings& out, Memory* memory) {
    out.points.clear();
    out.edges.clear();
    out.offsets.assign(1, 0);
    Offset offset(skeleton, distance, memory);
    offset.list_arcs();
    offset.add_sides();
    offset.write(out);
}

}  // namespace flg
