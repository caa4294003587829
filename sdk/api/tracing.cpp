// SPDX-License-Identifier: MIT
// Isolines, streams and paths on surfaces; curves on surfaces shown, lifted into space and released; curves in space
// laid onto surfaces.
#include <algorithm>
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/surface_inputs.h"
#include "filigree/filigree_project.h"
#include "surfaces/lift_curves.h"
#include "surfaces/project_curves.h"
#include "surfaces/tracing_jobs.h"

namespace flg {

namespace {

FlgSurfaceCurvesView default_curves_view() {
    FlgSurfaceCurvesView view{};
    view.struct_size = sizeof view;
    return view;
}

template <class Desc>
Desc default_desc() {
    Desc desc{};
    desc.struct_size = sizeof desc;
    desc.job = default_job_options();
    return desc;
}

FlgStreamsDesc default_streams_desc() {
    auto desc = default_desc<FlgStreamsDesc>();
    desc.end_value = HUGE_VALF;
    return desc;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgSurfaceCurvesViewInit(FlgSurfaceCurvesView* view, uint32_t struct_size) {
    return guarded([&] {
        init_struct(view, struct_size, default_curves_view(), "view");
        return FLG_OK;
    });
}

FlgResult flgSurfaceCurvesGetView(FlgContext context, FlgSurfaceCurves curves, FlgSurfaceCurvesView* out_view) {
    return guarded([&] {
        write_struct(out_view, default_curves_view(), "out_view");
        const TracedCurves& self = *get_context(context).surface_curves.get(curves.id, "curves");
        const FlgResult result = self.visible_result();
        if (result == FLG_OK) write_struct(out_view, self.view(), "out_view");
        return result < 0 ? set_last_error(result, self.error()) : result;
    });
}

FlgResult flgSurfaceCurvesRelease(FlgContext context, FlgSurfaceCurves curves) {
    return guarded([&] {
        get_context(context).surface_curves.remove(curves.id, "curves");
        return FLG_OK;
    });
}

FlgResult flgLiftDescInit(FlgLiftDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_desc<FlgLiftDesc>(), "desc");
        return FLG_OK;
    });
}

FlgResult flgLiftCurves(FlgContext context, const FlgLiftDesc* desc, FlgCurveSet* out_set, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        require(out_set, "out_set") = {};
        Context& self = get_context(context);
        const FlgLiftDesc read = read_struct(desc, default_desc<FlgLiftDesc>(), "desc");
        check_range(std::isfinite(read.height), "desc.height", read.height, "finite");
        Submission submission(self, read.job);
        const auto curves = self.surface_curves.get(read.curves.id, "desc.curves");
        check_revision(*curves, "desc.curves");
        submission.read(*curves, "desc.curves");
        submission.read_surface(curves->surface, "the surface of desc.curves");
        const auto out = make_object<CurveSet>(self, &self.memory);
        submission.job().strand.start(lift_curves(submission.pace(), curves, read.height, out));
        *out_set = {submission.commit(self.curve_sets, out, out_job)};
        return FLG_OK;
    });
}

FlgResult flgIsolinesDescInit(FlgIsolinesDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_desc<FlgIsolinesDesc>(), "desc");
        return FLG_OK;
    });
}

FlgResult flgTraceIsolines(FlgContext context, const FlgIsolinesDesc* desc, FlgSurfaceCurves* out_curves,
                           FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        require(out_curves, "out_curves") = {};
        Context& self = get_context(context);
        const FlgIsolinesDesc read = read_struct(desc, default_desc<FlgIsolinesDesc>(), "desc");
        Submission submission(self, read.job);
        const auto field = self.fields.get(read.field.id, "desc.field");
        check_revision(*field, "desc.field");
        submission.read(*field, "desc.field");
        submission.read_surface(field->surface, "the surface of desc.field");
        const auto out = make_object<TracedCurves>(self, field->surface, &self.memory);
        RegionSet regions = read_regions(read.regions, read.region_count, &self.memory);
        LevelRequest levels = read_levels(read.levels, &self.memory);
        IsolinesRequest request{field, std::move(regions), std::move(levels), out};
        submission.job().strand.start(trace_isolines(submission.pace(), std::move(request)));
        *out_curves = {submission.commit(self.surface_curves, out, out_job)};
        return FLG_OK;
    });
}

