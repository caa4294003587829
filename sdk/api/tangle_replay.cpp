// SPDX-License-Identifier: MIT
// Histories of tangles: read from hosts, and made again.
#include "tangles/tangle_replay.h"

#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/surface_inputs.h"
#include "api/tangle_change.h"
#include "api/tangle_requests.h"
#include "runtime/run_now.h"
#include "tangles/region_names.h"

namespace flg {

namespace {

// Lines of a history. Whether their triangles exist the job finds out.
std::shared_ptr<TracedCurves> read_lines(Memory* memory, const FlgSurfaceCurvesView& view,
                                         const std::shared_ptr<Surface>& surface) {
    if (view.curve_count == 0) return nullptr;
    const uint32_t* const offsets = &require(view.curve_offsets, "curves.curve_offsets");
    const uint8_t* const flags = &require(view.curve_flags, "curves.curve_flags");
    const float* const values = &require(view.curve_values, "curves.curve_values");
    if (offsets[0] != 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "curves.curve_offsets[0] is %u, must be 0", offsets[0]);
    }
    auto lines = make_object<TracedCurves>(memory, surface, memory);
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        const bool closed = (flags[c] & FLG_CURVE_CLOSED) != 0;
        if (offsets[c + 1] < uint64_t{offsets[c]} + (closed ? 3 : 2)) {
            throw Failure(
                FLG_ERROR_INVALID_ARGUMENT,
                "curves.curve_offsets[%u] is %u after %u; a curve has two points at least, a closed one three", c + 1,
                offsets[c + 1], offsets[c]);
        }
        check_range(!std::isnan(values[c]), "curves.curve_values", values[c], "a number");
        lines->curves.offsets.push_back(offsets[c + 1]);
        lines->curves.closed.push_back(closed);
        lines->curves.values.push_back(values[c]);
    }
    const Buffer<SurfacePoint> points = read_points(view.points, offsets[view.curve_count], "curves.points", memory);
    lines->curves.points.assign(points.begin(), points.end());
    run_now(memory, [&](Pace& pace) { return flatten_curves(pace, *lines); });
    return lines;
}

void read_places(Memory* memory, const FlgTangleSeedPlaces* given, bool placed, const std::shared_ptr<Surface>& surface,
                 TangleSeeds& seeds, SeedAnchors& anchors) {
    const FlgTangleSeedPlaces places = read_struct(given, sized<FlgTangleSeedPlaces>(), "places");
    if (places.point_count != 0 && places.point_count != seeds.points.size()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "places.point_count is %u, but the seeds have %zu points",
                      places.point_count, seeds.points.size());
    }
    anchors.points = read_positions(places.points, places.point_count, "places.points", memory);
    anchors.loops = read_positions(places.loops, places.loop_count, "places.loops", memory);
    anchors.samples = read_positions(places.samples, places.sample_count, "places.samples", memory);
    if (places.curves) {
        const FlgSurfaceCurvesView lines = read_struct(places.curves, sized<FlgSurfaceCurvesView>(), "places.curves");
        anchors.given_curves = read_lines(memory, lines, surface);
    }
    if (anchors.given_curves) {
        anchors.located_curves = make_object<TracedCurves>(memory, surface, memory);
        const auto count = static_cast<uint32_t>(anchors.given_curves->curves.points.size());
        anchors.curve_points = read_positions(places.curve_points, count, "places.curve_points", memory);
    }
    seeds.curves = anchors.given_curves;
    anchors.known = true;
    anchors.given = placed;
}

StepRecords read_request(const FlgTangleStep& step, Memory* memory) {
    switch (step.kind) {
        case FLG_TANGLE_STEP_KIND_DIVIDE:
            return record_step(read_divide(read_struct(step.divide, default_divide_desc(), "divide"), memory), memory);
        case FLG_TANGLE_STEP_KIND_MACRO:
            return record_step(read_macro(read_struct(step.macro, default_macro_desc(), "macro"), memory), memory);
        case FLG_TANGLE_STEP_KIND_DISPLACE:
            return record_step(read_displace(read_struct(step.displace, default_displace_desc(), "displace"), memory),
                               memory);
        case FLG_TANGLE_STEP_KIND_UNGROUP: return record_step(UngroupRequest{step.group}, memory);
        default: break;
    }
    check_range(step.region_count >= 1, "region_count", step.region_count, "at least 1");
    std::pmr::vector<RegionId> regions = read_region_ids(step.regions, step.region_count, "regions", memory);
    if (step.kind == FLG_TANGLE_STEP_KIND_GROUP) return record_step(GroupRequest{std::move(regions)}, memory);
    return record_step(JoinRequest{std::move(regions)}, memory);
}

