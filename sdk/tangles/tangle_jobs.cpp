// SPDX-License-Identifier: MIT
#include "tangles/tangle_jobs.h"

#include <exception>

#include "core/failure.h"
#include "surfaces/surface_update.h"
#include "tangles/history_edit.h"
#include "tangles/look_borders.h"
#include "tangles/region_partition.h"
#include "tangles/room_work.h"
#include "tangles/seed_location.h"
#include "tangles/step_removal.h"
#include "tangles/tangle_operators.h"

namespace flg {

Task<void> run_step(Pace& pace, Tangle& tangle, TangleStep& step, Task<void>& change) {
    tangle.tree.begin(step.tree);
    std::exception_ptr failure;
    try {
        co_await std::move(change);
        tangle.tree.end(step.tree);
    } catch (...) {
        failure = std::current_exception();
    }
    if (!failure) co_return;
    const bool updated = !pace.is_revocable();  // an update settles
    pace.settle();
    for (StepRemoval removal(tangle, step, updated); removal.goes_on();) co_await pace;
    tangle.surface->mesh().region_blocks.doubt(tangle.tree.size());
    std::rethrow_exception(failure);
}

void begin_act(Tangle& tangle, std::shared_ptr<StepTail> tail) {
    tangle.acts.push_back(std::move(tail));
}

void keep_act(Tangle& tangle) noexcept {
    const auto at = [&](size_t i) { return tangle.acts.begin() + static_cast<std::ptrdiff_t>(i); };
    tangle.acts.erase(at(tangle.done), at(tangle.acts.size() - 1));
    tangle.done = tangle.acts.size();
}

namespace {

// The steps of a job, behind all others until they are kept: so no memory is needed once they have come to their end.
// Steps that were taken back are forgotten only then.
class NewSteps {
public:
    NewSteps(Tangle& tangle, Memory* memory)
        : tangle_(tangle), memory_(memory), others_(tangle.steps.size()), identity_(++tangle.last_identity) {
        begin_act(tangle, nullptr);
    }
    ~NewSteps() {
        if (kept_) return;
        while (count() > 0) drop_last();
        tangle_.acts.pop_back();
    }

    TangleStep& add(std::shared_ptr<StepRecord> record) {
        const std::pmr::polymorphic_allocator<TangleStep> allocator(memory_);
        tangle_.steps.push_back(std::allocate_shared<TangleStep>(allocator, memory_));
        last().record = std::move(record);
        last().identity = identity_;
        last().goes_on = count() > 1;
        return last();
    }
    size_t count() const { return tangle_.steps.size() - others_; }
    TangleStep& last() { return *tangle_.steps.back(); }
    void drop_last() { tangle_.steps.pop_back(); }
    void keep() {
        const auto at = [&](size_t i) { return tangle_.steps.begin() + static_cast<std::ptrdiff_t>(i); };
        tangle_.steps.erase(at(tangle_.made), at(others_));
        tangle_.made = tangle_.steps.size();
        keep_act(tangle_);
        kept_ = true;
    }

private:
    Tangle& tangle_;
    Memory* memory_;
    const size_t others_;
    const uint32_t identity_;
    bool kept_ = false;
};

// What a step computes must not depend on how fine its mesh is elsewhere: the mean edge is that of the first mesh.
void fix_edge(Surface& surface) {
    GeodesicSolvers& solvers = surface.solvers;
    if (!solvers.blocks || solvers.fixed_edge > 0) return;
    solvers.fixed_edge = solvers.blocks->edges.mean();
    solvers.blocks->edges.fix_mean(solvers.fixed_edge);
}

Task<void> change_groups(Pace& pace, Tangle& tangle, const std::pmr::vector<RegionId>& regions, bool one_each,
                         TreeEdit& edit) {
    uint32_t group = one_each ? 0 : tangle.tree.add_group();
    co_await each(pace, regions.size(), Cost::tens_of_ns, [&](uint32_t i) {
        if (one_each) group = tangle.tree.add_group();
        tangle.tree.set_group(edit, tangle.tree.resolve(regions[i]), group);
    });
}

Task<void> check_regions(Pace& pace, const RegionTree& tree, const std::pmr::vector<RegionId>& regions) {
    return each(pace, regions.size(), Cost::some_ns, [&](uint32_t i) {
        if (regions[i] < tree.size()) return;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "regions[%u] is %u, the tangle has %u regions", i, regions[i],
                      tree.size());
    });
}

// Whether leaves are one piece.
Task<void> check_connected(Pace& pace, const Mesh& mesh, const LeafSet& leaves) {
    const std::pmr::deque<Corner> no_edges(pace.memory());
    const RegionPartition partition = co_await partition_regions(pace, mesh, leaves.set, no_edges);
    if (partition.part_count > 1) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "regions to join are in %u pieces that do not touch",
                      partition.part_count);
    }
}

