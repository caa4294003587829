// SPDX-License-Identifier: MIT
// The isolines of a field at many levels in one pass, ordered into loops and chains: the contour lines of sec. 4.2 (Line
// tracing) of Nazzaro, Puppo, Pellacini: geoTangle (2021).
//
// Invariants
// - A value at or above the level counts as above it, in every triangle alike. So a triangle has at most one segment a
//   level, segments join across edges without exception, and saddles and plateaus need no case of their own: an isoline
//   passes a plateau of exactly its value on the lower side.
// - Higher values lie on the left, seen from outside.
// - A chain ends where the mesh, the regions or the finite values end; all other isolines are closed.
// - At a point the field, interpolated on its edge, differs from the level by at most 2^-24 of the edge's difference.
//   Points are on the edges they cross, or on vertices of exactly the level's value (or as near as that).
// - Segments without length (at a vertex of the level's value) are left out, and so are curves that keep fewer points
//   than a curve must have: those around a single vertex or edge.
#pragma once

#include <span>

#include "surfaces/region_set.h"
#include "surfaces/surface_curves.h"

namespace flg {

class IsolineKernel {
public:
    static constexpr uint32_t max_levels = 65534;

    // `values`: one a vertex, linear in each triangle; triangles with one that is not finite hold no isoline. `levels`:
    // finite, rising, at most max_levels. Appends to `out`, values being the levels; first the chains, then the loops,
    // each kind by the triangle it begins in. All must outlive the run.
    // Memory while it runs: 2 bytes a vertex, 16 bytes for 64 triangles, 28 bytes a segment.
    IsolineKernel(const Mesh& mesh, std::span<const float> values, std::span<const float> levels,
                  const RegionSet& regions, SurfaceCurves& out, Memory* memory);

    // Spends `count` units of about 5 ns; true when done. A vertex or a triangle takes one, a segment eight.
    bool run(uint32_t count);

private:
    enum class Pass { classify, scan, link, chains, loops, done };

    // Where an isoline crosses a triangle: in on the edge at corner `in`, out on the one at `out`.
    struct Crossing {
        uint32_t in, out;        // 0 to 2
        float in_at, out_at;     // on these edges
        bool has_length = true;  // false if both are the same vertex
    };
    struct Segment {
        SurfacePoint start;
        uint32_t following;  // the triangle it leads into, after linking the segment there; no_index if none
        uint16_t level;
        bool has_length;
        bool has_preceding;
        bool is_drawn;
    };
    // For each 64 triangles.
    struct Mark {
        uint64_t crossed;  // bit i: triangle i of them is
        uint32_t before;   // crossed triangles before these
    };
    struct CrossedTriangle {
        uint32_t first_segment;  // one segment a level, rising
        uint16_t lowest_level;
    };

    void classify(uint32_t vertex);
    Crossing crossing(uint32_t triangle, uint32_t level) const;
    void begin_crossing(uint32_t triangle);
    void cross_next_level(uint32_t triangle);
    uint32_t segment_at(uint32_t triangle, uint32_t level) const;
    void draw(uint32_t segment);
    void end_curve(bool closed);
    void enter(Pass pass);

    const Mesh& mesh_;
    std::span<const float> values_;
    std::span<const float> levels_;
    const RegionSet& regions_;
    SurfaceCurves& out_;
    Buffer<uint16_t> classes_;  // of a vertex: how many levels its value reaches
    Buffer<Mark> marks_;
    std::pmr::deque<CrossedTriangle> crossed_;
    std::pmr::deque<Segment> segments_;
    Pass pass_ = Pass::classify;
    uint32_t at_ = 0;
    uint16_t band_ = 0;  // the class of values from band_begin_ to below band_end_; none yet
    float band_begin_ = 0, band_end_ = 0;
    uint16_t next_level_ = 0;  // of the triangle that is being crossed, the one before at_
    uint16_t end_level_ = 0;
    uint32_t drawing_ = no_index;     // the segment to draw next
    uint32_t last_drawn_ = no_index;  // the last one with length of this curve
};

}  // namespace flg
