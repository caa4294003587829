// SPDX-License-Identifier: MIT
// The guard of this library's entry points: whatever is thrown becomes a result and a sentence for flgErrorGetMessage.
#pragma once

#include "core/guard.h"

namespace flg {

// Remembers the sentence for flgErrorGetMessage on this thread, cut at 511 bytes; returns `result`.
FlgResult set_last_error(FlgResult result, const char* message) noexcept;

// Turns the exception being handled into a result; for use inside catch (...).
FlgResult translate_exception() noexcept;

template <class Body>
FlgResult guarded(Body&& body) noexcept {
    return guarded(std::forward<Body>(body), [] { return translate_exception(); });
}

}  // namespace flg
