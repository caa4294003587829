// SPDX-License-Identifier: MIT
// Isolines, streams and paths on surfaces; curves on surfaces shown, lifted into space and released; curves in space
// laid onto surfaces.
#include <algorithm>
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/surface_inputs.h"
#include "filigree/filigree_project.h"
#include "surfaces/curves_in_space.h"
#include "surfaces/tracing_jobs.h"

namespace flg {

namespace {

FlgFieldTraceStreamsDesc default_streams_desc() {
    auto desc = sized<FlgFieldTraceStreamsDesc>();
    desc.end_value = HUGE_VALF;
    return desc;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgSurfaceCurvesViewInit(FlgSurfaceCurvesView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgSurfaceCurvesGetView(FlgContext context, FlgSurfaceCurves curves, FlgSurfaceCurvesView* out_view) {
    return get_view(out_view, [&] { return get_context(context).surface_curves.get(curves.id, "curves"); });
}

FlgResult flgSurfaceCurvesRelease(FlgContext context, FlgSurfaceCurves curves) {
    return release(context, &Context::surface_curves, curves, "curves");
}

FlgResult flgSurfaceCurvesLiftDescInit(FlgSurfaceCurvesLiftDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgSurfaceCurvesLiftDesc>());
}

FlgResult flgSurfaceCurvesLift(FlgContext context, const FlgSurfaceCurvesLiftDesc* desc, FlgCurveSet* out_set,
                               FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_set, "out_set", out_job);
        const FlgSurfaceCurvesLiftDesc read = read_struct(desc, sized<FlgSurfaceCurvesLiftDesc>(), "desc");
        check_range(std::isfinite(read.height), "desc.height", read.height, "finite");
        Submission submission(self, read.job);
        const auto curves = read_current(self.surface_curves, read.curves.id, "desc.curves", submission);
        submission.read_surface(curves->surface, "the surface of desc.curves");
        const auto out = self.make(self.curve_sets);
        out->origin = curves->surface->origin;
        submission.job().strand.start(lift_curves(submission.pace(), curves, read.height, out));
        *out_set = {submission.commit(self.curve_sets, out, out_job)};
    });
}

FlgResult flgFieldTraceIsolinesDescInit(FlgFieldTraceIsolinesDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgFieldTraceIsolinesDesc>());
}

FlgResult flgFieldTraceIsolines(FlgContext context, const FlgFieldTraceIsolinesDesc* desc, FlgSurfaceCurves* out_curves,
                                FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_curves, "out_curves", out_job);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgFieldTraceIsolinesDesc read = read_struct(desc, sized<FlgFieldTraceIsolinesDesc>(), "desc");
        Submission submission(self, read.job);
        const auto field = read_current(self.fields, read.field.id, "desc.field", submission);
        submission.read_surface(field->surface, "the surface of desc.field");
        const auto out = self.make(self.surface_curves, field->surface);
        RegionSet regions = read_regions(read.regions, read.region_count, memory);
        LevelRequest levels = read_levels(read.levels, read.level_count, read.level_first, read.level_every, memory);
        submission.job().strand.start(
            trace_isolines(submission.pace(), field, std::move(regions), std::move(levels), out));
        *out_curves = {submission.commit(self.surface_curves, out, out_job)};
    });
}

FlgResult flgFieldTraceStreamsDescInit(FlgFieldTraceStreamsDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_streams_desc());
}

FlgResult flgFieldTraceStreams(FlgContext context, const FlgFieldTraceStreamsDesc* desc, FlgSurfaceCurves* out_curves,
                               FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_curves, "out_curves", out_job);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgFieldTraceStreamsDesc read = read_struct(desc, default_streams_desc(), "desc");
        check_range(!std::isnan(read.end_value), "desc.end_value", read.end_value, "a number");
        Submission submission(self, read.job);
        const auto field = read_current(self.fields, read.field.id, "desc.field", submission);
        submission.read_surface(field->surface, "the surface of desc.field");
        const auto out = self.make(self.surface_curves, field->surface);
        RegionSet regions = read_regions(read.regions, read.region_count, memory);
        Buffer<SurfacePoint> starts = read_points(read.starts, read.start_count, "desc.starts", memory);
        StreamsRequest request{field, std::move(regions), std::move(starts), nullptr, read, out};
        if (read.border_samples.id != 0) {
            request.further_starts = self.surface_curves.get(read.border_samples.id, "desc.border_samples");
            check_same_surface(*field, *request.further_starts, "desc.border_samples");
            submission.read(*request.further_starts, "desc.border_samples");
        }
        submission.job().strand.start(trace_streams(submission.pace(), std::move(request)));
        *out_curves = {submission.commit(self.surface_curves, out, out_job)};
    });
}

FlgResult flgFieldTracePathsDescInit(FlgFieldTracePathsDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgFieldTracePathsDesc>());
}

FlgResult flgFieldTracePaths(FlgContext context, const FlgFieldTracePathsDesc* desc, FlgSurfaceCurves* out_curves,
                             FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_curves, "out_curves", out_job);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgFieldTracePathsDesc read = read_struct(desc, sized<FlgFieldTracePathsDesc>(), "desc");
        Submission submission(self, read.job);
        const auto surface = self.surfaces.get(read.surface.id, "desc.surface");
        Buffer<uint32_t> offsets = read_path_offsets(read, memory);
        Buffer<SurfacePoint> points = read_points(read.points, *(offsets.end() - 1), "desc.points", memory);
        RegionSet regions = read_regions(read.regions, read.region_count, memory);
        const auto out = self.make(self.surface_curves, surface);
        Paths paths{.offsets = std::move(offsets),
                    .points = std::move(points),
                    .closed = read.closed != 0,
                    .regions = std::move(regions)};
        submission.wait_for(start_blocks(self, surface));
        submission.read_surface(surface, "desc.surface");
        submission.job().strand.start(trace_paths(submission.pace(), std::move(paths), out));
        *out_curves = {submission.commit(self.surface_curves, out, out_job)};
    });
}

FlgResult flgCurveSetProjectDescInit(FlgCurveSetProjectDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgCurveSetProjectDesc>());
}

FlgResult flgCurveSetProject(FlgContext context, const FlgCurveSetProjectDesc* desc, FlgSurfaceCurves* out_curves,
                             FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_curves, "out_curves", out_job);
        const FlgCurveSetProjectDesc read = read_struct(desc, sized<FlgCurveSetProjectDesc>(), "desc");
        Submission submission(self, read.job);
        const auto surface = self.surfaces.get(read.surface.id, "desc.surface");
        const auto curves = self.curve_sets.get(read.curves.id, "desc.curves");
        const auto out = self.make(self.surface_curves, surface);
        submission.read(*curves, "desc.curves");
        submission.wait_for(start_blocks(self, surface));
        submission.read_surface(surface, "desc.surface");
        submission.job().strand.start(project_curves(submission.pace(), curves, out));
        *out_curves = {submission.commit(self.surface_curves, out, out_job)};
    });
}

}  // extern "C"
