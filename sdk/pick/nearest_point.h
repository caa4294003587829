// SPDX-License-Identifier: MIT
// Nearest points of triangles and segments (Ericson: Real-Time Collision Detection, 2005, sec. 5.1).
#pragma once

#include <algorithm>

#include "pick/pick_target.h"

namespace flg::pick {

// How far along the segment from a to b, 0 to 1, its nearest point to p lies.
inline float nearest_on_segment(const Vec3f& p, const Vec3f& a, const Vec3f& b) {
    const Vec3f along = b - a;
    const float length_sq = along.squaredNorm();
    return length_sq > 0 ? std::clamp((p - a).dot(along) / length_sq, 0.0f, 1.0f) : 0.0f;
}

struct TrianglePoint {
    float u, v;  // weights of the second and the third corner
    Vec3f position;
};

// By the Voronoi regions of corners, edges and inside; for flat triangles the nearest edge.
inline TrianglePoint nearest_in_triangle(const Vec3f& p, const Vec3f (&corners)[3]) {
    const Vec3f& a = corners[0];
    const Vec3f ab = corners[1] - a, ac = corners[2] - a, ap = p - a;
    const float ab_sq = ab.squaredNorm(), ac_sq = ac.squaredNorm(), across = ab.dot(ac);
    const float det = ab_sq * ac_sq - across * across;
    if (det > 0) {
        const float u = (ac_sq * ap.dot(ab) - across * ap.dot(ac)) / det;
        const float v = (ab_sq * ap.dot(ac) - across * ap.dot(ab)) / det;
        if (u >= 0 && v >= 0 && u + v <= 1) return {u, v, a + u * ab + v * ac};
    }
    const float s = nearest_on_segment(p, corners[0], corners[1]);
    const float t = nearest_on_segment(p, corners[1], corners[2]);
    const float r = nearest_on_segment(p, corners[2], corners[0]);
    const TrianglePoint candidates[] = {{s, 0, a + s * ab},
                                        {1 - t, t, corners[1] + t * (corners[2] - corners[1])},
                                        {0, 1 - r, corners[2] + r * (a - corners[2])}};
    return *std::min_element(std::begin(candidates), std::end(candidates), [&](const auto& x, const auto& y) {
        return (x.position - p).squaredNorm() < (y.position - p).squaredNorm();
    });
}

}  // namespace flg::pick
