// SPDX-License-Identifier: MIT
#include "skeletons/wavefront.h"

#include <algorithm>
#include <cmath>

#include "skeletons/wavefront_limits.h"

namespace flg {

namespace {

// Measured: at most 1.4 events and 0.4 flips a point.
constexpr uint64_t events_a_point = 200, events_at_least = 10'000;

// A contour of n points and any holes has less than 2 n triangles; each event that ends vertices takes one away,
// makes at most two vertices and two nodes; each vertex draws one arc, and each loop one more.
constexpr size_t triangles_a_point = 2, vertices_a_point = 5, nodes_a_point = 5, arcs_a_point = 7;

}  // namespace

Wavefront::Wavefront(const ContourTriangulation& triangulation, std::span<const Point2> points,
                     std::span<const uint32_t> next, double size, double facing, Memory* memory)
    : triangulation_(triangulation),
      points_(points),
      next_(next),
      size_(size),
      facing_(facing),
      lines_(points.size(), memory),
      previous_(points.size(), memory),
      number_(triangulation.triangle_count(), memory),
      triangles_(triangles_a_point * points.size(), memory),
      vertices_(vertices_a_point * points.size(), memory),
      nodes_(nodes_a_point * points.size(), memory),
      arcs_(arcs_a_point * points.size(), memory),
      queue_(triangles_a_point * points.size(), memory),
      events_left_(events_a_point * points.size() + events_at_least) {}

void Wavefront::step() {
    const auto size = static_cast<uint32_t>(points_.size());
    switch (pass_) {
        case Pass::vertices:
            // Lines first: a vertex needs both of its own.
            if (at_ < size) {
                add_edge(at_++);
            } else if (at_ < 2 * size) {
                const uint32_t point = at_++ - size;
                const int32_t vertex = add_vertex(previous_[point], point, points_[point], add_node(points_[point]));
                vertices_[vertex].at = points_[point];
            } else {
                enter(Pass::number);
            }
            break;
        case Pass::number:
            if (at_ < triangulation_.triangle_count()) {
                number_[at_] = triangulation_.is_inside(at_) ? static_cast<int32_t>(triangle_count_++) : -1;
                ++at_;
            } else {
                enter(Pass::triangles);
            }
            break;
        case Pass::triangles:
            if (at_ < triangulation_.triangle_count()) {
                add_triangle(at_++);
            } else {
                enter(Pass::schedule);
            }
            break;
        case Pass::schedule:
            if (at_ < triangle_count_) {
                schedule(static_cast<int32_t>(at_++));
            } else {
                enter(Pass::events);
            }
            break;
        case Pass::events:
            if (fan_count_ > 0) {
                relabel_one();
            } else if (hops_ > 0) {
                walk();
            } else if (left_behind_ >= 0) {
                if (is_alive(left_behind_)) schedule(left_behind_);
                left_behind_ = -1;
            } else if (!queue_.empty()) {
                next_event();
            } else {
                enter(Pass::leftovers);
            }
            break;
        case Pass::leftovers:
            if (at_ == triangle_count_) {
                pass_ = Pass::done;
            } else if (is_alive(static_cast<int32_t>(at_++))) {
                fail();
            }
            break;
        case Pass::done: break;
    }
}

void Wavefront::add_edge(uint32_t point) {
    const Point2 &a = points_[point], &b = points_[next_[point]];
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
    Line& line = lines_[point];
    line.direction = {dx / length, dy / length};
    line.normal = {-line.direction.y, line.direction.x};
    line.offset = line.normal.x * (a.x + b.x) * 0.5 + line.normal.y * (a.y + b.y) * 0.5;
    previous_[next_[point]] = point;
}

void Wavefront::add_triangle(uint32_t index) {
    if (number_[index] < 0) return;
    const ContourTriangulation::Triangle& source = triangulation_.triangle(index);
    Triangle& triangle = triangles_[number_[index]];
    triangle.vertices = source.vertices;
    for (uint32_t k = 0; k < 3; ++k)
        triangle.neighbours[k] = source.is_edge[k] ? ~source.vertices[after(k)] : number_[source.neighbours[k]];
    queue_.begin_triangle(static_cast<uint32_t>(number_[index]));
}

// At `at` and the time that is now, moving with the lines of both edges.
int32_t Wavefront::add_vertex(uint32_t left, uint32_t right, const Point2& at, uint32_t node) {
    Vertex& vertex = vertices_[vertex_count_];
    vertex = {at, {0, 0}, now_, left, right, node, false};
    const Line &a = lines_[left], &b = lines_[right];
    const Point2 sum = {a.normal.x + b.normal.x, a.normal.y + b.normal.y};
    const double sum_sq = sum.x * sum.x + sum.y * sum.y;
    if (sum_sq < facing_ * facing_) {
        vertex.is_infinite = true;
    } else {
        vertex.velocity = {2 * sum.x / sum_sq, 2 * sum.y / sum_sq};
        const double off_a = a.offset + now_ - (a.normal.x * at.x + a.normal.y * at.y);
        const double off_b = b.offset + now_ - (b.normal.x * at.x + b.normal.y * at.y);
        const double cross = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
        if (std::fabs(cross) > wave::far_from_parallel) {
            vertex.at.x += (off_a * b.normal.y - off_b * a.normal.y) / cross;
            vertex.at.y += (a.normal.x * off_b - b.normal.x * off_a) / cross;
        } else if (sum_sq > 1) {
            const double off = (off_a + off_b) / 4;
            vertex.at.x += off * sum.x;
            vertex.at.y += off * sum.y;
        }
    }
    return static_cast<int32_t>(vertex_count_++);
}

uint32_t Wavefront::add_node(const Point2& at) {
    nodes_[node_count_] = {at, now_};
    return node_count_++;
}

void Wavefront::end_vertex(int32_t vertex, uint32_t node) {
    const Vertex& v = vertices_[vertex];
    arcs_[arc_count_++] = {v.node, node, v.left, v.right};
}

void Wavefront::remove(int32_t triangle) {
    triangles_[triangle].vertices[0] = -1;
    queue_.remove(static_cast<uint32_t>(triangle));
}

// Whether a triangle with an infinitely fast vertex has to wait for others at its time.
bool Wavefront::waits(const WaveEvent& event, uint32_t triangle) {
    if (event.kind != WaveEvent::Kind::last) return false;
    queue_.remove(triangle);
    if (!queue_.empty()) {
        const WaveEvent& other = queue_.event(queue_.first());
        if (other.kind != WaveEvent::Kind::last && other.time <= event.time + wave::closes * size_) {
            queue_.set(triangle, {other.time, event.kind, event.side});
            return true;
        }
    }
    return false;
}

void Wavefront::next_event() {
    if (events_left_-- == 0) {
        fail();
        return;
    }
    const uint32_t first = queue_.first();
    const WaveEvent event = queue_.event(first);
    if (waits(event, first)) return;
    queue_.remove(first);
    now_ = std::max(now_, event.time);
    begun_ = changing_ = static_cast<int32_t>(first);
    side_ = event.side;
    const Change decided = decide(begun_, side_, event);
    if (decided == Change::walk) {
        hops_ = 1;
    } else {
        change(decided);
    }
}

void Wavefront::change(Change change) {
    hops_ = 0;
    if (changing_ != begun_) left_behind_ = begun_;
    switch (change) {
        case Change::edge: collapse_edge(changing_, side_); break;
        case Change::diagonal: collapse_diagonal(changing_, side_); break;
        case Change::split: split(changing_, side_); break;
        case Change::flip: flip(changing_, side_); break;
        case Change::walk: break;
    }
}

}  // namespace flg
