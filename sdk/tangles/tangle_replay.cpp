// SPDX-License-Identifier: MIT
#include "tangles/tangle_replay.h"

#include <algorithm>
#include <exception>
#include <optional>

#include "core/failure.h"
#include "runtime/each.h"
#include "tangles/history_edit.h"
#include "tangles/region_names.h"
#include "tangles/seed_location.h"
#include "tangles/step_removal.h"

namespace flg {

namespace {

// Meshes of one shape differ by this share of their boxes' diagonal at most, at each side.
constexpr double box_slack = 0.05;

// From the history's identifiers of regions to those of the tangle.
using Identifiers = std::pmr::deque<RegionId>;

void check_boxes(const MeshFingerprint& history, const MeshFingerprint& mesh) {
    const Vec3 lower = load_vec3(mesh.lower.data()), upper = load_vec3(mesh.upper.data());
    const double off = std::max((load_vec3(history.lower.data()) - lower).cwiseAbs().maxCoeff(),
                                (load_vec3(history.upper.data()) - upper).cwiseAbs().maxCoeff());
    const double size = (upper - lower).norm();
    if (off <= box_slack * size) return;
    throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                  "history is of another shape: its mesh's box is %g m off, where the surface measures %g m", off,
                  size);
}

Task<void> map_regions(Pace& pace, const Identifiers& map, const char* argument, std::pmr::vector<RegionId>& regions) {
    co_await each(pace, regions.size(), Cost::tens_of_ns, [&](uint32_t i) {
        if (regions[i] >= map.size())
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%u] is %u, the history has made %zu regions so far", argument,
                          i, regions[i], map.size());
        regions[i] = map[regions[i]];
    });
}

// Gives the step's regions and groups the names they have in the tangle.
Task<void> translate(Pace& pace, const RegionTree& tree, const Identifiers& map, StepRecord& record) {
    if (auto* const divide = std::get_if<DivideRequest>(&record.request)) {
        co_await map_regions(pace, map, "desc.regions", divide->regions);
        co_await map_regions(pace, map, "desc.a.regions", divide->a.regions);
        co_await map_regions(pace, map, "desc.b.regions", divide->b.regions);
        if (record.macro) co_await map_regions(pace, map, "desc.regions", record.macro->regions);
        for (SeedAnchors* anchors : {&record.a, &record.b}) anchors->given = anchors->known;
    } else if (auto* const displace = std::get_if<DisplaceRequest>(&record.request)) {
        co_await map_regions(pace, map, "desc.regions", displace->regions);
    } else if (auto* const group = std::get_if<GroupRequest>(&record.request)) {
        co_await map_regions(pace, map, "regions", group->regions);
    } else if (auto* const join = std::get_if<JoinRequest>(&record.request)) {
        co_await map_regions(pace, map, "regions", join->regions);
    } else if (record.first_region < map.size()) {
        std::get<UngroupRequest>(record.request).group = tree[tree.resolve(map[record.first_region])].group;
    }
}

// How many regions there are once the records' operators are made, by the history; none: it does not say.
std::optional<size_t> regions_after(const StepRecords& records) {
    std::optional<size_t> count;
    for (const std::shared_ptr<StepRecord>& record : records) {
        const bool divides = std::holds_alternative<DivideRequest>(record->request);
        if (divides && !record->places.empty()) count = record->first_region + record->places.size();
    }
    return count;
}

// The last step's first operator.
size_t step_begin(const Tangle& tangle) {
    size_t begin = tangle.steps.size() - 1;
    while (tangle.steps[begin]->goes_on) --begin;
    return begin;
}

// Names say which steps they are of by identities, not by places in the history.
void name_steps(ReplayStep& step, uint32_t first_identity) {
    if (!step.records[0]->wanted) return;
    auto& wanted = const_cast<WantedRegions&>(*step.records[0]->wanted);  // it is the request's own
    for (WantedRegions::Name& name : wanted.names)
        if (name.step != no_index) name.step += first_identity;
}

// What a step made, by the history.
struct Made {
    RegionId first;
    Buffer<Position> places;
};

