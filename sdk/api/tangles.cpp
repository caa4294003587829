// SPDX-License-Identifier: MIT
// Tangles: begun, divided, grouped, joined, displaced, taken back and looked at.
#include <algorithm>
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/tangle_change.h"

namespace flg {

namespace {

constexpr uint32_t max_cycle = 65536;

FlgTangleDivideDesc default_divide_desc() {
    FlgTangleDivideDesc desc{};
    desc.struct_size = sizeof desc;
    desc.job = default_job_options();
    desc.count = 1;
    desc.delta = 0.1f;
    desc.cycle = 3;
    desc.frequency = 1;
    desc.seed = 1;
    return desc;
}

FlgTangleDisplaceDesc default_displace_desc() {
    FlgTangleDisplaceDesc desc{};
    desc.struct_size = sizeof desc;
    desc.job = default_job_options();
    desc.amount = 0.1f;
    desc.bias = desc.gain = 0.5f;
    return desc;
}

TangleSeeds read_seeds(Context& context, const FlgTangleSeeds& from, uint64_t seed, const char* name,
                       TangleChange& change) {
    Memory* memory = &context.memory;
    char argument[32];
    const auto member = [&](const char* member_name) {
        std::snprintf(argument, sizeof argument, "%s.%s", name, member_name);
        return argument;
    };
    TangleSeeds seeds(memory);
    check_enum(from.borders, FLG_TANGLE_BORDERS_NONE, FLG_TANGLE_BORDERS_EACH, member("borders"),
               "FLG_TANGLE_BORDERS_");
    seeds.borders = from.borders;
    if (from.stretch_count > 0) require(from.stretches, member("stretches"));
    for (uint32_t i = 0; i < from.stretch_count; ++i) {
        const FlgBorderStretch& stretch = from.stretches[i];
        const bool holds =
            stretch.begin >= 0 && stretch.begin < 1 && stretch.end > stretch.begin && stretch.end <= stretch.begin + 1;
        if (!holds) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "%s[%u] is from %g to %g, must begin in [0, 1) and end within 1 beyond", member("stretches"),
                          i, double{stretch.begin}, double{stretch.end});
        }
        seeds.stretches.push_back({stretch.loop, stretch.begin, stretch.end});
    }
    seeds.points = read_points(from.points, from.point_count, member("points"), memory);
    check_range(from.sample_radius == 0 || is_positive(from.sample_radius), member("sample_radius"), from.sample_radius,
                "0 or finite and above 0");
    check_range(from.border_spacing == 0 || is_positive(from.border_spacing), member("border_spacing"),
                from.border_spacing, "0 or finite and above 0");
    seeds.sample_radius = from.sample_radius;
    seeds.sample_count = from.sample_count;
    seeds.border_spacing = from.border_spacing;
    seeds.seed = seed;
    if (from.curves.id != 0) {
        seeds.curves = context.surface_curves.get(from.curves.id, member("curves"));
        if (seeds.curves->surface != change.tangle->surface) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s belongs to another surface", member("curves"));
        }
        check_revision(*seeds.curves, member("curves"));
        change.submission.read(*seeds.curves, member("curves"));
    }
    seeds.regions = read_region_ids(from.regions, from.region_count, member("regions"), memory);
    return seeds;
}

void check_divide(const FlgTangleDivideDesc& desc) {
    check_enum(desc.kind, FLG_TANGLE_CONTOUR, FLG_TANGLE_POLYLINE, "desc.kind", "FLG_TANGLE_");
    check_enum(desc.grouping, FLG_TANGLE_GROUP_TWO, FLG_TANGLE_GROUP_CYCLE, "desc.grouping", "FLG_TANGLE_GROUP_");
    check_range(desc.region_count >= 1, "desc.region_count", desc.region_count, "at least 1");
    check_range(desc.count <= 256, "desc.count", desc.count, "at most 256");
    check_range(is_positive(desc.delta), "desc.delta", desc.delta, "finite and above 0");
    check_range(desc.cycle >= 1 && desc.cycle <= max_cycle, "desc.cycle", desc.cycle, "1 to 65536");
    check_range(desc.perturbation >= 0 && std::isfinite(desc.perturbation), "desc.perturbation", desc.perturbation,
                "finite and at least 0");
    check_range(is_positive(desc.frequency), "desc.frequency", desc.frequency, "finite and above 0");
}

// What an operator can't do without, and what it has no use for.
void check_seeds_of(const DivideRequest& request) {
    const TangleSeeds& a = request.a;
    if (a.empty()) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.a is empty, the operator has nothing to begin at");
    if (request.kind == FLG_TANGLE_POLYLINE && a.points.size() < 2) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.a.point_count is %zu, a polyline needs 2 points at least",
                      a.points.size());
    }
    const bool has_cells = !a.points.empty() || a.sample_radius > 0 || a.border_spacing > 0;
    if (request.kind == FLG_TANGLE_VORONOI && !has_cells) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.a has neither points nor samples for cells to form around");
    }
    if (request.kind == FLG_TANGLE_CONTOUR && !request.b.empty() && !(request.delta < 1)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.delta is %g, of a blended field it must be below 1",
                      double{request.delta});
    }
}

