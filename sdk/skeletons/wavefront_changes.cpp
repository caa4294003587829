// SPDX-License-Identifier: MIT
// Of the wavefront: the four changes.
#include <cmath>
#include <limits>

#include "skeletons/wavefront.h"
#include "skeletons/wavefront_limits.h"

namespace flg {

// The triangles around vertex `from` get another one, from `triangle` on to the front: by the side before their
// corner at it, or the one after. They are done one a unit, once the change itself is done.
void Wavefront::give(int32_t triangle, bool by_before, int32_t from, int32_t to) {
    if (triangle >= 0) fans_[fan_count_++] = {triangle, from, to, by_before};
}

void Wavefront::relabel_one() {
    Fan& fan = fans_[fan_count_ - 1];
    const int32_t index = fan.triangle;
    const uint32_t k = corner(index, fan.from);
    Triangle& t = triangles_[index];
    t.vertices[k] = fan.to;
    fan.triangle = t.neighbours[fan.by_before ? before(k) : after(k)];
    if (fan.triangle < 0) --fan_count_;
    schedule(index);
}

// Sides i and j of a triangle that goes away become one. True if both were the front's: then nothing is left there.
bool Wavefront::join(int32_t triangle, uint32_t i, uint32_t j) {
    const int32_t a = triangles_[triangle].neighbours[i], b = triangles_[triangle].neighbours[j];
    if (a >= 0) triangles_[a].neighbours[side_to(a, triangle)] = b;
    if (b >= 0) triangles_[b].neighbours[side_to(b, triangle)] = a;
    return a < 0 && b < 0;
}

// Where the slower of two vertices that meet is: its place has the smaller error.
Point2 Wavefront::slower_place(int32_t a, int32_t b) const {
    const auto speed_sq = [](const Vertex& v) {
        if (v.is_infinite) return std::numeric_limits<double>::max();
        return v.velocity.x * v.velocity.x + v.velocity.y * v.velocity.y;
    };
    return position(vertices_[speed_sq(vertices_[a]) <= speed_sq(vertices_[b]) ? a : b]);
}

// The new vertex and the last one of its loop enclose nothing: an arc joins them, unless they are at one place.
void Wavefront::close_loop(int32_t vertex, int32_t last, const Point2& at) {
    const Vertex& v = vertices_[vertex];
    const Point2 end = position(vertices_[last]);
    if (std::hypot(end.x - at.x, end.y - at.y) <= wave::one_place * size_) {
        end_vertex(last, v.node);
    } else {
        const uint32_t node = add_node(end);
        end_vertex(last, node);
        arcs_[arc_count_++] = {v.node, node, v.left, v.right};
    }
}

// A front edge vanishes: its ends become one vertex.
void Wavefront::collapse_edge(int32_t triangle, uint32_t side) {
    const Triangle t = triangles_[triangle];
    const int32_t a = t.vertices[after(side)], b = t.vertices[before(side)], last = t.vertices[side];
    const Point2 at = slower_place(a, b);
    const uint32_t node = add_node(at), left = vertices_[a].left, right = vertices_[b].right;
    end_vertex(a, node);
    end_vertex(b, node);
    const bool ends = join(triangle, after(side), before(side));
    remove(triangle);
    const int32_t vertex = add_vertex(left, right, at, node);
    if (ends) {
        close_loop(vertex, last, at);
    } else {
        give(t.neighbours[after(side)], true, b, vertex);
        give(t.neighbours[before(side)], false, a, vertex);
    }
}

// Two vertices that are not neighbours on the front meet: it parts into one on each side of the diagonal.
void Wavefront::collapse_diagonal(int32_t triangle, uint32_t side) {
    const int32_t other = triangles_[triangle].neighbours[side];
    const uint32_t j = side_to(other, triangle);
    const Triangle t = triangles_[triangle], o = triangles_[other];
    const int32_t u = t.vertices[after(side)], w = t.vertices[before(side)];
    const Point2 at = slower_place(u, w);
    const uint32_t node = add_node(at);
    const Vertex from_u = vertices_[u], from_w = vertices_[w];
    end_vertex(u, node);
    end_vertex(w, node);
    const bool here_ends = join(triangle, after(side), before(side)), there_ends = join(other, after(j), before(j));
    remove(triangle);
    remove(other);
    const int32_t here = add_vertex(from_u.left, from_w.right, at, node);
    if (here_ends) {
        close_loop(here, t.vertices[side], at);
    } else {
        give(t.neighbours[after(side)], true, w, here);
        give(t.neighbours[before(side)], false, u, here);
    }
    const int32_t there = add_vertex(from_w.left, from_u.right, at, node);
    if (there_ends) {
        close_loop(there, o.vertices[j], at);
    } else {
        give(o.neighbours[after(j)], true, u, there);
        give(o.neighbours[before(j)], false, w, there);
    }
}

// A vertex reaches a front edge and parts it.
void Wavefront::split(int32_t triangle, uint32_t side) {
    const Triangle t = triangles_[triangle];
    const int32_t tip = t.vertices[side], edge = t.neighbours[side];
    const int32_t at_begin = t.neighbours[before(side)], at_end = t.neighbours[after(side)];
    if (at_begin < 0 || at_end < 0) {
        fail();
        return;
    }
    const Point2 at = position(vertices_[tip]);
    const uint32_t node = add_node(at), left = vertices_[tip].left, right = vertices_[tip].right;
    end_vertex(tip, node);
    triangles_[at_begin].neighbours[side_to(at_begin, triangle)] = edge;
    triangles_[at_end].neighbours[side_to(at_end, triangle)] = edge;
    remove(triangle);
    give(at_begin, true, tip, add_vertex(static_cast<uint32_t>(~edge), right, at, node));
    give(at_end, false, tip, add_vertex(left, static_cast<uint32_t>(~edge), at, node));
}

void Wavefront::flip(int32_t triangle, uint32_t k) {
    const Triangle here = triangles_[triangle];
    const int32_t other = here.neighbours[k];
    const uint32_t j = side_to(other, triangle);
    const Triangle there = triangles_[other];
    const int32_t a = here.vertices[k], b = here.vertices[after(k)], c = here.vertices[before(k)],
                  d = there.vertices[j];
    triangles_[triangle] = {{a, b, d}, {there.neighbours[after(j)], other, here.neighbours[before(k)]}};
    triangles_[other] = {{a, d, c}, {there.neighbours[before(j)], here.neighbours[after(k)], triangle}};
    const int32_t beyond_d = there.neighbours[after(j)], beyond_c = here.neighbours[after(k)];
    if (beyond_d >= 0) triangles_[beyond_d].neighbours[side_to(beyond_d, other)] = triangle;
    if (beyond_c >= 0) triangles_[beyond_c].neighbours[side_to(beyond_c, triangle)] = other;
    schedule(triangle);
    schedule(other);
}

}  // namespace flg
