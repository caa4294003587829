// SPDX-License-Identifier: MIT
#include "skeletons/skeleton_check.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

// Lengths are shares of the diagonal.
constexpr double most_residual = 1e-6;  // of a node's time, and ten times that of monotony
constexpr double on_one_line = 1e-5;    // |sine| between edges whose bisector the distances do not give
constexpr double most_slant = 1e-7;     // of an arc between such edges
constexpr double moved_most_slant = 1e-4;
constexpr double short_arc = 1e-7;  // and ten residuals: up to this an arc's direction is noise
constexpr double moved_short_arc = 1e-5;
constexpr double level_noise = 1e-6;  // of an arc's slope, beside what its length makes of that
constexpr double pinch = 1e-12;       // a node nearer than this to an arc is on it
constexpr double moved_pinch = 1e-14;
constexpr double near_end = 1e-6;  // of an arc: what is nearer is at its end

double sine_between(const Point2& a, const Point2& b) {
    return a.x * b.y - a.y * b.x;
}

}  // namespace

SkeletonCheck::SkeletonCheck(std::span<const Point2> points, std::span<const uint32_t> next, uint32_t ring_count,
                             double size, double perturbation, StraightSkeleton& skeleton, Memory* memory)
    : points_(points),
      next_(next),
      ring_count_(ring_count),
      size_(size),
      most_slant_((perturbation > 0 ? moved_most_slant : most_slant) * size),
      shortest_((perturbation > 0 ? moved_short_arc : short_arc) * size),
      pinch_((perturbation > 0 ? moved_pinch : pinch) * size),
      skeleton_(skeleton),
      directions_(points.size(), memory),
      clusters_(skeleton.nodes.size(), memory),
      places_(skeleton.nodes.size(), memory) {
    skeleton_.residual = 0;
}

void SkeletonCheck::step() {
    const auto& nodes = skeleton_.nodes;
    const auto& arcs = skeleton_.arcs;
    switch (pass_) {
        case Pass::directions: some(points_.size(), Pass::upright, [&](uint32_t i) { find_direction(i); }); break;
        case Pass::upright:
            some(arcs.size(), Pass::measure, [&](uint32_t i) {
                if (!is_upright(arcs[i])) fail();
            });
            break;
        case Pass::measure: measure(); break;
        case Pass::nodes: some(nodes.size(), Pass::join, [&](uint32_t i) { clusters_.begin(i); }); break;
        case Pass::join: some(arcs.size(), Pass::corners, [&](uint32_t i) { join(arcs[i]); }); break;
        case Pass::corners: corners(); break;
        case Pass::place: place(); break;
        case Pass::sweep: sweep(); break;
        case Pass::done: break;
    }
}

SkeletonCheck::Place SkeletonCheck::place_of(uint32_t node) const {
    const Point2 &at = skeleton_.nodes[node].at, &origin = points_[face_], &along = directions_[face_];
    const double dx = at.x - origin.x, dy = at.y - origin.y;
    return {dx * along.x + dy * along.y, dy * along.x - dx * along.y};
}

void SkeletonCheck::find_direction(uint32_t edge) {
    const Point2 &a = points_[edge], &b = points_[next_[edge]];
    const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    directions_[edge] = {(b.x - a.x) / length, (b.y - a.y) / length};
}

// Distances say nothing along two edges on one line: the arc between them starts where they meet and is perpendicular.
bool SkeletonCheck::is_upright(const SkeletonArc& arc) const {
    const Point2 &u = directions_[arc.left], &v = directions_[arc.right];
    const double sine = std::fabs(sine_between(u, v));
    if (sine >= on_one_line || u.x * v.x + u.y * v.y < 0) return true;
    const Point2 &a = skeleton_.nodes[arc.a].at, &b = skeleton_.nodes[arc.b].at;
    const Point2 way = {b.x - a.x, b.y - a.y};
    const double along = std::fabs(way.x * u.x + way.y * u.y), across = std::fabs(sine_between(u, way));
    return along - 2 * sine * across <= most_slant_;
}

