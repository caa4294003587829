// SPDX-License-Identifier: MIT
// Checks that can be made only once a job sees its surface.
#pragma once

#include "core/failure.h"
#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/surface_point.h"

namespace flg {

// Refuses points in triangles that do not exist.
inline Task<void> check_points(Pace& pace, const Mesh& mesh, const Buffer<SurfacePoint>& points, const char* argument) {
    constexpr size_t chunk = 10'000;  // about 10 us
    for (size_t i = 0; i < points.size(); ++i) {
        if (points[i].triangle >= mesh.triangle_count()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%zu] is in triangle %u, but there are %u triangles", argument,
                          i, points[i].triangle, mesh.triangle_count());
        }
        if (i % chunk == 0) co_await pace;
    }
}

inline Task<void> check_vertices(Pace& pace, const Mesh& mesh, const Buffer<uint32_t>& vertices, const char* argument) {
    constexpr size_t chunk = 10'000;
    for (size_t i = 0; i < vertices.size(); ++i) {
        if (vertices[i] >= mesh.vertex_count()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%zu] is vertex %u, but there are %u vertices", argument, i,
                          vertices[i], mesh.vertex_count());
        }
        if (i % chunk == 0) co_await pace;
    }
}

}  // namespace flg
