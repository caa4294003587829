// SPDX-License-Identifier: MIT
// Steps before the last one changed, inserted, moved, removed, muted: the tangle is what its history makes of its first
// mesh, to the bit, whatever was kept.
#include <functional>

#include "tangles/random_session.h"

namespace flg::test {
namespace {

const Regions root = {0};

FlgTangleHistory history_of(const TangleHost& host, FlgTangle tangle) {
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    EXPECT_EQ(flgTangleGetHistory(host.context, tangle, &history), FLG_OK) << flgErrorGetMessage();
    return history;
}

FlgTangleStep step_of(const TangleHost& host, FlgTangle tangle, uint32_t index) {
    return *history_of(host, tangle).steps[index];
}

std::string state(const TangleHost& host, FlgSurface surface, FlgTangle tangle) {
    return bits(host.view(surface)) + host.tree_bits(tangle);
}

using Start = std::function<FlgResult(FlgJob*)>;

FlgResult run(const TangleHost& host, const Start& start) {
    FlgJob job{};
    const FlgResult started = start(&job);
    if (started != FLG_OK) return started;
    host.finish(host.budget_us);
    return host.result_of(job);
}

// What changes the history of a tangle, in one line each.
struct Editor {
    const TangleHost& host;
    FlgTangle tangle;

    FlgResult edit(uint32_t step, const FlgTangleStep& desc) const {
        return run(host,
                   [&](FlgJob* job) { return flgTangleEditStep(host.context, tangle, step, &desc, nullptr, job); });
    }
    FlgResult insert(uint32_t step, const FlgTangleStep& desc) const {
        return run(host,
                   [&](FlgJob* job) { return flgTangleInsertStep(host.context, tangle, step, &desc, nullptr, job); });
    }
    FlgResult move(uint32_t step, uint32_t to) const {
        return run(host, [&](FlgJob* job) { return flgTangleMoveStep(host.context, tangle, step, to, nullptr, job); });
    }
    FlgResult remove(uint32_t step) const {
        return run(host, [&](FlgJob* job) { return flgTangleRemoveStep(host.context, tangle, step, nullptr, job); });
    }
    FlgResult mute(uint32_t step, bool muted) const {
        return run(host, [&](FlgJob* job) {
            return flgTangleMuteStep(host.context, tangle, step, muted ? 1 : 0, nullptr, job);
        });
    }
    FlgResult set_delta(uint32_t step, float delta) const {
        const FlgTangleStep before = step_of(host, tangle, step);
        FlgTangleDivideDesc desc = *before.divide;
        desc.delta = delta;
        FlgTangleStep changed = before;
        changed.divide = &desc;
        return edit(step, changed);
    }
};

// The places in the history that differ from those of another, as sentences.
void expect_same_places(const FlgTangleHistory& a, const FlgTangleHistory& b) {
    ASSERT_EQ(a.step_count, b.step_count);
    for (uint32_t i = 0; i < a.step_count; ++i) {
        SCOPED_TRACE("step " + std::to_string(i));
        EXPECT_EQ(a.steps[i]->state, b.steps[i]->state);
        EXPECT_STREQ(a.steps[i]->why, b.steps[i]->why);
        EXPECT_EQ(a.steps[i]->name_count, b.steps[i]->name_count);
        ASSERT_EQ(a.steps[i]->made_count, b.steps[i]->made_count);
        const size_t count = size_t{3} * a.steps[i]->made_count;
        EXPECT_TRUE(std::equal(a.steps[i]->made, a.steps[i]->made + count, b.steps[i]->made));
    }
}

// The tangle is what its history makes of the same mesh.
void expect_like_fresh(const TangleHost& host, const MeshArrays& mesh, FlgSurface surface, FlgTangle tangle) {
    const TangleHost other;
    const FlgSurface copy = other.surface(mesh);
    const FlgTangle again = other.tangle(copy);
    const FlgTangleHistory history = history_of(host, tangle);
    FlgJob job{};
    ASSERT_EQ(flgTangleReplay(other.context, again, &history, nullptr, &job), FLG_OK) << flgErrorGetMessage();
    other.finish();
    ASSERT_EQ(other.result_of(job), FLG_OK) << other.status_of(job).error;
    EXPECT_TRUE(bits(other.view(copy)) == bits(host.view(surface)));
    EXPECT_TRUE(other.tree_bits(again) == host.tree_bits(tangle));
    expect_same_places(history, history_of(other, again));
}

// So fine that the bands of neighbours do not share a triangle.
const MeshArrays& fine() {
    static const MeshArrays mesh = sphere(40);
    return mesh;
}

// Cells, and a band in each of the first ones.
struct Cells {
    static constexpr uint32_t bands = 6;