// From the edge's end on, a face's nodes go back along it as far as they go, once: then its beginning is reached. Each
// way of the walk around a monotone face is one run, so those that turn back are added up against the tolerance.
void SkeletonCheck::measure() {
    const uint32_t size = face_size(), end = std::min(size + 1, at_ + batch);
    for (; at_ < end; ++at_) {
        if (!measure_node(skeleton_.nodes[ring_node(at_ == size ? 0 : at_)])) {
            fail();
            return;
        }
    }
    if (at_ <= size) return;
    // Along the edge, back, and if the face reaches before its beginning forth again.
    if (walk_.turns > 2 || !(walk_.area > 0)) {
        fail();
        return;
    }
    walk_ = {};
    at_ = 0;
    if (++face_ == points_.size()) end_counts();
}

bool SkeletonCheck::measure_node(const SkeletonNode& node) {
    const Point2 &origin = points_[face_], &along = directions_[face_];
    const double dx = node.at.x - origin.x, dy = node.at.y - origin.y;
    const double s = dx * along.x + dy * along.y, t = dy * along.x - dx * along.y, off = std::fabs(t - node.time);
    if (!(off <= most_residual * size_)) return false;
    skeleton_.residual = std::max(skeleton_.residual, off / size_);
    walk_.area += walk_.previous_s * t - s * walk_.previous_t;
    if (walk_.way * (s - walk_.furthest) > 0) walk_.furthest = s;
    if (walk_.way * (walk_.furthest - s) > 10 * most_residual * size_) {
        walk_.way = -walk_.way;
        walk_.furthest = s;
        ++walk_.turns;
    }
    walk_.previous_s = s;
    walk_.previous_t = t;
    return true;
}

void SkeletonCheck::end_counts() {
    if (skeleton_.arcs.size() + 2 != skeleton_.nodes.size() + ring_count_) {
        fail();
        return;
    }
    face_ = 0;
    shortest_ = std::max(shortest_, 10 * skeleton_.residual * size_);
    slack_ = pinch_ + 10 * skeleton_.residual * size_;
    enter(Pass::nodes);
}

void SkeletonCheck::join(const SkeletonArc& arc) {
    if (is_contour(arc.a)) return;
    const Point2 &a = skeleton_.nodes[arc.a].at, &b = skeleton_.nodes[arc.b].at;
    const double dx = b.x - a.x, dy = b.y - a.y;
    if (dx * dx + dy * dy < shortest_ * shortest_) clusters_.join(arc.a, arc.b);
}

// Around the face from its edge's end on; nodes that short arcs join are one.
void SkeletonCheck::corners() {
    if (at_ == 0) {
        before_ = ring_node(0);
        first_ = last_ = ring_node(1);
        at_ = 2;
    }
    const uint32_t size = face_size(), end = std::min(size + 1, at_ + batch);
    for (; at_ < end; ++at_) {
        const uint32_t node = ring_node(at_ == size ? 0 : at_);
        if (clusters_.first(node) != clusters_.first(last_)) {
            if (!is_contour(first_) && !is_swept(before_, first_, last_, node)) {
                fail();
                return;
            }
            before_ = last_;
            first_ = node;
        }
        last_ = node;
    }
    if (at_ > size) enter(Pass::place);
}

