// SPDX-License-Identifier: MIT
// Of the wavefront: when a triangle changes next, and what the change is.
#include <cmath>
#include <limits>

#include "skeletons/wavefront.h"
#include "skeletons/wavefront_limits.h"

namespace flg {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr int longest_walk = 1000;

double cross(const Point2& a, const Point2& b) {
    return a.x * b.y - a.y * b.x;
}
double dot(const Point2& a, const Point2& b) {
    return a.x * b.x + a.y * b.y;
}
Point2 difference(const Point2& a, const Point2& b) {
    return {a.x - b.x, a.y - b.y};
}

}  // namespace

Wavefront::Shape Wavefront::shape(const Triangle& triangle) const {
    Shape s;
    for (uint32_t k = 0; k < 3; ++k) {
        const Vertex& vertex = vertices_[triangle.vertices[k]];
        s.at[k] = position(vertex);
        s.velocity[k] = vertex.velocity;
    }
    for (uint32_t k = 0; k < 3; ++k) {
        const Point2 side = difference(s.at[before(k)], s.at[after(k)]);
        s.lengths[k] = std::sqrt(dot(side, side));
    }
    return s;
}

void Wavefront::closing_edges(const Triangle& t, const Shape& s, WaveEvent& event) const {
    for (uint32_t k = 0; k < 3; ++k) {
        if (t.neighbours[k] >= 0) continue;
        const Point2& direction = lines_[~t.neighbours[k]].direction;
        const double length = dot(direction, difference(s.at[before(k)], s.at[after(k)]));
        const double growth = dot(direction, difference(s.velocity[before(k)], s.velocity[after(k)]));
        const double time = length <= wave::coincident * size_ ? now_ : growth < 0 ? now_ - length / growth : never;
        if (time < event.time) event = {time, WaveEvent::Kind::edge, static_cast<uint8_t>(k)};
    }
}

void Wavefront::closing_diagonals(const Triangle& t, const Shape& s, WaveEvent& event) const {
    for (uint32_t k = 0; k < 3; ++k) {
        if (t.neighbours[k] < 0) continue;
        const Point2 apart = difference(s.at[before(k)], s.at[after(k)]);
        const Point2 speed = difference(s.velocity[before(k)], s.velocity[after(k)]);
        const double approach = dot(apart, speed), speed_sq = dot(speed, speed), miss = cross(apart, speed);
        const double bound = wave::closes * size_;
        if (approach >= 0 || miss * miss > speed_sq * bound * bound) continue;
        const double time = now_ - approach / speed_sq;
        if (time < event.time) event = {time, WaveEvent::Kind::diagonal, static_cast<uint8_t>(k)};
    }
}

// Of a triangle with one front edge: when the corner across from it reaches it.
double Wavefront::reaches_edge(const Triangle& t, const Shape& s) const {
    const uint32_t k = t.neighbours[0] < 0 ? 0 : t.neighbours[1] < 0 ? 1 : 2;
    const Line& line = lines_[~t.neighbours[k]];
    const double height = dot(line.normal, s.at[k]) - line.offset - now_, growth = dot(line.normal, s.velocity[k]) - 1;
    if (height <= wave::on_line * size_) return growth <= 1e-9 ? now_ : never;
    return growth < 0 ? now_ - height / growth : never;
}

// Of a triangle without front edges: when its area gets zero, a quadratic equation.
double Wavefront::gets_flat(const Shape& s) const {
    const Point2 b = difference(s.at[1], s.at[0]), c = difference(s.at[2], s.at[0]);
    const Point2 u = difference(s.velocity[1], s.velocity[0]), w = difference(s.velocity[2], s.velocity[0]);
    const double area = cross(b, c), rate = cross(b, w) + cross(u, c), bend = cross(u, w);
    const double longest = std::max(s.lengths[0], std::max(s.lengths[1], s.lengths[2]));
    const double noise = wave::flat_height * size_ * longest;
    if (area <= noise) {
        const double speed = std::fabs(u.x) + std::fabs(u.y) + std::fabs(w.x) + std::fabs(w.y);
        if (rate <= wave::rate_noise * longest * speed) return now_;
        return bend < 0 ? now_ - rate / bend : never;
    }
    const double discriminant = rate * rate - 4 * area * bend;
    if (discriminant < 0) {
        const bool touches = rate < 0 && bend > 0 && area - rate * rate / (4 * bend) <= noise;
        return touches ? now_ - rate / (2 * bend) : never;
    }
    const double root = std::sqrt(discriminant);
    if (rate < 0) return now_ + 2 * area / (root - rate);
    return bend < 0 ? now_ - (rate + root) / (2 * bend) : never;
}

