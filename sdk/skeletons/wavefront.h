// SPDX-License-Identifier: MIT
// The wavefront of a contour whose edges all move inwards at unit speed, in a triangulation that moves with it: a
// change of the front is a triangle that collapses, so nothing is searched (Aichholzer, Aurenhammer: Straight
// skeletons for general polygonal figures in the plane, 1996; with the rules for events at one time of Palfrader,
// Held, Huber: On computing straight skeletons by means of kinetic triangulations, 2012). Its vertices draw the
// straight skeleton's arcs.
//
// Rules that keep it right in double precision, beside those of the second paper
// - A front edge without length vanishes now, whatever its ends' speeds: after a chain of edges collapsed at one
//   point rounding gives those left any sign. So do two vertices at one place that share a diagonal.
// - A vertex between edges that meet face to face is infinitely fast: it waits until all else at its time is done. So
//   does one that would move out of its only triangle.
// - Of triangles that are flat together the one with the longest side is flipped first.
// - A diagonal that closes as its triangle gets flat is a double root of the area: when it closes is found by itself,
//   and stands for the flattening up to closing_lead before.
// - Each vertex is put onto its two lines where these are far from parallel, so errors do not add up.
// - Bounds for areas are products of two lengths at hand, never one for all.
// All lengths are in units of the contour's diagonal, about 1.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/memory.h"
#include "skeletons/contour_triangulation.h"
#include "skeletons/event_queue.h"
#include "skeletons/skeleton_graph.h"

namespace flg {

class Wavefront {
public:
    // The triangulation is complete and without fault, its points have a diagonal of about `size`. Both outlive the
    // kernel. Edges face each other, and their vertex is infinitely fast, where their normals add up to less than
    // `facing`.
    Wavefront(const ContourTriangulation& triangulation, std::span<const Point2> points, std::span<const uint32_t> next,
              double size, double facing, Memory* memory);

    // A unit is an event, or a triangle or a point at the beginning: about 0.3 us. True at the end, also when it
    // failed.
    bool run(uint32_t count) {
        for (; count > 0 && pass_ != Pass::done; --count) step();
        return pass_ == Pass::done;
    }
    // Events came without end, or left triangles that no event takes away.
    bool failed() const { return failed_; }

    // The contour's points come first. Arcs may be without length.
    std::span<const SkeletonNode> nodes() const { return {nodes_.data(), node_count_}; }
    std::span<const SkeletonArc> arcs() const { return {arcs_.data(), arc_count_}; }

private:
    enum class Pass { vertices, number, triangles, schedule, events, leftovers, done };
    struct Line {
        Point2 normal, direction;
        double offset;  // at time t the line is where normal . x = offset + t
    };
    struct Vertex {
        Point2 at;  // at `time`
        Point2 velocity;
        double time;
        uint32_t left, right;  // the edge that ends here and the one that begins
        uint32_t node;
        bool is_infinite;
    };
    // neighbours[k] is across from vertices[k]; below 0: front edge ~neighbour. Without vertices: vertices[0] is -1.
    struct Triangle {
        std::array<int32_t, 3> vertices, neighbours;
    };
    // Triangles around a vertex that are still to get another one.
    struct Fan {
        int32_t triangle, from, to;
        bool by_before;
    };
    enum class Change { edge, diagonal, split, flip, walk };
    // A triangle's corners and sides at a moment.
    struct Shape {
        std::array<Point2, 3> at, velocity;
        std::array<double, 3> lengths;
    };

    static constexpr uint32_t none = ~0u;

    static uint32_t after(uint32_t k) { return k == 2 ? 0 : k + 1; }
    static uint32_t before(uint32_t k) { return k == 0 ? 2 : k - 1; }
    void step();
    void enter(Pass pass) {
        pass_ = pass;
        at_ = 0;
    }
    void fail() {
        failed_ = true;
        pass_ = Pass::done;
    }
    Point2 position(const Vertex& vertex) const {
        const double age = now_ - vertex.time;
        return {vertex.at.x + vertex.velocity.x * age, vertex.at.y + vertex.velocity.y * age};
    }
    Shape shape(const Triangle& triangle) const;
    static uint32_t front_sides(const Triangle& t) {
        return (t.neighbours[0] < 0) + (t.neighbours[1] < 0) + (t.neighbours[2] < 0);
    }
    bool is_alive(int32_t triangle) const { return triangles_[triangle].vertices[0] >= 0; }
    void remove(int32_t triangle);

    void add_edge(uint32_t point);
    void add_triangle(uint32_t triangle);
    int32_t add_vertex(uint32_t left, uint32_t right, const Point2& at, uint32_t node);
    uint32_t add_node(const Point2& at);
    void end_vertex(int32_t vertex, uint32_t node);

    void schedule(int32_t triangle);
    void hold_if_turned_out(const Triangle& t);
    void closing_edges(const Triangle& t, const Shape& s, WaveEvent& event) const;
    void closing_diagonals(const Triangle& t, const Shape& s, WaveEvent& event) const;
    double reaches_edge(const Triangle& t, const Shape& s) const;
    double gets_flat(const Shape& s) const;

    void next_event();
    bool waits(const WaveEvent& event, uint32_t triangle);
    Change decide(int32_t triangle, uint32_t& side, const WaveEvent& event) const;
    Change decide_flat(const Triangle& t, uint32_t& side) const;
    uint32_t shortest_front(const Triangle& t, uint32_t best) const;
    static uint32_t longest_side(const Shape& s);
    void walk();
    bool hop();
    void change(Change change);

    uint32_t corner(int32_t triangle, int32_t vertex) const { return place_in(triangles_[triangle].vertices, vertex); }
    uint32_t side_to(int32_t triangle, int32_t neighbour) const {
        return place_in(triangles_[triangle].neighbours, neighbour);
    }
    void give(int32_t triangle, bool by_before, int32_t from, int32_t to);
    void relabel_one();
    bool join(int32_t triangle, uint32_t i, uint32_t j);
    Point2 slower_place(int32_t a, int32_t b) const;
    void close_loop(int32_t vertex, int32_t last, const Point2& at);
    void collapse_edge(int32_t triangle, uint32_t side);
    void collapse_diagonal(int32_t triangle, uint32_t side);
    void split(int32_t triangle, uint32_t side);
    void flip(int32_t triangle, uint32_t side);

    const ContourTriangulation& triangulation_;
    std::span<const Point2> points_;
    std::span<const uint32_t> next_;
    double size_, facing_;
    double now_ = 0;
    Buffer<Line> lines_;
    Buffer<uint32_t> previous_;
    Buffer<int32_t> number_;  // of the triangulation's triangles, here
    Buffer<Triangle> triangles_;
    Buffer<Vertex> vertices_;
    Buffer<SkeletonNode> nodes_;
    Buffer<SkeletonArc> arcs_;
    EventQueue queue_;
    // The change that is under way: of the triangle whose event it is, or of one that was reached from it.
    int32_t begun_ = -1, changing_ = -1;
    uint32_t side_ = 0;
    uint32_t hops_ = 0;         // on the way to that; 0: there
    int32_t left_behind_ = -1;  // the triangle that it was reached from, without an event
    std::array<Fan, 4> fans_;
    uint32_t fan_count_ = 0;
    uint32_t triangle_count_ = 0, vertex_count_ = 0, node_count_ = 0, arc_count_ = 0;
    uint64_t events_left_;
    Pass pass_ = Pass::vertices;
    uint32_t at_ = 0;
    bool failed_ = false;
};

}  // namespace flg
