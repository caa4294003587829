// SPDX-License-Identifier: MIT
// Of the triangulation: the contour's edges come in, and what is inside is found.
#include <algorithm>

#include "skeletons/contour_triangulation.h"

namespace flg {

namespace {

constexpr size_t most_cleared = 1000;  // that the list of crossing sides still holds, if these are half of it

}  // namespace

// The side between two vertices, of which one at least is the contour's: around both at once, so that it takes as
// long as around the one of fewer triangles.
ContourTriangulation::Side ContourTriangulation::find(int32_t a, int32_t b) const {
    if (a >= size_) std::swap(a, b);
    const bool both = b < size_;
    const int32_t first_a = triangle_of_[a], first_b = triangle_of_[b];
    int32_t at_a = first_a, at_b = first_b;
    for (;;) {
        const uint32_t k = corner(at_a, a);
        if (triangles_[at_a].vertices[after(k)] == b) return {at_a, before(k)};
        at_a = triangles_[at_a].neighbours[after(k)];
        if (at_a == first_a) break;
        if (!both) continue;
        const uint32_t j = corner(at_b, b);
        if (triangles_[at_b].vertices[after(j)] == a) return {at_b, before(j)};
        at_b = triangles_[at_b].neighbours[after(j)];
        if (at_b == first_b) break;
    }
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
        return;
    }
    crossed_.clear();
    crossed_at_ = 0;
    here_ = triangle_of_[a];
    pass_ = Pass::aim;
}

// Around the edge's beginning to the triangle that it leaves through; a point on the way is a fault.
void ContourTriangulation::aim() {
    const auto a = static_cast<int32_t>(at_), b = static_cast<int32_t>(next_[at_]);
    for (uint32_t hop = 0; hop < hops_a_unit; ++hop) {
        const uint32_t k = corner(here_, a);
        right_ = triangles_[here_].vertices[after(k)];
        left_ = triangles_[here_].vertices[before(k)];
        const int side = turn(a, b, right_);
        if (side == 0) {
            const Point2 &from = points_[a], &to = points_[b], &between = points_[right_];
            if ((to.x - from.x) * (between.x - from.x) + (to.y - from.y) * (between.y - from.y) > 0) {
                stop(ContourFault::Kind::point_on_edge, right_, a);
                return;
            }
        }
        if (side < 0 && turn(a, b, left_) > 0) {
            side_ = k;
            pass_ = Pass::cross;
            return;
        }
        here_ = triangles_[here_].neighbours[after(k)];
        if (here_ == triangle_of_[a]) {
            stop(ContourFault::Kind::gave_up, a, b);
            return;
        }
    }
}

// Collects the sides that cross the edge; an edge of the contour or a point in its way is a fault.
void ContourTriangulation::cross() {
    const auto a = static_cast<int32_t>(at_), b = static_cast<int32_t>(next_[at_]);
    for (uint32_t hop = 0; hop < hops_a_unit; ++hop) {
        if (triangles_[here_].is_edge[side_]) {
            const int32_t crossed = edge_between(right_, left_);
            stop(ContourFault::Kind::edges_cross, std::min(a, crossed), std::max(a, crossed));
            return;
        }
        crossed_.push_back({right_, left_});
        const int32_t beyond = triangles_[here_].neighbours[side_];
        const uint32_t j = side_to(beyond, here_);
        const int32_t tip = triangles_[beyond].vertices[j];
        if (tip == b) {
            flips_left_ = 1000 + 100 * crossed_.size() * crossed_.size();
            pass_ = Pass::clear;
            return;
        }
        const int side = turn(a, b, tip);
        if (side == 0) {
            stop(ContourFault::Kind::point_on_edge, tip, a);
            return;
        }
        // Seen from beyond, `left` comes after the tip's corner and `right` before it.
        side_ = side > 0 ? after(j) : before(j);
        (side > 0 ? left_ : right_) = tip;
        here_ = beyond;
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
    if (crossed_at_ > most_cleared && 2 * crossed_at_ > crossed_.size()) {
        crossed_.erase(crossed_.begin(), crossed_.begin() + static_cast<ptrdiff_t>(crossed_at_));
        crossed_at_ = 0;
    }
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
