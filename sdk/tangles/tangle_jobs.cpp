// SPDX-License-Identifier: MIT
#include "tangles/tangle_jobs.h"

#include <exception>

#include "core/failure.h"
#include "surfaces/surface_update.h"
#include "tangles/look_borders.h"
#include "tangles/region_partition.h"
#include "tangles/seed_location.h"
#include "tangles/step_removal.h"
#include "tangles/tangle_operators.h"

namespace flg {

namespace {

// Each about 10 us.
constexpr uint32_t fingerprint_chunk = 3000;
constexpr uint32_t label_chunk = 10'000;
constexpr uint32_t join_chunk = 200;
constexpr uint32_t tree_chunk = 500;
constexpr uint32_t partition_chunk = 100;
constexpr uint32_t replay_chunk = 4000;
constexpr uint32_t borders_chunk = 500;
constexpr uint32_t flatten_chunk = 2000;

// A step: all of it or, if it fails, nothing.
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
    StepRemoval removal(tangle, step);
    while (!removal.run(replay_chunk)) co_await pace;
    std::rethrow_exception(failure);
}

// The steps of a job, behind all others until they are kept: so no memory is needed once they have come to their end. Steps that
// were taken back are forgotten only then.
class NewSteps {
public:
    NewSteps(Tangle& tangle, Memory* memory) : tangle_(tangle), memory_(memory), others_(tangle.steps.size()) {}
    ~NewSteps() {
        while (!kept_ && count() > 0) drop_last();
    }

    TangleStep& add(std::shared_ptr<StepRecord> record) {
        const std::pmr::polymorphic_allocator<TangleStep> allocator(memory_);
        tangle_.steps.push_back(std::allocate_shared<TangleStep>(allocator, memory_));
        last().record = std::move(record);
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
        kept_ = true;
    }

private:
    Tangle& tangle_;
    Memory* memory_;
    const size_t others_;
    bool kept_ = false;
};

Task<void> change_groups(Pace& pace, Tangle& tangle, const std::pmr::vector<RegionId>& regions, bool each,
                         TreeEdit& edit) {
    uint32_t group = each ? 0 : tangle.tree.add_group();
    for (size_t i = 0; i < regions.size(); ++i) {
        if (each) group = tangle.tree.add_group();
        tangle.tree.set_group(edit, tangle.tree.resolve(regions[i]), group);
        if (i % tree_chunk == 0) co_await pace;
    }
}

void check_regions(const RegionTree& tree, const std::pmr::vector<RegionId>& regions) {
    for (size_t i = 0; i < regions.size(); ++i) {
        if (regions[i] < tree.size()) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "regions[%zu] is %u, the tangle has %u regions", i, regions[i],
                      tree.size());
    }
}

// Whether leaves are one piece.
Task<void> check_connected(Pace& pace, const Mesh& mesh, const LeafSet& leaves) {
    const std::pmr::deque<Corner> no_edges(pace.memory());
    RegionPartitionKernel partition(mesh, leaves.set, no_edges, pace.memory());
    while (!partition.run(partition_chunk)) co_await pace;
    if (partition.part_count() > 1) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "regions to join are in %u pieces that do not touch",
                      partition.part_count());
    }
}

Task<void> join_leaves(Pace& pace, Tangle& tangle, const LeafSet& leaves, uint32_t revision, TangleStep& step) {
    Surface& surface = *tangle.surface;
    Mesh& mesh = surface.mesh();
    MeshEdit& edit = step.edit.emplace(pace.memory());
    edit.begin(mesh);
    tangle.tree.join(step.tree, leaves.list);
    RegionCursor joined(mesh, leaves.set);
    for (uint32_t passed = 1; !joined.at_end(); ++passed) {
        const uint32_t t = joined.next();
        if (t != no_index) edit.set_region(mesh, t, leaves.list[0]);
        if (passed % join_chunk == 0) co_await pace;
    }
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
    check_regions(tangle.tree, request.regions);
    pace.commit();
    co_await change_groups(pace, tangle, request.regions, false, step.tree);
}

