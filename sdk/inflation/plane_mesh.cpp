// SPDX-License-Identifier: MIT
#include "inflation/plane_mesh.h"

#include <cmath>

namespace flg {

namespace {

// Of rounding in the determinant below, relative to what is added up in it.
constexpr double circle_noise = 1e-14;

bool in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
    const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    const double determinant = aa * (bx * cy - cx * by) + bb * (cx * ay - ax * cy) + cc * (ax * by - bx * ay);
    const double magnitude = aa * (std::fabs(bx * cy) + std::fabs(cx * by)) +
                             bb * (std::fabs(cx * ay) + std::fabs(ax * cy)) +
                             cc * (std::fabs(ax * by) + std::fabs(bx * ay));
    return determinant > circle_noise * magnitude;
}

}  // namespace

PlaneMesh::PlaneMesh(size_t vertices, size_t triangles, Memory* memory)
    : points_(vertices, memory),
      border_(vertices, memory),
      triangle_of_(vertices, memory),
      triangles_(triangles, memory),
      stack_(memory) {}

void PlaneMesh::add_vertex(const Point2& point, bool border) {
    points_[vertex_count_] = point;
    border_[vertex_count_] = border;
    triangle_of_[vertex_count_] = -1;
    ++vertex_count_;
}

void PlaneMesh::add_triangle(const Triangle& triangle) {
    for (const int32_t vertex : triangle.vertices) triangle_of_[vertex] = static_cast<int32_t>(triangle_count_);
    triangles_[triangle_count_++] = triangle;
}

bool PlaneMesh::is_chord(int32_t triangle, uint32_t side) const {
    const Triangle& t = triangles_[triangle];
    return t.neighbours[side] >= 0 && on_border(t.vertices[after(side)]) && on_border(t.vertices[before(side)]);
}

PlaneMesh::Place PlaneMesh::locate(int32_t from, const Point2& point, uint32_t steps) const {
    int32_t here = from, came_from = -1;
    for (; steps > 0; --steps) {
        const Triangle& t = triangles_[here];
        int32_t on = -1, to = -1;
        for (uint32_t i = 0; i < 3 && to < 0; ++i) {
            // Turns with the steps, so that no walk goes in circles.
            const uint32_t k = (i + steps) % 3;
            if (t.neighbours[k] >= 0 && t.neighbours[k] == came_from) continue;
            const int side = orientation(points_[t.vertices[after(k)]], points_[t.vertices[before(k)]], point);
            if (side == 0) on = static_cast<int32_t>(k);
            if (side >= 0) continue;
            if (t.neighbours[k] < 0) return {here, static_cast<int32_t>(k), true};
            to = t.neighbours[k];
        }
        if (to < 0) return {here, on, false};
        came_from = here;
        here = to;
    }
    return {-1, -1, false};
}

void PlaneMesh::replace_neighbour(int32_t of, int32_t old, int32_t now) {
    if (of >= 0) triangles_[of].neighbours[place_in(triangles_[of].neighbours, old)] = now;
}

