// SPDX-License-Identifier: MIT
#include "skeletons/skeleton_faces.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr uint32_t none = ~0u;
constexpr double no_length = 1e-9;      // arcs up to this are contracted
constexpr double most_residual = 1e-6;  // of a node's time, and ten times that of monotony
constexpr double on_one_line = 1e-5;    // |sine| between edges whose bisector the distances do not give
constexpr double most_slant = 1e-7;     // of an arc between such edges

}  // namespace

SkeletonFaces::SkeletonFaces(std::span<const SkeletonNode> nodes, std::span<const SkeletonArc> arcs,
                             std::span<const Point2> points, std::span<const uint32_t> next, uint32_t ring_count,
                             double size, StraightSkeleton& out, Memory* memory)
    : nodes_(nodes),
      arcs_(arcs),
      points_(points),
      next_(next),
      ring_count_(ring_count),
      size_(size),
      out_(out),
      united_(nodes.size(), memory),
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
    out_.residual = 0;
}

void SkeletonFaces::step() {
    const auto nodes = static_cast<uint32_t>(nodes_.size()), arcs = static_cast<uint32_t>(arcs_.size());
    const auto faces = static_cast<uint32_t>(points_.size());
    switch (pass_) {
        case Pass::nodes:
            if (at_ < nodes) {
                united_[at_] = at_;
                next_node_[at_] = none;
            }
            if (at_ < faces + 2) first_half_[at_] = 0;
            if (++at_ == std::max(nodes, faces + 2)) enter(Pass::unite);
            break;
        case Pass::unite:
            unite(arcs_[at_]);
            if (++at_ == arcs) enter(Pass::number);
            break;
        case Pass::number:
            number(at_);
            if (!failed_ && ++at_ == nodes) enter(Pass::arcs);
            break;
        case Pass::arcs:
            add_arc(arcs_[at_]);
            if (++at_ == arcs) enter(Pass::sum);
            break;
        case Pass::sum:
            first_half_[at_ + 1] += first_half_[at_];
            if (++at_ == faces + 1) enter(Pass::halves);
            break;
        case Pass::halves: {
            if (at_ == out_.arcs.size()) {
                enter(Pass::faces);
                break;
            }
            // Counted one place further on, the sums are each face's beginning; they move on to its end.
            const SkeletonArc& arc = out_.arcs[at_++];
            halves_[first_half_[arc.left + 1]++] = {arc.a, arc.b};
            halves_[first_half_[arc.right + 1]++] = {arc.b, arc.a};
            break;
        }
        case Pass::faces:
            if (at_ < faces) {
                if (!chain(at_++)) fail();
            } else {
                out_.face_offsets.push_back(static_cast<uint32_t>(out_.face_nodes.size()));
                enter(Pass::measure);
            }
            break;
        case Pass::measure:
            if (at_ < faces) {
                if (!measure(at_)) fail();
            } else if (at_ - faces < out_.arcs.size()) {
                if (!is_upright(out_.arcs[at_ - faces])) fail();
            } else {
                pass_ = Pass::done;
                failed_ = out_.arcs.size() + 2 != out_.nodes.size() + ring_count_ || out_.residual > most_residual;
            }
            ++at_;
            break;
        case Pass::done: break;
    }
}

uint32_t SkeletonFaces::root(uint32_t node) {
    while (united_[node] != node) node = united_[node] = united_[united_[node]];
    return node;
}

// The ends of arcs without length; the contour's points stay by themselves.
void SkeletonFaces::unite(const SkeletonArc& arc) {
    if (arc.a < points_.size() || arc.b < points_.size()) return;
    const SkeletonNode &from = nodes_[arc.a], &to = nodes_[arc.b];
    if (std::fabs(from.at.x - to.at.x) + std::fabs(from.at.y - to.at.y) > no_length * size_) return;
    const uint32_t a = root(arc.a), b = root(arc.b);
    united_[std::max(a, b)] = std::min(a, b);
}

// The least of those that are one comes first, so it has its number when the others ask for it.
void SkeletonFaces::number(uint32_t node) {
    const uint32_t first = root(node);
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

bool SkeletonFaces::chain(uint32_t face) {
    const uint32_t begin = first_half_[face], end = first_half_[face + 1];
    const auto at = [&](uint32_t i) -> uint32_t& { return next_node_[halves_[i].from]; };
    bool is_chain = true;
    for (uint32_t i = begin; i < end; ++i) {
        is_chain &= at(i) == none;
        at(i) = halves_[i].to;
    }
    out_.face_offsets.push_back(static_cast<uint32_t>(out_.face_nodes.size()));
    out_.face_nodes.push_back(face);
    uint32_t used = 0, node = next_[face];
    for (; is_chain && node != face && node != none && used < end - begin; ++used) {
        out_.face_nodes.push_back(node);
        node = next_node_[node];
    }
    for (uint32_t i = begin; i < end; ++i) at(i) = none;
    return is_chain && node == face && used == end - begin;
}

Point2 SkeletonFaces::direction(uint32_t edge) const {
    const Point2 &a = points_[edge], &b = points_[next_[edge]];
    const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    return {(b.x - a.x) / length, (b.y - a.y) / length};
}

// From the edge's end on, its nodes go back along it as far as they go, once: then its beginning is reached. Each way
// of the walk around a monotone face is one run, so those that turn back are added up against the tolerance.
bool SkeletonFaces::measure(uint32_t face) {
    const uint32_t begin = out_.face_offsets[face], end = out_.face_offsets[face + 1];
    const Point2 &origin = points_[face], along = direction(face);
    double area = 0, previous_s = 0, previous_t = 0;
    int turns = 0, way = 1;
    double furthest = 0;
    for (uint32_t i = begin; i <= end; ++i) {
        const SkeletonNode& node = out_.nodes[out_.face_nodes[i == end ? begin : i]];
        const double dx = node.at.x - origin.x, dy = node.at.y - origin.y;
        const double s = dx * along.x + dy * along.y, t = dy * along.x - dx * along.y;
        if (!(std::fabs(t - node.time) <= most_residual * size_)) return false;
        out_.residual = std::max(out_.residual, std::fabs(t - node.time) / size_);
        area += previous_s * t - s * previous_t;
        if (way * (s - furthest) > 0) furthest = s;
        if (way * (furthest - s) > 10 * most_residual * size_) {
            way = -way;
            furthest = s;
            ++turns;
        }
        previous_s = s;
        previous_t = t;
    }
    // Along the edge, back, and if the face reaches before its beginning forth again.
    return turns <= 2 && area > 0;
}

// Distances say nothing along two edges on one line: the arc between them starts where they meet and is perpendicular.
bool SkeletonFaces::is_upright(const SkeletonArc& arc) const {
    const Point2 u = direction(arc.left), v = direction(arc.right);
    const double sine = std::fabs(u.x * v.y - u.y * v.x);
    if (sine >= on_one_line || u.x * v.x + u.y * v.y < 0) return true;
    const Point2 &a = out_.nodes[arc.a].at, &b = out_.nodes[arc.b].at;
    const double along = std::fabs((b.x - a.x) * u.x + (b.y - a.y) * u.y);
    const double across = std::fabs((b.y - a.y) * u.x - (b.x - a.x) * u.y);
    return along - 2 * sine * across <= most_slant * size_;
}

}  // namespace flg
