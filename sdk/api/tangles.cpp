// SPDX-License-Identifier: MIT
// Tangles: begun, divided, grouped, joined, displaced, taken back and looked at.
#include <algorithm>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/tangle_change.h"
#include "api/tangle_requests.h"

namespace flg {

namespace {

FlgTangleInfo describe(const Tangle& tangle) {
    auto info = sized<FlgTangleInfo>();
    info.region_count = tangle.tree.size();
    info.group_count = tangle.tree.group_count();
    for (RegionId r = 0; r < tangle.tree.size(); ++r) {
        const RegionNode& node = tangle.tree[r];
        if (node.child_count > 0 || node.joined_into != no_region) continue;
        ++info.leaf_count;
        info.depth = std::max(info.depth, tangle.tree.depth(r));
    }
    info.undo_count = static_cast<uint32_t>(tangle.done);
    info.redo_count = static_cast<uint32_t>(tangle.acts.size() - tangle.done);
    info.computed_count = tangle.computed;
    return info;
}

FlgTangleRegion describe(const RegionTree& tree, RegionId region) {
    const RegionNode& node = tree[region];
    return {.struct_size = sizeof(FlgTangleRegion),
            .parent = node.parent,
            .group = node.group,
            .look = node.look,
            .operation = node.operation,
            .part = node.part,
            .first_child = node.first_child,
            .child_count = node.child_count,
            .joined_into = node.joined_into,
            .scaffold = node.scaffold,
            .visible_group = tree.visible_group(region),
            .depth = tree.depth(region)};
}

// The lines seeds begin at, or null.
std::shared_ptr<const TracedCurves> read_curves(Context& context, FlgSurfaceCurves handle, const char* argument,
                                                TangleChange& change) {
    if (handle.id == 0) return nullptr;
    std::shared_ptr<const TracedCurves> curves = context.surface_curves.get(handle.id, argument);
    if (curves->surface != change.tangle->surface) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s belongs to another surface", argument);
    }
    check_revision(*curves, argument);
    change.submission.read(*curves, argument);
    return curves;
}

template <class Request>
FlgResult change_by_list(FlgContext context, FlgTangle tangle, const uint32_t* regions, uint32_t region_count,
                         const FlgJobOptions* job, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        check_range(region_count >= 1, "region_count", region_count, "at least 1");
        TangleChange change(self, job, tangle, "tangle");
        Request request{read_region_ids(regions, region_count, "regions", memory)};
        change.make_step(record_step(std::move(request), memory), out_job);
    });
}

template <class Desc, class Read>
FlgResult change_by_desc(FlgContext context, const Desc* desc, const Desc& defaults, Read read_request,
                         FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const Desc read = read_struct(desc, defaults, "desc");
        auto request = read_request(read, memory);
        TangleChange change(self, read.job, read.tangle, "desc.tangle");
        change.needs_blocks();
        change.make_step(record_step(std::move(request), memory), out_job);
    });
}

template <class Start>
FlgResult change_tangle(FlgContext context, FlgTangle tangle, const FlgJobOptions* job, FlgJob* out_job, Start start) {
    return guarded([&] {
        if (out_job) *out_job = {};
        TangleChange change(get_context(context), job, tangle, "tangle");
        change.commit(start(change), out_job);
    });
}

FlgSurfaceCurves curves_of(const FlgTangleSeeds* seeds) {
    return seeds ? read_struct(seeds, sized<FlgTangleSeeds>(), "seeds").curves : FlgSurfaceCurves{};
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgTangleSeedsInit(FlgTangleSeeds* seeds, uint32_t struct_size) {
    return init(seeds, struct_size, sized<FlgTangleSeeds>(), "seeds");
}

FlgResult flgTangleDivideDescInit(FlgTangleDivideDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_divide_desc());
}

FlgResult flgTangleApplyMacroDescInit(FlgTangleApplyMacroDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_macro_desc());
}

FlgResult flgTangleDisplaceDescInit(FlgTangleDisplaceDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_displace_desc());
}

FlgResult flgTangleCreate(FlgContext context, FlgSurface surface, const FlgJobOptions* job, FlgTangle* out_tangle,
                          FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_tangle, "out_tangle", out_job);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        Submission submission(self, job);
        const auto on = self.surfaces.get(surface.id, "surface");
        submission.change_surface(on, "surface");
        const auto tangle = self.make(self.tangles, on);
        const auto change = make_object<SurfaceChange>(memory, on, tangle);
        submission.job().strand.start(begin_tangle(submission.pace(), tangle));
        *out_tangle = {submission.commit(self.tangles, tangle, change, out_job)};
        tangle->revision = on->order.revision();
    });
}