Task<void> join_leaves(Pace& pace, Tangle& tangle, const LeafSet& leaves, uint32_t revision, TangleStep& step) {
    Surface& surface = *tangle.surface;
    Mesh& mesh = surface.mesh();
    MeshEdit& edit = step.edit.emplace(pace.memory());
    edit.begin(mesh);
    tangle.tree.join(step.tree, leaves.list);
    co_await each_within(pace, mesh, leaves.set, Cost::tens_of_ns,
                         [&](uint32_t t) { edit.set_region(mesh, t, leaves.list[0]); });
    edit.end(mesh);
    co_await update_after_edit(pace, surface, edit, revision);
}

Task<void> divide(Pace& pace, Tangle& tangle, const DivideRequest& request, uint32_t revision, TangleStep& step) {
    StepRecord& record = *step.record;
    const Mesh& mesh = tangle.surface->mesh();
    co_await locate_seeds(pace, mesh, record);
    co_await record_seeds(pace, mesh, record);
    co_await divide_regions(pace, tangle, request, revision, step);
    co_await record_places(pace, mesh, tangle.tree.size(), record);
}

Task<void> group(Pace& pace, Tangle& tangle, const GroupRequest& request, TangleStep& step) {
    co_await check_regions(pace, tangle.tree, request.regions);
    pace.commit();
    co_await change_groups(pace, tangle, request.regions, false, step.tree);
}

Task<void> ungroup(Pace& pace, Tangle& tangle, const UngroupRequest& request, TangleStep& step) {
    if (request.group >= tangle.tree.group_count()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "group is %u, the tangle has %u groups", request.group,
                      tangle.tree.group_count());
    }
    std::pmr::vector<RegionId> regions(pace.memory());
    co_await each(pace, tangle.tree.size(), Cost::tens_of_ns, [&](RegionId r) {
        const RegionNode& node = tangle.tree[r];
        if (node.group == request.group && node.joined_into == no_region) regions.push_back(r);
    });
    step.record->first_region = regions.empty() ? no_region : regions[0];
    pace.commit();
    co_await change_groups(pace, tangle, regions, true, step.tree);
}

Task<void> join(Pace& pace, Tangle& tangle, const JoinRequest& request, uint32_t revision, TangleStep& step) {
    pace.stage("join");
    const LeafSet leaves = co_await list_leaves(pace, tangle.tree, request.regions, "regions");
    co_await check_connected(pace, tangle.surface->mesh(), leaves);
    pace.commit();
    co_await join_leaves(pace, tangle, leaves, revision, step);
}

Task<void> change_tangle(Pace& pace, Tangle& tangle, uint32_t revision, TangleStep& step) {
    StepRecord& record = *step.record;
    const bool ungroups = std::holds_alternative<UngroupRequest>(record.request);
    const bool groups = ungroups || std::holds_alternative<GroupRequest>(record.request);
    if (!ungroups) record.first_region = tangle.tree.size();
    if (!groups) ++tangle.computed;
    fix_edge(*tangle.surface);
    if (const auto* const to_divide = std::get_if<DivideRequest>(&record.request)) {
        co_await divide(pace, tangle, *to_divide, revision, step);
    } else if (const auto* const to_displace = std::get_if<DisplaceRequest>(&record.request)) {
        co_await displace_regions(pace, tangle, *to_displace, revision, step);
    } else if (const auto* const to_group = std::get_if<GroupRequest>(&record.request)) {
        co_await group(pace, tangle, *to_group, step);
    } else if (const auto* const to_ungroup = std::get_if<UngroupRequest>(&record.request)) {
        co_await ungroup(pace, tangle, *to_ungroup, step);
    } else {
        co_await join(pace, tangle, std::get<JoinRequest>(record.request), revision, step);
    }
}

}  // namespace

