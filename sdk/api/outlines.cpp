// SPDX-License-Identifier: MIT
// Outlines of surfaces: made, shown, released.
#include "api/context.h"
#include "api/descriptors.h"
#include "api/error.h"
#include "api/inputs.h"
#include "api/products.h"
#include "bones/outline.h"

namespace flg {

namespace {

FlgOutlineDesc default_outline_desc() {
    FlgOutlineDesc desc{};
    desc.struct_size = sizeof desc;
    desc.job = default_job_options();
    return desc;
}

void read_regions(const FlgOutlineDesc& desc, HeldOutline& out) {
    if (!desc.regions) {
        check_range(desc.region_count == 0, "desc.region_count", desc.region_count, "0 without regions");
        return;
    }
    check_range(desc.region_count > 0, "desc.region_count", desc.region_count, "at least 1 with regions");
    for (uint32_t i = 0; i < desc.region_count; ++i) {
        const uint32_t region = desc.regions[i];
        check_range(region < FLG_REGION_MAX, "desc.regions", region, "a label below FLG_REGION_MAX");
        if (region >= out.regions.size()) out.regions.resize(region + 1, false);
        out.regions[region] = true;
    }
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgOutlineDescInit(FlgOutlineDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_outline_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgOutlineCreate(FlgContext context, const FlgOutlineDesc* desc, FlgOutline* out_outline, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        require(out_outline, "out_outline") = {};
        Context& self = get_context(context);
        const FlgOutlineDesc read = read_struct(desc, default_outline_desc(), "desc");
        for (int i = 0; i < 3; ++i) {
            check_range(is_coordinate(read.direction[i]), "desc.direction", read.direction[i],
                        "finite and at most 1e30 in size");
        }
        const auto out = make_object<HeldOutline>(self, &self.memory);
        out->surface = self.surfaces.get(read.surface.id, "desc.surface");
        out->towards = load_vec3(read.direction);
        read_regions(read, *out);
        Submission submission(self, read.job);
        submission.read_surface(out->surface, "desc.surface");
        submission.job().strand.start(make_outline(submission.pace(), out));
        *out_outline = {submission.commit(self.outlines, out, out_job)};
        return FLG_OK;
    });
}

FlgResult flgOutlineViewInit(FlgOutlineView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgOutlineGetView(FlgContext context, FlgOutline outline, FlgOutlineView* out_view) {
    return get_view(out_view, [&] { return get_context(context).outlines.get(outline.id, "outline"); });
}

FlgResult flgOutlineRelease(FlgContext context, FlgOutline outline) {
    return guarded([&] {
        get_context(context).outlines.remove(outline.id, "outline");
        return FLG_OK;
    });
}

}  // extern "C"