bool PlaneMesh::insert(int32_t triangle, int32_t side, const Point2& point) {
    const auto vertex = static_cast<int32_t>(vertex_count_), added = static_cast<int32_t>(triangle_count_);
    const Triangle old = triangles_[triangle];
    const auto turns_left = [&](int32_t a, int32_t b) { return orientation(points_[a], points_[b], point) > 0; };
    if (side < 0) {
        for (uint32_t k = 0; k < 3; ++k)
            if (!turns_left(old.vertices[after(k)], old.vertices[before(k)])) return false;
        add_vertex(point, false);
        const std::array<int32_t, 3> parts = {triangle, added, added + 1};
        triangle_count_ += 2;
        for (uint32_t k = 0; k < 3; ++k) {
            const int32_t a = old.vertices[after(k)], b = old.vertices[before(k)], beyond = old.neighbours[k];
            triangles_[parts[k]] = {{vertex, a, b}, {beyond, parts[after(k)], parts[before(k)]}};
            if (parts[k] != triangle) replace_neighbour(beyond, triangle, parts[k]);
            triangle_of_[a] = parts[k];
            check(parts[k]);
        }
        triangle_of_[vertex] = triangle;
        return true;
    }
    // Of triangle (a, b, c) with the point on (b, c), (a, b, p) stays and (a, p, c) is added; so beyond.
    const auto k = static_cast<uint32_t>(side);
    const int32_t a = old.vertices[k], b = old.vertices[after(k)], c = old.vertices[before(k)];
    const int32_t other = old.neighbours[k];
    if (!turns_left(a, b) || !turns_left(c, a)) return false;
    Triangle there{};
    int32_t d = -1;
    uint32_t j = 0;
    if (other >= 0) {
        there = triangles_[other];
        j = place_in(there.neighbours, triangle);
        d = there.vertices[j];
        if (!turns_left(d, c) || !turns_left(b, d)) return false;
    }
    add_vertex(point, other < 0);
    const int32_t beyond_b = old.neighbours[before(k)], beyond_c = old.neighbours[after(k)];
    triangle_count_ += other >= 0 ? 2 : 1;
    triangles_[triangle] = {{a, b, vertex}, {other >= 0 ? added + 1 : -1, added, beyond_b}};
    triangles_[added] = {{a, vertex, c}, {other, beyond_c, triangle}};
    replace_neighbour(beyond_c, triangle, added);
    triangle_of_[vertex] = triangle_of_[a] = triangle_of_[b] = triangle;
    triangle_of_[c] = added;
    check(triangle);
    check(added);
    if (other >= 0) {
        // (d, c, b): the part at c stays, next to `added`.
        const int32_t beyond_db = there.neighbours[after(j)], beyond_dc = there.neighbours[before(j)];
        triangles_[other] = {{d, c, vertex}, {added, added + 1, beyond_dc}};
        triangles_[added + 1] = {{d, vertex, b}, {triangle, beyond_db, other}};
        replace_neighbour(beyond_db, other, added + 1);
        triangle_of_[d] = other;
        check(other);
        check(added + 1);
    }
    return true;
}

bool PlaneMesh::flips(int32_t triangle, uint32_t k) const {
    const Triangle& here = triangles_[triangle];
    const int32_t other = here.neighbours[k];
    if (other < 0) return false;
    const Triangle& there = triangles_[other];
    const int32_t a = here.vertices[k], b = here.vertices[after(k)], c = here.vertices[before(k)];
    const int32_t d = there.vertices[place_in(there.neighbours, triangle)];
    if (border_[a] != 0 && border_[d] != 0) return false;
    return in_circle(points_[a], points_[b], points_[c], points_[d]) && turn(a, b, d) > 0 && turn(a, d, c) > 0;
}

// Of triangles (a, b, c) and (d, c, b), with a at corner k, makes (a, b, d) and (a, d, c).
void PlaneMesh::flip(int32_t triangle, uint32_t k) {
    const Triangle here = triangles_[triangle];
    const int32_t other = here.neighbours[k];
    const Triangle there = triangles_[other];
    const uint32_t j = place_in(there.neighbours, triangle);
    const int32_t a = here.vertices[k], b = here.vertices[after(k)], c = here.vertices[before(k)],
                  d = there.vertices[j];
    const int32_t beyond_ab = here.neighbours[before(k)], beyond_ca = here.neighbours[after(k)];
    const int32_t beyond_bd = there.neighbours[after(j)], beyond_dc = there.neighbours[before(j)];
    triangles_[triangle] = {{a, b, d}, {beyond_bd, other, beyond_ab}};
    triangles_[other] = {{a, d, c}, {beyond_dc, beyond_ca, triangle}};
    replace_neighbour(beyond_bd, other, triangle);
    replace_neighbour(beyond_ca, triangle, other);
    triangle_of_[a] = triangle_of_[b] = triangle_of_[d] = triangle;
    triangle_of_[c] = other;
}

}  // namespace flg
