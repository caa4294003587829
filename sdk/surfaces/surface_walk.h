// SPDX-License-Identifier: MIT
// Ways over a mesh between two points that lie in a plane: that through both and the surface's normal there.
//
// Invariants
// - Each vertex is on one side of the plane, none on it. So a way enters a triangle by one edge and leaves it by the one other
//   whose ends are on different sides: whatever the rounding, it neither branches nor ends within the mesh.
// - Points on edges are rounded as those of geodesic paths are: to 2^-24 of the edge, and onto a vertex nearer than 1e-6.
#pragma once

#include <optional>

#include "surfaces/surface_curves.h"
#include "surfaces/surface_place.h"

namespace flg {

class SurfaceWalkKernel {
public:
    // Ways so many times longer than the straight line are given up: the ends lie on different sides of something.
    static constexpr double most_detour = 4;

    // Both points are moved by less than 1e-6 of their triangle onto an edge or a vertex that is so near. Appends to `out` as
    // GeodesicPathKernel does; a way that isn't found leaves it as it was. All must outlive the run.
    SurfaceWalkKernel(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to, SurfaceCurves& out);

    // Spends `count` units of about 100 ns, a triangle each; true when done.
    bool run(uint32_t count);

    // When done. False: the way comes to a border, or passes the end by.
    bool found() const { return found_; }
    double length() const { return length_; }  // metres

private:
    enum class Pass { begin, look, walk, done };

    void begin();
    void look();
    void step();
    void give_up();
    void arrive(uint32_t triangle, const SurfacePoint& end);
    Corner next_around(Corner corner) const;
    bool is_at_start(Corner edge) const;
    double height(uint32_t vertex) const { return left_.dot(mesh_.position(vertex) - start_); }
    double share(Corner edge) const;
    bool leads_out(Corner edge) const;
    void draw(const SurfacePlace& to, uint32_t triangle);

    const Mesh& mesh_;
    const SurfacePoint points_[2];
    const SurfacePlace from_, to_;
    SurfaceCurves& out_;
    Vec3 start_, along_, left_;  // the plane; `left_` is across it
    Pass pass_ = Pass::begin;
    Corner corner_ = no_index;           // of the triangle around the start that comes next
    Corner exit_ = no_index;             // the edge that is crossed next
    double ahead_ = 0;                   // how straight ahead it is, at the start
    SurfacePlace drawn_;                 // how far the way has come
    size_t before_ = 0;                  // points of `out` that stay
    std::optional<SurfacePoint> joint_;  // the one behind them, where the way goes on
    uint32_t steps_ = 0;
    bool found_ = false;
    double length_ = 0;
};

}  // namespace flg
