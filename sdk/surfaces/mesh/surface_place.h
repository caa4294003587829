// SPDX-License-Identifier: MIT
// A point of a mesh by what it lies on, which a SurfacePoint leaves open: tracing goes on differently from a vertex, an
// edge and the inside of a triangle.
#pragma once

#include "surfaces/mesh/surface_point.h"

namespace flg {

struct SurfacePlace {
    enum class On : uint8_t { vertex, edge, triangle };
    On on;
    uint32_t index;  // a vertex; an edge, by the corner where it starts; a triangle
    float u, v;  // on an edge: u of the way along it, as round_on_edge() gives it, not 0 or 1; in a triangle: weights

    bool operator==(const SurfacePlace&) const = default;
};

// The weights of a triangle's corners.
using Weights = std::array<double, 3>;
inline Weights weights_of(const SurfacePoint& point) {
    return {1.0 - point.u - point.v, point.u, point.v};
}

// Weights below this count as 0: a point so near an edge, relative to the triangle, is moved onto it.
constexpr double snap_weight = 1e-6;

// `weights`: >= 0, sum 1, up to rounding.
SurfacePlace place_in(const Mesh& mesh, uint32_t triangle, const Weights& weights);
inline SurfacePlace place_in(const Mesh& mesh, const SurfacePoint& point) {
    return place_in(mesh, point.triangle, weights_of(point));
}

// At `t` along the edge that starts at `corner`: one of its ends where t rounds to 0 or 1.
SurfacePlace place_on_edge(const Mesh& mesh, Corner corner, double t);

inline SurfacePlace place_at_vertex(uint32_t vertex) {
    return {SurfacePlace::On::vertex, vertex, 0, 0};
}

// Whether the place belongs to the triangle, its border included; if so, `out` is the place seen in it.
bool find_in(const Mesh& mesh, const SurfacePlace& place, uint32_t triangle, SurfacePoint& out);

}  // namespace flg
