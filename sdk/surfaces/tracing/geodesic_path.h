// SPDX-License-Identifier: MIT
// Geodesic paths between points of a mesh: sec. 4.2 (Line tracing, Operators) of Nazzaro, Puppo, Pellacini: geoTangle
// (2021), and straightened as the paper's are not. The way down a field of distances gives a first sleeve of triangles;
// where it ends elsewhere, or there is no field, the shortest strip over centroids does. The sleeve's shortest path is
// found in the unfolded plane. Where that turns at a vertex the sleeve changes to the vertex's other side as long as
// that is shorter (Xin, Wang: Efficiently determining a locally exact shortest path on polyhedral surfaces, 2007).
//
// Invariants of the result
// - Locally shortest: straight across every edge, and at a vertex inside the path the angles on both sides are at
//   least pi - path_angle_tolerance, but for sides on which the mesh or the regions end. Then points are rounded on
//   their edges: to 2^-24 of them, and onto a vertex nearer than 1e-6.
// - Every round shortens the path: those flips of a round whose triangles do not overlap are made at once, and the path
//   before them lies in the sleeve after them. Where there is no more to gain than rounding (at triangles without area
//   angles mean nothing) max_idle_rounds end the search.
// - There is a path wherever triangles of the regions join both points across edges, whatever the field's values.
// - The same from either end up to rounding where there is one shortest path; among several locally shortest the
//   field's first guess decides.
#pragma once

#include <limits>
#include <memory>
#include <span>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/mesh/surface_curves.h"

namespace flg {

constexpr double path_angle_tolerance = 1e-6;  // radians
constexpr uint32_t max_idle_rounds = 8;

struct GeodesicPath {
    bool found = false;                                       // false: no way leads there, and nothing was appended
    double length = std::numeric_limits<double>::infinity();  // metres
    bool is_straight = false;                                 // locally shortest: no more rounds were left to do
};

// `distances`: one a vertex, metres, from `to`: as a geodesic solver gives them, in the whole neighbourhood of the
// path; or empty. Both points are moved by less than 1e-6 of their triangle onto an edge or a vertex that is so near.
// Keeps to the regions. Appends the path's points to the curve that `out` ends with, from where that has come to, and
// leaves it to end_polyline() to end it; a path from a point to itself has none.
Task<GeodesicPath> add_geodesic_path(Pace& pace, const Mesh& mesh, SurfacePoint from, SurfacePoint to,
                                     std::span<const float> distances, const RegionSet& regions, SurfaceCurves& out);

// What paths are found and straightened with, one after another, in memory that stays.
class PathShortener {
public:
    // Mesh and regions outlive it.
    PathShortener(const Mesh& mesh, const RegionSet& regions, Memory* memory);
    // As add_geodesic_path(); the first sleeve is that of the way, a curve from one point to the other, unless null. So
    // the path passes everything on the way's side. Where the way breaks off the shortest strip is taken. Some us, and
    // 100 ns a triangle.
    friend Task<GeodesicPath> shorten_way(Pace& pace, PathShortener& shortener, SurfacePoint from, SurfacePoint to,
                                          const SurfaceCurves* way, SurfaceCurves& out);

private:
    std::shared_ptr<void> search_;  // a PathSearch of geodesic_path.cpp
};

Task<GeodesicPath> shorten_way(Pace& pace, PathShortener& shortener, SurfacePoint from, SurfacePoint to,
                               const SurfaceCurves* way, SurfaceCurves& out);

// Ends the curve that paths were appended to; `closed`: the last path ended where the first began. Value: `length`. A
// curve of fewer points than curves have is dropped; false then.
bool end_polyline(SurfaceCurves& out, bool closed, double length);

}  // namespace flg
