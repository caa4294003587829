// SPDX-License-Identifier: MIT
#include "surfaces/mesh/surface_place.h"

#include <algorithm>

namespace flg {

SurfacePlace place_on_edge(const Mesh& mesh, Corner corner, double t) {
    const float rounded = round_on_edge(std::clamp(t, 0.0, 1.0));
    if (rounded == 0) return place_at_vertex(mesh.vertex_at(corner));
    if (rounded == 1) return place_at_vertex(mesh.vertex_at(next_corner(corner)));
    return {SurfacePlace::On::edge, corner, rounded, 0};
}

SurfacePlace place_in(const Mesh& mesh, uint32_t triangle, const Weights& weights) {
    uint32_t kept = 0, last_kept = 0, dropped = 0;
    for (uint32_t k = 0; k < 3; ++k) {
        if (weights[k] >= snap_weight) {
            ++kept;
            last_kept = k;
        } else {
            dropped = k;
        }
    }
    if (kept == 3) {
        return {SurfacePlace::On::triangle, triangle, static_cast<float>(weights[1]), static_cast<float>(weights[2])};
    }
    if (kept == 2) {
        const uint32_t from = (dropped + 1) % 3, to = (dropped + 2) % 3;
        return place_on_edge(mesh, 3 * triangle + from, weights[to] / (weights[from] + weights[to]));
    }
    return place_at_vertex(mesh.triangles[triangle][last_kept]);
}

bool find_in(const Mesh& mesh, const SurfacePlace& place, uint32_t triangle, SurfacePoint& out) {
    switch (place.on) {
        case SurfacePlace::On::triangle: out = {place.index, place.u, place.v}; return place.index == triangle;
        case SurfacePlace::On::edge: {
            if (triangle_of(place.index) == triangle) {
                out = point_on_edge(place.index, place.u);
                return true;
            }
            const Corner across = mesh.opposite(place.index);
            if (across == no_index || triangle_of(across) != triangle) return false;
            out = point_on_edge(across, 1 - place.u);
            return true;
        }
        default: {
            const Triple& vertices = mesh.triangles[triangle];
            for (uint32_t k = 0; k < 3; ++k) {
                if (vertices[k] != place.index) continue;
                out = {triangle, k == 1 ? 1.0f : 0.0f, k == 2 ? 1.0f : 0.0f};
                return true;
            }
            return false;
        }
    }
}

}  // namespace flg