FlgResult flgStreamsDescInit(FlgStreamsDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_streams_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgTraceStreams(FlgContext context, const FlgStreamsDesc* desc, FlgSurfaceCurves* out_curves,
                          FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        require(out_curves, "out_curves") = {};
        Context& self = get_context(context);
        const FlgStreamsDesc read = read_struct(desc, default_streams_desc(), "desc");
        check_range(!std::isnan(read.end_value), "desc.end_value", read.end_value, "a number");
        Submission submission(self, read.job);
        const auto field = self.fields.get(read.field.id, "desc.field");
        check_revision(*field, "desc.field");
        submission.read(*field, "desc.field");
        submission.read_surface(field->surface, "the surface of desc.field");
        const auto out = make_object<TracedCurves>(self, field->surface, &self.memory);
        RegionSet regions = read_regions(read.regions, read.region_count, &self.memory);
        Buffer<SurfacePoint> starts = read_points(read.starts, read.start_count, "desc.starts", &self.memory);
        StreamsRequest request{.field = field,
                               .regions = std::move(regions),
                               .starts = std::move(starts),
                               .further_starts = nullptr,
                               .downhill = read.downhill != 0,
                               .end_value = read.end_value,
                               .out = out};
        if (read.border_samples.id != 0) {
            request.further_starts = self.surface_curves.get(read.border_samples.id, "desc.border_samples");
            check_same_surface(*field, *request.further_starts, "desc.border_samples");
            submission.read(*request.further_starts, "desc.border_samples");
        }
        submission.job().strand.start(trace_streams(submission.pace(), std::move(request)));
        *out_curves = {submission.commit(self.surface_curves, out, out_job)};
        return FLG_OK;
    });
}

FlgResult flgPathsDescInit(FlgPathsDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_desc<FlgPathsDesc>(), "desc");
        return FLG_OK;
    });
}

FlgResult flgTracePaths(FlgContext context, const FlgPathsDesc* desc, FlgSurfaceCurves* out_curves, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        require(out_curves, "out_curves") = {};
        Context& self = get_context(context);
        const FlgPathsDesc read = read_struct(desc, default_desc<FlgPathsDesc>(), "desc");
        Submission submission(self, read.job);
        const auto surface = self.surfaces.get(read.surface.id, "desc.surface");
        Buffer<uint32_t> offsets = read_path_offsets(read, &self.memory);
        Buffer<SurfacePoint> points = read_points(read.points, *(offsets.end() - 1), "desc.points", &self.memory);
        RegionSet regions = read_regions(read.regions, read.region_count, &self.memory);
        const auto out = make_object<TracedCurves>(self, surface, &self.memory);
        PathsRequest request{.paths = {.offsets = std::move(offsets),
                                       .points = std::move(points),
                                       .closed = read.closed != 0,
                                       .regions = std::move(regions)},
                             .out = out};
        submission.wait_for(start_blocks(self, surface));
        submission.read_surface(surface, "desc.surface");
        submission.job().strand.start(trace_paths(submission.pace(), std::move(request)));
        *out_curves = {submission.commit(self.surface_curves, out, out_job)};
        return FLG_OK;
    });
}

FlgResult flgProjectDescInit(FlgProjectDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_desc<FlgProjectDesc>(), "desc");
        return FLG_OK;
    });
}

FlgResult flgProjectCurves(FlgContext context, const FlgProjectDesc* desc, FlgSurfaceCurves* out_curves,
                           FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        require(out_curves, "out_curves") = {};
        Context& self = get_context(context);
        const FlgProjectDesc read = read_struct(desc, default_desc<FlgProjectDesc>(), "desc");
        Submission submission(self, read.job);
        const auto surface = self.surfaces.get(read.surface.id, "desc.surface");
        const auto curves = self.curve_sets.get(read.curves.id, "desc.curves");
        const auto out = make_object<TracedCurves>(self, surface, &self.memory);
        submission.read(*curves, "desc.curves");
        submission.wait_for(start_blocks(self, surface));
        submission.read_surface(surface, "desc.surface");
        submission.job().strand.start(project_curves(submission.pace(), curves, out));
        *out_curves = {submission.commit(self.surface_curves, out, out_job)};
        return FLG_OK;
    });
}

}  // extern "C"
