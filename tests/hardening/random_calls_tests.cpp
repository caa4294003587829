// SPDX-License-Identifier: MIT
// Random sequences of calls, sound and not, end with documented results, and disturb nobody else's. FLG_RANDOM_SEEDS=N
// runs N sequences in place of a few.
#include <cstdlib>

#include "hardening/random_host.h"

namespace flg::test {
namespace {

TEST(RandomCalls, EndWithDocumentedResults) {
    const char* const wanted = std::getenv("FLG_RANDOM_SEEDS");
    const uint64_t seeds = wanted ? std::strtoull(wanted, nullptr, 10) : 24;
    std::string quiet;
    std::map<FlgResult, uint32_t> results;
    for (uint64_t seed = 0; seed < seeds && !HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        RandomHost host(seed, static_cast<uint32_t>(seed % 3));
        if (quiet.empty()) quiet = host.quiet_bits();
        for (int i = 0; i < 400 && !HasFailure(); ++i) {
            SCOPED_TRACE("step " + std::to_string(i));
            host.step();
        }
        EXPECT_TRUE(host.quiet_bits() == quiet);
        for (const auto& [result, times] : host.results) results[result] += times;
    }
    // It is neither all refused nor all taken.
    for (const FlgResult result : {FLG_OK, FLG_NOT_READY, FLG_ERROR_INVALID_ARGUMENT, FLG_ERROR_INVALID_HANDLE,
                                   FLG_ERROR_DEPENDENCY, FLG_ERROR_FORMAT}) {
        EXPECT_GT(results[result], 0u) << flgResultName(result);
    }
    EXPECT_GT(results[FLG_OK], results[FLG_ERROR_INVALID_HANDLE]);
}

}  // namespace
}  // namespace flg::test
