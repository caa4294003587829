// SPDX-License-Identifier: MIT
// The wrapper around every entry point: whatever is thrown becomes a result and a sentence for flgLastError.
#pragma once

#include "core/failure.h"

namespace flg {

// Remembers the sentence for flgLastError on this thread, cut at 511 bytes; returns `result`.
FlgResult set_last_error(FlgResult result, const char* message) noexcept;

// Turns the exception being handled into a result; for use inside catch (...).
FlgResult translate_exception() noexcept;

template <class Body>
FlgResult guarded(Body&& body) noexcept {
    try {
        return body();
    } catch (...) {
        return translate_exception();
    }
}

}  // namespace flg