Task<void> ungroup(Pace& pace, Tangle& tangle, const UngroupRequest& request, TangleStep& step) {
    if (request.group >= tangle.tree.group_count()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "group is %u, the tangle has %u groups", request.group,
                      tangle.tree.group_count());
    }
    std::pmr::vector<RegionId> regions(pace.memory());
    for (RegionId r = 0; r < tangle.tree.size(); ++r) {
        const RegionNode& node = tangle.tree[r];
        if (node.group == request.group && node.joined_into == no_region) regions.push_back(r);
        if (r % tree_chunk == 0) co_await pace;
    }
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

// What the step's record asks for.
Task<void> change_tangle(Pace& pace, Tangle& tangle, uint32_t revision, TangleStep& step) {
    StepRecord& record = *step.record;
    record.first_region = tangle.tree.size();
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

Task<void> begin_tangle(Pace& pace, std::shared_ptr<Tangle> tangle) {
    pace.stage("labels");
    pace.commit();
    Mesh& mesh = tangle->surface->mesh();
    MeshFingerprintKernel fingerprint(mesh);
    while (!fingerprint.run(fingerprint_chunk)) co_await pace;
    tangle->base = fingerprint.fingerprint();
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        mesh.regions[t] = 0;
        if (t % label_chunk == 0) co_await pace;
    }
}

Task<void> make_step(Pace& pace, std::shared_ptr<Tangle> tangle, StepRecords records, uint32_t revision) {
    NewSteps steps(*tangle, pace.memory());
    std::exception_ptr failure;
    size_t done = 0;
    try {
        for (std::shared_ptr<StepRecord>& record : records) {
            TangleStep& step = steps.add(std::move(record));
            Task<void> change = change_tangle(pace, *tangle, revision, step);
            co_await run_step(pace, *tangle, step, change);
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
        StepRemoval removal(*tangle, steps.last());
        while (!removal.run(replay_chunk)) co_await pace;
    }
    std::rethrow_exception(failure);
}

Task<void> trace_borders(Pace& pace, std::shared_ptr<Tangle> tangle, std::shared_ptr<TracedCurves> out) {
    pace.stage("borders");
    LookBordersKernel kernel(tangle->surface->mesh(), tangle->tree, out->curves, pace.memory());
    while (!kernel.run(borders_chunk)) co_await pace;
    FlattenCurvesKernel flatten_curves(*out, pace.memory());
    while (!flatten_curves.run(flatten_chunk)) co_await pace;
}

// A step is taken back, or made again, whole or not at all. If memory runs out between two that belong together, the job fails
// and the next one goes on from there.
Task<void> undo_step(Pace& pace, std::shared_ptr<Tangle> tangle, uint32_t revision) {
    if (tangle->made == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the tangle has no step to take back");
    pace.commit();
    for (bool goes_on = true; goes_on && tangle->made > 0; --tangle->made) {
        TangleStep& step = *tangle->steps[tangle->made - 1];
        if (step.edit) co_await take_back_edit(pace, *tangle->surface, *step.edit, revision);
        tangle->tree.take_back(step.tree);
        goes_on = step.goes_on;
    }
}

Task<void> redo_step(Pace& pace, std::shared_ptr<Tangle> tangle, uint32_t revision) {
    if (tangle->made == tangle->steps.size()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the tangle has no step to make again");
    }
    pace.commit();
    do {
        TangleStep& step = *tangle->steps[tangle->made];
        tangle->tree.make_again(step.tree);
        try {
            if (step.edit) co_await make_edit_again(pace, *tangle->surface, *step.edit, revision);
        } catch (...) {
            tangle->tree.take_back(step.tree);
            throw;
        }
        ++tangle->made;
    } while (tangle->made < tangle->steps.size() && tangle->steps[tangle->made]->goes_on);
}

}  // namespace flg