// The regions of the tangle that lie where those of the history did.
Task<void> follow_regions(Pace& pace, const Mesh& mesh, const std::pmr::deque<Made>& all, Identifiers& map) {
    pace.stage("locate");
    std::optional<NearestPoints> nearest;
    for (const Made& made : all) {
        if (made.places.empty()) continue;
        if (made.first != map.size()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "first_region is %u, but %zu regions come before it", made.first,
                          map.size());
        }
        if (!nearest) {
            nearest.emplace(mesh);
            co_await build(pace, *nearest);
        }
        const Buffer<SurfacePoint> points = co_await locate(pace, *nearest, made.places);
        co_await each(pace, points.size(), Cost::tens_of_ns,
                      [&](uint32_t i) { map.push_back(mesh.regions[points[i].triangle]); });
    }
}

// Makes a step, or leaves it as it is.
Task<void> make_or_leave(Pace& pace, const std::shared_ptr<Tangle>& tangle, ReplayStep step, uint32_t revision) {
    RegionsFound found;
    if (step.records[0]->wanted) {
        const flg::RegionMap as_they_are(no_region, pace.memory());
        found = co_await find_regions(pace, tangle->tree, tangle->steps, tangle->steps, as_they_are, step.records);
    }
    if (step.state != StepState::made) {
        co_await leave_step(pace, tangle, std::move(step.records), step.state, step.why.data());
        co_return;
    }
    if (!found.enough) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "names: none of them is of a region that is there");
    co_await make_step(pace, tangle, std::move(step.records), revision);
    if (found.found < found.wanted) tangle->steps[step_begin(*tangle)]->why = step.why;
}

Task<void> make_elsewhere(Pace& pace, const std::shared_ptr<Tangle>& tangle, ReplayStep step, uint32_t revision,
                          Identifiers& map) {
    std::pmr::deque<Made> made(pace.memory());
    for (const std::shared_ptr<StepRecord>& record : step.records) {
        if (!step.records[0]->wanted) co_await translate(pace, tangle->tree, map, *record);
        made.push_back({record->first_region, std::move(record->places)});
    }
    const bool is_made = step.state == StepState::made;
    co_await make_or_leave(pace, tangle, std::move(step), revision);
    if (is_made) co_await follow_regions(pace, tangle->surface->mesh(), made, map);
}

Task<void> make_all(Pace& pace, const std::shared_ptr<Tangle>& tangle, ReplayRequest& request, uint32_t revision) {
    const bool same = request.base.number == tangle->base.number;
    if (!same) check_boxes(request.base, tangle->base);
    Identifiers map(pace.memory());
    map.push_back(0);
    const uint32_t first_identity = tangle->last_identity + 1;
    for (size_t i = 0; i < request.steps.size(); ++i) {
        ReplayStep step = std::move(request.steps[i]);
        name_steps(step, first_identity);
        try {
            if (same) {
                const std::optional<size_t> expected =
                    step.state == StepState::made ? regions_after(step.records) : std::nullopt;
                co_await make_or_leave(pace, tangle, std::move(step), revision);
                if (expected && *expected != tangle->tree.size()) {
                    throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                                  "the tangle has %u regions after it, by the history %zu: it was changed, or made by "
                                  "another version",
                                  tangle->tree.size(), *expected);
                }
            } else {
                co_await make_elsewhere(pace, tangle, std::move(step), revision, map);
            }
        } catch (const Failure& failure) {
            throw Failure(failure.result(), "history.steps[%zu]: %.200s", i, failure.what());
        }
    }
    // From here on the history is made; what remains is to take back.
    const std::pmr::vector<size_t> begins = step_begins(*tangle, tangle->made, pace.memory());
    co_await go_to(pace, *tangle, begins[request.made], revision);
    tangle->done = request.made;
}

}  // namespace

Task<void> replay_tangle(Pace& pace, std::shared_ptr<Tangle> tangle, ReplayRequest request, uint32_t revision) {
    if (!tangle->steps.empty()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the tangle has steps already, a history needs one without");
    }
    std::exception_ptr failure;
    try {
        co_await make_all(pace, tangle, request, revision);
    } catch (...) {
        failure = std::current_exception();
    }
    if (!failure) co_return;
    tangle->done = 0;
    tangle->acts.clear();
    for (; !tangle->steps.empty(); tangle->steps.pop_back()) {
        if (tangle->made < tangle->steps.size()) continue;  // taken back already
        for (StepRemoval removal(*tangle, *tangle->steps.back()); removal.goes_on();) co_await pace;
        --tangle->made;
    }
    std::rethrow_exception(failure);
}

}  // namespace flg