// Regions by name, in place of identifiers.
std::shared_ptr<const WantedRegions> read_names(const FlgTangleStep& step, StepRecord& record, Memory* memory) {
    const auto wanted = make_object<WantedRegions>(memory, memory);
    const FlgTangleRegionName* const names = &require(step.names, "names");
    for (uint32_t i = 0; i < step.name_count; ++i) {
        const FlgTangleRegionName& name = names[i];
        if (name.parent != FLG_NO_INDEX && name.parent >= i)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "names[%u].parent is %u, must be below %u, or FLG_NO_INDEX", i,
                          name.parent, i);
        WantedRegions::Name& read = wanted->names.emplace_back();
        check_range(name.reach >= 0 && is_coordinate(name.reach), "names.reach", name.reach, "finite and at least 0");
        read = {name.step, name.operation, name.part, name.parent, {}, name.reach};
        for (size_t k = 0; k < 3; ++k) {
            check_range(is_coordinate(name.place[k]), "names.place", name.place[k], "finite");
            read.place[k] = name.place[k];
        }
    }
    const auto take = [&](std::pmr::vector<RegionId>* from, std::pmr::vector<uint32_t>& to) {
        if (!from) return;
        for (const uint32_t name : *from) {
            check_range(name < step.name_count, "regions", name, "below name_count");
            to.push_back(name);
        }
        from->clear();
    };
    const RegionLists lists = lists_of(record.request);
    take(lists.regions, wanted->regions);
    take(lists.a, wanted->a);
    take(lists.b, wanted->b);
    if (std::holds_alternative<UngroupRequest>(record.request)) wanted->regions.push_back(step.name_count - 1);
    return wanted;
}

}  // namespace

ReplayStep read_step(Memory* memory, const FlgTangleStep& step, const std::shared_ptr<Surface>& surface) {
    check_enum(step.kind, FLG_TANGLE_STEP_KIND_DIVIDE, FLG_TANGLE_STEP_KIND_JOIN, "kind", "FLG_TANGLE_STEP_");
    StepRecords records = read_request(step, memory);
    if (step.placed != 0 && step.place_count == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "place_count is 0, but the step is placed");
    }
    if (step.place_count != 0) {
        require(step.places, "places");
        const bool divides = std::holds_alternative<DivideRequest>(records[0]->request);
        const size_t needed = divides ? 2 * records.size() : 0;
        if (step.place_count != needed) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "place_count is %u, must be 0 or %zu", step.place_count, needed);
        }
        for (size_t i = 0; i < records.size(); ++i) {
            auto& divide = std::get<DivideRequest>(records[i]->request);
            const bool placed = step.placed != 0;
            read_places(memory, step.places[2 * i], placed, surface, divide.a, records[i]->a);
            read_places(memory, step.places[2 * i + 1], placed, surface, divide.b, records[i]->b);
        }
    }
    if (step.kind == FLG_TANGLE_STEP_KIND_DIVIDE) check_seeds_of(std::get<DivideRequest>(records[0]->request));
    // A macro's regions come one operator after the other; together they are followed as well.
    records.back()->first_region = step.first_region;
    records.back()->places = read_positions(step.made, step.made_count, "made", memory);
    check_enum(step.state, FLG_TANGLE_STEP_STATE_MADE, FLG_TANGLE_STEP_STATE_LOST, "state", "FLG_TANGLE_STEP_STATE_");
    if (step.name_count > 0) records[0]->wanted = read_names(step, *records[0], memory);
    ReplayStep read(std::move(records));
    read.state = static_cast<StepState>(step.state);
    if (step.why) std::snprintf(read.why.data(), read.why.size(), "%s", step.why);
    return read;
}

namespace {

ReplayRequest read_history(Memory* memory, const FlgTangleHistory& history, const std::shared_ptr<Surface>& surface) {
    ReplayRequest request(memory);
    check_range(history.made_count <= history.step_count, "history.made_count", history.made_count,
                "at most step_count");
    if (history.step_count > 0) require(history.steps, "history.steps");
    request.base.number = history.base;
    for (size_t k = 0; k < 3; ++k) {
        check_range(is_coordinate(history.box_min[k]), "history.box_min", history.box_min[k], "finite");
        check_range(is_coordinate(history.box_max[k]), "history.box_max", history.box_max[k], "finite");
        request.base.lower[k] = history.box_min[k];
        request.base.upper[k] = history.box_max[k];
    }
    for (uint32_t i = 0; i < history.step_count; ++i) {
        try {
            const FlgTangleStep step = read_struct(history.steps[i], sized<FlgTangleStep>(), "step");
            request.steps.push_back(read_step(memory, step, surface));
        } catch (const Failure& failure) {
            throw Failure(failure.result(), "history.steps[%u]: %.200s", i, failure.what());
        }
    }
    request.made = history.made_count;
    return request;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" FlgResult flgTangleReplay(FlgContext context, FlgTangle tangle, const FlgTangleHistory* history,
                                     const FlgJobOptions* job, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const FlgTangleHistory read = read_struct(history, sized<FlgTangleHistory>(), "history");
        TangleChange change(self, job, tangle, "tangle");
        ReplayRequest request = read_history(self.memory[MemoryKind::surfaces], read, change.tangle->surface);
        change.needs_blocks();
        change.commit(replay_tangle(change.submission.pace(), change.tangle, std::move(request), change.revision()),
                      out_job);
    });
}
