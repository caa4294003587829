// SPDX-License-Identifier: MIT
#include "surfaces/tracing_jobs.h"

#include <cmath>

#include "core/failure.h"
#include "surfaces/geodesic_jobs.h"
#include "surfaces/geodesic_path.h"
#include "surfaces/integral_curves.h"
#include "surfaces/isolines.h"
#include "surfaces/surface_inputs.h"

namespace flg {

namespace {

constexpr uint32_t isolines_chunk = 2000;
constexpr uint32_t streams_chunk = 100;
constexpr uint32_t path_chunk = 200;
constexpr uint32_t flatten_chunk = 2000;  // each about 10 us
constexpr uint32_t copy_chunk = 2000;

Task<void> finish(Pace& pace, TracedCurves& traced) {
    FlattenCurvesKernel flatten(traced, pace.memory());
    while (!flatten.run(flatten_chunk)) co_await pace;
}

std::span<const float> values_of(const Field& field) {
    return {field.data.distances.data(), field.data.distances.size()};
}

// From one point to the next; returns the length.
Task<double> trace_stretch(Pace& pace, Surface& surface, const Paths& paths, uint32_t from, uint32_t to,
                           const char* argument, SurfaceCurves& out) {
    DistanceField field;
    co_await solve_between(pace, surface, paths.regions, paths.points[to], paths.points[from], field);
    GeodesicPathKernel kernel(surface.mesh(), paths.points[from], paths.points[to],
                              {field.distances.data(), field.distances.size()}, paths.regions, out, pace.memory());
    while (!kernel.run(path_chunk)) co_await pace;
    if (!kernel.found()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no way leads from %s[%u] to %s[%u]", argument, from, argument, to);
    }
    co_return kernel.length();
}

}  // namespace

Task<void> trace_isolines(Pace& pace, IsolinesRequest request) {
    pace.stage("levels");
    const Buffer<float> levels =
        co_await list_levels(pace, request.field->data.distances, request.levels, IsolineKernel::max_levels);
    pace.stage("isolines");
    TracedCurves& out = *request.out;
    IsolineKernel kernel(out.surface->mesh(), values_of(*request.field), {levels.data(), levels.size()},
                         request.regions, out.curves, pace.memory());
    while (!kernel.run(isolines_chunk)) co_await pace;
    co_await finish(pace, out);
}

Task<void> trace_streams(Pace& pace, StreamsRequest request) {
    TracedCurves& out = *request.out;
    const size_t own = request.starts.size();
    const size_t further = request.further_starts ? request.further_starts->curves.points.size() : 0;
    Buffer<SurfacePoint> starts(own + further, pace.memory());
    for (size_t i = 0; i < own + further; ++i) {
        starts[i] = i < own ? request.starts[i] : request.further_starts->curves.points[i - own];
        if (i % copy_chunk == 0) co_await pace;
    }
    co_await check_points(pace, out.surface->mesh(), starts, "desc.starts");

    pace.stage("streams");
    IntegralCurveOptions options;
    options.downhill = request.downhill;
    if (std::isfinite(request.end_value)) options.level = request.end_value;
    IntegralCurveKernel kernel(out.surface->mesh(), values_of(*request.field), request.regions,
                               {starts.data(), starts.size()}, options, out.curves, pace.memory());
    while (!kernel.run(streams_chunk)) co_await pace;
    co_await finish(pace, out);
}

Task<void> trace_paths(Pace& pace, PathsRequest request) {
    TracedCurves& out = *request.out;
    co_await trace_polylines(pace, *out.surface, request.paths, "desc.points", out.curves);
    co_await finish(pace, out);
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
