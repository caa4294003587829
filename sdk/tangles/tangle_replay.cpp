// SPDX-License-Identifier: MIT
#include "tangles/tangle_replay.h"

#include <algorithm>
#include <exception>
#include <optional>

#include "core/failure.h"
#include "runtime/each.h"
#include "tangles/seed_location.h"
#include "tangles/step_removal.h"

namespace flg {

namespace {

// Meshes of one shape differ by this share of their boxes' diagonal at most, at each side.
constexpr double box_slack = 0.05;

// From the history's identifiers of regions to those of the tangle.
using RegionMap = std::pmr::deque<RegionId>;

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

Task<void> map_regions(Pace& pace, const RegionMap& map, const char* argument, std::pmr::vector<RegionId>& regions) {
    co_await each(pace, regions.size(), Cost::tens_of_ns, [&](uint32_t i) {
        if (regions[i] >= map.size())
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%u] is %u, the history has made %zu regions so far", argument,
                          i, regions[i], map.size());
        regions[i] = map[regions[i]];
    });
}

// Gives the step's regions and groups the names they have in the tangle.
Task<void> translate(Pace& pace, const RegionTree& tree, const RegionMap& map, StepRecord& record) {
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

// What a step made, by the history.
struct Made {
    RegionId first;
    Buffer<Position> places;
};

// The regions of the tangle that lie where those of the history did.
Task<void> follow_regions(Pace& pace, const Mesh& mesh, const std::pmr::deque<Made>& all, RegionMap& map) {
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

Task<void> make_elsewhere(Pace& pace, const std::shared_ptr<Tangle>& tangle, StepRecords records, uint32_t revision,
                          RegionMap& map) {
    std::pmr::deque<Made> made(pace.memory());
    for (const std::shared_ptr<StepRecord>& record : records) {
        co_await translate(pace, tangle->tree, map, *record);
        made.push_back({record->first_region, std::move(record->places)});
    }
    co_await make_step(pace, tangle, std::move(records), revision);
    co_await follow_regions(pace, tangle->surface->mesh(), made, map);
}

Task<void> make_all(Pace& pace, const std::shared_ptr<Tangle>& tangle, ReplayRequest& request, uint32_t revision) {
    const bool same = request.base.number == tangle->base.number;
    if (!same) check_boxes(request.base, tangle->base);
    RegionMap map(pace.memory());
    map.push_back(0);
    for (size_t i = 0; i < request.steps.size(); ++i) {
        StepRecords records = std::move(request.steps[i]);
        try {
            if (same) {
                const std::optional<size_t> expected = regions_after(records);
                co_await make_step(pace, tangle, std::move(records), revision);
                if (expected && *expected != tangle->tree.size()) {
                    throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                                  "the tangle has %u regions after it, by the history %zu: it was changed, or made by "
                                  "another version",
                                  tangle->tree.size(), *expected);
                }
            } else {
                co_await make_elsewhere(pace, tangle, std::move(records), revision, map);
            }
        } catch (const Failure& failure) {
            throw Failure(failure.result(), "history.steps[%zu]: %.200s", i, failure.what());
        }
    }
    // From here on the history is made; what remains is to take back.
    size_t undone = request.steps.size() - request.made;
    while (undone > 0) {
        TangleStep& step = *tangle->steps[tangle->made - 1];
        if (step.edit) co_await take_back_edit(pace, *tangle->surface, *step.edit, revision);
        tangle->tree.take_back(step.tree);
        --tangle->made;
        if (!step.goes_on) --undone;
    }
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
    for (; !tangle->steps.empty(); tangle->steps.pop_back()) {
        if (tangle->made < tangle->steps.size()) continue;  // taken back already
        for (StepRemoval removal(*tangle, *tangle->steps.back()); removal.goes_on();) co_await pace;
        --tangle->made;
    }
    std::rethrow_exception(failure);
}

}  // namespace flg
