// SPDX-License-Identifier: MIT
// Every entry point counts what it takes to the byte, after each call; and with any limit, what needs more says so,
// nothing else happens, nothing is lost, and no more than the limit was ever held.
#include "api/memory_uses.h"
#include "hardening/ledger.h"
#include "hardening/scenarios.h"

namespace flg::test {
namespace {

// After each call: the kinds together are what the allocator has given, and no failure but the limit's was met.
class Auditor final : public Meddler {
public:
    Auditor(FlgContext context, const Ledger& ledger) : context_(context), ledger_(ledger) {}

    void before(const char*, const std::type_info&, void*) override {}
    void after(const char* function, FlgResult) override {
        const MemoryUses memory = memory_uses(context_);
        const auto live = static_cast<uint64_t>(ledger_.live_bytes.load());
        if (memory.sum() != live || memory.total.bytes != live) {
            ADD_FAILURE() << "after " << function << ": the kinds hold " << memory.sum() << ", the total is "
                          << memory.total.bytes << ", the host gave " << live;
        }
        ++calls;
    }
    uint32_t calls = 0;

private:
    const FlgContext context_;
    const Ledger& ledger_;
};

struct Bench {
    explicit Bench(uint64_t limit = 0) : limit_(limit) {
        FlgContextDesc desc = flgContextDefaults();
        desc.worker_count = 0;
        desc.allocator = ledger.hook();
        desc.memory_limit = limit;
        EXPECT_EQ(flgContextCreate(&desc, &context), FLG_OK) << flgErrorGetMessage();
    }
    ~Bench() {
        EXPECT_EQ(flgContextDestroy(context), FLG_OK) << flgErrorGetMessage();
        EXPECT_EQ(ledger.live_bytes, 0);
        EXPECT_EQ(ledger.wrong_frees, 0);
        EXPECT_TRUE(limit_ == 0 || ledger.max_live_bytes <= static_cast<int64_t>(limit_));
    }
    // The bits, and whether it came to its end.
    std::pair<std::string, bool> run(const Scenario& scenario) {
        Calls calls(context);
        if (limit_ != 0) calls.allowed = {FLG_ERROR_OUT_OF_MEMORY};
        Auditor auditor(context, ledger);
        calls.meddler = &auditor;
        try {
            scenario.run(calls);
        } catch (const Ended&) {}
        FlgFrameReport report = flgFrameReportDefaults();
        do {
            EXPECT_EQ(flgContextTick(context, FLG_UNLIMITED, &report), FLG_OK) << flgErrorGetMessage();
        } while (report.jobs_pending > 0);
        auditor.after("the last job", FLG_OK);
        EXPECT_GT(auditor.calls, 0u);
        const MemoryUses memory = memory_uses(context);
        EXPECT_EQ(memory.scratch.bytes, 0u);
        EXPECT_EQ(memory.total.peak_bytes, static_cast<uint64_t>(ledger.max_live_bytes.load()));
        return {calls.bits, !calls.ended};
    }

    Ledger ledger;
    FlgContext context{};

private:
    const uint64_t limit_;
};

class MemoryLimits : public testing::TestWithParam<Scenario> {};

TEST_P(MemoryLimits, AreKeptAndLoseNothing) {
    const Scenario& scenario = GetParam();
    uint64_t least = 0, most = 0;
    std::string whole;
    {
        Bench bench;
        least = static_cast<uint64_t>(bench.ledger.live_bytes.load());
        const auto [bits, complete] = bench.run(scenario);
        ASSERT_TRUE(complete);
        whole = bits;
        most = static_cast<uint64_t>(bench.ledger.max_live_bytes.load());
    }
    // The same with room for all of it, to the byte.
    {
        Bench bench(most);
        EXPECT_TRUE(bench.run(scenario) == std::pair(whole, true));
    }
    const int64_t steps = std::max<int64_t>(8, 40 / scenario.cost);
    uint32_t ended = 0;
    for (int64_t k = 0; k < steps && !HasFailure(); ++k) {
        const uint64_t limit = least + (most - least) * static_cast<uint64_t>(k) / static_cast<uint64_t>(steps);
        SCOPED_TRACE("a limit of " + std::to_string(limit) + " bytes");
        Bench bench(limit);
        const auto [bits, complete] = bench.run(scenario);
        EXPECT_TRUE(!complete || bits == whole);
        ended += complete ? 0 : 1;
    }
    EXPECT_EQ(ended > 0, most > least);
}

INSTANTIATE_TEST_SUITE_P(Of, MemoryLimits, testing::ValuesIn(scenarios), name_of);

}  // namespace
}  // namespace flg::test
