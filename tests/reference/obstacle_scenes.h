// SPDX-License-Identifier: MIT
// Random scenes of solids for splines among obstacles, and how near a curve comes to the solids, by nothing but their
// definitions: places along the curve, densely, and the exact distance from each solid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "filigree/filigree_spline.h"

namespace flg::reference {

// A solid of the plane (z = 0) or of space.
struct Solid {
    enum class Kind : uint8_t { ball, box, capsule, polygon, mesh, half_space } kind = Kind::ball;
    Vec3 centre;                   // of balls and boxes; a capsule's end
    Vec3 to;                       // a capsule's other end; a half-space's unit vector outwards
    double half[3] = {};           // a box's
    Vec3 axes[3];                  // a box's and a prism's, orthonormal
    double radius = 0;             // of balls and capsules
    std::vector<double> polygon;   // x and y of each vertex; in space, along its axes from its centre, of a prism
    std::vector<float> positions;  // of a closed mesh
    std::vector<uint32_t> triangles;
};

// For the ABI; of a mesh all but its surface. Points into the solid.
inline FlgObstacle described(const Solid& solid, uint32_t dimension) {
    FlgObstacle out = flgObstacleDefaults();
    constexpr FlgObstacleKind kinds[] = {FLG_OBSTACLE_KIND_BALL,    FLG_OBSTACLE_KIND_BOX,
                                         FLG_OBSTACLE_KIND_CAPSULE, FLG_OBSTACLE_KIND_POLYGON,
                                         FLG_OBSTACLE_KIND_MESH,    FLG_OBSTACLE_KIND_HALF_SPACE};
    out.kind = kinds[static_cast<uint32_t>(solid.kind)];
    out.radius = solid.radius;
    out.points = solid.polygon.data();
    out.point_count = static_cast<uint32_t>(solid.polygon.size() / 2);
    for (uint32_t c = 0; c < 3; ++c) {
        out.centre[c] = solid.centre[c];
        out.to[c] = solid.to[c];
        out.half[c] = solid.half[c];
        for (uint32_t i = 0; i < dimension && c < dimension; ++i) out.axes[i * 3 + c] = solid.axes[i][c];
    }
    return out;
}

// Signed, negative inside.
double exact_distance(const Solid& solid, uint32_t dimension, const Vec3& place);

enum class SceneKind : uint8_t { plane, space, meshes, sphere, walled_plane, walled_space, walled_sphere };

struct ObstacleScene {
    uint32_t dimension = 3;
    double size = 5;       // metres
    double clearance = 0;  // metres
    std::vector<Solid> solids;
    std::vector<double> points;  // `dimension` numbers each, clear of all solids by 1 % of the size at least
};

inline constexpr double sphere_radius = 2;  // metres, of the surface that scenes on a sphere lie on

// Scenes of about 5 metres: 3 to 14 solids and 2 to 5 points. Walled: the same, prisms too, between two half-spaces.
ObstacleScene obstacle_scene(uint64_t seed, SceneKind kind);

// 5 metres of a plane with 14 boxes and balls in staggered columns: the straight way from the first point to the second
// leads through some of them.
ObstacleScene obstacle_maze(uint64_t seed);

struct Approach {
    double clearance;  // metres: the least distance less the scene's clearance
    uint32_t node;     // in the interval after this node
    uint32_t solid;
};

// Of the chain of nodes, and of the cubic spline through them: natural, or closed.
Approach closest_approach(const ObstacleScene& scene, std::span<const double> nodes, std::span<const double> parameters,
                          bool closed);

}  // namespace flg::reference