Task<void> run_record(Pace& pace, Tangle& tangle, uint32_t revision, TangleStep& step) {
    Task<void> change = change_tangle(pace, tangle, revision, step);
    co_await run_step(pace, tangle, step, change);
}

constexpr double speck_share = 1e-6;  // of the surface

Task<void> begin_tangle(Pace& pace, std::shared_ptr<Tangle> tangle) {
    pace.stage("labels");
    pace.commit();
    Mesh& mesh = tangle->surface->mesh();
    tangle->base = co_await take_fingerprint(pace, mesh);
    tangle->least_area = speck_share * (co_await measure_extent(pace, mesh)).area;
    GeodesicSolvers& solvers = tangle->surface->solvers;
    solvers.fixed_edge = 0;
    if (solvers.blocks) solvers.blocks->edges.fix_mean(0);
    co_await each(pace, mesh.triangle_count(), Cost::some_ns, [&](uint32_t t) { mesh.regions[t] = 0; });
    co_await RegionBlocks::begin(pace, mesh.region_blocks, 0);
}

Task<void> make_step(Pace& pace, std::shared_ptr<Tangle> tangle, StepRecords records, uint32_t revision) {
    NewSteps steps(*tangle, pace.memory());
    std::exception_ptr failure;
    size_t done = 0;
    tangle->computed = 0;
    try {
        for (std::shared_ptr<StepRecord>& record : records) {
            TangleStep& step = steps.add(std::move(record));
            pace.begin_revocable();
            co_await run_record(pace, *tangle, revision, step);
            pace.settle();
            ++done;
        }
    } catch (...) {
        failure = std::current_exception();
    }
    if (!failure) {
        steps.keep();
        co_return;
    }
    if (steps.count() > done) steps.drop_last();  // took itself back
    for (; steps.count() > 0; steps.drop_last()) {
        for (StepRemoval removal(*tangle, steps.last()); removal.goes_on();) co_await pace;
    }
    // What was undone, and can be made again, may have lost its blocks.
    tangle->surface->mesh().region_blocks.doubt(tangle->tree.size());
    std::rethrow_exception(failure);
}

Task<void> leave_step(Pace& pace, std::shared_ptr<Tangle> tangle, StepRecords records, StepState state,
                      const char* why) {
    NewSteps steps(*tangle, pace.memory());
    pace.commit();
    for (std::shared_ptr<StepRecord>& record : records) {
        TangleStep& step = steps.add(std::move(record));
        tangle->tree.begin(step.tree);
        step.state = state;
        step.record->places = {};
        if (!step.goes_on) std::snprintf(step.why.data(), step.why.size(), "%s", why);
        co_await pace;
    }
    steps.keep();
}

Task<void> trace_borders(Pace& pace, std::shared_ptr<Tangle> tangle, std::shared_ptr<TracedCurves> out) {
    pace.stage("borders");
    out->curves = co_await look_borders(pace, tangle->surface->mesh(), tangle->tree);
    co_await flatten_curves(pace, *out);
}

Task<void> undo_step(Pace& pace, std::shared_ptr<Tangle> tangle, uint32_t revision) {
    if (tangle->done == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the tangle has no step to take back");
    pace.commit();
    tangle->computed = 0;
    if (const std::shared_ptr<StepTail> tail = tangle->acts[tangle->done - 1]) {
        co_await exchange_tail(pace, *tangle, *tail, revision);
    } else {
        size_t count = tangle->made - 1;
        while (tangle->steps[count]->goes_on) --count;
        co_await go_to(pace, *tangle, count, revision);
    }
    --tangle->done;
}

Task<void> redo_step(Pace& pace, std::shared_ptr<Tangle> tangle, uint32_t revision) {
    if (tangle->done == tangle->acts.size()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the tangle has no step to make again");
    }
    pace.commit();
    tangle->computed = 0;
    if (const std::shared_ptr<StepTail> tail = tangle->acts[tangle->done]) {
        co_await exchange_tail(pace, *tangle, *tail, revision);
    } else {
        size_t count = tangle->made + 1;
        while (count < tangle->steps.size() && tangle->steps[count]->goes_on) ++count;
        co_await go_to(pace, *tangle, count, revision);
    }
    ++tangle->done;
}

}  // namespace flg
