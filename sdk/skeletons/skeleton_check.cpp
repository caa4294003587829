// SPDX-License-Identifier: MIT
#include "skeletons/skeleton_check.h"

#include <algorithm>
#include <cmath>

#include "skeletons/node_clusters.h"
#include "skeletons/passes.h"

namespace flg {

namespace {

// Lengths are shares of the diagonal.
constexpr double max_residual = 1e-6;  // of a node's time, and ten times that of monotony
constexpr double on_one_line = 1e-5;   // |sine| between edges whose bisector the distances do not give
constexpr double max_slant = 1e-7;     // of an arc between such edges
constexpr double moved_max_slant = 1e-4;
constexpr double short_arc = 1e-7;  // and ten residuals: up to this an arc's direction is noise
constexpr double moved_short_arc = 1e-5;
constexpr double level_noise = 1e-6;  // of an arc's slope, beside what its length makes of that
constexpr double pinch = 1e-12;       // a node nearer than this to an arc is on it
constexpr double moved_pinch = 1e-14;
constexpr double near_end = 1e-6;  // of an arc: what is nearer is at its end

double sine_between(const Point2& a, const Point2& b) {
    return a.x * b.y - a.y * b.x;
}

class Check {
public:
    Check(std::span<const Point2> points, std::span<const uint32_t> next, double size, double perturbation,
          StraightSkeleton& skeleton, Memory* memory);

    void find_direction(uint32_t edge);
    bool is_upright(const SkeletonArc& arc) const;
    void begin_face(uint32_t face);
    uint32_t face_size() const { return skeleton_.face_offsets[face_ + 1] - face_begin(); }
    bool measure_node(uint32_t i);
    bool end_measuring() const;
    void end_residual();
    void begin_node(uint32_t node) { clusters_.begin(node); }
    void join(const SkeletonArc& arc);
    bool go_on(uint32_t i);
    void place(uint32_t i);
    void begin_sweep(bool forwards);
    bool sweep();
    void fail() { has_failed_ = true; }
    bool has_failed() const { return has_failed_; }

private:
    // Which way a face's walk around has gone since it last turned back.
    struct Walk {
        double area = 0, previous_s = 0, previous_t = 0, furthest = 0;
        int turns = 0, way = 1;
    };
    struct Place {
        double s, t;  // along a face's edge, from its beginning, and above its line
    };

    uint32_t face_begin() const { return skeleton_.face_offsets[face_]; }
    // Around the face: the one after the last is the first.
    uint32_t ring_node(uint32_t i) const { return skeleton_.face_nodes[face_begin() + (i == face_size() ? 0 : i)]; }
    bool is_contour(uint32_t node) const { return node < points_.size(); }
    Place place_of(uint32_t node) const;
    bool is_swept(uint32_t before, uint32_t first, uint32_t last, uint32_t after);
    bool is_on(uint32_t i, uint32_t from, uint32_t to) const;
    uint32_t beyond(uint32_t i, bool forwards) const;

