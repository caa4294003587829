// SPDX-License-Identifier: MIT
// A place and a triangle: the nearest point, and on which side of an edge a line passes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/vec.h"

namespace flg {

// What of a triangle is nearest: all of it, an edge (from its corner k to the next), or a corner.
struct TriangleFoot {
    enum class On : uint8_t { face, edge, corner };

    Vec3 to;  // from the nearest point to the place
    On on;
    uint8_t k = 0;
};

// Ericson: Real-time collision detection (2005), sec. 5.1.5, by Voronoi regions.
inline TriangleFoot triangle_foot(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    using On = TriangleFoot::On;
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return {ap, On::corner, 0};
    const Vec3 bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return {bp, On::corner, 1};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {ap - d1 / (d1 - d3) * ab, On::edge, 0};
    const Vec3 cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return {cp, On::corner, 2};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {ap - d2 / (d2 - d6) * ac, On::edge, 2};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return {bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), On::edge, 1};
    const double sum = va + vb + vc;
    return {ap - vb / sum * ab - vc / sum * ac, On::face};
}

// Between the nearest points of two straight ways, from the first one.
inline Vec3 way_between(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = d - c, w = c - a;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
    const double across = uu * vv - uv * uv;
    double s = across > 1e-14 * uu * vv ? std::clamp((uw * vv - vw * uv) / across, 0.0, 1.0) : 0, t = 0;
    if (vv > 0) t = std::clamp((s * uv - vw) / vv, 0.0, 1.0);
    if (uu > 0) s = std::clamp((t * uv + uw) / uu, 0.0, 1.0);
    return w + t * v - s * u;
}

// Whether the straight way from a to b meets a triangle: by the signs of volumes, on which sides of the triangle the
// ends are, and of the way its edges. A way in the triangle's plane may meet it and may not: `in_plane` says.
inline bool meets_triangle(const Vec3& a, const Vec3& b, const Vec3* corners, bool in_plane) {
    const Vec3 way = b - a, p = corners[0] - a, q = corners[1] - a, r = corners[2] - a;
    const Vec3 normal = (q - p).cross(r - p);
    const double begin = -normal.dot(p), last = normal.dot(way - p);
    if ((begin > 0 && last > 0) || (begin < 0 && last < 0)) return false;
    if (begin == 0 && last == 0) return in_plane;
    const double u = way.dot(p.cross(q)), v = way.dot(q.cross(r)), w = way.dot(r.cross(p));
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

// From the nearest point of a triangle to that of the straight way from a to b; 0 where they meet.
inline Vec3 way_from_triangle(const Vec3* corners, const Vec3& a, const Vec3& b) {
    if (meets_triangle(a, b, corners, false)) return Vec3::Zero();
    Vec3 out = triangle_foot(a, corners[0], corners[1], corners[2]).to;
    const auto take = [&](const Vec3& way) {
        if (way.squaredNorm() < out.squaredNorm()) out = way;
    };
    take(triangle_foot(b, corners[0], corners[1], corners[2]).to);
    for (uint32_t k = 0; k < 3; ++k) take(way_between(corners[k], corners[(k + 1) % 3], a, b));
    return out;
}

// How often the edge from a to b turns around p counter-clockwise, seen along an axis: 1, -1 or 0, by whether it passes
// the ray from p in direction u. The same bits for the edge from b to a but for the sign.
inline int winding_of_edge(double pu, double pv, double au, double av, double bu, double bv) {
    if ((av <= pv) == (bv <= pv)) return 0;
    const bool up = av <= pv;
    if (!up) {
        std::swap(au, bu);
        std::swap(av, bv);
    }
    const double side = (bu - au) * (pv - av) - (pu - au) * (bv - av);
    return side > 0 ? (up ? 1 : -1) : 0;
}

// How often a triangle's outline turns around the line through p along an axis, and where on that axis the triangle
// crosses it.
inline int crossing_of_line(const Vec3* corners, const Vec3& p, int axis, double* at) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    int turns = 0;
    for (uint32_t e = 0; e < 3; ++e) {
        const Vec3 &a = corners[e], &b = corners[(e + 1) % 3];
        turns += winding_of_edge(p[u], p[v], a[u], a[v], b[u], b[v]);
    }
    if (turns == 0) return 0;
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    double place = corners[0][axis];
    if (normal[axis] != 0)
        place -= (normal[u] * (p[u] - corners[0][u]) + normal[v] * (p[v] - corners[0][v])) / normal[axis];
    const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
    *at = std::clamp(place, low, high);
    return turns;
}

}  // namespace flg
