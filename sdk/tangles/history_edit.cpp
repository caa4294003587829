// SPDX-License-Identifier: MIT
#include "tangles/history_edit.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>

#include "core/failure.h"
#include "runtime/job.h"
#include "surfaces/geodesic_jobs.h"
#include "surfaces/surface_update.h"
#include "tangles/region_names.h"
#include "tangles/room_work.h"
#include "tangles/step_removal.h"
#include "tangles/step_reuse.h"

namespace flg {

namespace {

// ---- To and fro

// Lists of blocks follow only labels that triangles get: those of a step that others came after are listed anew.
Task<void> follow_labels(Pace& pace, Mesh& mesh, const TangleStep& step) {
    const MeshEdit& edit = *step.edit;
    if (!step.tree.added().empty()) co_await RegionBlocks::restart(pace, mesh.region_blocks, step.record->first_region);
    Slice slice(Cost::some_ns);
    for (const MeshEdit::LabelRun& run : edit.labels()) {
        for (Portion part(slice, run.first, run.first + run.count); part.next();) {
            for (uint32_t t = part.begin; t < part.end; ++t) mesh.region_blocks.add(run.label, t);
            if (part.is_over()) co_await pace;
        }
    }
    co_await each(pace, edit.before().triangles, edit.after().triangles, Cost::some_ns,
                  [&](uint32_t t) { mesh.region_blocks.add(mesh.regions[t], t); });
}

enum class Labels { known, forgotten };

Task<void> take_back(Pace& pace, Tangle& tangle, uint32_t revision) {
    TangleStep& step = *tangle.steps[tangle.made - 1];
    if (step.edit) co_await take_back_edit(pace, *tangle.surface, *step.edit, revision);
    tangle.tree.take_back(step.tree);
    --tangle.made;
}

Task<void> make_again(Pace& pace, Tangle& tangle, Labels labels, uint32_t revision) {
    TangleStep& step = *tangle.steps[tangle.made];
    tangle.tree.make_again(step.tree);
    std::exception_ptr failure;
    try {
        if (step.edit) co_await make_edit_again(pace, *tangle.surface, *step.edit, revision);
    } catch (...) {
        failure = std::current_exception();
        tangle.tree.take_back(step.tree);
    }
    if (failure) std::rethrow_exception(failure);
    ++tangle.made;
    if (step.edit && labels == Labels::forgotten) co_await follow_labels(pace, tangle.surface->mesh(), step);
}

Task<void> move_to(Pace& pace, Tangle& tangle, size_t count, Labels labels, uint32_t revision) {
    while (tangle.made > count) co_await take_back(pace, tangle, revision);
    while (tangle.made < count) co_await make_again(pace, tangle, labels, revision);
}

// Each step an act: where the acts there were can't be kept.
void recount_acts(Tangle& tangle) noexcept {
    size_t count = 0;
    tangle.done = 0;
    for (size_t i = 0; i < tangle.steps.size(); ++i) {
        if (tangle.steps[i]->goes_on) continue;
        ++count;
        if (i < tangle.made) ++tangle.done;
    }
    while (tangle.acts.size() > count) tangle.acts.pop_back();
    for (std::shared_ptr<StepTail>& act : tangle.acts) act = nullptr;
}

// ---- An edit

void check_step(size_t step, size_t end, const char* name) {
    if (step >= end)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is %zu, must be below %zu: the steps that are not undone", name,
                      step, end);
}

void check_edit(const HistoryEdit& edit, size_t steps) {
    if (edit.kind == HistoryEdit::Kind::insert) {
        if (edit.step > steps)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "step is %zu, must be at most %zu: the steps that are not undone",
                          edit.step, steps);
        return;
    }
    check_step(edit.step, steps, "step");
    if (edit.kind == HistoryEdit::Kind::move) check_step(edit.to, steps, "to");
}

// A step of the new end.
struct PlannedStep {
    size_t old = no_index;   // of the steps before the edit; no_index: it is the host's, and new
    bool is_target = false;  // not as it was, or not where it was
};

