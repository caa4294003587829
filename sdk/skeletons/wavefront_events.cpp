// SPDX-License-Identifier: MIT
// Of the wavefront: when a triangle changes next, and what the change is.
#include <cmath>
#include <limits>

#include "skeletons/wavefront.h"
#include "skeletons/wavefront_limits.h"

namespace flg {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr uint32_t longest_walk = 1000, hops_a_unit = 8;

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

// A vertex with one triangle turns by less than a half turn. If its lines say more, they are about to be one:
// rounding has put what happens there in a wrong order, and all of it happens now.
void Wavefront::hold_if_turned_out(const Triangle& t) {
    for (uint32_t k = 0; k < 3; ++k) {
        if (t.neighbours[after(k)] >= 0 || t.neighbours[before(k)] >= 0) continue;
        Vertex& v = vertices_[t.vertices[k]];
        const Point2 &in = lines_[v.left].direction, &out = lines_[v.right].direction;
        if (v.is_infinite || dot(in, out) >= 0 || cross(in, out) >= 0) continue;
        v.at = position(v);
        v.time = now_;
        v.velocity = {0, 0};
        v.is_infinite = true;
    }
}

void Wavefront::schedule(int32_t index) {
    const Triangle& t = triangles_[index];
    if (front_sides(t) > 1) hold_if_turned_out(t);
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

// What happens to a triangle; of one that gets flat together with others walk() finds out.
Wavefront::Change Wavefront::decide(int32_t triangle, uint32_t& side, const WaveEvent& event) const {
    const Triangle& t = triangles_[triangle];
    if (event.kind == WaveEvent::Kind::diagonal) return Change::diagonal;
    if (event.kind == WaveEvent::Kind::edge) {
        if (front_sides(t) > 1) side = shortest_front(t, side);
        return Change::edge;
    }
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t i = after(k), j = before(k);
        if (!vertices_[t.vertices[k]].is_infinite || t.neighbours[i] >= 0 || t.neighbours[j] >= 0) continue;
        const Shape s = shape(t);
        side = s.lengths[i] <= s.lengths[j] ? i : j;
        return Change::edge;
    }
    const Change change = decide_flat(t, side);
    if (change != Change::split || front_sides(t) < 2) return change;
    side = shortest_front(t, none);
    return Change::edge;
}

uint32_t Wavefront::shortest_front(const Triangle& t, uint32_t best) const {
    const Shape s = shape(t);
    for (uint32_t k = 0; k < 3; ++k) {
        if (t.neighbours[k] < 0 && (best == none || s.lengths[k] < s.lengths[best])) best = k;
    }
    return best;
}

Wavefront::Change Wavefront::decide_flat(const Triangle& t, uint32_t& side) const {
    const Shape s = shape(t);
    uint32_t shortest = 0;
    for (uint32_t k = 1; k < 3; ++k) {
        if (s.lengths[k] < s.lengths[shortest]) shortest = k;
    }
    if (s.lengths[shortest] <= 10 * wave::coincident * size_) {
        side = shortest;
        return t.neighbours[shortest] < 0 ? Change::edge : Change::diagonal;
    }
    side = longest_side(s);
    return t.neighbours[side] < 0 ? Change::split : Change::walk;
}

uint32_t Wavefront::longest_side(const Shape& s) {
    const uint32_t longest = s.lengths[1] > s.lengths[0] ? 1 : 0;
    return s.lengths[2] > s.lengths[longest] ? 2 : longest;
}

// Some steps through neighbours that are flat too, each across the longest side of the one before, while sides get
// longer.
void Wavefront::walk() {
    for (uint32_t i = 0; i < hops_a_unit; ++i) {
        if (hops_++ == longest_walk || !hop()) {
            change(Change::flip);
            return;
        }
        if (triangles_[changing_].neighbours[side_] < 0) {
            change(Change::split);
            return;
        }
    }
}

bool Wavefront::hop() {
    const int32_t other = triangles_[changing_].neighbours[side_];
    const Triangle& t = triangles_[other];
    if (front_sides(t) > 1) return false;
    for (const int32_t vertex : t.vertices) {
        if (vertices_[vertex].is_infinite) return false;
    }
    const Shape s = shape(t);
    const uint32_t longest = longest_side(s), shared = side_to(other, changing_);
    if (longest == shared || s.lengths[longest] <= s.lengths[shared]) return false;
    const double area = cross(difference(s.at[1], s.at[0]), difference(s.at[2], s.at[0]));
    if (area > wave::walk_height * size_ * s.lengths[longest]) return false;
    const double bound = 10 * wave::coincident * size_;
    if (s.lengths[after(longest)] <= bound || s.lengths[before(longest)] <= bound) return false;
    changing_ = other;
    side_ = longest;
    return true;
}

}  // namespace flg
