// SPDX-License-Identifier: MIT
#include "tangles/tangle_jobs.h"

#include <exception>

#include "core/failure.h"
#include "surfaces/mesh_edit_replay.h"
#include "surfaces/surface_update.h"
#include "tangles/look_borders.h"
#include "tangles/region_partition.h"

namespace flg {

namespace {

// Each about 10 us.
constexpr uint32_t label_chunk = 10'000;
constexpr uint32_t tree_chunk = 500;
constexpr uint32_t partition_chunk = 100;
constexpr uint32_t replay_chunk = 4000;
constexpr uint32_t borders_chunk = 500;
constexpr uint32_t flatten_chunk = 2000;

// A step: all of it or, if it fails, nothing. It takes no memory to take one back: no call of another task does that.
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
    tangle.tree.take_back(step.tree);
    if (step.edit) {
        drop_solvers(*tangle.surface);  // they may have followed it
        MeshEditReplay back(tangle.surface->mesh(), tangle.surface->columns, *step.edit,
                            MeshEditReplay::Direction::abandon);
        while (!back.run(replay_chunk)) co_await pace;
    }
    std::rethrow_exception(failure);
}

// A place for a step behind those made. Steps that were taken back are forgotten once it has come to its end.
class NextStep {
public:
    NextStep(Tangle& tangle, Memory* memory) : tangle_(tangle), step_(memory) {}

    TangleStep& operator*() { return step_; }
    void keep() {
        while (tangle_.steps.size() > tangle_.made) tangle_.steps.pop_back();
        tangle_.steps.push_back(std::move(step_));
        ++tangle_.made;
    }

private:
    Tangle& tangle_;
    TangleStep step_;
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
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        if (leaves.set.contains(mesh.regions[t])) edit.set_region(mesh, t, leaves.list[0]);
        if (t % label_chunk == 0) co_await pace;
    }
    edit.end(mesh);
    co_await update_after_edit(pace, surface, edit, revision);
}

}  // namespace

Task<void> begin_tangle(Pace& pace, std::shared_ptr<Tangle> tangle) {
    pace.stage("labels");
    pace.commit();
    Mesh& mesh = tangle->surface->mesh();
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        mesh.regions[t] = 0;
        if (t % label_chunk == 0) co_await pace;
    }
}

Task<void> divide_tangle(Pace& pace, std::shared_ptr<Tangle> tangle, DivideRequest request, uint32_t revision) {
    NextStep step(*tangle, pace.memory());
    Task<void> change = divide_regions(pace, *tangle, request, revision, *step);
    co_await run_step(pace, *tangle, *step, change);
    step.keep();
}

// Steps that were forgotten can't come back: so none is until the last operator has come to its end.
Task<void> divide_in_sequence(Pace& pace, std::shared_ptr<Tangle> tangle, std::pmr::vector<DivideRequest> requests,
                              uint32_t revision) {
    std::pmr::deque<NextStep> steps(pace.memory());
    std::exception_ptr failure;
    try {
        for (const DivideRequest& request : requests) {
            NextStep& step = steps.emplace_back(*tangle, pace.memory());
            (*step).goes_on = steps.size() > 1;
            Task<void> change = divide_regions(pace, *tangle, request, revision, *step);
            co_await run_step(pace, *tangle, *step, change);
        }
    } catch (...) {
        failure = std::current_exception();
    }
    if (!failure) {
        for (NextStep& step : steps) step.keep();
        co_return;
    }
    if (!steps.empty()) steps.pop_back();  // the one that failed took itself back
    for (size_t i = steps.size(); i-- > 0;) {
        TangleStep& step = *steps[i];
        if (step.edit) co_await take_back_edit(pace, *tangle->surface, *step.edit, revision);
        tangle->tree.take_back(step.tree);
    }
    std::rethrow_exception(failure);
}

Task<void> displace_tangle(Pace& pace, std::shared_ptr<Tangle> tangle, DisplaceRequest request, uint32_t revision) {
    NextStep step(*tangle, pace.memory());
    Task<void> change = displace_regions(pace, *tangle, request, revision, *step);
    co_await run_step(pace, *tangle, *step, change);
    step.keep();
}

Task<void> group_regions(Pace& pace, std::shared_ptr<Tangle> tangle, std::pmr::vector<RegionId> regions) {
    check_regions(tangle->tree, regions);
    pace.commit();
    NextStep step(*tangle, pace.memory());
    Task<void> change = change_groups(pace, *tangle, regions, false, (*step).tree);
    co_await run_step(pace, *tangle, *step, change);
    step.keep();
}

Task<void> ungroup_regions(Pace& pace, std::shared_ptr<Tangle> tangle, uint32_t group) {
    if (group >= tangle->tree.group_count()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "group is %u, the tangle has %u groups", group,
                      tangle->tree.group_count());
    }
    std::pmr::vector<RegionId> regions(pace.memory());
    for (RegionId r = 0; r < tangle->tree.size(); ++r) {
        if (tangle->tree[r].group == group && tangle->tree[r].joined_into == no_region) regions.push_back(r);
        if (r % tree_chunk == 0) co_await pace;
    }
    pace.commit();
    NextStep step(*tangle, pace.memory());
    Task<void> change = change_groups(pace, *tangle, regions, true, (*step).tree);
    co_await run_step(pace, *tangle, *step, change);
    step.keep();
}

Task<void> join_regions(Pace& pace, std::shared_ptr<Tangle> tangle, std::pmr::vector<RegionId> regions,
                        uint32_t revision) {
    pace.stage("join");
    const LeafSet leaves = co_await list_leaves(pace, tangle->tree, regions, "regions");
    co_await check_connected(pace, tangle->surface->mesh(), leaves);
    pace.commit();
    NextStep step(*tangle, pace.memory());
    Task<void> change = join_leaves(pace, *tangle, leaves, revision, *step);
    co_await run_step(pace, *tangle, *step, change);
    step.keep();
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
        TangleStep& step = tangle->steps[tangle->made - 1];
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
        TangleStep& step = tangle->steps[tangle->made];
        tangle->tree.make_again(step.tree);
        try {
            if (step.edit) co_await make_edit_again(pace, *tangle->surface, *step.edit, revision);
        } catch (...) {
            tangle->tree.take_back(step.tree);
            throw;
        }
        ++tangle->made;
    } while (tangle->made < tangle->steps.size() && tangle->steps[tangle->made].goes_on);
}

}  // namespace flg
