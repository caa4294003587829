// SPDX-License-Identifier: MIT
// Contours that cross or touch themselves, made simple: the region around which ring 0 winds, either way, without
// what the other rings wind around; of its connected parts the largest one, with its holes.
//
// Points are put onto a grid of 2^26 cells or more across the drawing, where all signs are exact in whole numbers.
// Where edges cross both get a point, rounded to the grid; edges that pass a point nearer than a cell are led through
// it (Hobby: Practical segment intersection with finite precision output, 1999); that is done again until there is
// nothing to do. Edges that are drawn as often one way as the other go. What is left are the borders of faces, with a
// winding number each. Where the region touches itself in a point, its corners there are moved a few cells inwards,
// and all is checked again.
//
// Invariants
// - Rings stay closed: what is done to an edge leaves a way between its ends. So windings are those of whole rings.
// - In the end no two edges meet but at common points, and no point is nearer than a cell to another edge.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "skeletons/contour.h"
#include "skeletons/node_clusters.h"

namespace flg {

class ContourRepair {
public:
    // Rings from gather_contour, which outlive the kernel.
    ContourRepair(const Contour& rings, Memory* memory);

    // A unit is an edge, or some pairs of edges: at most 1 us on the whole. Throws if nothing with an area is left.
    // About linear in the points of drawings, 2 us each; quadratic where all edges are above each other.
    bool run(uint32_t count) {
        for (; count > 0 && pass_ != Pass::done; --count) step();
        return pass_ == Pass::done;
    }
    // As from clean_contour; input_points are no_point where edges crossed. Where nothing met, points are where they
    // were, else within 1e-7 of the drawing's size.
    Contour take_contour();

    static constexpr uint32_t no_point = ~0u;

private:
    // clang-format off
    enum class Pass {
        points, segments, begin_round, zero, count, sum, list, sweep, cut,
        end_round, heads, merge, halves, clear, degrees, sum_degrees, fan,
        sort, cycles, rays, spread, join, sizes, borders, done
    };
    // clang-format on
    struct Cell {
        int64_t x, y;
    };
    // How often it is drawn from a to b less than from b to a: by ring 0, and by the others, each with a weight of
    // its own so that what two of them wind around does not cancel out.
    struct Segment {
        uint32_t a, b;
        int64_t outer, hole;
    };
    struct Cut {
        uint32_t vertex, next;  // of the same segment
    };
    struct Cycle {
        uint64_t twice_area;  // of a whole number that may be below 0; sums on the way wrap
        uint32_t leftmost;    // vertex
        uint32_t begin;       // half
        uint32_t container;   // of an outer one: the cycle around it
        int64_t outer, hole;
        bool is_known;
    };

    void step();
    void enter(Pass pass) {
        pass_ = pass;
        at_ = 0;
    }
    void next_of(size_t count, Pass then) {
        if (++at_ >= count) enter(then);
    }
    uint32_t vertex_at(const Cell& cell, uint32_t source);
    void step_region();
    void add_point();
    void add_segment();
    void add_segment(uint32_t a, uint32_t b, uint32_t ring, uint32_t outer_ring);
    void begin_round();
    uint32_t bucket(const Segment& segment) const;
    void sweep();
    void meet(uint32_t first, uint32_t second);
    static int64_t turn(const Cell& a, const Cell& b, const Cell& c);
    static uint64_t twice_area_under(const Cell& a, const Cell& b);
    bool lead_through(uint32_t segment, uint32_t vertex);
    void cut_at(uint32_t segment, uint32_t vertex);
    void cut();
    void end_round();
    void merge();

    uint32_t from(uint32_t half) const { return half % 2 == 0 ? segments_[half / 2].a : segments_[half / 2].b; }
    uint32_t to(uint32_t half) const { return from(half ^ 1); }
    uint32_t clockwise(uint32_t half) const;
    bool is_before(uint32_t half, uint32_t other) const;
    void begin_regions();
    void walk_cycle();
    void begin_rays();
    void shoot();
    void spread();
    void begin_join();
    bool is_inside(uint32_t cycle) const { return cycles_[cycle].outer != 0 && cycles_[cycle].hole == 0; }
    void join_regions();
    void measure_regions();
    bool is_border(uint32_t half);
    void walk_border();
    void end_borders();
    void end_ring();
    void move_corners(const std::pmr::vector<uint32_t>& visits);
    [[noreturn]] void refuse() const;

    static constexpr int64_t margin = 1 << 12;       // cells around the drawing, for corners that are moved
    static constexpr int64_t area_origin = 1 << 26;  // of areas: about the middle

    const Contour& input_;
    Memory* memory_;
    Point2 low_{};
    double cell_ = 0;
    std::pmr::vector<Cell> vertices_;
    std::pmr::vector<uint32_t> sources_;  // one a vertex: the input's point, or no_point
    std::pmr::unordered_map<uint64_t, uint32_t> vertex_of_;
    std::pmr::vector<Segment> segments_, parts_;
    std::pmr::vector<uint32_t> first_cut_;
    std::pmr::vector<Cut> cuts_;
    std::pmr::vector<uint32_t> bucket_begin_, order_, active_;
    uint32_t active_at_ = 0;
    std::pmr::vector<uint32_t> chain_;
    std::pmr::vector<uint32_t> first_part_, next_part_;  // by vertex, and of the same vertex
    uint32_t rounds_ = 0, moves_ = 0;
    bool has_met_ = false;
    std::pmr::vector<uint32_t> fan_begin_, fan_, place_, cycle_of_;  // place_, cycle_of_: by half
    std::pmr::vector<Cycle> cycles_;
    std::pmr::vector<uint32_t> outer_cycles_, stack_;
    uint32_t ray_edge_ = 0, nearest_ = no_point;
    long double nearest_x_ = 0, nearest_slope_ = 0;
    int64_t ray_outer_ = 0, ray_hole_ = 0;
    uint32_t walk_at_ = no_point, walk_begin_ = no_point;  // halves, on the way around a cycle or a ring
    std::optional<NodeClusters> regions_;
    std::pmr::vector<uint64_t> areas_;
    uint32_t best_ = no_point;
    std::pmr::vector<uint8_t> is_used_;
    std::pmr::vector<uint32_t> ring_vertices_, ring_begin_;
    uint32_t outer_ring_ = 0;
    Pass pass_ = Pass::points;
    uint32_t at_ = 0;
};

}  // namespace flg
