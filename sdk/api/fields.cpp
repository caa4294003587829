// SPDX-License-Identifier: MIT
// Fields on surfaces: distances, blends and the host's own; shown and released.
#include <algorithm>
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/surface_inputs.h"
#include "surfaces/geodesic_jobs.h"

namespace flg {

namespace {

FlgFieldGeodesicDesc default_geodesic_desc() {
    auto desc = sized<FlgFieldGeodesicDesc>();
    desc.max_distance = HUGE_VALF;
    desc.frequency = 1;
    desc.seed = 1;
    return desc;
}

void check(const FlgFieldGeodesicDesc& desc) {
    check_enum(desc.accuracy, FLG_ACCURACY_REFINED, FLG_ACCURACY_EXACT, "desc.accuracy", "FLG_ACCURACY_");
    if (desc.accuracy == FLG_ACCURACY_EXACT && desc.perturbation > 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.perturbation is %g, an exact field can have none",
                      double{desc.perturbation});
    }
    check_range(desc.max_distance > 0, "desc.max_distance", desc.max_distance, "above 0");
    check_range(desc.perturbation >= 0 && std::isfinite(desc.perturbation), "desc.perturbation", desc.perturbation,
                "finite and at least 0");
    check_range(desc.frequency > 0 && std::isfinite(desc.frequency), "desc.frequency", desc.frequency,
                "finite and above 0");
    if (desc.vertex_count == 0 && desc.point_count == 0 && desc.curves.id == 0 && desc.border_region_count == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc has no sources: no vertices, no points, no curves and no border_regions");
    }
}

GeodesicRequest read_request(Context& context, const FlgFieldGeodesicDesc& desc, const Field& out,
                             Submission& submission) {
    Memory* memory = context.memory[MemoryKind::surfaces];
    // What may fail comes first: GCC 12 frees members of an aggregate twice if a later one throws.
    GeodesicSources sources;
    sources.vertices = read_indices(desc.vertices, desc.vertex_count, "desc.vertices", memory);
    sources.points = read_points(desc.points, desc.point_count, "desc.points", memory);
    sources.border_regions = read_border_regions(desc, memory);
    RegionSet regions = read_regions(desc.regions, desc.region_count, memory);
    Buffer<uint32_t> targets = read_indices(desc.targets, desc.target_count, "desc.targets", memory);
    GeodesicRequest request{.surface = out.surface,
                            .sources = std::move(sources),
                            .regions = std::move(regions),
                            .max_distance = desc.max_distance,
                            .targets = std::move(targets),
                            .labelled = desc.labels != 0,
                            .perturbation = {desc.perturbation, desc.frequency, desc.seed},
                            .exact = desc.accuracy == FLG_ACCURACY_EXACT};
    if (desc.curves.id != 0) {
        request.sources.curves = context.surface_curves.get(desc.curves.id, "desc.curves");
        check_same_surface(out, *request.sources.curves, "desc.curves");
        submission.read(*request.sources.curves, "desc.curves");
    }
    return request;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgFieldGeodesicDescInit(FlgFieldGeodesicDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_geodesic_desc());
}

FlgResult flgFieldViewInit(FlgFieldView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgFieldBlendDescInit(FlgFieldBlendDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgFieldBlendDesc>());
}

FlgResult flgFieldCreateGeodesic(FlgContext context, const FlgFieldGeodesicDesc* desc, FlgField* out_field,
                                 FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_field, "out_field", out_job);
        const FlgFieldGeodesicDesc read = read_struct(desc, default_geodesic_desc(), "desc");
        check(read);
        Submission submission(self, read.job);
        const auto surface = self.surfaces.get(read.surface.id, "desc.surface");
        const auto out = self.make(self.fields, surface);
        GeodesicRequest request = read_request(self, read, *out, submission);
        // In a perturbed metric the solver builds its own.
        submission.wait_for(start_blocks(self, surface));
        submission.read_surface(surface, "desc.surface");
        submission.job().strand.start(solve_geodesic(submission.pace(), std::move(request), out));
        *out_field = {submission.commit(self.fields, out, out_job)};
    });
}

FlgResult flgFieldGetView(FlgContext context, FlgField field, FlgFieldView* out_view) {
    return get_view(out_view, [&] { return get_context(context).fields.get(field.id, "field"); });
}

FlgResult flgFieldCreate(FlgContext context, FlgSurface surface, const float* values, uint32_t value_count,
                         FlgField* out_field) {
    return guarded([&] {
        require(out_field, "out_field") = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const auto of_surface = self.surfaces.get(surface.id, "surface");
        const FlgResult result = visible_result_now(*of_surface);
        if (result != FLG_OK) return result;
        require(values, "values");
        if (value_count != of_surface->mesh().vertex_count()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "value_count is %u, but the surface has %u vertices", value_count,
                          of_surface->mesh().vertex_count());
        }
        const auto field = self.make(self.fields, of_surface);
        field->data.distances = Buffer<float>(value_count, memory);
        for (uint32_t v = 0; v < value_count; ++v) {
            if (std::isnan(values[v])) {
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "values[%u] is nan, must be a number or infinite", v);
            }
            field->data.distances[v] = values[v];
        }
        field->publish_complete();
        *out_field = {self.fields.add(field)};
        return FLG_OK;
    });
}

FlgResult flgFieldRelease(FlgContext context, FlgField field) {
    return release(context, &Context::fields, field, "field");
}

FlgResult flgFieldBlend(FlgContext context, const FlgFieldBlendDesc* desc, FlgField* out_field, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_field, "out_field", out_job);
        const FlgFieldBlendDesc read = read_struct(desc, sized<FlgFieldBlendDesc>(), "desc");
        Submission submission(self, read.job);
        const auto from = self.fields.get(read.from.id, "desc.from");
        const auto to = self.fields.get(read.to.id, "desc.to");
        check_same_surface(*from, *to, "desc.to");
        submission.read(*from, "desc.from");
        submission.read(*to, "desc.to");
        const auto out = self.make(self.fields, from->surface);
        out->revision = from->revision;
        submission.job().strand.start(blend_fields(submission.pace(), from, to, out));
        *out_field = {submission.commit(self.fields, out, out_job)};
    });
}

}  // extern "C"
