// SPDX-License-Identifier: MIT
// Points placed on surfaces.
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/surface_inputs.h"
#include "surfaces/sampling_jobs.h"

namespace flg {

namespace {

FlgSurfaceSampleDesc default_sampling_desc() {
    auto desc = sized<FlgSurfaceSampleDesc>();
    desc.seed = 1;
    return desc;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgSurfaceSampleDescInit(FlgSurfaceSampleDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_sampling_desc());
}

FlgResult flgSurfaceSample(FlgContext context, const FlgSurfaceSampleDesc* desc, FlgField* out_field, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_field, "out_field", out_job);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgSurfaceSampleDesc read = read_struct(desc, default_sampling_desc(), "desc");
        check_range(read.radius > 0 && std::isfinite(read.radius), "desc.radius", read.radius, "finite and above 0");
        Submission submission(self, read.job);
        const auto surface = self.surfaces.get(read.surface.id, "desc.surface");
        const auto out = self.make(self.fields, surface);
        RegionSet regions = read_regions(read.regions, read.region_count, memory);
        submission.wait_for(start_blocks(self, surface));
        submission.read_surface(surface, "desc.surface");
        submission.job().strand.start(sample_surface(submission.pace(), read, std::move(regions), out));
        *out_field = {submission.commit(self.fields, out, out_job)};
    });
}

FlgResult flgSurfaceSampleBordersDescInit(FlgSurfaceSampleBordersDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgSurfaceSampleBordersDesc>());
}

FlgResult flgSurfaceSampleBorders(FlgContext context, const FlgSurfaceSampleBordersDesc* desc,
                                  FlgSurfaceCurves* out_curves, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_curves, "out_curves", out_job);
        const FlgSurfaceSampleBordersDesc read = read_struct(desc, sized<FlgSurfaceSampleBordersDesc>(), "desc");
        check_range(read.spacing > 0 && std::isfinite(read.spacing), "desc.spacing", read.spacing,
                    "finite and above 0");
        check_range(read.region <= FLG_REGION_MAX, "desc.region", read.region, "at most FLG_REGION_MAX");
        Submission submission(self, read.job);
        const auto surface = self.surfaces.get(read.surface.id, "desc.surface");
        submission.read_surface(surface, "desc.surface");
        const auto out = self.make(self.surface_curves, surface);
        submission.job().strand.start(sample_border(submission.pace(), read.region, read.spacing, out));
        *out_curves = {submission.commit(self.surface_curves, out, out_job)};
    });
}

}  // extern "C"
