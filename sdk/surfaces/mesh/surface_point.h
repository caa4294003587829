// SPDX-License-Identifier: MIT
// Points on a mesh, given by where they lie in its triangles and not in space, so that they can be embedded
// exactly.
#pragma once

#include "surfaces/mesh/mesh.h"

namespace flg {

// In `triangle`, at weights (1 - u - v, u, v) of its corners; u, v >= 0, u + v <= 1. On an edge or a vertex any
// triangle there will do: two points may be the same place with different triangles.
struct SurfacePoint {
    uint32_t triangle;
    float u, v;
};

inline Vec3 position_of(const Mesh& mesh, const SurfacePoint& point) {
    const Triple& corners = mesh.triangles[point.triangle];
    const double u = point.u, v = point.v;
    return (1 - u - v) * mesh.position(corners[0]) + u * mesh.position(corners[1]) + v * mesh.position(corners[2]);
}

// Points on edges lie at multiples of 2^-24 of the way: then 1 - t is exact, and both triangles of an edge see the same
// point. `t` in [0, 1].
inline float round_on_edge(double t) {
    return static_cast<float>(static_cast<int32_t>(t * 0x1p24 + 0.5)) * 0x1p-24f;
}

// The point at `t` of the way along the edge that starts at `corner`; `t` as round_on_edge() gives it.
inline SurfacePoint point_on_edge(Corner corner, float t) {
    const uint32_t triangle = triangle_of(corner);
    switch (corner % 3) {
        case 0: return {triangle, t, 0};
        case 1: return {triangle, 1 - t, t};
        default: return {triangle, 0, 1 - t};
    }
}

}  // namespace flg