// Whether the front goes on at the corner between the arcs from `before` to `first` and from `last` to `after`.
bool SkeletonCheck::is_swept(uint32_t before, uint32_t first, uint32_t last, uint32_t after) {
    if (clusters_.first(before) == clusters_.first(after)) return true;
    const auto way = [&](uint32_t from, uint32_t to) {
        const Point2 &p = skeleton_.nodes[from].at, &q = skeleton_.nodes[to].at;
        return Point2{q.x - p.x, q.y - p.y};
    };
    const Point2 a = way(first, before), b = way(last, after), &along = directions_[face_];
    const double a_length = std::sqrt(a.x * a.x + a.y * a.y), b_length = std::sqrt(b.x * b.x + b.y * b.y);
    const double level = level_noise + 2 * shortest_ / std::min(a_length, b_length);
    const double a_rise = sine_between(along, a) / a_length, b_rise = sine_between(along, b) / b_length;
    const bool a_level = std::fabs(a_rise) <= level, b_level = std::fabs(b_rise) <= level;
    if (b_level && !is_contour(after) && (b.x * along.x + b.y * along.y) > 0.5 * b_length) return false;
    if (a_level || b_level || (a_rise > 0) != (b_rise > 0)) return true;
    // The turn from b to a, counter-clockwise: a half turn but for noise, less, or more. None at all is little.
    const double sine = sine_between(b, a) / (a_length * b_length);
    const bool is_ahead = a.x * b.x + a.y * b.y > 0;
    const bool is_less = is_ahead ? sine > -1e-3 : sine > level, is_more = is_ahead ? !is_less : sine < -level;
    return a_rise > 0 ? !is_less : !is_more;
}

void SkeletonCheck::place() {
    const uint32_t size = face_size(), end = std::min(size, at_ + batch);
    if (at_ == 0) lowest_ = highest_ = 0;
    for (; at_ < end; ++at_) {
        places_[at_] = place_of(ring_node(at_));
        if (places_[at_].s < places_[lowest_].s) lowest_ = at_;
        if (places_[at_].s > places_[highest_].s) highest_ = at_;
    }
    if (at_ < size) return;
    pass_ = Pass::sweep;
    begin_sweep(true);
}

// From the face's lowest node to its highest by one of the two ways around, which are monotone.
void SkeletonCheck::begin_sweep(bool forwards) {
    forwards_ = forwards;
    own_ = other_ = probe_ = lowest_;
}

uint32_t SkeletonCheck::beyond(uint32_t i, bool forwards) const {
    const uint32_t size = face_size();
    return forwards ? (i + 1 == size ? 0 : i + 1) : (i == 0 ? size : i) - 1;
}

// Each node against the arcs of the other way around that are over or under it, and the two next to it on its own.
void SkeletonCheck::sweep() {
    for (uint32_t i = 0; i < batch; ++i) {
        const uint32_t to = beyond(probe_, !forwards_);
        const double s = places_[own_].s;
        if (probe_ == highest_ || places_[probe_].s > s + slack_) {
            if (own_ == highest_) {
                end_sweep();
                return;
            }
            own_ = beyond(own_, forwards_);
            probe_ = other_;
            const uint32_t after = beyond(own_, true), before = beyond(own_, false);
            if (is_on(own_, after, beyond(after, true)) || is_on(own_, before, beyond(before, false))) fail();
        } else if (probe_ == other_ && places_[to].s < s - slack_) {
            other_ = probe_ = to;
        } else {
            if (is_on(own_, probe_, to)) fail();
            probe_ = to;
        }
        if (failed_) return;
    }
}

void SkeletonCheck::end_sweep() {
    if (forwards_) {
        begin_sweep(false);
    } else if (++face_ == points_.size()) {
        pass_ = Pass::done;
    } else {
        enter(Pass::corners);
    }
}

bool SkeletonCheck::is_on(uint32_t i, uint32_t from, uint32_t to) const {
    if (i < 2 || i == from || i == to) return false;  // the edge's ends are the contour's
    const Place &p = places_[i], &a = places_[from], &b = places_[to];
    const double ds = b.s - a.s, dt = b.t - a.t, off = (p.s - a.s) * dt - (p.t - a.t) * ds;
    const double length_sq = ds * ds + dt * dt;
    if (off * off >= pinch_ * pinch_ * length_sq) return false;
    const double length = std::sqrt(length_sq), at = ((p.s - a.s) * ds + (p.t - a.t) * dt) / length;
    return at >= near_end * size_ && length - at >= near_end * size_;
}

}  // namespace flg