// What the steps from `first` on become.
std::pmr::vector<PlannedStep> plan(const HistoryEdit& edit, size_t first, size_t steps, Memory* memory) {
    using Kind = HistoryEdit::Kind;
    std::pmr::vector<PlannedStep> planned(memory);
    for (size_t i = first; i < steps; ++i) {
        if (edit.kind == Kind::insert && i == edit.step) planned.push_back({no_index, true});
        if (i == edit.step && (edit.kind == Kind::remove || edit.kind == Kind::move)) continue;
        const bool is_target = i == edit.step && (edit.kind == Kind::change || edit.kind == Kind::mute);
        planned.push_back({i, is_target});
    }
    if (edit.kind == Kind::insert && edit.step == steps) planned.push_back({no_index, true});
    const auto at = [&](size_t i) { return planned.begin() + static_cast<std::ptrdiff_t>(i - first); };
    if (edit.kind == Kind::move) planned.insert(at(edit.to), {edit.step, true});
    return planned;
}

// Lines and points keep their places: they are found by these. So are borders, where some of them are chosen.
bool needs_places(const TangleSeeds& seeds) {
    return seeds.curves || !seeds.points.empty();
}
bool chooses_borders(const TangleSeeds& seeds) {
    return !seeds.stretches.empty() || seeds.loops != TangleSeeds::Loops::none;
}

class Rebuilding {
public:
    Rebuilding(Tangle& tangle, size_t first, Memory* memory)
        : after(tangle.steps.begin(), tangle.steps.begin() + static_cast<std::ptrdiff_t>(first),
                tangle.steps.get_allocator()),
          old(memory),
          changes(memory),
          regions(no_region, memory),
          whole(first),
          first_(first) {}

    // The steps after the edit, as far as they are there.
    TangleSteps after;
    // Those before it from the first changed one on; the last one first.
    std::pmr::vector<OldStep> old;
    MeshChanges changes;
    RegionMap regions;
    size_t whole;  // of the steps after the edit: others have taken themselves back

    OldStep& old_step(size_t i) { return old[old.size() - 1 - (i - first_)]; }
    TangleStep& add(Memory* memory, std::shared_ptr<StepRecord> record, uint32_t identity, bool goes_on) {
        const std::pmr::polymorphic_allocator<TangleStep> allocator(memory);
        after.push_back(std::allocate_shared<TangleStep>(allocator, memory));
        after.back()->record = std::move(record);
        after.back()->identity = identity;
        after.back()->goes_on = goes_on;
        return *after.back();
    }

private:
    const size_t first_;
};

Task<void> take_back_all(Pace& pace, Tangle& tangle, size_t first, Rebuilding& work, uint32_t revision) {
    const size_t regions = tangle.tree.size();
    work.old.reserve(tangle.made - first);
    while (tangle.made > first) {
        work.old.emplace_back(tangle.steps[tangle.made - 1], pace.memory());
        co_await take_back(pace, tangle, revision);
        co_await look_back(pace, tangle, work.old.back());
    }
    work.regions = RegionMap(tangle.tree.size(), pace.memory());
    co_await begin(pace, work.regions, regions);
    co_await begin(pace, work.changes, tangle.surface->mesh());
}

// Whether a step's seeds are found by where they were, and whether they are where they were.
struct SeedsFound {
    bool same = true, by_place = false;
};

// Lets a step find its seeds by where they were.
Task<void> give_places(Pace& pace, Tangle& tangle, uint32_t revision, StepRecord& record) {
    auto* const divide = std::get_if<DivideRequest>(&record.request);
    if (!divide) co_return;
    const auto give = [&](TangleSeeds& seeds, SeedAnchors& anchors) {
        if (!anchors.given && seeds.curves) anchors.given_curves = std::const_pointer_cast<TracedCurves>(seeds.curves);
        anchors.given = anchors.known = true;
        if (!anchors.given_curves) return;
        const std::pmr::polymorphic_allocator<TracedCurves> allocator(pace.memory());
        anchors.located_curves = std::allocate_shared<TracedCurves>(allocator, tangle.surface, revision, pace.memory());
    };
    give(divide->a, record.a);
    give(divide->b, record.b);
}

