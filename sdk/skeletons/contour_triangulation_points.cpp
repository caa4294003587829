// SPDX-License-Identifier: MIT
// Of the triangulation: points come in.
#include <cmath>

#include "core/random.h"
#include "skeletons/contour_triangulation.h"

namespace flg {

namespace {

// Of rounding in the determinant below, with coordinates relative to the fourth point.
constexpr double circle_noise = 4e-15;

}  // namespace

// Walks to the triangle that holds the next point. Which side is looked at first is drawn, so that no walk goes in
// circles.
void ContourTriangulation::locate() {
    const auto vertex = static_cast<int32_t>(order_[at_]);
    const Point2& point = points_[vertex];
    for (uint32_t hop = 0; hop < hops_a_unit; ++hop) {
        const Triangle& here = triangles_[here_];
        const auto first = static_cast<uint32_t>(mix64(search_++) % 3);
        int32_t to = -1;
        for (uint32_t i = 0; i < 3 && to < 0; ++i) {
            const uint32_t k = (first + i) % 3;
            const int32_t a = here.vertices[after(k)], b = here.vertices[before(k)];
            if (here.neighbours[k] >= 0 && orientation(points_[a], points_[b], point) < 0) to = here.neighbours[k];
        }
        if (to < 0) {
            insert(vertex);
            return;
        }
        here_ = to;
    }
}

// Splits the triangle in three; of a point on a side, the flat one of these is flipped away.
void ContourTriangulation::insert(int32_t vertex) {
    const Triangle old = triangles_[here_];
    int32_t on = -1;
    for (uint32_t k = 0; k < 3; ++k) {
        const int32_t a = old.vertices[after(k)], b = old.vertices[before(k)];
        if (turn(a, b, vertex) != 0) continue;
        if (on >= 0) {
            const int32_t shared = old.vertices[3 - k - static_cast<uint32_t>(on)];
            stop(ContourFault::Kind::same_point, std::min(vertex, shared), std::max(vertex, shared));
            return;
        }
        on = static_cast<int32_t>(k);
    }
    const auto added = static_cast<int32_t>(count_);
    const std::array<int32_t, 3> parts = {added, added + 1, here_};  // across from corner 0, 1, 2
    count_ += 2;
    for (uint32_t k = 0; k < 3; ++k) {
        const int32_t a = old.vertices[after(k)], b = old.vertices[before(k)], beyond = old.neighbours[k];
        triangles_[parts[k]] = {{a, b, vertex}, {parts[after(k)], parts[before(k)], beyond}, {}};
        if (beyond >= 0) triangles_[beyond].neighbours[side_to(beyond, here_)] = parts[k];
        triangle_of_[a] = parts[k];
    }
    triangle_of_[vertex] = here_;
    stack_.assign(parts.begin(), parts.end());
    if (on >= 0) {
        const int32_t flat = parts[on], other = triangles_[flat].neighbours[2];
        flip(flat, 2);
        stack_.push_back(other);
    }
    inserted_ = vertex;
    ++at_;
    pass_ = Pass::legalize;
}

// Flips the side across from the new vertex if the circle through it and that side holds what is beyond.
void ContourTriangulation::legalize() {
    const int32_t t = stack_.back();
    stack_.pop_back();
    const uint32_t k = corner(t, inserted_);
    const int32_t other = triangles_[t].neighbours[k];
    if (other < 0) return;
    const int32_t b = triangles_[t].vertices[after(k)], c = triangles_[t].vertices[before(k)];
    const int32_t d = triangles_[other].vertices[side_to(other, t)];
    if (!in_circle(points_[inserted_], points_[b], points_[c], points_[d])) return;
    if (turn(inserted_, b, d) <= 0 || turn(inserted_, d, c) <= 0) return;
    flip(t, k);
    stack_.push_back(t);
    stack_.push_back(other);
}

bool ContourTriangulation::in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) const {
    const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
    const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    const double determinant = aa * (bx * cy - cx * by) + bb * (cx * ay - ax * cy) + cc * (ax * by - bx * ay);
    const double magnitude = aa * (std::fabs(bx * cy) + std::fabs(cx * by)) +
                             bb * (std::fabs(cx * ay) + std::fabs(ax * cy)) +
                             cc * (std::fabs(ax * by) + std::fabs(bx * ay));
    return determinant > circle_noise * magnitude;
}

}  // namespace flg
