// SPDX-License-Identifier: MIT
// Every kind of job cancelled after any number of its pauses: it is published as cancelled, or had finished; what
// depends on it fails; surfaces are as they were before or after a whole step; nothing is lost, and the context works
// as before.
#include <algorithm>

#include "hardening/ledger.h"
#include "hardening/scenarios.h"

namespace flg::test {
namespace {

// A clock that goes on by a tenth of a microsecond whenever it is looked at: ticks of one end after a few pauses of
// jobs.
struct LookClock {
    std::atomic<uint64_t> ns{0};
    const FlgClock* hook() const { return &hook_; }

    const FlgClock hook_{sizeof(FlgClock), this,
                         [](void* self) { return static_cast<LookClock*>(self)->ns.fetch_add(100); }};
};

struct Made {
    std::string bits;
    std::vector<std::string> surface_bits;
    uint32_t ticks = 0;
    bool ended = false;
};

void expect_whole(const Calls& calls, const Made& whole) {
    for (const FlgSurface surface : calls.surfaces) {
        FlgSurfaceView view = flgSurfaceViewDefaults();
        const FlgResult result = flgSurfaceGetView(calls.context, surface, &view);
        if (result == FLG_ERROR_CANCELLED || result == FLG_ERROR_DEPENDENCY) continue;  // never made
        ASSERT_EQ(result, FLG_OK) << flgErrorGetMessage();
        expect_valid(view);
        const std::string now = bits(view);
        EXPECT_NE(std::find(whole.surface_bits.begin(), whole.surface_bits.end(), now), whole.surface_bits.end())
            << "a surface was left in the middle of a step";
    }
}

// Cancels one of the jobs before tick number `at`, counted from 1, by this choice; at 0: none.
Made run(const Scenario& scenario, uint32_t workers, uint32_t at, uint32_t choice, const Made* whole) {
    Ledger ledger;
    LookClock clock;
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = workers;
    desc.allocator = ledger.hook();
    if (workers == 0) desc.clock = clock.hook();
    FlgContext context{};
    EXPECT_EQ(flgContextCreate(&desc, &context), FLG_OK) << flgErrorGetMessage();
    Made made;
    {
        Calls calls(context);
        calls.tick_budget_us = workers == 0 ? 1 : FLG_UNLIMITED;
        if (at != 0) calls.allowed = {FLG_ERROR_CANCELLED};
        calls.before_tick = [&] {
            if (calls.ticks + 1 != at || calls.jobs().empty()) return;
            FLG_CALL(calls, flgJobCancel, context, calls.jobs()[choice % calls.jobs().size()]);
        };
        try {
            scenario.run(calls);
        } catch (const Ended&) {}
        FlgFrameReport report{};
        report.struct_size = sizeof report;
        do {
            EXPECT_EQ(flgContextTick(context, FLG_UNLIMITED, &report), FLG_OK) << flgErrorGetMessage();
            flgContextWait(context, 1000);
        } while (report.jobs_pending > 0);
        if (whole) expect_whole(calls, *whole);
        made = {calls.bits, calls.surface_bits, calls.ticks, calls.ended};
    }
    if (at % 8 == 1) {
        Calls after(context);
        make_curves(after);
        EXPECT_FALSE(after.ended);
    }
    EXPECT_EQ(flgContextDestroy(context), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(ledger.live_bytes, 0);
    EXPECT_EQ(ledger.wrong_frees, 0);
    return made;
}

class Cancellation : public testing::TestWithParam<Scenario> {};

TEST_P(Cancellation, LeavesAllOrNothing) {
    const Scenario& scenario = GetParam();
    const Made whole = run(scenario, 0, 0, 0, nullptr);
    ASSERT_FALSE(whole.ended);
    ASSERT_GT(whole.ticks, 1u);
    const auto stride = std::max<uint32_t>(1, whole.ticks * static_cast<uint32_t>(scenario.cost) / 120);
    uint32_t cancelled = 0;
    for (uint32_t at = 1, choice = 0; at <= whole.ticks && !HasFailure(); at += stride, ++choice) {
        SCOPED_TRACE("before tick " + std::to_string(at) + " of " + std::to_string(whole.ticks));
        const Made made = run(scenario, 0, at, choice, &whole);
        EXPECT_TRUE(made.ended || made.bits == whole.bits);
        cancelled += made.ended ? 1 : 0;
    }
    EXPECT_GT(cancelled, 0u);
    for (uint32_t at = 1; at <= 6 && !HasFailure(); ++at) {
        SCOPED_TRACE("two workers, before tick " + std::to_string(at));
        const Made made = run(scenario, 2, at, at, &whole);
        EXPECT_TRUE(made.ended || made.bits == whole.bits);
    }
}

std::vector<Scenario> with_jobs() {
    std::vector<Scenario> all(std::begin(scenarios), std::end(scenarios));
    std::erase_if(all, [](const Scenario& of) {
        return of.run == pose_skins || of.run == make_contexts || of.run == make_manifolds;
    });
    return all;
}

INSTANTIATE_TEST_SUITE_P(Of, Cancellation, testing::ValuesIn(with_jobs()), name_of);

}  // namespace
}  // namespace flg::test
