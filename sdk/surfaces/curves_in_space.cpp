// SPDX-License-Identifier: MIT
#include "surfaces/curves_in_space.h"

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/geodesic_jobs.h"
#include "surfaces/mesh/mesh_measures.h"
#include "surfaces/tracing/geodesic_path.h"
#include "surfaces/tracing/surface_walk.h"

namespace flg {

namespace {

// Each about 10 us.
constexpr uint32_t find_chunk = 100;

struct Scene {
    Surface& surface;
    NearestPoints& nearest;
    CurvesInSpace curves;
    const char* argument;
};

Task<SurfacePoint> find_nearest(Pace& pace, const Scene& scene, uint32_t point) {
    const Vec3 place = load_vec3(scene.curves.positions + size_t{3} * point) + scene.curves.shift;
    Position rounded;
    store_vec3(place, rounded.data());
    scene.nearest.begin(rounded);
    while (!scene.nearest.find(find_chunk)) co_await pace;
    co_return scene.nearest.found();
}

// The length of the shortest path; where there is none the failure names the curve's points.
Task<double> follow_shortest(Pace& pace, const Scene& scene, const SurfacePoint& from, const SurfacePoint& to,
                             uint32_t curve, uint32_t end, SurfaceCurves& out) {
    const RegionSet everywhere(pace.memory());
    DistanceField field;
    co_await solve_between(pace, scene.surface, everywhere, to, from, field);
    const std::span<const float> distances(field.distances.data(), field.distances.size());
    const GeodesicPath path =
        co_await add_geodesic_path(pace, scene.surface.mesh(), from, to, distances, everywhere, out);
    if (!path.found) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "%s: no way leads over the surface to point %u of curve %u from the one before it",
                      scene.argument, end - scene.curves.offsets[curve], curve);
    }
    co_return path.length;
}

// From a curve's point to its point `end`, as laid; returns the length.
Task<double> lay_stretch(Pace& pace, const Scene& scene, SurfacePoint from, SurfacePoint to, uint32_t curve,
                         uint32_t end, SurfaceCurves& out) {
    const SurfaceWalk walk = co_await add_surface_walk(pace, scene.surface.mesh(), from, to, out);
    if (walk.found) co_return walk.length;
    co_return co_await follow_shortest(pace, scene, from, to, curve, end, out);
}

}  // namespace

Task<void> lay_curves(Pace& pace, Surface& surface, NearestPoints& nearest, CurvesInSpace curves, const char* argument,
                      SurfaceCurves& out) {
    const Scene scene{surface, nearest, curves, argument};
    for (uint32_t c = 0; c + 1 < curves.offsets.size(); ++c) {
        const uint32_t first = curves.offsets[c], end = curves.offsets[c + 1];
        const bool closed = (curves.flags[c] & FLG_CURVE_CLOSED) != 0;
        const SurfacePoint begin = co_await find_nearest(pace, scene, first);
        SurfacePoint at = begin;
        double length = 0;
        for (uint32_t i = first + 1; i < end; ++i) {
            const SurfacePoint next = co_await find_nearest(pace, scene, i);
            length += co_await lay_stretch(pace, scene, at, next, c, i, out);
            at = next;
            pace.advance(1);
        }
        if (closed) length += co_await lay_stretch(pace, scene, at, begin, c, first, out);
        end_polyline(out, closed, length);
    }
}

Task<void> project_curves(Pace& pace, std::shared_ptr<const CurveSet> set, std::shared_ptr<TracedCurves> out) {
    pace.stage("sort");
    Surface& surface = *out->surface;
    NearestPoints nearest(surface.mesh());
    co_await build(pace, nearest);
    pace.stage("project");
    pace.expect(set->point_count());
    const CurvesInSpace curves{.offsets = {set->offsets().data(), size_t{set->curve_count()} + 1},
                               .flags = {set->flags().data(), set->curve_count()},
                               .positions = set->positions(),
                               .shift = origin_shift(set->origin, surface.origin)};
    co_await lay_curves(pace, surface, nearest, curves, "desc.curves", out->curves);
    out->left_out = set->curve_count() - out->curves.curve_count();
    co_await flatten_curves(pace, *out);
}

Task<void> lift_curves(Pace& pace, std::shared_ptr<const TracedCurves> traced, float height,
                       std::shared_ptr<CurveSet> out) {
    const SurfaceCurves& curves = traced->curves;
    const Mesh& mesh = traced->surface->mesh();
    if (curves.curve_count() == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "there are no curves to lift");
    pace.stage("lift");
    out->allocate_curves(curves.curve_count());
    out->offsets()[0] = 0;
    co_await each(pace, curves.curve_count(), Cost::some_ns, [&](uint32_t c) {
        out->offsets()[c + 1] = curves.offsets[c + 1];
        out->begin_curve(c, curves.closed[c] ? FLG_CURVE_CLOSED : 0);
    });
    out->allocate_columns({{{FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_NORMAL, 3}}, pace.memory()});
    float* positions = out->find(FLG_ATTRIBUTE_POSITION)->values.data();
    float* frames = out->find(FLG_ATTRIBUTE_NORMAL)->values.data();
    co_await each(pace, curves.points.size(), Cost::microseconds, [&](uint32_t p) {
        const Vec3 normal = smooth_normal(mesh, curves.points[p]);
        store_vec3(position_of(mesh, curves.points[p]) + height * normal, positions + size_t{3} * p);
        store_vec3(normal, frames + size_t{3} * p);
    });
    co_await each(pace, curves.curve_count(), Cost::some_ns, [&](uint32_t c) { out->complete_curve(c); });
}

}  // namespace flg
