// SPDX-License-Identifier: MIT
// How a segment makes its way through a triangulation.
#include <algorithm>
#include <cmath>

#include "surfaces/cut_triangulation.h"

namespace flg {

bool CutTriangulation::crosses(uint32_t from, uint32_t to, uint32_t a, uint32_t b) const {
    if (a == from || a == to || b == from || b == to) return false;
    return (turn(from, to, a) > 0) != (turn(from, to, b) > 0) && (turn(a, b, from) > 0) != (turn(a, b, to) > 0);
}

// The vertex nearest to the segment among those beside it; no_index if all keep off. It is nearer to both ends than they
// are to each other, so that ways through such vertices come to an end.
uint32_t CutTriangulation::vertex_near(uint32_t from, uint32_t to) const {
    const Point &a = points_[from], &b = points_[to];
    const double length = dot(a, b, b);
    // Distance = area / length; an equilateral triangle has the root of 3/4 of the area it has on the lattice.
    double nearest = 4.0 / 3 * length * tolerance * tolerance;
    uint32_t found = no_index;
    for (uint32_t v = 0; v < points_.size(); ++v) {
        const Point& point = points_[v];
        const auto area = static_cast<double>(turn(a, b, point));
        if (area * area > nearest || v == from || v == to) continue;
        if (dot(a, point, point) >= length || dot(b, point, point) >= length) continue;
        nearest = area * area;
        found = v;
    }
    return found;
}

CutTriangulation::Edge CutTriangulation::first_segment_across(uint32_t from, uint32_t to) const {
    Edge first = no_edge;
    double least = 2;
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
        for (uint32_t k = 0; k < 3; ++k) {
            if (!triangles_[t].is_segment[k]) continue;
            const uint32_t a = triangles_[t].vertices[k], b = triangles_[t].vertices[(k + 1) % 3];
            if (!crosses(from, to, a, b)) continue;
            const auto before = static_cast<double>(turn(a, b, from)), after = static_cast<double>(turn(a, b, to));
            const double at = before / (before - after);
            if (at >= least) continue;
            least = at;
            first = {t, k};
        }
    }
    return first;
}

// The vertex through which the way from `from` to `to` goes on across a segment: a new one, or where rounding leaves no
// room for it, an end of the segment.
uint32_t CutTriangulation::cross_segment(uint32_t from, uint32_t to, const Edge& edge) {
    const Triple& vertices = triangles_[edge.triangle].vertices;
    const uint32_t a = vertices[edge.k], b = vertices[(edge.k + 1) % 3];
    const Point start = points_[a], end = points_[b];
    const auto before = static_cast<double>(turn(from, to, a)), after = static_cast<double>(turn(from, to, b));
    const double at = before / (before - after);
    const auto vertex = static_cast<uint32_t>(points_.size());
    points_.push_back({static_cast<int32_t>(std::lround(start.x + at * (end.x - start.x))),
                       static_cast<int32_t>(std::lround(start.y + at * (end.y - start.y)))});
    if (split_edge(edge, vertex)) return vertex;
    points_.pop_back();
    return at < 0.5 ? a : b;
}

void CutTriangulation::begin_clearing(uint32_t from, uint32_t to) {
    progress_ = Progress::clearing;
    way_at_ = 0;
    way_.clear();
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t a = triangles_[t].vertices[k], b = triangles_[t].vertices[(k + 1) % 3];
            if (a < b && crosses(from, to, a, b)) way_.push_back({a, b});
        }
    }
    way_most_ = 16 * (way_.size() + 1) * (way_.size() + 1);
}

// Flips until no edge crosses the way; looks for another one if that takes too long.
void CutTriangulation::clear_next(uint32_t from, uint32_t to) {
    if (way_at_ == way_.size()) {
        progress_ = Progress::straight;
        return;
    }
    if (way_at_ == way_most_) return begin_search();
    const auto [a, b] = way_[way_at_++];
    const Edge edge = find(a, b);
    const Edge other = across(edge);
    const uint32_t c = triangles_[edge.triangle].vertices[(edge.k + 2) % 3];
    const uint32_t d = triangles_[other.triangle].vertices[(other.k + 2) % 3];
    if (!flip(edge)) {
        way_.push_back({a, b});
    } else if (crosses(from, to, c, d)) {
        way_.push_back({c, d});
    }
}

void CutTriangulation::aim_at(uint32_t vertex) {
    const auto found = std::find(targets_.begin(), targets_.end(), vertex);
    targets_.erase(found, targets_.end());
    targets_.push_back(vertex);
}

void CutTriangulation::go_along(const Edge& edge, uint32_t to) {
    triangles_[edge.triangle].is_segment[edge.k] = true;
    const Edge other = across(edge);
    if (other.triangle != no_index) triangles_[other.triangle].is_segment[other.k] = true;
    path_.push_back(to);
    here_ = to;
}

// The fewest edges there are to the end: the way out where rounding leaves no straight one. Searched from the end, so that
// the way back is the way there.
void CutTriangulation::begin_search() {
    progress_ = Progress::searching;
    way_at_ = 0;
    targets_.resize(1);
    reached_from_.assign(points_.size(), no_index);
    reached_from_[targets_.front()] = targets_.front();
    way_.assign(1, {targets_.front(), no_index});
}

void CutTriangulation::search_next() {
    const uint32_t from = way_[way_at_++].first;
    if (from == here_) {
        progress_ = Progress::walking;
        return;
    }
    for (const Triangle& triangle : triangles_) {
        const Triple& vertices = triangle.vertices;
        if (std::find(vertices.begin(), vertices.end(), from) == vertices.end()) continue;
        for (uint32_t vertex : vertices) {
            if (reached_from_[vertex] != no_index) continue;
            reached_from_[vertex] = from;
            way_.push_back({vertex, no_index});
        }
    }
}

void CutTriangulation::begin_segment(uint32_t from, uint32_t to) {
    progress_ = Progress::straight;
    path_.assign(1, from);
    targets_.assign(1, to);
    here_ = from;
    // Each step comes nearer or adds a crossing; the bound is for what rounding might do.
    steps_left_ = 16 + 8 * points_.size();
}

bool CutTriangulation::step() {
    switch (progress_) {
        case Progress::straight: return step_straight();
        case Progress::clearing: clear_next(here_, targets_.back()); break;
        case Progress::searching: search_next(); break;
        case Progress::walking: {
            if (here_ == targets_.front()) return true;
            const uint32_t next = reached_from_[here_];
            go_along(find(here_, next), next);
            break;
        }
    }
    return false;
}

bool CutTriangulation::step_straight() {
    while (!targets_.empty() && targets_.back() == here_) targets_.pop_back();
    if (targets_.empty()) return true;
    if (steps_left_-- == 0) {
        begin_search();
        return false;
    }
    const uint32_t target = targets_.back();
    if (const uint32_t near = vertex_near(here_, target); near != no_index) {
        aim_at(near);
    } else if (const Edge edge = find(here_, target); edge.triangle != no_index) {
        go_along(edge, target);
    } else if (const Edge segment = first_segment_across(here_, target); segment.triangle != no_index) {
        aim_at(cross_segment(here_, target, segment));
    } else {
        begin_clearing(here_, target);
    }
    return false;
}

}  // namespace flg
