// SPDX-License-Identifier: MIT
#include "splines/surface_trace.h"

#include <algorithm>
#include <cmath>

#include "surfaces/geodesics/offset_lines.h"
#include "surfaces/mesh/mesh_measures.h"
#include "surfaces/tracing/geodesic_path.h"
#include "surfaces/tracing/straight_walk.h"
#include "surfaces/tracing/surface_walk.h"

namespace flg {

namespace {

constexpr uint32_t find_chunk = 100;

Task<double> lay_interval(Pace& pace, const Mesh& mesh, PathShortener& shortener, const SurfacePoint& from,
                          const SurfacePoint& to, uint32_t node, SurfaceCurves& out) {
    const SurfaceWalk walk = co_await add_surface_walk(pace, mesh, from, to, out);
    if (walk.found) co_return walk.length;
    const GeodesicPath path = co_await shorten_way(pace, shortener, from, to, nullptr, out);
    if (!path.found)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.spline: no way leads over the triangles from node %u to the next", node);
    co_return path.length;
}

}  // namespace

Task<SurfacePoint> nearest_point(Pace& pace, NearestPoints& nearest, Vec3 place) {
    nearest.begin(place);
    do co_await pace;
    while (!nearest.find(find_chunk));
    co_return nearest.found();
}

Task<void> walk_aside(Pace& pace, const Mesh& mesh, SurfacePoint from, Vec3 direction, double offset,
                      SurfacePath& out) {
    const Vec3 left = triangle_normal(mesh, from.triangle).cross(direction);
    out.clear();
    out.add(mesh, from);
    if (!(left.squaredNorm() > 0)) co_return;
    const Vec3 aside = offset > 0 ? left.normalized() : -left.normalized();
    co_await walk_straight(pace, mesh, {moved_inside(from.triangle, from.u, from.v), aside}, std::abs(offset), out);
}

Task<void> find_surface_points(Pace& pace, Spline& out) {
    NearestPoints nearest = co_await nearest_on(pace, *out.manifold);
    const auto nodes = static_cast<uint32_t>(out.chain.nodes.size() / 3);
    out.surface_points = Buffer<FlgSurfacePoint>(nodes, pace.memory());
    out.largest_moved = 0;
    for (uint32_t i = 0; i < nodes; ++i) {
        const double* const node = &out.chain.nodes[size_t{3} * i];
        const SurfacePoint point = co_await nearest_point(pace, nearest, Vec3(node));
        out.surface_points[i] = {point.triangle, point.u, point.v};
        out.largest_moved = std::max(out.largest_moved, (nearest.found_place() - Vec3(node)).norm());
    }
}

Task<void> trace_spline(Pace& pace, std::shared_ptr<const Spline> spline, double offset,
                        std::shared_ptr<TracedCurves> out) {
    pace.stage("trace");
    const Mesh& mesh = out->surface->mesh();
    NearestPoints nearest = co_await nearest_on(pace, *spline->manifold);
    const RegionSet all(pace.memory());
    PathShortener shortener(mesh, all, pace.memory());
    SurfaceCurves own(pace.memory());
    SurfaceCurves& curve = offset != 0 ? own : out->curves;
    const auto nodes = static_cast<uint32_t>(spline->chain.nodes.size() / 3);
    double length = 0;
    SurfacePoint first{}, last{};
    for (uint32_t i = 0; i < nodes; ++i) {
        const SurfacePoint next = co_await nearest_point(pace, nearest, Vec3(&spline->chain.nodes[size_t{3} * i]));
        if (i > 0) {
            length += co_await lay_interval(pace, mesh, shortener, last, next, i - 1, curve);
        } else {
            first = next;
        }
        last = next;
    }
    if (spline->closed) length += co_await lay_interval(pace, mesh, shortener, last, first, nodes - 1, curve);
    out->left_out = end_polyline(curve, spline->closed, length) ? 0 : 1;
    if (offset != 0 && out->left_out == 0) {
        pace.stage("offset");
        std::pmr::deque<uint32_t> pieces(pace.memory());
        co_await add_offset_lines(pace, mesh, own, offset, out->curves, pieces);
        if (out->curves.curve_count() == 0)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.offset is %g: nowhere on that side is the surface so far from the curve", offset);
    }
    co_await flatten_curves(pace, *out);
}

}  // namespace flg
