// SPDX-License-Identifier: MIT
// Outlines of surfaces: made, shown, released.
#include "api/descriptors.h"
#include "api/inputs.h"
#include "bones/outline.h"

namespace flg {

namespace {

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

constexpr FlgContourView no_contour = sized<FlgContourView>();

// Shown until there is an outline: hosts may read the counts without a look at the result.
FlgOutlineView no_outline_view() {
    auto view = sized<FlgOutlineView>();
    view.contour = &no_contour;
    return view;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgOutlineDescInit(FlgOutlineDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgOutlineDesc>());
}

FlgResult flgOutlineCreate(FlgContext context, const FlgOutlineDesc* desc, FlgOutline* out_outline, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_outline, "out_outline", out_job);
        const FlgOutlineDesc read = read_struct(desc, sized<FlgOutlineDesc>(), "desc");
        for (int i = 0; i < 3; ++i) {
            check_range(is_coordinate(read.direction[i]), "desc.direction", read.direction[i],
                        "finite and at most 1e30 in size");
        }
        const auto out = self.make(self.outlines);
        out->surface = self.surfaces.get(read.surface.id, "desc.surface");
        out->towards = load_vec3(read.direction);
        read_regions(read, *out);
        Submission submission(self, read.job);
        submission.read_surface(out->surface, "desc.surface");
        submission.job().strand.start(make_outline(submission.pace(), out));
        *out_outline = {submission.commit(self.outlines, out, out_job)};
    });
}

FlgResult flgOutlineViewInit(FlgOutlineView* view, uint32_t struct_size) {
    return init(view, struct_size, no_outline_view(), "view");
}

FlgResult flgOutlineGetView(FlgContext context, FlgOutline outline, FlgOutlineView* out_view) {
    return show(
        out_view, "out_view", no_outline_view(),
        [&] { return get_context(context).outlines.get(outline.id, "outline"); },
        [](const HeldOutline& held) { return held.view(); });
}

FlgResult flgOutlineRelease(FlgContext context, FlgOutline outline) {
    return release(context, &Context::outlines, outline, "outline");
}

}  // extern "C"