// Gives points of seeds the numbers they have now.
Task<SeedsFound> move_seeds(Pace& pace, const Mesh& mesh, const MeshChanges& changes, StepRecords& records) {
    SeedsFound found;
    bool chooses = false, samples = false, given = false;
    for (const std::shared_ptr<StepRecord>& record : records) {
        auto* const divide = std::get_if<DivideRequest>(&record->request);
        if (!divide) continue;
        given |= record->a.given || record->b.given;
        for (TangleSeeds* seeds : {&divide->a, &divide->b}) {
            chooses |= chooses_borders(*seeds);
            samples |= seeds->sample_radius > 0;
            if (given || !needs_places(*seeds)) continue;
            if (seeds->curves || !co_await move_points(pace, mesh, changes, seeds->points)) found.same = false;
        }
    }
    found.by_place = given || !found.same || (chooses && !samples);
    found.same &= !given;
    co_return found;
}

void say(TangleStep& step, const char* sentence) {
    std::snprintf(step.why.data(), step.why.size(), "%s", sentence);
}

// Takes back what a step's operators made before one of them failed, and marks it as lost.
Task<void> lose(Pace& pace, Tangle& tangle, Rebuilding& work, size_t begin, const char* sentence, uint32_t revision) {
    for (; work.whole > begin; --work.whole) {
        TangleStep& step = *work.after[work.whole - 1];
        if (step.edit) co_await take_back_edit(pace, *tangle.surface, *step.edit, revision);
        tangle.tree.take_back(step.tree);
    }
    for (; work.whole < work.after.size(); ++work.whole) {
        TangleStep& step = *work.after[work.whole];
        step.edit.reset();
        step.tree = TreeEdit(pace.memory());
        tangle.tree.begin(step.tree);
        step.state = StepState::lost;
        step.record->places = {};
    }
    say(*work.after[begin], sentence);
}

// What was there in place of a step, and how it may be made.
struct Remake {
    size_t old_begin, old_count;  // of the steps before the edit
    uint32_t identity;
    bool may_fail;  // it is lost then
    SeedsFound seeds{};
    bool may_reuse = false;
};

