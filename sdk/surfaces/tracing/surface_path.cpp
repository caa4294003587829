// SPDX-License-Identifier: MIT
#include "surfaces/tracing/surface_path.h"

#include <algorithm>

#include "surfaces/mesh/surface_place.h"

namespace flg {

namespace {

constexpr double inside = 4e-6;  // weight, above snap_weight

// A path's point as it is seen in a triangle that it belongs to.
SurfacePoint seen_in(const Mesh& mesh, const SurfacePoint& point, uint32_t triangle) {
    SurfacePoint out = point;
    if (point.triangle != triangle) find_in(mesh, place_in(mesh, point), triangle, out);
    return out;
}

// The stretch that a length falls into.
size_t stretch_at(const SurfacePath& path, double length) {
    const auto after = std::upper_bound(path.lengths.begin() + 1, path.lengths.end() - 1, length);
    return static_cast<size_t>(after - path.lengths.begin()) - 1;
}

}  // namespace

void SurfacePath::add(const Mesh& mesh, const SurfacePoint& point) {
    lengths.push_back(
        points.empty() ? 0 : lengths.back() + (position_of(mesh, point) - position_of(mesh, points.back())).norm());
    points.push_back(point);
}

SurfacePoint moved_inside(uint32_t triangle, double u, double v) {
    Weights weights = {1 - u - v, u, v};
    double sum = 0;
    for (double& weight : weights) sum += weight = std::max(weight, inside);
    return {triangle, static_cast<float>(weights[1] / sum), static_cast<float>(weights[2] / sum)};
}

SurfacePoint point_at(const Mesh& mesh, const SurfacePath& path, double length) {
    if (path.points.size() == 1) {
        const SurfacePoint& only = path.points.front();
        return moved_inside(only.triangle, only.u, only.v);
    }
    const size_t i = stretch_at(path, length);
    const double stretch = path.lengths[i + 1] - path.lengths[i];
    const double t = stretch > 0 ? std::clamp((length - path.lengths[i]) / stretch, 0.0, 1.0) : 0;
    const SurfacePoint& from = path.points[i];
    const SurfacePoint to = seen_in(mesh, path.points[i + 1], from.triangle);
    return moved_inside(from.triangle, (1 - t) * from.u + t * to.u, (1 - t) * from.v + t * to.v);
}

Vec3 first_way(const Mesh& mesh, const SurfacePath& path, uint32_t& triangle) {
    for (size_t i = 0; i + 1 < path.points.size(); ++i) {
        triangle = path.points[i].triangle;
        const Vec3 way = position_of(mesh, path.points[i + 1]) - position_of(mesh, path.points[i]);
        if (way.squaredNorm() > 0) return way;
    }
    return Vec3::Zero();
}

void reverse_path(const Mesh& mesh, const SurfacePath& path, SurfacePath& out) {
    out.clear();
    for (size_t i = path.points.size(); i-- > 0;) {
        // The next stretch is the one that lay before.
        const uint32_t triangle = path.points[i > 0 ? i - 1 : 0].triangle;
        out.points.push_back(seen_in(mesh, path.points[i], triangle));
        out.lengths.push_back(path.length() - path.lengths[i]);
    }
}

SurfacePoint first_point(const Mesh& mesh, const PathPart& part) {
    return part.begin <= 0 ? part.path->points.front() : point_at(mesh, *part.path, part.begin);
}

SurfacePoint last_point(const Mesh& mesh, const PathPart& part) {
    return part.end >= part.path->length() ? part.path->points.back() : point_at(mesh, *part.path, part.end);
}

void append_part(const Mesh& mesh, const PathPart& part, SurfaceCurves& way) {
    const SurfacePath& path = *part.path;
    if (!way.points.empty()) way.points.pop_back();
    way.points.push_back(first_point(mesh, part));
    if (path.points.size() > 1) {
        const size_t first = part.begin <= 0 ? 0 : stretch_at(path, part.begin);
        const size_t last = part.end >= path.length() ? path.points.size() - 2 : stretch_at(path, part.end);
        for (size_t i = first + 1; i <= last; ++i) way.points.push_back(path.points[i]);
    }
    way.points.push_back(last_point(mesh, part));
}

}  // namespace flg
