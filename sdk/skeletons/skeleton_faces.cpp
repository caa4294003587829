// SPDX-License-Identifier: MIT
#include "skeletons/skeleton_faces.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr uint32_t none = ~0u;
constexpr double contracted_length = 1e-9;  // arcs up to this share of the diagonal are contracted

}  // namespace

SkeletonFaces::SkeletonFaces(std::span<const SkeletonNode> nodes, std::span<const SkeletonArc> arcs,
                             std::span<const Point2> points, std::span<const uint32_t> next, double size,
                             StraightSkeleton& out, Memory* memory)
    : nodes_(nodes),
      arcs_(arcs),
      points_(points),
      next_(next),
      size_(size),
      out_(out),
      clusters_(nodes.size(), memory),
      number_(nodes.size(), memory),
      first_half_(points.size() + 2, memory),
      halves_(2 * arcs.size(), memory),
      next_node_(nodes.size(), memory) {
    out_.nodes.clear();
    out_.arcs.clear();
    out_.face_offsets.clear();
    out_.face_nodes.clear();
    out_.nodes.reserve(nodes.size());
    out_.arcs.reserve(arcs.size());
    out_.face_offsets.reserve(points.size() + 1);
    out_.face_nodes.reserve(2 * arcs.size() + points.size());
}

void SkeletonFaces::step() {
    const size_t faces = points_.size();
    switch (pass_) {
        case Pass::nodes:
            some(std::max(nodes_.size(), faces + 2), Pass::join, [&](uint32_t i) {
                if (i < nodes_.size()) {
                    clusters_.begin(i);
                    next_node_[i] = none;
                }
                if (i < faces + 2) first_half_[i] = 0;
            });
            break;
        case Pass::join: some(arcs_.size(), Pass::number, [&](uint32_t i) { join(arcs_[i]); }); break;
        case Pass::number: some(nodes_.size(), Pass::arcs, [&](uint32_t i) { number(i); }); break;
        case Pass::arcs: some(arcs_.size(), Pass::sum, [&](uint32_t i) { add_arc(arcs_[i]); }); break;
        case Pass::sum: some(faces + 1, Pass::halves, [&](uint32_t i) { first_half_[i + 1] += first_half_[i]; }); break;
        case Pass::halves:
            some(out_.arcs.size(), Pass::link, [&](uint32_t i) { add_halves(out_.arcs[i]); });
            if (pass_ == Pass::link) begin_face();
            break;
        case Pass::link: link(); break;
        case Pass::walk: walk(); break;
        case Pass::unlink: unlink(); break;
        case Pass::done: break;
    }
}

// The ends of arcs without length; the contour's points stay by themselves.
void SkeletonFaces::join(const SkeletonArc& arc) {
    if (arc.a < points_.size() || arc.b < points_.size()) return;
    const SkeletonNode &from = nodes_[arc.a], &to = nodes_[arc.b];
    if (std::fabs(from.at.x - to.at.x) + std::fabs(from.at.y - to.at.y) <= contracted_length * size_)
        clusters_.join(arc.a, arc.b);
}

// The least of those that are one comes first, so it has its number when the others ask for it.
void SkeletonFaces::number(uint32_t node) {
    const uint32_t first = clusters_.first(node);
    if (first != node) {
        number_[node] = number_[first];
        return;
    }
    if (node >= points_.size() && !(nodes_[node].time > 0)) {
        fail();
        return;
    }
    number_[node] = static_cast<uint32_t>(out_.nodes.size());
    out_.nodes.push_back(nodes_[node]);
    if (node < points_.size()) out_.nodes.back().at = points_[node];
}

void SkeletonFaces::add_arc(const SkeletonArc& arc) {
    const uint32_t a = number_[arc.a], b = number_[arc.b];
    if (a == b) return;
    out_.arcs.push_back({a, b, arc.left, arc.right});
    ++first_half_[arc.left + 2];
    ++first_half_[arc.right + 2];
}

// Counted one place further on, the sums are each face's beginning; they move on to its end.
void SkeletonFaces::add_halves(const SkeletonArc& arc) {
    halves_[first_half_[arc.left + 1]++] = {arc.a, arc.b};
    halves_[first_half_[arc.right + 1]++] = {arc.b, arc.a};
}

void SkeletonFaces::begin_face() {
    out_.face_offsets.push_back(static_cast<uint32_t>(out_.face_nodes.size()));
    if (face_ == points_.size()) {
        pass_ = Pass::done;
        return;
    }
    pass_ = Pass::link;
    at_ = first_half_[face_];
    out_.face_nodes.push_back(face_);
    node_ = next_[face_];
    used_ = 0;
}

void SkeletonFaces::link() {
    const uint32_t all = first_half_[face_ + 1], end = std::min(all, at_ + batch);
    for (; at_ < end; ++at_) {
        uint32_t& following = next_node_[halves_[at_].from];
        if (following != none) {
            fail();
            return;
        }
        following = halves_[at_].to;
    }
    if (at_ == all) pass_ = Pass::walk;
}

void SkeletonFaces::walk() {
    const uint32_t all = first_half_[face_ + 1] - first_half_[face_], end = std::min(all, used_ + batch);
    for (; used_ < end && node_ != face_ && node_ != none; ++used_) {
        out_.face_nodes.push_back(node_);
        node_ = next_node_[node_];
    }
    if (used_ < all && node_ != face_ && node_ != none) return;
    if (node_ == face_ && used_ == all) {
        pass_ = Pass::unlink;
        at_ = first_half_[face_];
    } else {
        fail();
    }
}

void SkeletonFaces::unlink() {
    const uint32_t all = first_half_[face_ + 1], end = std::min(all, at_ + batch);
    for (; at_ < end; ++at_) next_node_[halves_[at_].from] = none;
    if (at_ < all) return;
    ++face_;
    begin_face();
}

}  // namespace flg