// Makes a step anew, or as it was where nothing that it reads has changed.
Task<void> make_planned(Pace& pace, const std::shared_ptr<Tangle>& tangle, Rebuilding& work, StepRecords records,
                        Remake remake, uint32_t revision) {
    const size_t begin = work.after.size();
    const size_t vertex_ranges = work.changes.vertices.range_count(),
                 triangle_ranges = work.changes.triangles.range_count();
    bool given = false;
    std::array<char, 200> sentence{};
    for (size_t r = 0; r < records.size() && sentence[0] == 0; ++r) {
        TangleStep& step = work.add(pace.memory(), records[r], remake.identity, r > 0);
        OldStep* const old = r < remake.old_count ? &work.old_step(remake.old_begin + r) : nullptr;
        if (old && remake.may_reuse && remake.seeds.same) {
            if (co_await use_again(pace, *tangle, *old, revision, work.changes, work.regions, step)) {
                work.whole = work.after.size();
                continue;
            }
        }
        for (size_t rest = r; remake.seeds.by_place && !given && rest < records.size(); ++rest)
            co_await give_places(pace, *tangle, revision, *records[rest]);
        given = true;
        const bool solves = std::holds_alternative<DivideRequest>(records[r]->request) ||
                            std::holds_alternative<DisplaceRequest>(records[r]->request);
        if (solves && !tangle->surface->solvers.blocks) co_await build_blocks(pace, tangle->surface);
        try {
            co_await run_record(pace, *tangle, revision, step);
        } catch (const Failure& stop) {
            const bool ends = stop.result() == FLG_ERROR_OUT_OF_MEMORY || stop.result() == FLG_ERROR_CANCELLED;
            if (ends || !remake.may_fail) throw;
            std::snprintf(sentence.data(), sentence.size(), "%s", stop.what());
        }
        if (sentence[0] != 0) break;
        work.whole = work.after.size();
        co_await mark_new(pace, tangle->surface->mesh(), step, work.changes);
        if (!old) continue;
        co_await mark_old(pace, *old, work.changes);
        co_await follow_anew(pace, *old->step, step, work.regions);
    }
    const bool lost = sentence[0] != 0;
    for (size_t r = work.after.size() - begin; lost && r < records.size(); ++r)
        work.add(pace.memory(), records[r], remake.identity, true);
    if (lost) {
        co_await lose(pace, *tangle, work, begin, sentence.data(), revision);
        work.changes.vertices.forget_after(vertex_ranges);
        work.changes.triangles.forget_after(triangle_ranges);
        for (size_t r = 0; r < remake.old_count; ++r) {
            const TangleStep& old = *work.old_step(remake.old_begin + r).step;
            co_await each(pace, old.tree.added().size(), Cost::some_ns,
                          [&](uint32_t i) { work.regions.set(old.record->first_region + i, no_region); });
        }
    }
    for (size_t r = lost ? 0 : records.size(); r < remake.old_count; ++r)
        co_await mark_old(pace, work.old_step(remake.old_begin + r), work.changes);
}

// A step that does nothing.
Task<void> leave_out(Pace& pace, Tangle& tangle, Rebuilding& work, StepRecords records, const Remake& remake,
                     StepState state, const char* sentence) {
    const size_t begin = work.after.size();
    for (size_t r = 0; r < records.size(); ++r) {
        TangleStep& step = work.add(pace.memory(), std::move(records[r]), remake.identity, r > 0);
        tangle.tree.begin(step.tree);
        step.state = state;
        step.record->places = {};
    }
    work.whole = work.after.size();
    say(*work.after[begin], sentence);
    for (size_t r = 0; r < remake.old_count; ++r)
        co_await mark_old(pace, work.old_step(remake.old_begin + r), work.changes);
}

constexpr const char* regions_gone = "the regions it acts on, or begins at, are not there";

// A step that the host has described.
Task<void> make_given(Pace& pace, const std::shared_ptr<Tangle>& tangle, HistoryEdit& edit, Remake remake,
                      Rebuilding& work, uint32_t revision) {
    const bool muted = remake.old_count > 0 && work.old_step(remake.old_begin).step->state == StepState::muted;
    if (edit.records[0]->wanted) {
        const RegionsFound found =
            co_await find_regions(pace, tangle->tree, tangle->steps, work.after, work.regions, edit.records);
        if (!found.enough) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s", regions_gone);
    }
    if (muted) {
        co_await leave_out(pace, *tangle, work, std::move(edit.records), remake, StepState::muted, "");
    } else {
        co_await make_planned(pace, tangle, work, std::move(edit.records), remake, revision);
    }
}

