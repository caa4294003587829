// SPDX-License-Identifier: MIT
#include "surfaces/cutting/cut_triangulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flg {

void CutTriangulation::reset(const Vec3& to_1, const Vec3& to_2) {
    points_.assign({{0, 0}, {scale, 0}, {0, scale}});
    constexpr uint32_t outer = Pieces::outer_edge;
    triangles_.assign({{{0, 1, 2}, {outer, outer | 1, outer | 2}, {}}});
    splits_.clear();
    first_split_.clear();
    edge_growing_ = no_index;
    metric_xx_ = to_1.squaredNorm();
    metric_xy_ = to_1.dot(to_2);
    metric_yy_ = to_2.squaredNorm();
}

double CutTriangulation::dot(const Point& a, const Point& b, const Point& c) {
    const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
    return ux * vx + uy * vy + 0.5 * (ux * vy + uy * vx);
}

int64_t CutTriangulation::turn(const Point& a, const Point& b, const Point& c) {
    return int64_t{b.x - a.x} * (c.y - a.y) - int64_t{b.y - a.y} * (c.x - a.x);
}

CutTriangulation::Edge CutTriangulation::find(uint32_t a, uint32_t b) const {
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
        const Triple& vertices = triangles_[t].vertices;
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t start = vertices[k], end = vertices[(k + 1) % 3];
            if ((start == a && end == b) || (start == b && end == a)) return {t, k};
        }
    }
    return no_edge;
}

// The edge seen from the other side; none at the border.
CutTriangulation::Edge CutTriangulation::across(const Edge& edge) const {
    const Triangle& triangle = triangles_[edge.triangle];
    const uint32_t neighbour = triangle.neighbours[edge.k], start = triangle.vertices[(edge.k + 1) % 3];
    if (neighbour >= Pieces::outer_edge) return no_edge;
    const Triple& vertices = triangles_[neighbour].vertices;
    return {neighbour, vertices[0] == start ? 0u : vertices[1] == start ? 1u : 2u};
}

void CutTriangulation::redirect(uint32_t triangle, uint32_t old, uint32_t now) {
    if (triangle >= Pieces::outer_edge) return;
    for (uint32_t& neighbour : triangles_[triangle].neighbours) {
        if (neighbour == old) neighbour = now;
    }
}

// False, and nothing changed, if a part would not turn counter-clockwise.
bool CutTriangulation::split_edge(const Edge& edge, uint32_t vertex) {
    const uint32_t t = edge.triangle, k = edge.k;
    const Triangle here = triangles_[t];
    const uint32_t a = here.vertices[k], b = here.vertices[(k + 1) % 3], c = here.vertices[(k + 2) % 3];
    const Edge other = across(edge);
    if (turn(a, vertex, c) <= 0 || turn(vertex, b, c) <= 0) return false;
    const bool inner = other.triangle != no_index;
    const uint32_t n = other.triangle, j = other.k, first_new = static_cast<uint32_t>(triangles_.size());
    uint32_t d = no_index;
    if (inner) {
        d = triangles_[n].vertices[(j + 2) % 3];
        if (turn(b, vertex, d) <= 0 || turn(vertex, a, d) <= 0) return false;
    }
    const uint32_t t2 = first_new, n2 = first_new + 1, outer = here.neighbours[k];
    const bool segment = here.is_segment[k];
    triangles_[t] = {{a, vertex, c},
                     {inner ? n2 : outer, t2, here.neighbours[(k + 2) % 3]},
                     {segment, false, here.is_segment[(k + 2) % 3]}};
    triangles_.push_back({{vertex, b, c},
                          {inner ? n : outer, here.neighbours[(k + 1) % 3], t},
                          {segment, here.is_segment[(k + 1) % 3], false}});
    redirect(here.neighbours[(k + 1) % 3], t, t2);
    if (inner) {
        const Triangle there = triangles_[n];
        triangles_[n] = {
            {b, vertex, d}, {t2, n2, there.neighbours[(j + 2) % 3]}, {segment, false, there.is_segment[(j + 2) % 3]}};
        triangles_.push_back(
            {{vertex, a, d}, {t, there.neighbours[(j + 1) % 3], n}, {segment, there.is_segment[(j + 1) % 3], false}});
        redirect(there.neighbours[(j + 1) % 3], n, n2);
    }
    if (segment) remember_split(a, b, vertex);
    return true;
}

void CutTriangulation::remember_split(uint32_t a, uint32_t b, uint32_t middle) {
    const uint32_t later = std::max(a, b);
    if (first_split_.size() <= later) first_split_.resize(points_.size(), no_index);
    splits_.push_back({std::min(a, b), middle, first_split_[later]});
    first_split_[later] = static_cast<uint32_t>(splits_.size() - 1);
}

void CutTriangulation::split_triangle(uint32_t triangle, uint32_t vertex) {
    const Triangle here = triangles_[triangle];
    const auto first_new = static_cast<uint32_t>(triangles_.size());
    const std::array<uint32_t, 3> places = {triangle, first_new, first_new + 1};
    triangles_.resize(triangles_.size() + 2);
    for (uint32_t k = 0; k < 3; ++k) {
        triangles_[places[k]] = {{here.vertices[k], here.vertices[(k + 1) % 3], vertex},
                                 {here.neighbours[k], places[(k + 1) % 3], places[(k + 2) % 3]},
                                 {here.is_segment[k], false, false}};
        redirect(here.neighbours[k], triangle, places[k]);
    }
}

