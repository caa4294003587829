// SPDX-License-Identifier: MIT
// Checks that can be made only once a job sees its surface.
#pragma once

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/mesh/surface_point.h"

namespace flg {

// Refuses points in triangles that do not exist.
inline Task<void> check_points(Pace& pace, const Mesh& mesh, const Buffer<SurfacePoint>& points, const char* argument) {
    co_await each(pace, points.size(), Cost::some_ns, [&](uint32_t i) {
        if (points[i].triangle < mesh.triangle_count()) return;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%u] is in triangle %u, but there are %u triangles", argument, i,
                      points[i].triangle, mesh.triangle_count());
    });
}

inline Task<void> check_vertices(Pace& pace, const Mesh& mesh, const Buffer<uint32_t>& vertices, const char* argument) {
    co_await each(pace, vertices.size(), Cost::some_ns, [&](uint32_t i) {
        if (vertices[i] < mesh.vertex_count()) return;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%u] is vertex %u, but there are %u vertices", argument, i,
                      vertices[i], mesh.vertex_count());
    });
}

}  // namespace flg
