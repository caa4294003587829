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
    FlgTangleInfo info{};
    info.struct_size = sizeof info;
    info.region_count = tangle.tree.size();
    info.group_count = tangle.tree.group_count();
    for (RegionId r = 0; r < tangle.tree.size(); ++r) {
        const RegionNode& node = tangle.tree[r];
        if (node.child_count > 0 || node.joined_into != no_region) continue;
        ++info.leaf_count;
        info.depth = std::max(info.depth, tangle.tree.depth(r));
    }
    for (size_t i = 0; i < tangle.steps.size(); ++i) {
        if (tangle.steps[i]->goes_on) continue;
        ++(i < tangle.made ? info.undo_count : info.redo_count);
    }
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
                         FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        check_range(region_count >= 1, "region_count", region_count, "at least 1");
        TangleChange change(self, default_job_options(), tangle, "tangle");
        Request request{read_region_ids(regions, region_count, "regions", &self.memory)};
        change.make_step(record_step(std::move(request), &self.memory), out_job);
        return FLG_OK;
    });
}

template <class Start>
FlgResult change_tangle(FlgContext context, FlgTangle tangle, FlgJob* out_job, Start start) {
    return guarded([&] {
        if (out_job) *out_job = {};
        TangleChange change(get_context(context), default_job_options(), tangle, "tangle");
        change.commit(start(change), out_job);
        return FLG_OK;
    });
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgTangleDivideDescInit(FlgTangleDivideDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_divide_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgTangleMacroDescInit(FlgTangleMacroDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_macro_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgTangleDisplaceDescInit(FlgTangleDisplaceDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_displace_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgTangleCreate(FlgContext context, FlgSurface surface, FlgTangle* out_tangle, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        require(out_tangle, "out_tangle") = {};
        Context& self = get_context(context);
        Submission submission(self, default_job_options());
        const auto on = self.surfaces.get(surface.id, "surface");
        submission.change_surface(on, "surface");
        const auto tangle = make_object<Tangle>(self, on, &self.memory);
        const auto change = make_object<SurfaceChange>(self, on, tangle);
        submission.job().strand.start(begin_tangle(submission.pace(), tangle));
        *out_tangle = {submission.commit(self.tangles, tangle, change, out_job)};
        tangle->revision = on->order.revision();
        return FLG_OK;
    });
}

FlgResult flgTangleRelease(FlgContext context, FlgTangle tangle) {
    return guarded([&] {
        get_context(context).tangles.remove(tangle.id, "tangle");
        return FLG_OK;
    });
}

FlgResult flgTangleDivide(FlgContext context, const FlgTangleDivideDesc* desc, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const FlgTangleDivideDesc read = read_struct(desc, default_divide_desc(), "desc");
        DivideRequest request = read_divide(read, &self.memory);
        TangleChange change(self, read.job, read.tangle, "desc.tangle");
        request.a.curves = read_curves(self, read.a.curves, "desc.a.curves", change);
        request.b.curves = read_curves(self, read.b.curves, "desc.b.curves", change);
        check_seeds_of(request);
        change.needs_blocks();
        change.make_step(record_step(std::move(request), &self.memory), out_job);
        return FLG_OK;
    });
}

FlgResult flgTangleApplyMacro(FlgContext context, const FlgTangleMacroDesc* desc, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const FlgTangleMacroDesc read = read_struct(desc, default_macro_desc(), "desc");
        MacroRequest request = read_macro(read, &self.memory);
        TangleChange change(self, read.job, read.tangle, "desc.tangle");
        change.needs_blocks();
        change.make_step(record_macro(std::move(request), &self.memory), out_job);
        return FLG_OK;
    });
}

FlgResult flgTangleDisplace(FlgContext context, const FlgTangleDisplaceDesc* desc, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const FlgTangleDisplaceDesc read = read_struct(desc, default_displace_desc(), "desc");
        DisplaceRequest request = read_displace(read, &self.memory);
        TangleChange change(self, read.job, read.tangle, "desc.tangle");
        change.needs_blocks();
        change.make_step(record_step(std::move(request), &self.memory), out_job);
        return FLG_OK;
    });
}

FlgResult flgTangleGroup(FlgContext context, FlgTangle tangle, const uint32_t* regions, uint32_t region_count,
                         FlgJob* out_job) {
    return change_by_list<GroupRequest>(context, tangle, regions, region_count, out_job);
}

FlgResult flgTangleUngroup(FlgContext context, FlgTangle tangle, uint32_t group, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        TangleChange change(self, default_job_options(), tangle, "tangle");
        change.make_step(record_step(UngroupRequest{group}, &self.memory), out_job);
        return FLG_OK;
    });
}

FlgResult flgTangleJoin(FlgContext context, FlgTangle tangle, const uint32_t* regions, uint32_t region_count,
                        FlgJob* out_job) {
    return change_by_list<JoinRequest>(context, tangle, regions, region_count, out_job);
}

FlgResult flgTangleBorders(FlgContext context, FlgTangle tangle, FlgSurfaceCurves* out_curves, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        require(out_curves, "out_curves") = {};
        Context& self = get_context(context);
        const auto of = self.tangles.get(tangle.id, "tangle");
        Submission submission(self, default_job_options());
        submission.read(*of, "tangle");
        refuse_changed_surface(*of, "tangle");
        submission.read_surface(of->surface, "the surface of the tangle");
        const auto out = make_object<TracedCurves>(self, of->surface, &self.memory);
        submission.job().strand.start(trace_borders(submission.pace(), of, out));
        *out_curves = {submission.commit(self.surface_curves, out, out_job)};
        return FLG_OK;
    });
}

FlgResult flgTangleUndo(FlgContext context, FlgTangle tangle, FlgJob* out_job) {
    return change_tangle(context, tangle, out_job, [](TangleChange& change) {
        return undo_step(change.submission.pace(), change.tangle, change.revision());
    });
}

FlgResult flgTangleRedo(FlgContext context, FlgTangle tangle, FlgJob* out_job) {
    return change_tangle(context, tangle, out_job, [](TangleChange& change) {
        return redo_step(change.submission.pace(), change.tangle, change.revision());
    });
}

FlgResult flgTangleGetInfo(FlgContext context, FlgTangle tangle, FlgTangleInfo* out_info) {
    return guarded([&] {
        FlgTangleInfo none{};
        none.struct_size = sizeof none;
        write_struct(out_info, none, "out_info");
        const Tangle& self = *get_context(context).tangles.get(tangle.id, "tangle");
        const FlgResult result = visible_result_now(self);
        if (result == FLG_OK) write_struct(out_info, describe(self), "out_info");
        return result;
    });
}

FlgResult flgTangleGetRegion(FlgContext context, FlgTangle tangle, uint32_t region, FlgTangleRegion* out_region) {
    return guarded([&] {
        FlgTangleRegion none{};
        none.struct_size = sizeof none;
        write_struct(out_region, none, "out_region");
        const Tangle& self = *get_context(context).tangles.get(tangle.id, "tangle");
        const FlgResult result = visible_result_now(self);
        if (result != FLG_OK) return result;
        check_range(region < self.tree.size(), "region", region, "below the tangle's region_count");
        write_struct(out_region, describe(self.tree, region), "out_region");
        return FLG_OK;
    });
}

}  // extern "C"