    std::span<const Point2> points_;
    std::span<const uint32_t> next_;
    double size_;
    double max_slant_;
    double shortest_;  // arcs up to this length say nothing of how the front goes on
    double pinch_;
    double slack_ = 0;  // of a face's order along its edge
    StraightSkeleton& skeleton_;
    Buffer<Point2> directions_;  // of the edges
    NodeClusters clusters_;
    Buffer<Place> places_;  // of the nodes of the face at hand
    uint32_t face_ = 0;
    Walk walk_;
    // The last two clusters on the way around a face: the first's last node, and both ends of the second.
    uint32_t before_ = 0, first_ = 0, last_ = 0;
    uint32_t lowest_ = 0, highest_ = 0;         // of the face's nodes, along its edge
    uint32_t own_ = 0, other_ = 0, probe_ = 0;  // the node at hand, and where on the other side arcs are tried
    bool forwards_ = true;
    bool has_failed_ = false;
};

Check::Check(std::span<const Point2> points, std::span<const uint32_t> next, double size, double perturbation,
             StraightSkeleton& skeleton, Memory* memory)
    : points_(points),
      next_(next),
      size_(size),
      max_slant_((perturbation > 0 ? moved_max_slant : max_slant) * size),
      shortest_((perturbation > 0 ? moved_short_arc : short_arc) * size),
      pinch_((perturbation > 0 ? moved_pinch : pinch) * size),
      skeleton_(skeleton),
      directions_(points.size(), memory),
      clusters_(skeleton.nodes.size(), memory),
      places_(skeleton.nodes.size(), memory) {
    skeleton_.residual = 0;
}

Check::Place Check::place_of(uint32_t node) const {
    const Point2 &at = skeleton_.nodes[node].at, &origin = points_[face_], &along = directions_[face_];
    const double dx = at.x - origin.x, dy = at.y - origin.y;
    return {dx * along.x + dy * along.y, dy * along.x - dx * along.y};
}

void Check::find_direction(uint32_t edge) {
    const Point2 &a = points_[edge], &b = points_[next_[edge]];
    const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    directions_[edge] = {(b.x - a.x) / length, (b.y - a.y) / length};
}

// Distances say nothing along two edges on one line: the arc between them starts where they meet and is perpendicular.
bool Check::is_upright(const SkeletonArc& arc) const {
    const Point2 &u = directions_[arc.left], &v = directions_[arc.right];
    const double sine = std::fabs(sine_between(u, v));
    if (sine >= on_one_line || u.x * v.x + u.y * v.y < 0) return true;
    const Point2 &a = skeleton_.nodes[arc.a].at, &b = skeleton_.nodes[arc.b].at;
    const Point2 way = {b.x - a.x, b.y - a.y};
    const double along = std::fabs(way.x * u.x + way.y * u.y), across = std::fabs(sine_between(u, way));
    return along - 2 * sine * across <= max_slant_;
}

void Check::begin_face(uint32_t face) {
    face_ = face;
    walk_ = {};
    lowest_ = highest_ = 0;
    before_ = ring_node(0);
    first_ = last_ = ring_node(1);
}

// From the edge's end on, a face's nodes go back along it as far as they go, once: then its beginning is reached. Each
// way of the walk around a monotone face is one run, so those that turn back are added up against the tolerance.
bool Check::measure_node(uint32_t i) {
    const SkeletonNode& node = skeleton_.nodes[ring_node(i)];
    const Point2 &origin = points_[face_], &along = directions_[face_];
    const double dx = node.at.x - origin.x, dy = node.at.y - origin.y;
    const double s = dx * along.x + dy * along.y, t = dy * along.x - dx * along.y, off = std::fabs(t - node.time);
    if (!(off <= max_residual * size_)) return false;
    skeleton_.residual = std::max(skeleton_.residual, off / size_);
    walk_.area += walk_.previous_s * t - s * walk_.previous_t;
    if (walk_.way * (s - walk_.furthest) > 0) walk_.furthest = s;
    if (walk_.way * (walk_.furthest - s) > 10 * max_residual * size_) {
        walk_.way = -walk_.way;
        walk_.furthest = s;
        ++walk_.turns;
    }
    walk_.previous_s = s;
    walk_.previous_t = t;
    return true;
}

// Along the edge, back, and if the face reaches before its beginning forth again.
bool Check::end_measuring() const {
    return walk_.turns <= 2 && walk_.area > 0;
}

void Check::end_residual() {
    shortest_ = std::max(shortest_, 10 * skeleton_.residual * size_);
    slack_ = pinch_ + 10 * skeleton_.residual * size_;
}

void Check::join(const SkeletonArc& arc) {
    if (is_contour(arc.a)) return;
    const Point2 &a = skeleton_.nodes[arc.a].at, &b = skeleton_.nodes[arc.b].at;
    const double dx = b.x - a.x, dy = b.y - a.y;
    if (dx * dx + dy * dy < shortest_ * shortest_) clusters_.join(arc.a, arc.b);
}

// Around the face from its edge's end on: whether the front goes on at the nodes before this one. Nodes that short arcs
// join are one.
bool Check::go_on(uint32_t i) {
    const uint32_t node = ring_node(i);
    if (clusters_.first(node) != clusters_.first(last_)) {
        if (!is_contour(first_) && !is_swept(before_, first_, last_, node)) return false;
        before_ = last_;
        first_ = node;
    }
    last_ = node;
    return true;
}

// Whether the front goes on at the corner between the arcs from `before` to `first` and from `last` to `after`.
bool Check::is_swept(uint32_t before, uint32_t first, uint32_t last, uint32_t after) {
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

void Check::place(uint32_t i) {
    places_[i] = place_of(ring_node(i));
    if (places_[i].s < places_[lowest_].s) lowest_ = i;
    if (places_[i].s > places_[highest_].s) highest_ = i;
}

// From the face's lowest node to its highest by one of the two ways around, which are monotone.
void Check::begin_sweep(bool forwards) {
    forwards_ = forwards;
    own_ = other_ = probe_ = lowest_;
}

uint32_t Check::beyond(uint32_t i, bool forwards) const {
    const uint32_t size = face_size();
    return forwards ? (i + 1 == size ? 0 : i + 1) : (i == 0 ? size : i) - 1;
}

// A step of that: a node against an arc of the other way around that is over or under it, or, when its turn comes,
// against the two next to it on its own. False when the highest node is done, or at a fault.
bool Check::sweep() {
    const uint32_t to = beyond(probe_, !forwards_);
    const double s = places_[own_].s;
    if (probe_ == highest_ || places_[probe_].s > s + slack_) {
        if (own_ == highest_) return false;
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
    return !has_failed_;
}

bool Check::is_on(uint32_t i, uint32_t from, uint32_t to) const {
    if (i < 2 || i == from || i == to) return false;  // the edge's ends are the contour's
    const Place &p = places_[i], &a = places_[from], &b = places_[to];
    const double ds = b.s - a.s, dt = b.t - a.t, off = (p.s - a.s) * dt - (p.t - a.t) * ds;
    const double length_sq = ds * ds + dt * dt;
    if (off * off >= pinch_ * pinch_ * length_sq) return false;
    const double length = std::sqrt(length_sq), at = ((p.s - a.s) * ds + (p.t - a.t) * dt) / length;
    return at >= near_end * size_ && length - at >= near_end * size_;
}

}  // namespace

Task<bool> can_be_straight_skeleton(Pace& pace, std::span<const Point2> points, std::span<const uint32_t> next,
                                    uint32_t ring_count, double size, double perturbation, StraightSkeleton& skeleton,
                                    Memory* memory) {
    const auto& nodes = skeleton.nodes;
    const auto& arcs = skeleton.arcs;
    const auto faces = static_cast<uint32_t>(points.size());
    Check check(points, next, size, perturbation, skeleton, memory);
    co_await pass(pace, faces, Cost::tens_of_ns, [&](uint32_t i) { check.find_direction(i); });
    co_await pass(pace, arcs.size(), Cost::tens_of_ns, [&](uint32_t i) {
        if (!check.is_upright(arcs[i])) check.fail();
    });
    if (check.has_failed()) co_return false;
    Slice slice(Cost::tens_of_ns);
    for (uint32_t face = 0; face < faces; ++face) {
        check.begin_face(face);
        for (uint32_t i = 0; i <= check.face_size(); ++i) {
            if (!check.measure_node(i)) co_return false;
            if (slice.is_over()) co_await pace;
        }
        if (!check.end_measuring()) co_return false;
    }
    if (arcs.size() + 2 != nodes.size() + ring_count) co_return false;
    check.end_residual();
    co_await pass(pace, nodes.size(), Cost::some_ns, [&](uint32_t i) { check.begin_node(i); });
    co_await pass(pace, arcs.size(), Cost::tens_of_ns, [&](uint32_t i) { check.join(arcs[i]); });
    for (uint32_t face = 0; face < faces; ++face) {
        check.begin_face(face);
        const uint32_t count = check.face_size();
        for (uint32_t i = 2; i <= count; ++i) {
            if (!check.go_on(i)) co_return false;
            if (slice.is_over()) co_await pace;
        }
        for (uint32_t i = 0; i < count; ++i) {
            check.place(i);
            if (slice.is_over()) co_await pace;
        }
        // From the face's lowest node to its highest by both ways around, which are monotone.
        for (uint32_t way = 0; way < 2; ++way) {
            check.begin_sweep(way == 0);
            while (check.sweep())
                if (slice.is_over()) co_await pace;
            if (check.has_failed()) co_return false;
        }
    }
    co_return true;
}

}  // namespace flg
