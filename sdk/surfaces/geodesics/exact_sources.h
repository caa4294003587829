// SPDX-License-Identifier: MIT
// Sources of exact distances: vertices, points, lines. Light goes out from vertices and points in circles, from the
// inside of lines straight to both sides, and from their ends in circles to what lies beyond.
#pragma once

#include "surfaces/geodesics/exact_solver.h"
#include "surfaces/mesh/surface_curves.h"

namespace flg {

// A straight piece of a curve whose sides are told apart, in the coordinates of its triangle's first edge.
struct SidedSegment {
    static constexpr uint32_t no_side = no_index - 1, beyond_end = no_index - 2;  // labels of places on the curve, and
                                                                                  // of those nearest to its ends
    // Left of piece i is 2 i, right of it 2 i + 1.
    uint32_t label_of(const Vec2& place) const;
    Vec2 foot_of(const Vec2& place) const;  // its nearest place

    uint32_t piece = 0;
    bool begins = false, ends = false;  // the curve
    uint32_t triangle = no_index;
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};

// Sources outside of `within` add nothing. Each costs less than 2 us.
class ExactSources {
public:
    // All outlive this.
    ExactSources(const Mesh& mesh, const RegionSet& within, ExactSolver& solver)
        : mesh_(mesh), within_(within), solver_(solver) {}

    // A vertex must have a triangle within the regions: that is not checked.
    void add_vertex(uint32_t vertex, uint32_t label) { solver_.start_at(vertex, label); }
    void add_point(const SurfacePoint& point, uint32_t label);
    // From `begin` to `end` in begin's triangle; `end` may name another triangle that it lies on the border of.
    void add_segment(const SurfacePoint& begin, const SurfacePoint& end, uint32_t label);
    // Likewise a piece of a curve, from and to places a little within the triangle: so each side of it sends light of
    // its own label, wherever it lies. Places that it moves: by 1e-9 of an edge.
    SidedSegment add_sided(const SurfacePoint& begin, const SurfacePoint& end, SidedSegment labels);
    // The edge that starts at `corner`, to both sides.
    void add_edge(Corner corner, uint32_t label);

private:
    void shine_straight(uint32_t triangle, const Vec2& begin, const Vec2& end, uint32_t label);
    void shine_around(uint32_t triangle, const Vec2& place, const Vec2& beyond, const Vec2& beside, uint32_t label);

    const Mesh& mesh_;
    const RegionSet& within_;
    ExactSolver& solver_;
};

// Adds a curve of a set, segment by segment.
Task<void> add_curve(Pace& pace, const SurfaceCurves& curves, uint32_t curve, uint32_t label, ExactSources& sources);

// Adds the border of a set of regions: the edges of their triangles that lie towards others, or at the mesh's border.
Task<void> add_border(Pace& pace, const Mesh& mesh, const RegionSet& regions, uint32_t label, ExactSources& sources);

}  // namespace flg
