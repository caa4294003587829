// SPDX-License-Identifier: MIT
#include "surfaces/tracing_jobs.h"

#include <cmath>

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/geodesic_jobs.h"
#include "surfaces/surface_inputs.h"
#include "surfaces/tracing/geodesic_path.h"
#include "surfaces/tracing/integral_curves.h"
#include "surfaces/tracing/isolines.h"

namespace flg {

namespace {

std::span<const float> values_of(const Field& field) {
    return {field.data.distances.data(), field.data.distances.size()};
}

// From one point to the next; returns the length.
Task<double> trace_stretch(Pace& pace, Surface& surface, const Paths& paths, uint32_t from, uint32_t to,
                           const char* argument, SurfaceCurves& out) {
    DistanceField field;
    co_await solve_between(pace, surface, paths.regions, paths.points[to], paths.points[from], field);
    const std::span<const float> distances(field.distances.data(), field.distances.size());
    const GeodesicPath path = co_await add_geodesic_path(pace, surface.mesh(), paths.points[from], paths.points[to],
                                                         distances, paths.regions, out);
    if (!path.found) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no way leads from %s[%u] to %s[%u]", argument, from, argument, to);
    }
    co_return path.length;
}

}  // namespace

Task<void> trace_isolines(Pace& pace, std::shared_ptr<const Field> field, RegionSet regions, LevelRequest levels,
                          std::shared_ptr<TracedCurves> out) {
    pace.stage("levels");
    const Buffer<float> list = co_await list_levels(pace, field->data, levels, max_isoline_levels);
    pace.stage("isolines");
    const std::span<const float> values = values_of(*field), at(list.data(), list.size());
    co_await add_isolines(pace, out->surface->mesh(), values, at, regions, out->curves);
    co_await flatten_curves(pace, *out);
}

Task<void> trace_streams(Pace& pace, StreamsRequest request) {
    TracedCurves& out = *request.out;
    const size_t own = request.starts.size();
    const size_t further = request.further_starts ? request.further_starts->curves.points.size() : 0;
    Buffer<SurfacePoint> starts(own + further, pace.memory());
    co_await each(pace, starts.size(), Cost::some_ns, [&](uint32_t i) {
        starts[i] = i < own ? request.starts[i] : request.further_starts->curves.points[i - own];
    });
    co_await check_points(pace, out.surface->mesh(), starts, "desc.starts");

    pace.stage("streams");
    IntegralCurveOptions options;
    options.downhill = request.desc.downhill != 0;
    if (std::isfinite(request.desc.end_value)) options.level = request.desc.end_value;
    const std::span<const float> values = values_of(*request.field);
    const std::span<const SurfacePoint> from(starts.data(), starts.size());
    co_await add_integral_curves(pace, out.surface->mesh(), values, request.regions, from, options, out.curves);
    co_await flatten_curves(pace, out);
}

Task<void> trace_paths(Pace& pace, Paths paths, std::shared_ptr<TracedCurves> out) {
    co_await trace_polylines(pace, *out->surface, paths, "desc.points", out->curves);
    co_await flatten_curves(pace, *out);
}

Task<void> trace_polylines(Pace& pace, Surface& surface, const Paths& paths, const char* argument, SurfaceCurves& out) {
    co_await check_points(pace, surface.mesh(), paths.points, argument);
    pace.stage("paths");
    pace.expect(paths.points.size());
    for (uint32_t p = 0; p + 1 < paths.offsets.size(); ++p) {
        const uint32_t first = paths.offsets[p], end = paths.offsets[p + 1];
        double length = 0;
        for (uint32_t i = first; i + 1 < end; ++i) {
            length += co_await trace_stretch(pace, surface, paths, i, i + 1, argument, out);
            pace.advance(1);
        }
        if (paths.closed) length += co_await trace_stretch(pace, surface, paths, end - 1, first, argument, out);
        end_polyline(out, paths.closed, length);
    }
}

}  // namespace flg