// One step of the plan.
Task<void> rebuild_step(Pace& pace, const std::shared_ptr<Tangle>& tangle, HistoryEdit& edit, PlannedStep planned,
                        const std::pmr::vector<size_t>& begins, Rebuilding& work, uint32_t revision) {
    Remake remake{.old_begin = 0, .old_count = 0, .identity = 0, .may_fail = true};
    if (planned.old != no_index) {
        remake.old_begin = begins[planned.old];
        remake.old_count = begins[planned.old + 1] - remake.old_begin;
        remake.identity = work.old_step(remake.old_begin).step->identity;
    }
    if (planned.is_target && !edit.records.empty()) {
        if (remake.identity == 0) remake.identity = ++tangle->last_identity;
        remake.may_fail = false;  // what the host asks for has to be possible
        co_await make_given(pace, tangle, edit, remake, work, revision);
        co_return;
    }
    const TangleStep& old = *work.old_step(remake.old_begin).step;
    StepRecords records(pace.memory());
    for (size_t r = 0; r < remake.old_count; ++r)
        records.push_back(co_await copy_record(pace, *work.old_step(remake.old_begin + r).step->record));
    const RegionsFound found =
        co_await find_regions(pace, tangle->tree, tangle->steps, work.after, work.regions, records);
    remake.seeds = co_await move_seeds(pace, tangle->surface->mesh(), work.changes, records);
    remake.may_reuse = !planned.is_target;
    const bool mutes = planned.is_target && edit.kind == HistoryEdit::Kind::mute;
    const bool muted = mutes ? edit.muted : old.state == StepState::muted;
    if (muted || !found.enough) {
        for (size_t r = 0; !remake.seeds.same && r < records.size(); ++r)
            co_await give_places(pace, *tangle, revision, *records[r]);
        co_await leave_out(pace, *tangle, work, std::move(records), remake, muted ? StepState::muted : StepState::lost,
                           muted ? "" : regions_gone);
        co_return;
    }
    const size_t begin = work.after.size();
    co_await make_planned(pace, tangle, work, std::move(records), remake, revision);
    TangleStep& step = *work.after[begin];
    if (found.found < found.wanted && step.state == StepState::made)
        std::snprintf(step.why.data(), step.why.size(), "%zu of its %zu regions are not there",
                      found.wanted - found.found, found.wanted);
}

// Names of a host say which steps they are of by places in the history, not by identities.
void name_steps(const Tangle& tangle, const std::pmr::vector<size_t>& begins, StepRecord& record) {
    if (!record.wanted) return;
    auto& wanted = const_cast<WantedRegions&>(*record.wanted);  // it is the edit's own
    for (WantedRegions::Name& name : wanted.names)
        name.step = name.step < begins.size() - 1 ? tangle.steps[begins[name.step]]->identity : no_index;
}

void stop_if_cancelled(const Pace& pace) {
    if (pace.job().cancelled.load(std::memory_order_relaxed))
        throw Failure(FLG_ERROR_CANCELLED, "the job was cancelled");
}

// Back to the steps before the edit.
Task<void> abandon(Pace& pace, Tangle& tangle, Rebuilding& work, size_t first, size_t made, uint32_t revision) {
    while (work.after.size() > work.whole) work.after.pop_back();
    for (size_t i = work.after.size(); i-- > first;) {
        for (StepRemoval removal(tangle, *work.after[i]); removal.goes_on();) co_await pace;
        work.after.pop_back();
    }
    tangle.surface->mesh().region_blocks.doubt(tangle.tree.size());
    try {
        co_await move_to(pace, tangle, made, Labels::forgotten, revision);
    } catch (...) {
        recount_acts(tangle);
    }
}

}  // namespace

std::pmr::vector<size_t> step_begins(const Tangle& tangle, size_t made, Memory* memory) {
    std::pmr::vector<size_t> begins(memory);
    for (size_t i = 0; i < made; ++i)
        if (!tangle.steps[i]->goes_on) begins.push_back(i);
    begins.push_back(made);
    return begins;
}

Task<void> go_to(Pace& pace, Tangle& tangle, size_t count, uint32_t revision) {
    const size_t made = tangle.made;
    std::exception_ptr failure;
    try {
        co_await move_to(pace, tangle, count, Labels::known, revision);
    } catch (...) {
        failure = std::current_exception();
    }
    if (!failure) co_return;
    try {
        co_await move_to(pace, tangle, made, Labels::known, revision);
    } catch (...) {
        recount_acts(tangle);
    }
    std::rethrow_exception(failure);
}