    explicit Cells(const TangleHost& host, const MeshArrays& mesh = fine())
        : surface(host.surface(mesh)), tangle(host.tangle(surface)), editor{host, tangle} {
        FlgTangleDivideDesc desc = contour(tangle, root, samples(0.6f), 0.1f, 1);
        desc.kind = FLG_TANGLE_OPERATOR_VORONOI;
        EXPECT_EQ(host.divide(desc), FLG_OK);
        for (uint32_t cell = 1; cell <= bands; ++cell)
            EXPECT_EQ(host.divide(contour(tangle, {cell}, borders(FLG_TANGLE_BORDERS_OUTER), 0.08f, 1)), FLG_OK);
    }

    FlgSurface surface;
    FlgTangle tangle;
    Editor editor;
};

TEST(TangleEdits, ChangedNumbersGiveWhatAFreshReplayGives) {
    const TangleHost host;
    const Cells cells(host);
    const std::string before = state(host, cells.surface, cells.tangle);
    ASSERT_EQ(cells.editor.set_delta(2, 0.05f), FLG_OK);
    const std::string after = state(host, cells.surface, cells.tangle);
    EXPECT_FALSE(after == before);
    EXPECT_EQ(step_of(host, cells.tangle, 2).divide->delta, 0.05f);
    expect_like_fresh(host, fine(), cells.surface, cells.tangle);
    expect_valid(host, cells.surface, cells.tangle, whole_area(host.view(cells.surface)));
    // An edit is undone and redone like a step.
    EXPECT_EQ(host.info(cells.tangle).undo_count, Cells::bands + 2);
    ASSERT_EQ(host.undo(cells.tangle), FLG_OK);
    EXPECT_TRUE(state(host, cells.surface, cells.tangle) == before);
    EXPECT_EQ(step_of(host, cells.tangle, 2).divide->delta, 0.08f);
    EXPECT_EQ(host.info(cells.tangle).redo_count, 1u);
    ASSERT_EQ(host.redo(cells.tangle), FLG_OK);
    EXPECT_TRUE(state(host, cells.surface, cells.tangle) == after);
    for (uint32_t i = 0; i < Cells::bands + 2; ++i) ASSERT_EQ(host.undo(cells.tangle), FLG_OK);
    EXPECT_EQ(host.info(cells.tangle).region_count, 1u);
    for (uint32_t i = 0; i < Cells::bands + 2; ++i) ASSERT_EQ(host.redo(cells.tangle), FLG_OK);
    EXPECT_TRUE(state(host, cells.surface, cells.tangle) == after);
}

TEST(TangleEdits, OnlyWhatTheEditReachesIsComputedAgain) {
    const TangleHost host;
    const Cells cells(host);
    // A band within a band, far from the cell that is edited.
    const uint32_t inner = host.children(cells.tangle, 6)[0];
    ASSERT_EQ(host.divide(contour(cells.tangle, {inner}, borders(FLG_TANGLE_BORDERS_OUTER), 0.02f, 1)), FLG_OK);
    ASSERT_EQ(cells.editor.set_delta(1, 0.05f), FLG_OK);
    EXPECT_EQ(host.info(cells.tangle).computed_count, 1u) << "bands do not reach the borders of their cells";
    expect_like_fresh(host, fine(), cells.surface, cells.tangle);
    ASSERT_EQ(cells.editor.mute(1, true), FLG_OK);
    EXPECT_EQ(host.info(cells.tangle).computed_count, 0u);
    expect_like_fresh(host, fine(), cells.surface, cells.tangle);
    ASSERT_EQ(cells.editor.set_delta(6, 0.1f), FLG_OK);
    EXPECT_EQ(host.info(cells.tangle).computed_count, 2u) << "the one in it too";
    expect_like_fresh(host, fine(), cells.surface, cells.tangle);
    ASSERT_EQ(host.undo(cells.tangle), FLG_OK);
    EXPECT_EQ(host.info(cells.tangle).computed_count, 0u);
}

TEST(TangleEdits, MutedStepsDoNothingUntilTheyAreHeardAgain) {
    const TangleHost host;
    const Cells cells(host);
    const std::string before = state(host, cells.surface, cells.tangle);
    ASSERT_EQ(cells.editor.mute(3, true), FLG_OK);
    EXPECT_EQ(step_of(host, cells.tangle, 3).state, FLG_TANGLE_STEP_STATE_MUTED);
    EXPECT_EQ(host.region(cells.tangle, 3).child_count, 0u);
    EXPECT_GT(host.region(cells.tangle, 4).child_count, 0u);
    expect_like_fresh(host, fine(), cells.surface, cells.tangle);
    // Its numbers may change while it is.
    ASSERT_EQ(cells.editor.set_delta(3, 0.04f), FLG_OK);
    EXPECT_EQ(step_of(host, cells.tangle, 3).state, FLG_TANGLE_STEP_STATE_MUTED);
    ASSERT_EQ(cells.editor.set_delta(3, 0.08f), FLG_OK);
    ASSERT_EQ(cells.editor.mute(3, false), FLG_OK);
    EXPECT_TRUE(state(host, cells.surface, cells.tangle) == before);
    expect_like_fresh(host, fine(), cells.surface, cells.tangle);
}

TEST(TangleEdits, WhatHasNoRegionLeftIsLostUntilItComesBack) {
    const TangleHost host;
    const Cells cells(host);
    const uint32_t inner = host.children(cells.tangle, 5)[1];
    ASSERT_EQ(host.divide(contour(cells.tangle, {inner}, borders(FLG_TANGLE_BORDERS_OUTER), 0.02f, 1)), FLG_OK);
    const uint32_t last = Cells::bands + 1;
    const std::string before = state(host, cells.surface, cells.tangle);
    ASSERT_EQ(cells.editor.mute(5, true), FLG_OK);
    const FlgTangleStep lost = step_of(host, cells.tangle, last);
    EXPECT_EQ(lost.state, FLG_TANGLE_STEP_STATE_LOST);
    EXPECT_STREQ(lost.why, "the regions it acts on, or begins at, are not there");
    ASSERT_EQ(lost.name_count, 3u) << "the root, the cell and its inner part";
    EXPECT_EQ(lost.names[2].step, 5u);
    EXPECT_EQ(lost.names[2].part, host.region(cells.tangle, 0).part + 1);
    expect_like_fresh(host, fine(), cells.surface, cells.tangle);
    ASSERT_EQ(cells.editor.set_delta(1, 0.06f), FLG_OK);
    EXPECT_EQ(step_of(host, cells.tangle, last).state, FLG_TANGLE_STEP_STATE_LOST);
    ASSERT_EQ(cells.editor.set_delta(1, 0.08f), FLG_OK);
    ASSERT_EQ(cells.editor.mute(5, false), FLG_OK);
    EXPECT_EQ(step_of(host, cells.tangle, last).state, FLG_TANGLE_STEP_STATE_MADE);
    EXPECT_STREQ(step_of(host, cells.tangle, last).why, "");
    EXPECT_TRUE(state(host, cells.surface, cells.tangle) == before);
    // Or by undoing.
    ASSERT_EQ(cells.editor.remove(5), FLG_OK);
    EXPECT_EQ(step_of(host, cells.tangle, last - 1).state, FLG_TANGLE_STEP_STATE_LOST);
    expect_like_fresh(host, fine(), cells.surface, cells.tangle);
    ASSERT_EQ(host.undo(cells.tangle), FLG_OK);
    EXPECT_TRUE(state(host, cells.surface, cells.tangle) == before);
}

TEST(TangleEdits, AStepThatMissesSomeOfItsRegionsActsOnTheOthers) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(24));
    const FlgTangle tangle = host.tangle(surface);
    const Editor editor{host, tangle};
    ASSERT_EQ(host.divide(contour(tangle, root, borders(FLG_TANGLE_BORDERS_OUTER), 0.1f, 3)), FLG_OK);
    const Regions bands = host.children(tangle, 0);
    ASSERT_EQ(bands.size(), 4u);
    ASSERT_EQ(host.divide(contour(tangle, bands, borders(FLG_TANGLE_BORDERS_EACH), 0.02f, 1)), FLG_OK);
    const std::string before = state(host, surface, tangle);
    ASSERT_EQ(editor.set_delta(0, 0.2f), FLG_OK);
    EXPECT_EQ(step_of(host, tangle, 1).state, FLG_TANGLE_STEP_STATE_MADE);
    EXPECT_STREQ(step_of(host, tangle, 1).why, "1 of its 4 regions are not there");
    expect_like_fresh(host, plane(24), surface, tangle);
    ASSERT_EQ(editor.set_delta(0, 0.1f), FLG_OK);
    EXPECT_STREQ(step_of(host, tangle, 1).why, "");
    EXPECT_TRUE(state(host, surface, tangle) == before);
}

