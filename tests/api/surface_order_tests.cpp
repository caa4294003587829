// SPDX-License-Identifier: MIT
// Jobs on one surface keep the order they were started in, whoever runs them and whatever is cancelled.
#include "api/surface_scenario.h"

namespace flg::test {
namespace {

// As if done one after the other; measured with everything awaited after each step.
const std::string& one_by_one() {
    static const std::string expected = [] {
        const SurfaceHost host;
        SurfaceScenario scenario(host);
        scenario.start([&] { host.finish(); });
        expect_valid(host.view(scenario.surface));
        EXPECT_EQ(host.view(scenario.surface).revision, 3u);
        return scenario.all_bits();
    }();
    return expected;
}

TEST(SurfaceOrder, JobsStartedAtOnceSeeTheSurfaceAsItWasTheirTurn) {
    const SurfaceHost host;
    SurfaceScenario scenario(host);
    scenario.start([] {});
    host.finish();
    EXPECT_TRUE(scenario.all_bits() == one_by_one());
}

TEST(SurfaceOrder, SameBitsUnderAnyWorkersAndBudgets) {
    for (uint32_t workers : {0u, 1u, 2u, 4u}) {
        for (uint32_t budget_us : {30u, FLG_UNLIMITED}) {
            FlgContextDesc desc = flgContextDefaults();
            desc.worker_count = workers;
            desc.worker_budget_us = 7 * budget_us;
            const SurfaceHost host(desc);
            SurfaceScenario scenario(host);
            uint32_t started = 0;
            scenario.start([&] {
                if (++started % 3 == 0) flgContextTick(host.context, std::min(budget_us, 30u) + 1, nullptr);
            });
            host.finish(budget_us);
            EXPECT_TRUE(scenario.all_bits() == one_by_one()) << workers << " workers, " << budget_us << " us";
        }
    }
}

// A job says what it waits for: its input, those before it on its surface, or its turn.
TEST(SurfaceOrder, JobsSayWhatTheyWaitFor) {
    const SurfaceHost host;
    MeshArrays mesh = plane(4);
    const FlgMeshView view = mesh.view();
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    desc.mesh = &view;
    FlgSurface surface{};
    FlgJob making{}, measuring{}, cutting{}, later{};
    ASSERT_EQ(flgSurfaceCreate(host.context, &desc, &surface, &making), FLG_OK);
    FlgFieldGeodesicDesc source = flgFieldGeodesicDefaults();
    const uint32_t corner = 0;
    source.surface = surface;
    source.vertices = &corner;
    source.vertex_count = 1;
    FlgField field{}, other{};
    ASSERT_EQ(flgFieldCreateGeodesic(host.context, &source, &field, &measuring), FLG_OK);
    FlgSurfaceCutIsolinesDesc cut = flgSurfaceCutIsolinesDefaults();
    const float level = 0.5f;
    cut.field = field;
    cut.levels = &level;
    cut.level_count = 1;
    ASSERT_EQ(flgSurfaceCutIsolines(host.context, &cut, nullptr, &cutting), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(flgFieldCreateGeodesic(host.context, &source, &other, &later), FLG_OK);
    EXPECT_EQ(host.status_of(making).wait, FLG_JOB_WAIT_TURN);
    EXPECT_EQ(host.status_of(making).waits_for.id, 0u);
    EXPECT_EQ(host.status_of(measuring).wait, FLG_JOB_WAIT_INPUT);
    EXPECT_EQ(host.status_of(measuring).waits_for.id, making.id);
    EXPECT_EQ(host.status_of(cutting).wait, FLG_JOB_WAIT_INPUT);
    EXPECT_EQ(host.status_of(later).wait, FLG_JOB_WAIT_INPUT);
    while (host.status_of(making).state != FLG_JOB_STATE_FINISHED) flgContextTick(host.context, 1, nullptr);
    EXPECT_EQ(host.status_of(making).wait, FLG_JOB_WAIT_NONE);
    while (host.status_of(measuring).state != FLG_JOB_STATE_FINISHED) flgContextTick(host.context, 1, nullptr);
    EXPECT_EQ(host.status_of(later).wait, FLG_JOB_WAIT_ORDER) << "the cut was started earlier";
    EXPECT_EQ(host.status_of(later).waits_for.id, cutting.id);
    host.finish();
    for (const FlgJob job : {making, measuring, cutting, later}) {
        EXPECT_EQ(host.status_of(job).wait, FLG_JOB_WAIT_NONE);
        EXPECT_EQ(host.status_of(job).remaining_us, 0);
    }
}

TEST(SurfaceOrder, NothingIsShownWhileAChangeIsPending) {
    const SurfaceHost host;
    MeshArrays mesh = plane(1);
    FlgSurfaceView view = flgSurfaceViewDefaults();
    FlgSurfaceReport report{};
    report.struct_size = sizeof report;
    uint32_t count = 7;
    FlgField field{};
    const float values[9] = {};
    const auto expect_hidden = [&](FlgSurface surface) {
        const FlgMeshView other = mesh.view();
        view.mesh = &other;
        EXPECT_EQ(flgSurfaceGetView(host.context, surface, &view), FLG_NOT_READY);
        EXPECT_EQ(view.mesh->vertex_count, 0u);
        EXPECT_EQ(flgSurfaceGetChanges(host.context, surface, 0, nullptr, 0, &count), FLG_NOT_READY);
        EXPECT_EQ(count, 0u);
        EXPECT_EQ(flgFieldCreate(host.context, surface, values, 9, &field), FLG_NOT_READY);
        EXPECT_EQ(field.id, 0u);
    };
    const FlgSurface surface = host.start_surface(plane(2));
    expect_hidden(surface);
    EXPECT_EQ(flgSurfaceGetReport(host.context, surface, &report), FLG_NOT_READY);
    EXPECT_EQ(report.vertex_count, 0u);
    host.finish();
    FlgSurfaceCutIsolinesDesc cut = flgSurfaceCutIsolinesDefaults();
    cut.field = host.field(surface, [](const Point& p) { return p[0]; });
    cut.level_first = 0.3f;
    cut.level_every = 1;
    FlgField first{}, second{};
    ASSERT_EQ(flgSurfaceCutIsolines(host.context, &cut, &first, nullptr), FLG_OK) << flgErrorGetMessage();
    expect_hidden(surface);
    EXPECT_EQ(flgSurfaceGetReport(host.context, surface, &report), FLG_OK) << "cuts don't change it";
    EXPECT_EQ(report.vertex_count, 9u);
    cut.field = first;
    cut.level_first = 0.6f;
    ASSERT_EQ(flgSurfaceCutIsolines(host.context, &cut, &second, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(host.view(surface).revision, 2u);
    EXPECT_EQ(host.view(first).revision, 1u);
    EXPECT_EQ(host.view(second).vertex_count, host.view(surface).mesh->vertex_count);
    EXPECT_EQ(host.report(surface).vertex_count, 9u);
}

// A job that only reads does not hide the surface.
TEST(SurfaceOrder, ReadersLeaveTheViewOpen) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(4));
    host.start_distances(surface, 0);
    EXPECT_EQ(host.view(surface).mesh->vertex_count, 25u);
    host.finish();
}

// In the callback of a cut its surface is there to be uploaded, and the next job can be started.
TEST(SurfaceOrder, CallbacksSeeTheCutSurface) {
    const SurfaceHost host;
    struct State {
        const SurfaceHost& host;
        FlgSurface surface;
        uint32_t changed = 0;
        FlgField next{};
    } state{host, host.surface(plane(4))};
    FlgSurfaceCutIsolinesDesc desc = flgSurfaceCutIsolinesDefaults();
    desc.field = host.field(state.surface, [](const Point& p) { return p[0]; });
    desc.level_first = 0.3f;
    desc.level_every = 9;
    FlgJobOptions options = flgJobOptionsDefaults();
    desc.job = &options;
    options.user_data = &state;
    options.on_finished = [](void* user, FlgJob, FlgResult result) {
        State& s = *static_cast<State*>(user);
        EXPECT_EQ(result, FLG_OK);
        EXPECT_EQ(s.host.view(s.surface).revision, 1u);
        s.changed = static_cast<uint32_t>(s.host.changes(s.surface, 0).size());
        s.next = s.host.start_distances(s.surface, 0);
    };
    ASSERT_EQ(flgSurfaceCutIsolines(host.context, &desc, nullptr, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(state.changed, 24u) << "each triangle of a column of 4 squares became three";
    EXPECT_EQ(host.view(state.next).vertex_count, host.view(state.surface).mesh->vertex_count);
}

struct Cut {
    FlgJob job{};
    FlgField field{};
};

Cut start_cut(const SurfaceHost& host, FlgField field) {
    FlgSurfaceCutIsolinesDesc desc = flgSurfaceCutIsolinesDefaults();
    desc.field = field;
    desc.level_first = 0.2f;
    desc.level_every = 0.15f;
    desc.first_label = 3;
    Cut cut;
    EXPECT_EQ(flgSurfaceCutIsolines(host.context, &desc, &cut.field, &cut.job), FLG_OK) << flgErrorGetMessage();
    return cut;
}

TEST(SurfaceOrder, ACutCancelledBeforeItsTurnLeavesTheSurface) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(6));
    const std::string before = bits(host.view(surface));
    const FlgField distances = host.start_distances(surface, 0);
    const Cut cut = start_cut(host, distances);
    const FlgField later = host.start_distances(surface, 3);
    const FlgSurfaceCurves of_cut = host.start_isolines(cut.field, {0.5f});
    ASSERT_EQ(flgJobCancel(host.context, cut.job), FLG_OK);
    host.finish();
    EXPECT_EQ(host.result_of(cut.job), FLG_ERROR_CANCELLED);
    EXPECT_EQ(bits(host.view(surface)), before);
    EXPECT_EQ(host.view(later).vertex_count, 49u);
    FlgFieldView field = flgFieldViewDefaults();
    expect_failure(flgFieldGetView(host.context, cut.field, &field), FLG_ERROR_CANCELLED, "cancelled");
    FlgSurfaceCurvesView curves = flgSurfaceCurvesViewDefaults();
    expect_failure(flgSurfaceCurvesGetView(host.context, of_cut, &curves), FLG_ERROR_DEPENDENCY, "cancelled");
    EXPECT_TRUE(host.changes(surface, 0).empty());
}

// At whatever moment: all of it or nothing, and what comes later is not disturbed.
TEST(SurfaceOrder, ACutIsDoneWholeOrNotAtAll) {
    for (uint32_t workers : {0u, 2u}) {
        std::string whole;
        uint32_t ticks_needed = 0;
        std::map<FlgResult, int> results;
        for (uint32_t round = 0; round < 60; ++round) {
            const SurfaceHost host(workers);
            const FlgSurface surface = host.surface(plane(12));
            const std::string before = bits(host.view(surface));
            const Cut cut = start_cut(host, host.start_distances(surface, 0));
            const FlgField later = host.start_distances(surface, 3);
            const auto tick = [&] {
                flgContextTick(host.context, 20, nullptr);
                if (workers > 0) flgContextWait(host.context, 10);
            };
            if (round == 0) {
                for (; host.result_of(cut.job) == FLG_NOT_READY; ++ticks_needed) tick();
            } else {
                // Two before they have begun, the others anywhere.
                const uint32_t ticks = round <= 2 ? 0 : round * 7919 % (ticks_needed + ticks_needed / 8 + 1);
                for (uint32_t i = 0; i < ticks; ++i) tick();
                ASSERT_EQ(flgJobCancel(host.context, cut.job), FLG_OK);
            }
            host.finish(50);
            const FlgResult result = host.result_of(cut.job);
            ++results[result];
            const FlgSurfaceView view = host.view(surface);
            expect_valid(view);
            if (round == 0) whole = bits(view);
            EXPECT_TRUE(result == FLG_OK || result == FLG_ERROR_CANCELLED) << flgResultGetName(result);
            EXPECT_TRUE(bits(view) == (result == FLG_OK ? whole : before)) << "round " << round;
            EXPECT_EQ(host.view(later).vertex_count, view.mesh->vertex_count);
            const Cut again = start_cut(host, later);
            host.finish();
            EXPECT_EQ(host.result_of(again.job), FLG_OK);
            expect_valid(host.view(surface));
        }
        EXPECT_TRUE(workers > 0 || results[FLG_ERROR_CANCELLED] > 1);
    }
}

// A cut that is done before its turn, cancelled or failed: what comes later still waits for what came before it.
TEST(SurfaceOrder, NothingOvertakesACutBecauseAnotherOneEndedEarly) {
    for (uint32_t workers : {0u, 2u}) {
        for (bool cancelled : {true, false}) {
            // However long the host is kept from going on, workers can't be done before it has cancelled.
            FlgContextDesc context_desc = flgContextDefaults();
            context_desc.worker_count = workers;
            context_desc.worker_budget_us = 100;
            const SurfaceHost host(context_desc);
            const FlgSurface surface = host.surface(plane(40));
            const Cut first = start_cut(host, host.start_distances(surface, 0));
            FlgSurfaceCutIsolinesDesc desc = flgSurfaceCutIsolinesDefaults();
            desc.field = first.field;
            desc.level_every = 1;
            const Cut other = start_cut(host, host.start_distances(host.start_surface(plane(1)), 0));
            FlgJobOptions options = flgJobOptionsDefaults();
            if (!cancelled) {
                options.dependencies = &other.job;
                options.dependency_count = 1;
            }
            desc.job = &options;
            FlgJob second{};
            ASSERT_EQ(flgSurfaceCutIsolines(host.context, &desc, nullptr, &second), FLG_OK) << flgErrorGetMessage();
            ASSERT_EQ(flgJobCancel(host.context, cancelled ? second : other.job), FLG_OK);
            const FlgField later = host.start_distances(surface, 3);
            const Cut third = start_cut(host, later);
            host.finish();
            EXPECT_EQ(host.result_of(first.job), FLG_OK);
            EXPECT_EQ(host.result_of(second), cancelled ? FLG_ERROR_CANCELLED : FLG_ERROR_DEPENDENCY);
            EXPECT_EQ(host.view(later).vertex_count, host.view(first.field).vertex_count);
            EXPECT_EQ(host.result_of(third.job), FLG_OK);
            expect_valid(host.view(surface));
        }
    }
}

TEST(SurfaceOrder, ContextsMayEndAtAnyMoment) {
    for (uint32_t round = 0; round < 30; ++round) {
        const SurfaceHost host(round % 3);
        SurfaceScenario scenario(host);
        scenario.start([&] {
            if (round % 2 == 0) flgContextTick(host.context, 10, nullptr);
        });
        for (uint32_t i = 0; i < round * 11 % 40; ++i) flgContextTick(host.context, 100, nullptr);
    }
}

}  // namespace
}  // namespace flg::test
