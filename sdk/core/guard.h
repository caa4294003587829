// SPDX-License-Identifier: MIT
// The guard around every entry point of every library: nothing is thrown across an ABI.
#pragma once

#include <cstdio>
#include <new>
#include <type_traits>

#include "core/failure.h"

namespace flg {

// The result and the sentence of the exception being handled; for use inside catch (...). Sentences are cut at
// `size` - 1 bytes.
inline FlgResult translate_exception(char* sentence, size_t size, const char* out_of_memory) noexcept {
    const auto tell = [&](FlgResult result, const char* text) {
        std::snprintf(sentence, size, "%s", text);
        return result;
    };
    try {
        throw;
    } catch (const Failure& failure) {
        return tell(failure.result(), failure.what());
    } catch (const MemoryLimitReached& reached) {
        return tell(FLG_ERROR_OUT_OF_MEMORY, reached.what());
    } catch (const std::bad_alloc&) {
        return tell(FLG_ERROR_OUT_OF_MEMORY, out_of_memory);
    } catch (const std::exception& e) {
        return tell(FLG_ERROR_INTERNAL, e.what());
    } catch (...) {
        return tell(FLG_ERROR_INTERNAL, "unknown exception");
    }
}

// Runs an entry point's body, which returns its result, or nothing for FLG_OK. `translate` gives the result of the
// exception being handled.
template <class Body, class Translate>
FlgResult guarded(Body&& body, Translate&& translate) noexcept {
    try {
        if constexpr (std::is_void_v<decltype(body())>) {
            body();
            return FLG_OK;
        } else {
            return body();
        }
    } catch (...) {
        return translate();
    }
}

}  // namespace flg
