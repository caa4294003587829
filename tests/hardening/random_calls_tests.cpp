// SPDX-License-Identifier: MIT
// Random sequences of calls, sound and not, end with documented results, and disturb nobody else's. FLG_RANDOM_SEEDS=N
// runs the sequences before N in place of a few, FLG_RANDOM_FIRST=N leaves out those before N.
#include <cstdlib>

#include "hardening/random_host.h"

namespace flg::test {
namespace {

uint64_t number_in(const char* variable, uint64_t otherwise) {
    const char* const text = std::getenv(variable);
    return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

TEST(RandomCalls, EndWithDocumentedResults) {
    const uint64_t first = number_in("FLG_RANDOM_FIRST", 0), end = number_in("FLG_RANDOM_SEEDS", 24);
    std::string quiet;
    std::map<FlgResult, uint32_t> results;
    for (uint64_t seed = first; seed < end && !HasFailure(); ++seed) {
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
    if (first > 0) return;
    // It is neither all refused nor all taken.
    for (const FlgResult result : {FLG_OK, FLG_NOT_READY, FLG_ERROR_INVALID_ARGUMENT, FLG_ERROR_INVALID_HANDLE,
                                   FLG_ERROR_DEPENDENCY, FLG_ERROR_FORMAT}) {
        EXPECT_GT(results[result], 0u) << flgResultGetName(result);
    }
    EXPECT_GT(results[FLG_OK], results[FLG_ERROR_INVALID_HANDLE]);
}

}  // namespace
}  // namespace flg::test
