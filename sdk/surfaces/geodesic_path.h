// SPDX-License-Identifier: MIT
// Geodesic paths between points of a mesh: sec. 4.2 (Line tracing, Operators) of Nazzaro, Puppo, Pellacini: geoTangle
// (2021), and straightened as the paper's are not: the way down a field of distances gives a first sleeve of triangles,
// the shortest path in it is found in the unfolded plane, and where the path turns at a vertex the sleeve changes to the
// vertex's other side as long as that is shorter (Xin, Wang: Efficiently determining a locally exact shortest path on
// polyhedral surfaces, 2007).
//
// Invariants of the result
// - Locally shortest: straight across every edge, and at a vertex inside the path the angles on both sides are at least
//   pi - angle_tolerance, but for sides on which the mesh or the regions end. Then points are rounded on their edges:
//   to 2^-24 of them, and onto a vertex nearer than 1e-6.
// - Every round shortens the path: those flips of a round whose triangles do not overlap are made at once, and the path
//   before them lies in the sleeve after them. Where there is no more to gain than rounding (at triangles without area
//   angles mean nothing) max_idle_rounds end the search.
// - The same from either end up to rounding where there is one shortest path; among several locally shortest the field's
//   first guess decides.
#pragma once

#include <limits>

#include "surfaces/distance_field.h"
#include "surfaces/geodesic_funnel.h"
#include "surfaces/integral_curves.h"

namespace flg {

class GeodesicPathKernel {
public:
    static constexpr double angle_tolerance = 1e-6;  // radians
    static constexpr uint32_t max_idle_rounds = 8;

    // `distances`: one a vertex, metres, from `to`: as a geodesic solver gives them, in the whole neighbourhood of the
    // path. Both points are moved by less than 1e-6 of their triangle onto an edge or a vertex that is so near. Keeps to
    // the regions. Appends the path's points to the curve that `out` ends with, from where that has come to, and leaves it
    // to end_polyline() to end it; a path from a point to itself has none. All must outlive the run.
    GeodesicPathKernel(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to,
                       std::span<const float> distances, const RegionSet& regions, SurfaceCurves& out, Memory* memory);

    GeodesicPathKernel(const GeodesicPathKernel&) = delete;
    GeodesicPathKernel& operator=(const GeodesicPathKernel&) = delete;

    // Spends `count` units of about 50 ns; true when done.
    bool run(uint32_t count);

    // When done. False: `to` can't be reached, and nothing was appended.
    bool found() const { return found_; }
    double length() const { return found_ ? length_ : std::numeric_limits<double>::infinity(); }  // metres
    // Whether it is locally shortest: no more rounds were left to do.
    bool is_straight() const { return found_ && flips_.size() == 0; }

private:
    enum class Pass { trace, follow, unfold, test_bends, flip, draw, done };

    // The sleeve's triangles between `first` and `last`, all about the vertex, are to be those on its other side.
    struct Flip {
        uint32_t first, last;
        uint32_t vertex;
        bool counter_clockwise;
    };

    bool is_open(uint32_t triangle) const { return regions_.contains(mesh_.regions[triangle]); }
    void begin_follow();
    void follow_point();
    void follow_to_end(const SurfacePlace& last);
    void begin_unfold();
    uint32_t last_gate_at(const PathBend& bend) const;
    double corner_angle(uint32_t triangle, uint32_t vertex) const;
    bool is_shorter_around(uint32_t bend, Flip& flip);
    void test_bend();
    void flip_next();
    void draw_next();
    void pass_through(const SurfacePlace& place, uint32_t triangle);
    void charge(uint32_t units) { units_ -= std::min(units_, units); }

    const Mesh& mesh_;
    const RegionSet& regions_;
    const SurfacePoint start_;
    const SurfacePlace from_, to_;
    SurfaceCurves& out_;
    std::array<uint32_t, 3> targets_{};
    SurfaceCurves traced_;
    IntegralCurveKernel trace_;
    GeodesicSleeve sleeves_[2];
    GeodesicSleeve* sleeve_ = &sleeves_[0];
    GeodesicSleeve* flipped_ = &sleeves_[1];
    GeodesicFunnel funnel_;
    ReusedDeque<Flip> flips_;
    Pass pass_ = Pass::trace;
    uint32_t units_ = 0;
    uint32_t at_ = 0;       // point, bend, triangle or gate of the pass
    uint32_t item_at_ = 0;  // flip, or bend to draw
    Vec2 straight_from_{};
    SurfacePlace drawn_{};  // the place drawn last, and the triangle the path enters from there
    uint32_t drawn_triangle_ = 0;
    uint32_t idle_rounds_ = 0;  // without gain
    bool found_ = false;
    double length_ = 0;
    double shortest_ = std::numeric_limits<double>::infinity();  // of all rounds
};

// Ends the curve that paths were appended to; `closed`: the last path ended where the first began. Value: `length`. A
// curve of fewer points than curves have is dropped; false then.
bool end_polyline(SurfaceCurves& out, bool closed, double length);

}  // namespace flg
