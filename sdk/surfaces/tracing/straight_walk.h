// SPDX-License-Identifier: MIT
// Straightest geodesics (Polthier, Schmies: Straightest geodesics on polyhedral surfaces, 1998): from a point of a mesh
// on in a direction, straight across every edge, so long as wanted.
//
// Directions at a point are angles, counter-clockwise. About a vertex the angles of its triangles are scaled to a full
// turn, so opposite directions leave equal angles on both sides; at a border vertex they stay as they are.
#pragma once

#include <vector>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/surface_place.h"
#include "surfaces/tracing/surface_path.h"

namespace flg {

// Where a walk begins.
struct SurfaceRay {
    SurfacePoint from{};
    Vec3 direction = Vec3::Zero();  // of unit length, in the plane of that triangle
};

class DirectionFrame {
public:
    explicit DirectionFrame(Memory* memory) : wedges_(memory) {}
    // About 50 ns a triangle around the place.
    friend Task<void> set_frame(Pace& pace, DirectionFrame& frame, const Mesh& mesh, SurfacePlace place);

    // False where the triangles around have no area, or at a place that was not set.
    bool is_valid() const { return turn_ > 0; }
    // Of a direction in one of the triangles around, not 0.
    double angle_of(uint32_t triangle, const Vec3& direction) const;
    // The angle of a tangent's half, given that of its forward one: at a border that either half would lead over, along
    // the border.
    double half_tangent(double forward, bool is_forward) const;
    // Any angle; at a border, the nearest that leads into the surface.
    SurfaceRay ray(const Mesh& mesh, double angle) const;

private:
    // A triangle's part of the turn: angles from `begin` on, before they are scaled.
    struct Wedge {
        uint32_t triangle;
        double begin, size;
        Vec3 along, across;  // unit length
    };
    void add(const Mesh& mesh, Corner corner, const Vec3& along, double size);
    double from_middle(double angle) const;

    std::pmr::vector<Wedge> wedges_;
    SurfacePlace place_{};
    double turn_ = 0;   // of all wedges, radians
    double scale_ = 1;  // of angles
    bool closed_ = false;
};
Task<void> set_frame(Pace& pace, DirectionFrame& frame, const Mesh& mesh, SurfacePlace place);

// A path of `length` metres; shorter where it comes to a border or a triangle without area. Its end lies within a
// triangle. About 60 ns a triangle.
Task<void> walk_straight(Pace& pace, const Mesh& mesh, SurfaceRay ray, double length, SurfacePath& out);

}  // namespace flg