FlgResult flgTangleRelease(FlgContext context, FlgTangle tangle) {
    return release(context, &Context::tangles, tangle, "tangle");
}

FlgResult flgTangleDivide(FlgContext context, const FlgTangleDivideDesc* desc, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgTangleDivideDesc read = read_struct(desc, default_divide_desc(), "desc");
        DivideRequest request = read_divide(read, memory);
        TangleChange change(self, read.job, read.tangle, "desc.tangle");
        request.a.curves = read_curves(self, curves_of(read.a), "desc.a.curves", change);
        request.b.curves = read_curves(self, curves_of(read.b), "desc.b.curves", change);
        check_seeds_of(request);
        change.needs_blocks();
        change.make_step(record_step(std::move(request), memory), out_job);
    });
}

FlgResult flgTangleApplyMacro(FlgContext context, const FlgTangleApplyMacroDesc* desc, FlgJob* out_job) {
    return change_by_desc(context, desc, default_macro_desc(), &read_macro, out_job);
}

FlgResult flgTangleDisplace(FlgContext context, const FlgTangleDisplaceDesc* desc, FlgJob* out_job) {
    return change_by_desc(context, desc, default_displace_desc(), &read_displace, out_job);
}

FlgResult flgTangleGroup(FlgContext context, FlgTangle tangle, const uint32_t* regions, uint32_t region_count,
                         const FlgJobOptions* job, FlgJob* out_job) {
    return change_by_list<GroupRequest>(context, tangle, regions, region_count, job, out_job);
}

FlgResult flgTangleUngroup(FlgContext context, FlgTangle tangle, uint32_t group, const FlgJobOptions* job,
                           FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        TangleChange change(self, job, tangle, "tangle");
        change.make_step(record_step(UngroupRequest{group}, memory), out_job);
    });
}

FlgResult flgTangleJoin(FlgContext context, FlgTangle tangle, const uint32_t* regions, uint32_t region_count,
                        const FlgJobOptions* job, FlgJob* out_job) {
    return change_by_list<JoinRequest>(context, tangle, regions, region_count, job, out_job);
}

FlgResult flgTangleTraceBorders(FlgContext context, FlgTangle tangle, const FlgJobOptions* job,
                                FlgSurfaceCurves* out_curves, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_curves, "out_curves", out_job);
        const auto of = self.tangles.get(tangle.id, "tangle");
        Submission submission(self, job);
        submission.read(*of, "tangle");
        refuse_changed_surface(*of, "tangle");
        submission.read_surface(of->surface, "the surface of the tangle");
        const auto out = self.make(self.surface_curves, of->surface);
        submission.job().strand.start(trace_borders(submission.pace(), of, out));
        *out_curves = {submission.commit(self.surface_curves, out, out_job)};
    });
}

FlgResult flgTangleUndo(FlgContext context, FlgTangle tangle, const FlgJobOptions* job, FlgJob* out_job) {
    return change_tangle(context, tangle, job, out_job, [](TangleChange& change) {
        return undo_step(change.submission.pace(), change.tangle, change.revision());
    });
}

FlgResult flgTangleRedo(FlgContext context, FlgTangle tangle, const FlgJobOptions* job, FlgJob* out_job) {
    return change_tangle(context, tangle, job, out_job, [](TangleChange& change) {
        return redo_step(change.submission.pace(), change.tangle, change.revision());
    });
}

FlgResult flgTangleInfoInit(FlgTangleInfo* info, uint32_t struct_size) {
    return init(info, struct_size, sized<FlgTangleInfo>(), "info");
}

FlgResult flgTangleGetInfo(FlgContext context, FlgTangle tangle, FlgTangleInfo* out_info) {
    return show(
        out_info, "out_info", sized<FlgTangleInfo>(),
        [&] { return get_context(context).tangles.get(tangle.id, "tangle"); },
        [](const Tangle& self) { return describe(self); });
}

FlgResult flgTangleRegionInit(FlgTangleRegion* region, uint32_t struct_size) {
    return init(region, struct_size, sized<FlgTangleRegion>(), "region");
}

FlgResult flgTangleGetRegion(FlgContext context, FlgTangle tangle, uint32_t region, FlgTangleRegion* out_region) {
    return show(
        out_region, "out_region", sized<FlgTangleRegion>(),
        [&] { return get_context(context).tangles.get(tangle.id, "tangle"); },
        [&](const Tangle& self) {
            check_range(region < self.tree.size(), "region", region, "below the tangle's region_count");
            return describe(self.tree, region);
        });
}

}  // extern "C"