Task<void> exchange_tail(Pace& pace, Tangle& tangle, StepTail& tail, uint32_t revision) {
    const size_t made = tangle.made, first = tail.first, other = first + tail.steps.size();
    const auto at = [&](size_t i) { return tangle.steps.begin() + static_cast<std::ptrdiff_t>(i); };
    TangleSteps steps(at(0), at(first), tangle.steps.get_allocator());
    steps.insert(steps.end(), tail.steps.begin(), tail.steps.end());
    steps.insert(steps.end(), at(made), tangle.steps.end());
    TangleSteps end(at(first), at(made), tangle.steps.get_allocator());
    bool exchanged = false;
    const auto exchange = [&]() noexcept {
        tangle.steps.swap(steps);
        tail.steps.swap(end);
        exchanged = !exchanged;
    };
    std::exception_ptr failure;
    try {
        co_await move_to(pace, tangle, first, Labels::known, revision);
        exchange();
        co_await move_to(pace, tangle, other, Labels::forgotten, revision);
    } catch (...) {
        failure = std::current_exception();
    }
    if (!failure) co_return;
    try {
        if (exchanged) {
            co_await move_to(pace, tangle, first, Labels::known, revision);
            exchange();
        }
        co_await move_to(pace, tangle, made, Labels::forgotten, revision);
    } catch (...) {
        recount_acts(tangle);
    }
    std::rethrow_exception(failure);
}

Task<void> edit_history(Pace& pace, std::shared_ptr<Tangle> tangle, HistoryEdit edit, uint32_t revision) {
    const size_t made = tangle->made;
    const std::pmr::vector<size_t> begins = step_begins(*tangle, made, pace.memory());
    check_edit(edit, begins.size() - 1);
    if (!edit.records.empty()) name_steps(*tangle, begins, *edit.records[0]);
    const bool moves = edit.kind == HistoryEdit::Kind::move;
    const size_t first_step = moves ? std::min(edit.step, edit.to) : edit.step;
    const size_t first = begins[first_step];
    const std::pmr::vector<PlannedStep> planned = plan(edit, first_step, begins.size() - 1, pace.memory());
    const auto tail = std::allocate_shared<StepTail>(std::pmr::polymorphic_allocator<StepTail>(pace.memory()), first,
                                                     tangle->steps.get_allocator());
    tail->steps.assign(tangle->steps.begin() + static_cast<std::ptrdiff_t>(first),
                       tangle->steps.begin() + static_cast<std::ptrdiff_t>(made));
    const std::pmr::vector<std::shared_ptr<StepTail>> undone(
        tangle->acts.begin() + static_cast<std::ptrdiff_t>(tangle->done), tangle->acts.end(), pace.memory());
    Rebuilding work(*tangle, first, pace.memory());
    tangle->computed = 0;
    pace.commit();
    std::exception_ptr failure;
    try {
        co_await take_back_all(pace, *tangle, first, work, revision);
        // What is not where it was is missed from there on.
        bool is_missed = moves || edit.kind == HistoryEdit::Kind::remove;
        for (const PlannedStep& step : planned) {
            stop_if_cancelled(pace);
            if (is_missed && step.old != no_index && step.old > edit.step) {
                for (size_t i = begins[edit.step]; i < begins[edit.step + 1]; ++i)
                    co_await mark_old(pace, work.old_step(i), work.changes);
                is_missed = false;
            }
            co_await rebuild_step(pace, tangle, edit, step, begins, work, revision);
        }
        begin_act(*tangle, tail);
    } catch (...) {
        failure = std::current_exception();
    }
    if (failure) {
        co_await abandon(pace, *tangle, work, first, made, revision);
        std::rethrow_exception(failure);
    }
    tangle->steps.swap(work.after);
    tangle->made = tangle->steps.size();
    keep_act(*tangle);
    // What was undone before is forgotten.
    for (; !work.after.empty(); work.after.pop_back()) co_await pace;
    for (const std::shared_ptr<StepTail>& end : undone)
        for (; end && !end->steps.empty(); end->steps.pop_back()) co_await pace;
}

}  // namespace flg