TEST(TangleEdits, StepsAreInsertedMovedAndRemoved) {
    const TangleHost host;
    const Cells cells(host);
    const std::string before = state(host, cells.surface, cells.tangle);
    const Regions seventh = {7};
    FlgTangleDivideDesc band = contour(cells.tangle, seventh, borders(FLG_TANGLE_BORDERS_OUTER), 0.08f, 1);
    FlgTangleStep step = flgTangleStepDefaults();
    step.kind = FLG_TANGLE_STEP_KIND_DIVIDE;
    step.divide = &band;
    ASSERT_EQ(cells.editor.insert(1, step), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(host.info(cells.tangle).computed_count, 1u);
    EXPECT_GT(host.region(cells.tangle, 7).child_count, 0u);
    expect_like_fresh(host, fine(), cells.surface, cells.tangle);
    ASSERT_EQ(cells.editor.move(1, 4), FLG_OK);
    EXPECT_EQ(host.info(cells.tangle).computed_count, 1u);
    EXPECT_EQ(step_of(host, cells.tangle, 4).divide->regions[0], 7u);
    expect_like_fresh(host, fine(), cells.surface, cells.tangle);
    ASSERT_EQ(cells.editor.remove(4), FLG_OK);
    EXPECT_EQ(host.info(cells.tangle).computed_count, 0u);
    EXPECT_TRUE(state(host, cells.surface, cells.tangle) == before);
    // A step that stands before what it needs.
    ASSERT_EQ(cells.editor.move(1, 0), FLG_OK);
    EXPECT_EQ(step_of(host, cells.tangle, 0).state, FLG_TANGLE_STEP_STATE_LOST);
    expect_like_fresh(host, fine(), cells.surface, cells.tangle);
    ASSERT_EQ(cells.editor.move(0, 1), FLG_OK);
    EXPECT_TRUE(state(host, cells.surface, cells.tangle) == before);
}

TEST(TangleEdits, WhatCanNotBeMadeChangesNothing) {
    const TangleHost host;
    const Cells cells(host);
    const std::string before = state(host, cells.surface, cells.tangle);
    const Regions first = {1};
    FlgTangleDivideDesc desc = contour(cells.tangle, first, borders(FLG_TANGLE_BORDERS_OUTER), 0.03f, 1);
    FlgTangleStep step = flgTangleStepDefaults();
    step.divide = &desc;
    const Regions none = {900};
    desc.regions = none.data();
    EXPECT_EQ(cells.editor.edit(2, step), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_TRUE(state(host, cells.surface, cells.tangle) == before);
    desc.regions = root.data();
    desc.delta = -1;
    EXPECT_EQ(cells.editor.edit(2, step), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgErrorGetMessage(), "desc.delta is -1, must be finite and above 0");
    desc.delta = 0.1f;
    EXPECT_EQ(cells.editor.edit(7, step), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(cells.editor.insert(8, step), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(cells.editor.move(2, 7), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(cells.editor.remove(7), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(cells.editor.mute(7, true), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_TRUE(state(host, cells.surface, cells.tangle) == before);
    EXPECT_EQ(host.info(cells.tangle).undo_count, Cells::bands + 1);
    ASSERT_EQ(host.undo(cells.tangle), FLG_OK);
    ASSERT_EQ(host.redo(cells.tangle), FLG_OK);
    EXPECT_TRUE(state(host, cells.surface, cells.tangle) == before);
}

TEST(TangleEdits, CancelledTheyChangeNothing) {
    // Ticks as short as they can be: the job is cancelled after more and more of them.
    for (uint32_t ticks = 0; ticks < 60; ticks += 3) {
        SCOPED_TRACE(ticks);
        const TangleHost host;
        const Cells cells(host);
        const std::string before = state(host, cells.surface, cells.tangle);
        FlgJob job{};
        ASSERT_EQ(flgTangleMuteStep(host.context, cells.tangle, 0, 1, nullptr, &job), FLG_OK);
        for (uint32_t i = 0; i < ticks; ++i) ASSERT_EQ(flgContextTick(host.context, 1, nullptr), FLG_OK);
        const FlgResult cancelled = flgJobCancel(host.context, job);
        host.finish();
        if (cancelled == FLG_OK && host.result_of(job) == FLG_ERROR_CANCELLED) {
            EXPECT_TRUE(state(host, cells.surface, cells.tangle) == before);
            EXPECT_EQ(host.info(cells.tangle).undo_count, Cells::bands + 1);
            ASSERT_EQ(cells.editor.mute(0, true), FLG_OK);
        }
        EXPECT_EQ(host.info(cells.tangle).leaf_count, 1u);
        ASSERT_EQ(host.undo(cells.tangle), FLG_OK);
        EXPECT_TRUE(state(host, cells.surface, cells.tangle) == before);
    }
}

TEST(TangleEdits, SameBitsWithAnyWorkersAndBudget) {
    std::string expected;
    for (const auto& [workers, budget] : {std::pair{0u, FLG_UNLIMITED}, {0u, 100u}, {1u, FLG_UNLIMITED}, {4u, 50u}}) {
        const TangleHost host(workers, budget);
        const Cells cells(host, sphere(12));
        ASSERT_EQ(cells.editor.set_delta(2, 0.05f), FLG_OK);
        ASSERT_EQ(cells.editor.mute(4, true), FLG_OK);
        ASSERT_EQ(cells.editor.move(5, 1), FLG_OK);
        const std::string got = state(host, cells.surface, cells.tangle);
        if (expected.empty()) expected = got;
        EXPECT_TRUE(got == expected) << workers << " workers, " << budget << " us";
    }
}

// ---- Hundreds of random steps and edits

class EditSession {
public:
    EditSession(const TangleHost& host, FlgSurface surface, FlgTangle tangle, uint64_t seed)
        : session_(host, surface, tangle, seed), host_(host), tangle_(tangle), editor_{host, tangle} {}

    std::string last;

    FlgResult go_on() {
        const FlgTangleHistory history = history_of(host_, tangle_);
        const uint32_t count = history.made_count;
        const uint32_t kind = session_.draw(10);
        if (count < 3 || kind < 5) {
            const FlgResult result = session_.step();
            last = session_.last;
            return result;
        }
        const uint32_t step = session_.draw(count), to = session_.draw(count);
        last = "step " + std::to_string(step) + " of " + std::to_string(count);
        if (kind == 5) {
            last += " removed";
            return editor_.remove(step);
        }
        if (kind == 6) {
            last += " muted, or heard";
            return editor_.mute(step, history.steps[step]->state != FLG_TANGLE_STEP_STATE_MUTED);
        }
        if (kind == 7) {
            last += " moved to " + std::to_string(to);
            return editor_.move(step, to);
        }
        if (kind == 8) {
            last += " copied to " + std::to_string(to);
            return editor_.insert(to, *history.steps[step]);
        }
        last += " changed";
        return change(step, *history.steps[step]);
    }
    uint32_t draw(uint32_t count) { return session_.draw(count); }

private:
    FlgResult change(uint32_t step, FlgTangleStep desc) {
        FlgTangleDivideDesc divide{};
        FlgTangleApplyMacroDesc macro{};
        FlgTangleDisplaceDesc displace{};
        const float factor = 0.6f + 0.8f * static_cast<float>(session_.draw(100)) / 100;
        if (desc.kind == FLG_TANGLE_STEP_KIND_DIVIDE) {
            divide = *desc.divide;
            divide.delta *= factor;
            divide.seed = session_.draw(1000);
            desc.divide = &divide;
        } else if (desc.kind == FLG_TANGLE_STEP_KIND_MACRO) {
            macro = *desc.macro;
            macro.size *= factor;
            desc.macro = &macro;
        } else if (desc.kind == FLG_TANGLE_STEP_KIND_DISPLACE) {
            displace = *desc.displace;
            displace.amount *= factor;
            desc.displace = &displace;
        }
        return editor_.edit(step, desc);
    }

    RandomSession session_;
    const TangleHost& host_;
    const FlgTangle tangle_;
    const Editor editor_;
};

struct Counts {
    uint32_t edits = 0, refused = 0, lost = 0, kept = 0;
};

Counts run_session(const MeshArrays& mesh, uint64_t seed, uint32_t operations) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    constexpr uint32_t max_triangles = 2500, most_steps = 14;
    const TangleHost host;
    const FlgSurface surface = host.surface(mesh);
    const FlgTangle tangle = host.tangle(surface);
    EditSession session(host, surface, tangle, seed);
    Counts counts;
    std::vector<std::string> states = {state(host, surface, tangle)};
    uint32_t done = 0;
    for (uint32_t i = 0; i < operations && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE("operation " + std::to_string(i));
        const FlgResult result = session.go_on();
        SCOPED_TRACE(session.last);
        if (result == FLG_OK) {
            states.resize(++done);
            states.push_back(state(host, surface, tangle));
            const bool edited = session.last.starts_with("step ");
            if (edited) ++counts.edits;
            expect_valid(host, surface, tangle, whole_area(host.view(surface)));
            if (edited) expect_like_fresh(host, mesh, surface, tangle);
            const FlgTangleHistory history = history_of(host, tangle);
            for (uint32_t s = 0; s < history.made_count; ++s)
                if (history.steps[s]->state == FLG_TANGLE_STEP_STATE_LOST) ++counts.lost;
            if (edited && host.info(tangle).computed_count < history.made_count / 2) ++counts.kept;
        } else {
            EXPECT_TRUE(result == FLG_ERROR_INVALID_ARGUMENT || result == FLG_ERROR_LIMIT);
            EXPECT_TRUE(state(host, surface, tangle) == states[done]) << "what failed changed nothing";
            ++counts.refused;
        }
        if (testing::Test::HasFailure()) break;
        const auto back = [&] {
            ASSERT_EQ(host.undo(tangle), FLG_OK);
            ASSERT_TRUE(state(host, surface, tangle) == states[--done]) << "taken back";
        };
        while (done > 0 && (host.view(surface).mesh->triangle_count > max_triangles ||
                            history_of(host, tangle).made_count > most_steps)) {
            for (uint32_t n = 1 + session.draw(5); n > 0 && done > 0; --n) back();
        }
        if (session.draw(8) == 0 && done > 0) back();
        if (session.draw(6) == 0 && host.info(tangle).redo_count > 0) {
            EXPECT_EQ(host.redo(tangle), FLG_OK);
            EXPECT_TRUE(state(host, surface, tangle) == states[++done]) << "made again";
        }
    }
    if (testing::Test::HasFailure()) return counts;
    EXPECT_EQ(host.info(tangle).undo_count, done);
    expect_like_fresh(host, mesh, surface, tangle);
    const uint32_t end = done;
    while (done > 0) {
        EXPECT_EQ(host.undo(tangle), FLG_OK);
        EXPECT_TRUE(state(host, surface, tangle) == states[--done]) << "back to " << done;
    }
    while (done < end) {
        EXPECT_EQ(host.redo(tangle), FLG_OK);
        EXPECT_TRUE(state(host, surface, tangle) == states[++done]) << "again to " << done;
    }
    return counts;
}

void expect_session(const MeshArrays& mesh, uint64_t seed) {
    const Counts counts = run_session(mesh, seed, 500);
    if (testing::Test::HasFailure()) return;
    EXPECT_GT(counts.edits, 100u);
    EXPECT_LT(counts.refused, 170u);
    EXPECT_GT(counts.lost, 20u);
    EXPECT_GT(counts.kept, 30u);
}

TEST(TangleEditSessions, FiveHundredOperationsOnAClosedSurface) {
    expect_session(sphere(6), 31);
}

TEST(TangleEditSessions, FiveHundredOperationsOnASurfaceWithBorders) {
    expect_session(cylinder(24, 8), 32);
}

TEST(TangleEditSessions, FiveHundredOperationsOnAPlane) {
    expect_session(plane(14), 33);
}

}  // namespace
}  // namespace flg::test