DivideRequest read_divide(Context& context, const FlgTangleDivideDesc& desc, TangleChange& change) {
    DivideRequest request(&context.memory);
    request.kind = desc.kind;
    request.regions = read_region_ids(desc.regions, desc.region_count, "desc.regions", &context.memory);
    request.a = read_seeds(context, desc.a, desc.seed, "desc.a", change);
    request.b = read_seeds(context, desc.b, desc.seed, "desc.b", change);
    request.delta = desc.delta;
    request.count = desc.count;
    request.grouping = desc.grouping;
    request.cycle = desc.cycle;
    request.scaffold = desc.scaffold != 0;
    request.closed = desc.closed != 0;
    request.perturbation = {desc.perturbation, desc.frequency, desc.seed};
    check_seeds_of(request);
    return request;
}

// Whether a tangle can be seen now.
FlgResult visible_result_now(const Tangle& tangle) {
    const FlgResult result = tangle.visible_result();
    if (result < 0) return set_last_error(result, tangle.error());
    return result == FLG_OK ? visible_result_now(*tangle.surface) : result;
}

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
        if (tangle.steps[i].goes_on) continue;
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

template <class Start>
FlgResult change_by_list(FlgContext context, FlgTangle tangle, const uint32_t* regions, uint32_t region_count,
                         FlgJob* out_job, Start start) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        check_range(region_count >= 1, "region_count", region_count, "at least 1");
        TangleChange change(self, default_job_options(), tangle, "tangle");
        change.commit(start(change, read_region_ids(regions, region_count, "regions", &self.memory)), out_job);
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

FlgResult flgTangleDisplaceDescInit(FlgTangleDisplaceDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_displace_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgTangleCreate(FlgContext context, FlgSurface surface, FlgTangle* out_tangle, FlgJob* out_job) {
    return guarded([&] {
        require(out_tangle, "out_tangle") = {};
        if (out_job) *out_job = {};
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
        check_divide(read);
        TangleChange change(self, read.job, read.tangle, "desc.tangle");
        DivideRequest request = read_divide(self, read, change);
        change.needs_blocks();
        change.commit(divide_tangle(change.submission.pace(), change.tangle, std::move(request), change.revision()),
                      out_job);
        return FLG_OK;
    });
}

FlgResult flgTangleDisplace(FlgContext context, const FlgTangleDisplaceDesc* desc, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const FlgTangleDisplaceDesc read = read_struct(desc, default_displace_desc(), "desc");
        check_range(read.region_count >= 1, "desc.region_count", read.region_count, "at least 1");
        check_range(std::isfinite(read.amount), "desc.amount", read.amount, "finite");
        check_range(read.bias > 0 && read.bias < 1, "desc.bias", read.bias, "between 0 and 1");
        check_range(read.gain > 0 && read.gain < 1, "desc.gain", read.gain, "between 0 and 1");
        check_range(read.reach >= 0 && std::isfinite(read.reach), "desc.reach", read.reach, "finite and at least 0");
        TangleChange change(self, read.job, read.tangle, "desc.tangle");
        DisplaceRequest request(&self.memory);
        request.regions = read_region_ids(read.regions, read.region_count, "desc.regions", &self.memory);
        request.amount = read.amount;
        request.bias = read.bias;
        request.gain = read.gain;
        request.reach = read.reach;
        change.needs_blocks();
        change.commit(displace_tangle(change.submission.pace(), change.tangle, std::move(request), change.revision()),
                      out_job);
        return FLG_OK;
    });
}

FlgResult flgTangleGroup(FlgContext context, FlgTangle tangle, const uint32_t* regions, uint32_t region_count,
                         FlgJob* out_job) {
    return change_by_list(context, tangle, regions, region_count, out_job,
                          [](TangleChange& change, std::pmr::vector<RegionId> list) {
                              return group_regions(change.submission.pace(), change.tangle, std::move(list));
                          });
}

FlgResult flgTangleUngroup(FlgContext context, FlgTangle tangle, uint32_t group, FlgJob* out_job) {
    return change_tangle(context, tangle, out_job, [&](TangleChange& change) {
        return ungroup_regions(change.submission.pace(), change.tangle, group);
    });
}

FlgResult flgTangleJoin(FlgContext context, FlgTangle tangle, const uint32_t* regions, uint32_t region_count,
                        FlgJob* out_job) {
    return change_by_list(
        context, tangle, regions, region_count, out_job, [](TangleChange& change, std::pmr::vector<RegionId> list) {
            return join_regions(change.submission.pace(), change.tangle, std::move(list), change.revision());
        });
}

FlgResult flgTangleBorders(FlgContext context, FlgTangle tangle, FlgSurfaceCurves* out_curves, FlgJob* out_job) {
    return guarded([&] {
        require(out_curves, "out_curves") = {};
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const auto of = self.tangles.get(tangle.id, "tangle");
        Submission submission(self, default_job_options());
        submission.read(*of, "tangle");
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