void Wavefront::schedule(int32_t index) {
    const Triangle& t = triangles_[index];
    const Shape s = shape(t);
    const uint32_t front = front_sides(t);
    WaveEvent event = {never, WaveEvent::Kind::flat, 0};
    closing_edges(t, s, event);
    for (uint32_t k = 0; k < 3; ++k) {
        const bool closed = t.neighbours[k] >= 0 && s.lengths[k] <= wave::coincident * size_;
        if (closed && now_ < event.time) event = {now_, WaveEvent::Kind::flat, 0};
    }
    const auto is_infinite = [&](uint32_t k) { return vertices_[t.vertices[k]].is_infinite; };
    if (is_infinite(0) || is_infinite(1) || is_infinite(2)) {
        if (event.time > now_) event = {now_, WaveEvent::Kind::last, 0};
    } else if (front < 3) {
        WaveEvent closing = {never, WaveEvent::Kind::diagonal, 0};
        closing_diagonals(t, s, closing);
        const double flat = front == 1 ? reaches_edge(t, s) : front == 0 ? gets_flat(s) : never;
        if (closing.time < event.time) event = closing;
        if (flat < event.time && flat < closing.time - wave::closing_lead * size_)
            event = {flat, WaveEvent::Kind::flat, 0};
    }
    // No front outlives its contour's diagonal.
    if (event.time < now_ + 2 * size_) {
        queue_.set(static_cast<uint32_t>(index), event);
    } else {
        queue_.remove(static_cast<uint32_t>(index));
    }
}

Wavefront::Change Wavefront::decide(int32_t& triangle, uint32_t& side, const WaveEvent& event) const {
    const Triangle& t = triangles_[triangle];
    const auto shortest_front = [&](const Shape& s, uint32_t best) {
        for (uint32_t k = 0; k < 3; ++k) {
            if (t.neighbours[k] < 0 && (best == 3 || s.lengths[k] < s.lengths[best])) best = k;
        }
        return best;
    };
    if (event.kind == WaveEvent::Kind::diagonal) return Change::diagonal;
    if (event.kind == WaveEvent::Kind::edge) {
        if (front_sides(t) > 1) side = shortest_front(shape(t), side);
        return Change::edge;
    }
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t i = after(k), j = before(k);
        if (!vertices_[t.vertices[k]].is_infinite || t.neighbours[i] >= 0 || t.neighbours[j] >= 0) continue;
        const Shape s = shape(t);
        side = s.lengths[i] <= s.lengths[j] ? i : j;
        return Change::edge;
    }
    const int32_t began_at = triangle;
    const Change change = decide_flat(triangle, side);
    if (change != Change::split || triangle != began_at || front_sides(t) < 2) return change;
    side = shortest_front(shape(t), 3);
    return Change::edge;
}

Wavefront::Change Wavefront::decide_flat(int32_t& triangle, uint32_t& side) const {
    const Triangle& t = triangles_[triangle];
    const Shape s = shape(t);
    uint32_t shortest = 0, longest = 0;
    for (uint32_t k = 1; k < 3; ++k) {
        if (s.lengths[k] < s.lengths[shortest]) shortest = k;
        if (s.lengths[k] > s.lengths[longest]) longest = k;
    }
    if (s.lengths[shortest] <= 10 * wave::coincident * size_) {
        side = shortest;
        return t.neighbours[shortest] < 0 ? Change::edge : Change::diagonal;
    }
    side = longest;
    return t.neighbours[longest] < 0 ? Change::split : walk_to_longest(triangle, side);
}

// Through neighbours that are flat too, each across the longest side of the one before, while sides get longer.
Wavefront::Change Wavefront::walk_to_longest(int32_t& triangle, uint32_t& side) const {
    for (int i = 0; i < longest_walk; ++i) {
        const int32_t other = triangles_[triangle].neighbours[side];
        const Triangle& t = triangles_[other];
        bool stops = front_sides(t) > 1;
        for (const int32_t vertex : t.vertices) stops |= vertices_[vertex].is_infinite;
        if (stops) break;
        const Shape s = shape(t);
        uint32_t longest = 0;
        for (uint32_t k = 1; k < 3; ++k) {
            if (s.lengths[k] > s.lengths[longest]) longest = k;
        }
        const uint32_t shared = side_to(other, triangle);
        if (longest == shared || s.lengths[longest] <= s.lengths[shared]) break;
        const double area = cross(difference(s.at[1], s.at[0]), difference(s.at[2], s.at[0]));
        if (area > wave::walk_height * size_ * s.lengths[longest]) break;
        const double bound = 10 * wave::coincident * size_;
        if (s.lengths[after(longest)] <= bound || s.lengths[before(longest)] <= bound) break;
        triangle = other;
        side = longest;
        if (t.neighbours[longest] < 0) return Change::split;
    }
    return Change::flip;
}

}  // namespace flg