// False if the two triangles do not form a strictly convex quad.
bool CutTriangulation::flip(const Edge& edge) {
    const Edge other = across(edge);
    const uint32_t t = edge.triangle, k = edge.k, n = other.triangle, j = other.k;
    const Triangle here = triangles_[t], there = triangles_[n];
    const uint32_t a = here.vertices[k], b = here.vertices[(k + 1) % 3], c = here.vertices[(k + 2) % 3];
    const uint32_t d = there.vertices[(j + 2) % 3];
    if (turn(a, d, c) <= 0 || turn(d, b, c) <= 0) return false;
    triangles_[t] = {{a, d, c},
                     {there.neighbours[(j + 1) % 3], n, here.neighbours[(k + 2) % 3]},
                     {there.is_segment[(j + 1) % 3], false, here.is_segment[(k + 2) % 3]}};
    triangles_[n] = {{d, b, c},
                     {there.neighbours[(j + 2) % 3], here.neighbours[(k + 1) % 3], t},
                     {there.is_segment[(j + 2) % 3], here.is_segment[(k + 1) % 3], false}};
    redirect(there.neighbours[(j + 1) % 3], n, t);
    redirect(here.neighbours[(k + 1) % 3], t, n);
    return true;
}

uint32_t CutTriangulation::add_on_edge(uint32_t k, int32_t along) {
    const auto vertex = static_cast<uint32_t>(points_.size());
    points_.push_back(k == 0 ? Point{along, 0} : k == 1 ? Point{scale - along, along} : Point{0, scale - along});
    if (edge_growing_ != k) {
        edge_growing_ = k;
        last_part_ = find(k, (k + 1) % 3);
    }
    if (split_edge(last_part_, vertex)) last_part_ = {static_cast<uint32_t>(triangles_.size() - 1), 0};
    return vertex;
}

uint32_t CutTriangulation::add(const Point& point) {
    for (uint32_t v = 0; v < points_.size(); ++v) {
        if (dot(points_[v], point, point) <= double{tolerance} * tolerance) return v;
    }
    const auto vertex = static_cast<uint32_t>(points_.size());
    points_.push_back(point);
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
        const Triple& corners = triangles_[t].vertices;
        std::array<int64_t, 3> turns;
        for (uint32_t k = 0; k < 3; ++k) turns[k] = turn(corners[k], corners[(k + 1) % 3], vertex);
        if (turns[0] < 0 || turns[1] < 0 || turns[2] < 0) continue;
        for (uint32_t k = 0; k < 3; ++k) {
            if (turns[k] == 0 && split_edge({t, k}, vertex)) return vertex;
        }
        split_triangle(t, vertex);
        return vertex;
    }
    return vertex;
}

// By the angles opposite to the edge, in space: their cotangents must not sum to less than nothing.
bool CutTriangulation::is_delaunay(const Edge& edge) const {
    const Edge other = across(edge);
    const auto& here = triangles_[edge.triangle].vertices;
    const auto& there = triangles_[other.triangle].vertices;
    const Point &a = points_[here[edge.k]], &b = points_[here[(edge.k + 1) % 3]];
    const auto cotangent = [&](const Point& apex) {
        const double ux = a.x - apex.x, uy = a.y - apex.y, vx = b.x - apex.x, vy = b.y - apex.y;
        const double inner = metric_xx_ * ux * vx + metric_xy_ * (ux * vy + uy * vx) + metric_yy_ * uy * vy;
        return inner / static_cast<double>(std::abs(turn(apex, a, b)));
    };
    const double one = cotangent(points_[here[(edge.k + 2) % 3]]);
    const double two = cotangent(points_[there[(other.k + 2) % 3]]);
    return one + two >= -1e-6 * (std::abs(one) + std::abs(two));
}

void CutTriangulation::begin_improvement() {
    constexpr uint32_t max_passes = 8;
    passes_left_ = max_passes;
    improved_to_ = 0;
    pass_flipped_ = false;
}

bool CutTriangulation::improve() {
    constexpr size_t triangles_a_step = 8;
    const size_t end = std::min(triangles_.size(), improved_to_ + triangles_a_step);
    for (; improved_to_ < end; ++improved_to_) {
        for (uint32_t k = 0; k < 3; ++k) {
            const Edge edge{improved_to_, k};
            if (triangles_[improved_to_].is_segment[k]) continue;
            if (triangles_[improved_to_].neighbours[k] >= Pieces::outer_edge) continue;
            if (!is_delaunay(edge) && flip(edge)) pass_flipped_ = true;
        }
    }
    if (end < triangles_.size()) return false;
    improved_to_ = 0;
    --passes_left_;
    return !std::exchange(pass_flipped_, false) || passes_left_ == 0;
}

// ---- How a segment makes its way

bool CutTriangulation::crosses(uint32_t from, uint32_t to, uint32_t a, uint32_t b) const {
    if (a == from || a == to || b == from || b == to) return false;
    return (turn(from, to, a) > 0) != (turn(from, to, b) > 0) && (turn(a, b, from) > 0) != (turn(a, b, to) > 0);
}

// The vertex nearest to the segment among those beside it; no_index if all keep off. It is nearer to both ends than
// they are to each other, so that ways through such vertices come to an end.
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

// The fewest edges there are to the end: the way out where rounding leaves no straight one. Searched from the end, so
// that the way back is the way there.
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
