// SPDX-License-Identifier: MIT
// From sources to seeds. A source is a vertex, a point on a face, a curve on the surface, or an edge; what solvers
// start from are vertices and how far they are from it. Distances are straight ones within the triangle that holds the
// source and, where the straight line leads there, across one edge of it into the neighbour, or up to four where edges
// were flipped: exact where no shorter way leads around a vertex.
//
// A seed also tells whether the front is straight or a circle when it comes by, and a wrong circle makes distances too
// short all the way on. So what is nearest to the joint of two segments, but to neither's inside, is told by others.
#pragma once

#include <deque>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/geodesics/distance_field.h"
#include "surfaces/geodesics/intrinsic_triangles.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/mesh/surface_curves.h"

namespace flg {

// Collects seeds, in any order and more than one a vertex. Sources outside of `within` add nothing, others nothing
// outside.
class GeodesicSeeds {
public:
    // `positions`, one a vertex, may be others than the mesh's: those of the metric to measure in. `flipped`: triangles
    // that the solver will unfold in place of the mesh's, or null. All outlive this.
    GeodesicSeeds(const Mesh& mesh, const GrowingBuffer<Position>& positions, const RegionSet& within, Memory* memory,
                  const IntrinsicTriangles* flipped = nullptr)
        : mesh_(mesh), positions_(positions), within_(within), flipped_(flipped), found_(memory) {}

    // Each costs less than 1 us. A vertex must have a triangle within the regions: that is not checked.
    void add_vertex(uint32_t vertex, uint32_t label) { found_.push_back({vertex, 0, label}); }
    void add_point(const SurfacePoint& point, uint32_t label) {
        add_segment(point, point, {End::corner, End::corner}, label);
    }
    // What a segment's end is: the source's end, or a corner of it, from which circles go out; a joint where it goes on
    // with little of a turn; or a vertex of the mesh.
    enum class End : uint8_t { corner, joint, vertex };
    // From `begin` to `end` in begin's triangle; `end` may name another triangle that it lies on the border of.
    void add_segment(const SurfacePoint& begin, const SurfacePoint& end, std::array<End, 2> ends, uint32_t label);
    // The edge that starts at `corner`, seen from its triangle.
    void add_edge(Corner corner, uint32_t label);
    // Where a border of regions turns away from the triangles on one side of it, circles go out from its vertex: the
    // one at `corner`, of the triangles from the border's edge that starts there counter-clockwise to its next one.
    void add_turn(Corner corner, const RegionSet& regions, uint32_t label);

    const std::pmr::deque<Seed>& found() const { return found_; }

    Vec3 place(const SurfacePoint& point) const;

private:
    double angle_at(Corner corner) const;
    void add_from_triangle(uint32_t triangle, const Vec3& begin, const Vec3& end, std::array<End, 2> ends,
                           uint32_t label);

    const Mesh& mesh_;
    const GrowingBuffer<Position>& positions_;
    const RegionSet& within_;
    const IntrinsicTriangles* flipped_;
    std::pmr::deque<Seed> found_;
};

// Adds a curve of a set, segment by segment.
Task<void> add_curve(Pace& pace, const SurfaceCurves& curves, uint32_t curve, uint32_t label, GeodesicSeeds& seeds);

// Adds the border of a set of regions: the edges of their triangles that lie towards others, or at the mesh's border.
// Of all regions: the mesh's border.
Task<void> add_border(Pace& pace, const Mesh& mesh, const RegionSet& regions, uint32_t label, GeodesicSeeds& seeds);

// Sorts seeds by vertex and keeps of each vertex the nearest, of equally near ones the first added.
Task<Buffer<Seed>> merge_seeds(Pace& pace, const std::pmr::deque<Seed>& found);

}  // namespace flg
