// SPDX-License-Identifier: MIT
// Every entry point with an allocator that fails: at each allocation by itself, and at all from each one on. What
// needed the memory says so, nothing else happens, nothing is lost, and the context works as before.
#include <algorithm>

#include "hardening/ledger.h"
#include "hardening/scenarios.h"

namespace flg::test {
namespace {

// A context whose memory comes from a ledger, and goes back to it whole.
struct Bench {
    explicit Bench() {
        FlgContextDesc desc = flgContextDefaults();
        desc.worker_count = 0;
        desc.allocator = ledger.hook();
        EXPECT_EQ(flgContextCreate(&desc, &context), FLG_OK) << flgErrorGetMessage();
    }
    ~Bench() {
        EXPECT_EQ(flgContextDestroy(context), FLG_OK) << flgErrorGetMessage();
        EXPECT_EQ(ledger.live_bytes, 0);
        EXPECT_EQ(ledger.wrong_frees, 0);
    }
    // The bits, and whether it came to its end.
    std::pair<std::string, bool> run(const Scenario& scenario, std::vector<FlgResult> allowed = {}) {
        Calls calls(context);
        calls.allowed = std::move(allowed);
        calls.contexts.allocator = ledger.hook();
        try {
            scenario.run(calls);
        } catch (const Ended&) {}
        return {calls.bits, !calls.ended};
    }
    // Whatever is still going on comes to its end.
    void drain() {
        FlgFrameReport report{};
        report.struct_size = sizeof report;
        do {
            ASSERT_EQ(flgContextTick(context, FLG_UNLIMITED, &report), FLG_OK) << flgErrorGetMessage();
        } while (report.jobs_pending > 0);
    }

    Ledger ledger;
    FlgContext context{};
};

// All of the first ones, where most entry points take theirs, then one in `stride`.
std::vector<int64_t> chosen(int64_t count, int64_t first, int64_t further) {
    std::vector<int64_t> numbers;
    const int64_t stride = std::max<int64_t>(1, (count - first) / further);
    for (int64_t n = 0; n < count; n += n < first ? 1 : stride) numbers.push_back(n);
    return numbers;
}

class MemoryFailures : public testing::TestWithParam<Scenario> {};

TEST_P(MemoryFailures, AreSaidAndLoseNothing) {
    const Scenario& scenario = GetParam();
    const Scenario small = {"curves", make_curves};
    std::string whole, small_bits;
    int64_t count = 0;
    {
        Bench bench;
        bench.ledger.never_fail();
        const auto [bits, complete] = bench.run(scenario);
        ASSERT_TRUE(complete);
        whole = bits;
        count = bench.ledger.calls;
        small_bits = bench.run(small).first;
    }
    uint32_t ended = 0;
    for (const bool from_then_on : {false, true}) {
        const std::vector<int64_t> numbers = from_then_on ? chosen(count, 0, 60 / scenario.cost)
                                                          : chosen(count, 200 / scenario.cost, 200 / scenario.cost);
        for (size_t i = 0; i < numbers.size() && !HasFailure(); ++i) {
            SCOPED_TRACE("allocation " + std::to_string(numbers[i]) + (from_then_on ? " and all later ones" : ""));
            Bench bench;
            bench.ledger.fail(numbers[i], from_then_on);
            const auto [bits, complete] = bench.run(scenario, {FLG_ERROR_OUT_OF_MEMORY});
            bench.ledger.never_fail();
            bench.drain();
            // What could do without has done all the same.
            EXPECT_TRUE(!complete || bits == whole);
            ended += complete ? 0 : 1;
            EXPECT_TRUE(i % 16 != 3 || bench.run(scenario).first == whole);
            EXPECT_TRUE(bench.run(small).first == small_bits);
        }
    }
    // All but poses, which need no context.
    EXPECT_EQ(ended > 0, scenario.run != pose_skins);
}

INSTANTIATE_TEST_SUITE_P(Of, MemoryFailures, testing::ValuesIn(scenarios), name_of);

// Functions that have no context take the C++ runtime's memory. It fails in the same way. (Not here: picking, where
// Embree takes it too, and gives any error then.)
class HeapFailures : public testing::TestWithParam<Scenario> {};

TEST_P(HeapFailures, AreSaidAndLoseNothing) {
    const Scenario& scenario = GetParam();
    const auto run = [&](int64_t fail_at, bool from_then_on) {
        Calls calls(FlgContext{});
        if (fail_at >= 0) calls.allowed = {FLG_ERROR_OUT_OF_MEMORY};
        fail_heap(fail_at, from_then_on);
        try {
            scenario.run(calls);
        } catch (const Ended&) {}
        const int64_t count = heap_calls_since();
        fail_heap(-1, false);
        return std::pair(calls.ended ? std::string() : calls.bits, count);
    };
    const auto [whole, count] = run(-1, false);
    ASSERT_NE(whole, "");
    ASSERT_GT(count, 0);
    uint32_t ended = 0;
    for (const bool from_then_on : {false, true}) {
        const std::vector<int64_t> numbers = from_then_on ? chosen(count, 0, 60) : chosen(count, 200, 200);
        for (size_t i = 0; i < numbers.size() && !HasFailure(); ++i) {
            SCOPED_TRACE("allocation " + std::to_string(numbers[i]) + (from_then_on ? " and all later ones" : ""));
            const std::string bits = run(numbers[i], from_then_on).first;
            if (bits.empty()) {
                ++ended;
            } else {
                EXPECT_TRUE(bits == whole);
            }
        }
    }
    EXPECT_GT(ended, 0u);
    EXPECT_TRUE(run(-1, false).first == whole);
}

constexpr Scenario heap_scenarios[] = {
    {"poses", pose_skins},
#ifdef FLG_WITH_IO
    {"plain_files", keep_plain_files},
    {"curve_files", keep_curve_files},
    {"mesh_files", keep_mesh_files},
    {"skin_files", keep_skin_files},
    {"tangle_files", keep_tangle_files},
#endif
};

INSTANTIATE_TEST_SUITE_P(Of, HeapFailures, testing::ValuesIn(heap_scenarios), name_of);

}  // namespace
}  // namespace flg::test
