// SPDX-License-Identifier: MIT
// All memory goes through the hook and comes back: nothing is taken from the C++ runtime's heap inside the SDK, on any
// thread, but for threads themselves (flgContextCreate) and exceptions (calls and jobs that fail).
#include "api/live_inputs.h"
#include "hardening/ledger.h"
#include "hardening/scenarios.h"

namespace flg::test {
namespace {

// From its first zone on, a thread that the SDK started is inside.
const FlgProfiler thread_watch = {sizeof thread_watch, nullptr, [](void*, const char*) { InsideSdk::is_inside = true; },
                                  [](void*) {}};

class Allocator : public testing::TestWithParam<Scenario> {};

TEST_P(Allocator, GivesAllMemoryAndGetsItBack) {
    for (const uint32_t workers : {0u, 2u}) {
        SCOPED_TRACE(std::to_string(workers) + " workers");
        Ledger ledger;
        FlgContextDesc desc = flgContextDefaults();
        desc.worker_count = workers;
        desc.allocator = ledger.hook();
        if (workers > 0) desc.profiler = &thread_watch;
        FlgContext context{};
        ASSERT_EQ(flgContextCreate(&desc, &context), FLG_OK) << flgErrorGetMessage();
        const uint64_t heap_calls = heap_calls_inside_sdk();
        {
            Calls calls(context);
            calls.contexts.allocator = ledger.hook();
            GetParam().run(calls);
            EXPECT_FALSE(calls.ended);
        }
        EXPECT_EQ(heap_calls_inside_sdk(), heap_calls);
        EXPECT_GT(ledger.calls, 0);
        {
            const InsideSdk inside;
            ASSERT_EQ(flgContextDestroy(context), FLG_OK) << flgErrorGetMessage();
        }
        EXPECT_EQ(heap_calls_inside_sdk(), heap_calls);
        EXPECT_EQ(ledger.live_bytes, 0);
        EXPECT_EQ(ledger.live_blocks, 0);
        EXPECT_EQ(ledger.wrong_frees, 0);
    }
}

std::vector<Scenario> with_contexts() {
    std::vector<Scenario> all(std::begin(scenarios), std::end(scenarios));
    std::erase_if(all, [](const Scenario& scenario) { return scenario.run == pose_skins; });
    return all;
}

INSTANTIATE_TEST_SUITE_P(Of, Allocator, testing::ValuesIn(with_contexts()), name_of);

TEST(AllocatorWatch, SeesWhatPassesTheHook) {
    const Host host;
    Calls calls(host.context);
    const uint64_t before = heap_calls_inside_sdk();
    pose_skins(calls);  // of more joints than fit on the stack
    EXPECT_EQ(heap_calls_inside_sdk(), before + 1);
}

// Frames in which a stroke is drawn and nothing else is started take no memory at all.
TEST(AllocatorSteadyState, TicksAndLiveStrokesTakeNone) {
    for (const uint32_t workers : {0u, 1u}) {
        LiveHost host(workers);
        const Samples samples = drawn(900, 2);
        const FlgLiveStroke stroke = host.begin();
        const int64_t calls = host.allocator.calls;
        const uint64_t heap_calls = heap_calls_inside_sdk();
        {
            const InsideSdk inside;
            FlgCurveSetView view = flgCurveSetViewDefaults();
            FlgFrameReport report{};
            report.struct_size = sizeof report;
            for (uint32_t at = 0; at + 3 <= samples.size(); at += 3) {
                ASSERT_EQ(push_samples(host.context, stroke, samples.data() + at, 3, &view), FLG_OK);
                ASSERT_EQ(flgContextTick(host.context, 2000, &report), FLG_OK);
                if (at % 30 == 27) {
                    ASSERT_EQ(flgLiveStrokeUndo(host.context, stroke, 2, nullptr), FLG_OK);
                    ASSERT_EQ(push_samples(host.context, stroke, samples.data() + at + 1, 2, &view), FLG_OK);
                }
            }
        }
        EXPECT_EQ(host.allocator.calls, calls);
        EXPECT_EQ(heap_calls_inside_sdk(), heap_calls);
    }
}

}  // namespace
}  // namespace flg::test
