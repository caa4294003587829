// SPDX-License-Identifier: MIT
// Contexts side by side, each on a thread of its own, made and destroyed while others run: they share nothing.
#include <algorithm>
#include <thread>

#include "hardening/ledger.h"
#include "hardening/scenarios.h"

namespace flg::test {
namespace {

std::vector<Scenario> quick_scenarios() {
    std::vector<Scenario> all(std::begin(scenarios), std::end(scenarios));
    std::erase_if(all, [](const Scenario& of) { return of.cost > 1; });
    return all;
}

// The bits of a scenario in a context of its own, whose memory and log are not those of any other.
std::string run(const Scenario& scenario, uint32_t workers, uint32_t budget_us) {
    Ledger ledger;
    std::vector<std::string> lines;
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = workers;
    desc.allocator = ledger.hook();
    // Scenarios whose input is repaired hear so in warnings.
    const FlgLog log = {sizeof log, &lines, [](void* user, FlgLogLevel level, const char* message) {
                            if (level == FLG_LOG_LEVEL_WARNING) return;
                            static_cast<std::vector<std::string>*>(user)->push_back(message);
                        }};
    desc.log = &log;
    FlgContext context{};
    EXPECT_EQ(flgContextCreate(&desc, &context), FLG_OK) << flgErrorGetMessage();
    std::string bits;
    {
        Calls calls(context);
        calls.contexts.allocator = ledger.hook();
        calls.tick_budget_us = budget_us;
        scenario.run(calls);
        EXPECT_FALSE(calls.ended);
        bits = calls.bits;
    }
    EXPECT_EQ(flgContextDestroy(context), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(lines.size(), 0u);
    EXPECT_GT(ledger.calls, 0);
    EXPECT_EQ(ledger.live_bytes, 0);
    EXPECT_EQ(ledger.wrong_frees, 0) << "memory of another context came back here";
    return bits;
}

TEST(Contexts, SideBySideTheyGiveWhatEachGivesAlone) {
    std::vector<Scenario> all = quick_scenarios();
    std::erase_if(all, [](const Scenario& of) { return of.run == pose_skins; });
    std::vector<std::string> alone;
    for (const Scenario& scenario : all) alone.push_back(run(scenario, 0, FLG_UNLIMITED));
    constexpr uint32_t thread_count = 4;
    std::vector<std::thread> threads;
    for (uint32_t t = 0; t < thread_count; ++t) {
        threads.emplace_back([&, t] {
            for (size_t i = 0; i < 2 * all.size(); ++i) {
                const size_t which = (i * (2 * t + 1) + 5 * t) % all.size();
                const uint32_t workers = t == 0 ? 0 : static_cast<uint32_t>((i + t) % 3);
                const uint32_t budget_us = workers == 0 && t > 0 ? 50 * t : FLG_UNLIMITED;
                EXPECT_TRUE(run(all[which], workers, budget_us) == alone[which]) << all[which].name;
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
}

TEST(Contexts, EachThreadHasItsOwnLastError) {
    const Host host;
    const FlgCurveSet set = host.create(arcs(1));
    FlgCurveSet out{};
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = set;
    desc.spacing = -1;
    ASSERT_EQ(flgCurveSetResample(host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    const std::string mine = flgErrorGetMessage();
    std::vector<std::thread> threads;
    for (uint32_t t = 1; t <= 4; ++t) {
        threads.emplace_back([t] {
            const Host own;
            EXPECT_STREQ(flgErrorGetMessage(), "no error");
            for (int i = 0; i < 200; ++i) {
                FlgCurveSetResampleDesc wrong = flgCurveSetResampleDefaults();
                FlgCurveSet none{};
                wrong.curves = own.create(arcs(1));
                wrong.spacing = -static_cast<float>(t);
                ASSERT_EQ(flgCurveSetResample(own.context, &wrong, &none, nullptr), FLG_ERROR_INVALID_ARGUMENT);
                std::this_thread::yield();
                const std::string sentence = flgErrorGetMessage();
                ASSERT_NE(sentence.find(std::string("-").append(std::to_string(t))), sentence.npos) << sentence;
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(flgErrorGetMessage(), mine);
}

}  // namespace
}  // namespace flg::test
