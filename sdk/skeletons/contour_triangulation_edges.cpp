// SPDX-License-Identifier: MIT
// Of the triangulation: the contour's edges come in, and what is inside is found.
#include <algorithm>

#include "skeletons/contour_triangulation.h"

namespace flg {

// The side between two vertices, of which one at least is the contour's.
ContourTriangulation::Side ContourTriangulation::find(int32_t a, int32_t b) const {
    if (a >= size_) std::swap(a, b);
    const int32_t first = triangle_of_[a];
    int32_t t = first;
    do {
        const uint32_t k = corner(t, a);
        if (triangles_[t].vertices[after(k)] == b) return {t, before(k)};
        t = triangles_[t].neighbours[after(k)];
    } while (t != first);
    return {-1, 0};
}

int32_t ContourTriangulation::edge_between(int32_t a, int32_t b) const {
    return static_cast<int32_t>(next_[a]) == b ? a : b;
}

void ContourTriangulation::mark(const Side& side) {
    const int32_t other = triangles_[side.triangle].neighbours[side.k];
    triangles_[side.triangle].is_edge[side.k] = true;
    triangles_[other].is_edge[side_to(other, side.triangle)] = true;
}

void ContourTriangulation::join() {
    const auto a = static_cast<int32_t>(at_), b = static_cast<int32_t>(next_[at_]);
    const Side side = find(a, b);
    if (side.triangle >= 0) {
        mark(side);
        ++at_;
    } else if (collect_crossed(a, b)) {
        crossed_at_ = 0;
        flips_left_ = 1000 + 100 * crossed_.size() * crossed_.size();
        pass_ = Pass::clear;
    }
}

// The sides that cross the way from a to b; false, with a fault, if an edge or a point is in it.
bool ContourTriangulation::collect_crossed(int32_t a, int32_t b) {
    crossed_.clear();
    int32_t t = triangle_of_[a];
    uint32_t k = 0;
    int32_t right = -1, left = -1;
    for (const int32_t first = t;;) {
        k = corner(t, a);
        right = triangles_[t].vertices[after(k)];
        left = triangles_[t].vertices[before(k)];
        const int side = turn(a, b, right);
        if (side == 0) {
            const Point2 &from = points_[a], &to = points_[b], &between = points_[right];
            if ((to.x - from.x) * (between.x - from.x) + (to.y - from.y) * (between.y - from.y) > 0) {
                stop(ContourFault::Kind::point_on_edge, right, a);
                return false;
            }
        }
        if (side < 0 && turn(a, b, left) > 0) break;
        t = triangles_[t].neighbours[after(k)];
        if (t == first) {
            stop(ContourFault::Kind::gave_up, a, b);
            return false;
        }
    }
    for (;;) {
        if (triangles_[t].is_edge[k]) {
            const int32_t crossed = edge_between(right, left);
            stop(ContourFault::Kind::edges_cross, std::min(a, crossed), std::max(a, crossed));
            return false;
        }
        crossed_.push_back({right, left});
        const int32_t beyond = triangles_[t].neighbours[k];
        const uint32_t j = side_to(beyond, t);
        const int32_t tip = triangles_[beyond].vertices[j];
        if (tip == b) return true;
        const int side = turn(a, b, tip);
        if (side == 0) {
            stop(ContourFault::Kind::point_on_edge, tip, a);
            return false;
        }
        // Seen from beyond, `left` comes after the tip's corner and `right` before it.
        k = side > 0 ? after(j) : before(j);
        (side > 0 ? left : right) = tip;
        t = beyond;
    }
}

// Flips one side out of the way, or puts it off if it is a corner's only one.
void ContourTriangulation::clear() {
    const auto a = static_cast<int32_t>(at_), b = static_cast<int32_t>(next_[at_]);
    if (crossed_at_ == crossed_.size()) {
        mark(find(a, b));
        ++at_;
        pass_ = Pass::join;
        return;
    }
    if (--flips_left_ == 0) {
        stop(ContourFault::Kind::gave_up, a, b);
        return;
    }
    const std::array<int32_t, 2> ends = crossed_[crossed_at_++];
    const Side side = find(ends[0], ends[1]);
    const Triangle& here = triangles_[side.triangle];
    const int32_t other = here.neighbours[side.k], p = here.vertices[side.k];
    const int32_t q = triangles_[other].vertices[side_to(other, side.triangle)];
    if (turn(p, here.vertices[after(side.k)], q) <= 0 || turn(p, q, here.vertices[before(side.k)]) <= 0) {
        crossed_.push_back(ends);
        return;
    }
    flip(side.triangle, side.k);
    const bool apart = p != a && p != b && q != a && q != b;
    if (apart && turn(a, b, p) * turn(a, b, q) < 0) crossed_.push_back({p, q});
}

// Begins to flood the left of an edge, unless it is flooded.
void ContourTriangulation::seed() {
    const auto a = static_cast<int32_t>(at_), b = static_cast<int32_t>(next_[at_]);
    Side side = find(a, b);
    if (triangles_[side.triangle].vertices[after(side.k)] != a)
        side.triangle = triangles_[side.triangle].neighbours[side.k];
    if (inside_[side.triangle] == 0) {
        inside_[side.triangle] = 1;
        stack_.assign(1, side.triangle);
        ring_edge_ = a;
        pass_ = Pass::flood;
    }
    ++at_;
}

void ContourTriangulation::flood() {
    const Triangle& here = triangles_[stack_.back()];
    stack_.pop_back();
    for (uint32_t k = 0; k < 3; ++k) {
        if (here.vertices[k] >= size_) {
            stop(ContourFault::Kind::outside, ring_edge_, ring_edge_);
            return;
        }
        if (here.is_edge[k] || inside_[here.neighbours[k]] != 0) continue;
        inside_[here.neighbours[k]] = 1;
        stack_.push_back(here.neighbours[k]);
    }
}

void ContourTriangulation::check() {
    const auto a = static_cast<int32_t>(at_), b = static_cast<int32_t>(next_[at_]);
    const Side side = find(a, b);
    const int32_t other = triangles_[side.triangle].neighbours[side.k];
    if (inside_[side.triangle] != 0 && inside_[other] != 0) stop(ContourFault::Kind::nested, a, a);
    ++at_;
}

}  // namespace flg
