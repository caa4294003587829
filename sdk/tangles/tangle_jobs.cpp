// SPDX-License-Identifier: MIT
#include "tangles/tangle_jobs.h"

#include <exception>

#include "core/failure.h"
#include "surfaces/surface_update.h"
#include "tangles/look_borders.h"
#include "tangles/region_partition.h"
#include "tangles/room_work.h"
#include "tangles/seed_location.h"
#include "tangles/step_removal.h"
#include "tangles/tangle_operators.h"

namespace flg {

namespace {

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
    for (StepRemoval removal(tangle, step); removal.goes_on();) co_await pace;
    tangle.surface->mesh().region_blocks.doubt(tangle.tree.size());
    std::rethrow_exception(failure);
}

// The steps of a job, behind all others until they are kept: so no memory is needed once they have come to their end.
// Steps that were taken back are forgotten only then.
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
    tangle->base = co_await take_fingerprint(pace, mesh);
    co_await each(pace, mesh.triangle_count(), Cost::some_ns, [&](uint32_t t) { mesh.regions[t] = 0; });
    co_await RegionBlocks::begin(pace, mesh.region_blocks, 0);
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
        for (StepRemoval removal(*tangle, steps.last()); removal.goes_on();) co_await pace;
    }
    // What was undone, and can be made again, may have lost its blocks.
    tangle->surface->mesh().region_blocks.doubt(tangle->tree.size());
    std::rethrow_exception(failure);
}

Task<void> trace_borders(Pace& pace, std::shared_ptr<Tangle> tangle, std::shared_ptr<TracedCurves> out) {
    pace.stage("borders");
    out->curves = co_await look_borders(pace, tangle->surface->mesh(), tangle->tree);
    co_await flatten_curves(pace, *out);
}

// A step is taken back, or made again, whole or not at all. If memory runs out between two that belong together, the
// job fails and the next one goes on from there.
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
