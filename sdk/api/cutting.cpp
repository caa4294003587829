// SPDX-License-Identifier: MIT
// Surfaces cut along isolines and curves.
#include <algorithm>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/surface_inputs.h"
#include "surfaces/cutting_jobs.h"

namespace flg {

namespace {

FlgSurfaceCutIsolinesDesc default_cut_isolines_desc() {
    auto desc = sized<FlgSurfaceCutIsolinesDesc>();
    desc.first_label = FLG_NO_INDEX;
    return desc;
}

FlgSurfaceCutCurvesDesc default_cut_curves_desc() {
    auto desc = sized<FlgSurfaceCutCurvesDesc>();
    desc.first_label = FLG_NO_INDEX;
    return desc;
}

void check_first_label(uint32_t label) {
    if (label > FLG_REGION_MAX && label != FLG_NO_INDEX) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.first_label is %u, the largest label is %u", label,
                      FLG_REGION_MAX);
    }
}

// A host's list of labels, each once; empty: all regions.
std::pmr::vector<uint32_t> list_regions(const uint32_t* regions, uint32_t count, Memory* memory) {
    read_regions(regions, count, memory);
    std::pmr::vector<uint32_t> list(memory);
    if (!regions) return list;
    check_range(count > 0, "desc.region_count", count, "above 0 with regions");
    list.assign(regions, regions + count);
    for (uint32_t i = 1; i < count; ++i) {
        if (list[i] <= list[i - 1]) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.regions[%u] is %u after %u, must rise", i, list[i],
                          list[i - 1]);
        }
    }
    return list;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgSurfaceCutIsolinesDescInit(FlgSurfaceCutIsolinesDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_cut_isolines_desc());
}

FlgResult flgSurfaceCutIsolines(FlgContext context, const FlgSurfaceCutIsolinesDesc* desc, FlgField* out_field,
                                FlgJob* out_job) {
    return guarded([&] {
        if (out_field) *out_field = {};
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgSurfaceCutIsolinesDesc read = read_struct(desc, default_cut_isolines_desc(), "desc");
        check_first_label(read.first_label);
        Submission submission(self, read.job);
        const auto field = read_current(self.fields, read.field.id, "desc.field", submission);
        const auto surface = field->surface;
        submission.change_surface(surface, "the surface of desc.field");
        const std::shared_ptr<Field> out = out_field ? self.make(self.fields, surface) : nullptr;
        std::pmr::vector<uint32_t> regions = list_regions(read.regions, read.region_count, memory);
        LevelRequest levels = read_levels(read.levels, read.level_count, read.level_first, read.level_every, memory);
        CutIsolinesRequest request{.field = field,
                                   .revision = surface->order.revision() + 1,
                                   .regions = std::move(regions),
                                   .levels = std::move(levels),
                                   .first_label = read.first_label,
                                   .out = out};
        const auto change = make_object<SurfaceChange>(memory, surface, out);
        submission.job().strand.start(cut_isolines(submission.pace(), std::move(request)));
        if (out) {
            // It belongs to the surface as it will be.
            ++out->revision;
            *out_field = {submission.commit(self.fields, out, change, out_job)};
        } else {
            submission.commit(change, MemoryKind::surfaces, out_job);
        }
    });
}

FlgResult flgSurfaceCutCurvesDescInit(FlgSurfaceCutCurvesDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_cut_curves_desc());
}

FlgResult flgSurfaceCutCurves(FlgContext context, const FlgSurfaceCutCurvesDesc* desc, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgSurfaceCutCurvesDesc read = read_struct(desc, default_cut_curves_desc(), "desc");
        check_first_label(read.first_label);
        Submission submission(self, read.job);
        const auto curves = read_current(self.surface_curves, read.curves.id, "desc.curves", submission);
        const auto surface = curves->surface;
        submission.change_surface(surface, "the surface of desc.curves");
        submission.job().strand.start(
            cut_curves(submission.pace(), curves, read.first_label, surface->order.revision() + 1));
        submission.commit(make_object<SurfaceChange>(memory, surface, nullptr), MemoryKind::surfaces, out_job);
    });
}

}  // extern "C"
