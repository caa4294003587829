// SPDX-License-Identifier: MIT
// A constrained triangulation of one triangle: points on its edges and inside, straight segments between them that
// become edges, and new points where they cross. Segments come in one by one; edges in their way are flipped (Sloan: A
// fast algorithm for generating constrained Delaunay triangulations, 1993).
//
// Invariants
// - Coordinates are weights of the triangle's corners 1 and 2 in whole numbers, so orientations are exact: all
//   triangles turn counter-clockwise at all times, however flat the triangle is in space.
// - Points closer than `tolerance` are one; a segment that passes a vertex at most that far away goes through it. So
//   curves move by about the tolerance, and crossings keep off vertices.
// - Each point, crossing and flip takes time linear in the vertices: made for triangles with a few dozen of them. With
//   thousands it takes seconds. So it goes step by step, and no call does more than looking at all triangles a few
//   times (cost()): how many steps there will be is not known.
#pragma once

#include <algorithm>

#include "surfaces/cutting/cut_pieces.h"

namespace flg {

class CutTriangulation {
public:
    static constexpr int32_t scale = 1 << 24;  // the weight of a corner where it is
    static constexpr int32_t tolerance = static_cast<int32_t>(cut_tolerance * scale);

    struct Point {
        int32_t x, y;  // weights of the corners 1 and 2
    };
    struct Triangle {
        Triple vertices, neighbours;  // neighbours as in Pieces
        std::array<bool, 3> is_segment;
    };

    explicit CutTriangulation(Memory* memory)
        : points_(memory),
          triangles_(memory),
          splits_(memory),
          first_split_(memory),
          path_(memory),
          targets_(memory),
          way_(memory),
          reached_from_(memory) {}

    // Begins anew: vertices 0, 1, 2 are the corners, `to_1` and `to_2` the edges from corner 0 to the others in space.
    void reset(const Vec3& to_1, const Vec3& to_2);
    // On edge k, before all other points, those of an edge in the order they have along it; 0 < along < scale.
    uint32_t add_on_edge(uint32_t k, int32_t along);
    uint32_t add(const Point& point);
    // Joins two vertices, step by step until one returns true. Then path() holds the vertices on the way, both
    // included.
    void begin_segment(uint32_t from, uint32_t to);
    bool step();
    const std::pmr::vector<uint32_t>& path() const { return path_; }
    // Flips edges that belong to no segment and are not Delaunay in space, step by step until one returns true.
    void begin_improvement();
    bool improve();
    // How long the next call takes, in units of about 0.2 us.
    uint32_t cost() const { return 1 + static_cast<uint32_t>(triangles_.size()) / 16; }

    // Visits the vertices after `from` up to `to`, two that followed each other on a path, with the crossings of later
    // segments.
    template <class Visit>
    void follow(uint32_t from, uint32_t to, const Visit& visit) const {
        const uint32_t later = std::max(from, to);
        for (uint32_t i = later < first_split_.size() ? first_split_[later] : no_index; i != no_index;) {
            const Split& split = splits_[i];
            if (split.earlier == std::min(from, to)) {
                follow(from, split.middle, visit);
                follow(split.middle, to, visit);
                return;
            }
            i = split.next;
        }
        visit(to);
    }

    const std::pmr::vector<Point>& points() const { return points_; }
    const std::pmr::vector<Triangle>& triangles() const { return triangles_; }

private:
    struct Edge {
        uint32_t triangle, k;
    };
    // A segment's edge that was split; listed with the later one of its ends, which few edges share.
    struct Split {
        uint32_t earlier, middle, next;
    };
    // How a segment gets on: straight, once the edges in its way are flipped; else along the fewest edges there are.
    enum class Progress { straight, clearing, searching, walking };

    static constexpr Edge no_edge{no_index, 0};

    // Of the vectors from a to b and c, as if the triangle were equilateral with edges of length `scale`.
    static double dot(const Point& a, const Point& b, const Point& c);
    // Twice the area, on the lattice; positive if counter-clockwise.
    static int64_t turn(const Point& a, const Point& b, const Point& c);
    int64_t turn(uint32_t a, uint32_t b, uint32_t c) const { return turn(points_[a], points_[b], points_[c]); }
    bool crosses(uint32_t from, uint32_t to, uint32_t a, uint32_t b) const;
    Edge find(uint32_t a, uint32_t b) const;
    uint32_t vertex_near(uint32_t from, uint32_t to) const;
    Edge first_segment_across(uint32_t from, uint32_t to) const;
    Edge across(const Edge& edge) const;
    void redirect(uint32_t triangle, uint32_t old, uint32_t now);
    bool split_edge(const Edge& edge, uint32_t vertex);
    void remember_split(uint32_t a, uint32_t b, uint32_t middle);
    void split_triangle(uint32_t triangle, uint32_t vertex);
    bool flip(const Edge& edge);
    bool is_delaunay(const Edge& edge) const;
    uint32_t cross_segment(uint32_t from, uint32_t to, const Edge& edge);
    void begin_clearing(uint32_t from, uint32_t to);
    void clear_next(uint32_t from, uint32_t to);
    void aim_at(uint32_t vertex);
    void go_along(const Edge& edge, uint32_t to);
    void begin_search();
    void search_next();
    bool step_straight();

    std::pmr::vector<Point> points_;
    std::pmr::vector<Triangle> triangles_;
    std::pmr::vector<Split> splits_;
    std::pmr::vector<uint32_t> first_split_;  // by vertex
    // The last part of the edge that points are added to.
    uint32_t edge_growing_ = no_index;
    Edge last_part_ = no_edge;
    std::pmr::vector<uint32_t> path_;
    uint32_t here_ = 0;  // where the segment has come to
    size_t steps_left_ = 0;
    std::pmr::vector<uint32_t> targets_;                   // of the segment, the nearest last
    std::pmr::vector<std::pair<uint32_t, uint32_t>> way_;  // edges to clear; vertices to search from
    std::pmr::vector<uint32_t> reached_from_;              // by vertex, of a search: the next one on the way to the end
    Progress progress_ = Progress::straight;
    size_t way_at_ = 0;    // edges that were cleared, or vertices that were searched from
    size_t way_most_ = 0;  // edges to clear at most
    uint32_t improved_to_ = 0;
    uint32_t passes_left_ = 0;
    bool pass_flipped_ = false;
    double metric_xx_ = 1, metric_xy_ = 0, metric_yy_ = 1;
};

}  // namespace flg
