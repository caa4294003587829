// SPDX-License-Identifier: MIT
// What every set of curves on a mesh must keep (surfaces/mesh/surface_curves.h), and measures of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "surfaces/mesh/surface_curves.h"
#include "surfaces/test_meshes.h"

namespace flg::test {

inline std::vector<SurfacePoint> points_of(const SurfaceCurves& curves, uint32_t curve) {
    return {curves.points.begin() + curves.offsets[curve], curves.points.begin() + curves.offsets[curve + 1]};
}

// Whether the place of `point` is in `triangle`, borders included.
inline bool lies_in(const Mesh& mesh, const SurfacePoint& point, uint32_t triangle) {
    const double weights[3] = {1.0 - point.u - point.v, point.u, point.v};
    for (uint32_t k = 0; k < 3; ++k) {
        if (weights[k] == 0 || point.triangle == triangle) continue;
        const uint32_t vertex = mesh.triangles[point.triangle][k];
        const Triple& other = mesh.triangles[triangle];
        if (std::find(other.begin(), other.end(), vertex) == other.end()) return false;
    }
    return true;
}

inline void expect_valid(const Mesh& mesh, const SurfaceCurves& curves) {
    ASSERT_EQ(curves.offsets.size(), curves.closed.size() + 1);
    ASSERT_EQ(curves.values.size(), curves.closed.size());
    ASSERT_EQ(curves.offsets.back(), curves.points.size());
    for (uint32_t c = 0; c < curves.curve_count(); ++c) {
        const auto points = points_of(curves, c);
        const bool closed = curves.closed[c];
        ASSERT_GE(points.size(), closed ? 3u : 2u);
        for (const SurfacePoint& p : points) {
            ASSERT_LT(p.triangle, mesh.triangle_count());
            ASSERT_TRUE(p.u >= 0 && p.v >= 0 && double(p.u) + p.v <= 1) << p.u << " " << p.v;
        }
        for (size_t i = 0; i + 1 < points.size() + closed; ++i) {
            ASSERT_TRUE(lies_in(mesh, points[(i + 1) % points.size()], points[i].triangle)) << "point " << i;
        }
        if (!closed) {
            ASSERT_EQ(points.back().triangle, points[points.size() - 2].triangle);
        }
    }
}

inline void expect_same(const SurfaceCurves& a, const SurfaceCurves& b) {
    ASSERT_EQ(a.points.size(), b.points.size());
    for (size_t i = 0; i < a.points.size(); ++i) {
        EXPECT_EQ(a.points[i].triangle, b.points[i].triangle);
        EXPECT_EQ(a.points[i].u, b.points[i].u);
        EXPECT_EQ(a.points[i].v, b.points[i].v);
    }
    EXPECT_TRUE(std::equal(a.offsets.begin(), a.offsets.end(), b.offsets.begin(), b.offsets.end()));
    EXPECT_TRUE(std::equal(a.closed.begin(), a.closed.end(), b.closed.begin(), b.closed.end()));
    EXPECT_TRUE(std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end()));
}

inline double length_of(const Mesh& mesh, const SurfaceCurves& curves, uint32_t curve) {
    const auto points = points_of(curves, curve);
    double length = 0;
    for (size_t i = 0; i + 1 < points.size() + curves.closed[curve]; ++i) {
        length += (position_of(mesh, points[(i + 1) % points.size()]) - position_of(mesh, points[i])).norm();
    }
    return length;
}

// The field at a point.
inline double value_at(const Mesh& mesh, const std::vector<float>& values, const SurfacePoint& p) {
    const Triple& t = mesh.triangles[p.triangle];
    const double u = p.u, v = p.v, a = values[t[0]], b = values[t[1]], c = values[t[2]];
    // Without the terms of no weight: their values may be infinite.
    return (u + v < 1 ? (1 - u - v) * a : 0) + (u > 0 ? u * b : 0) + (v > 0 ? v * c : 0);
}

inline std::vector<float> field_of(const Mesh& mesh, const std::function<double(const Vec3&)>& value) {
    std::vector<float> values;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) values.push_back(static_cast<float>(value(mesh.position(v))));
    return values;
}

// The shortest way along edges from a vertex: a field without false minima.
inline std::vector<float> edge_distances(const Mesh& mesh, const std::vector<uint32_t>& sources) {
    std::vector<std::vector<std::pair<uint32_t, float>>> edges(mesh.vertex_count());
    for (Corner corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
        const uint32_t a = mesh.vertex_at(corner), b = mesh.vertex_at(next_corner(corner));
        const auto length = static_cast<float>((mesh.position(a) - mesh.position(b)).norm());
        edges[a].emplace_back(b, length);
        edges[b].emplace_back(a, length);
    }
    std::vector<float> distances(mesh.vertex_count(), std::numeric_limits<float>::infinity());
    std::set<std::pair<float, uint32_t>> queue;
    for (uint32_t source : sources) {
        distances[source] = 0;
        queue.insert({0.0f, source});
    }
    while (!queue.empty()) {
        const auto [distance, vertex] = *queue.begin();
        queue.erase(queue.begin());
        for (const auto& [other, length] : edges[vertex]) {
            if (distance + length >= distances[other]) continue;
            queue.erase({distances[other], other});
            distances[other] = distance + length;
            queue.insert({distances[other], other});
        }
    }
    return distances;
}

}  // namespace flg::test
