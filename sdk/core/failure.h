// SPDX-License-Identifier: MIT
// How work inside the SDK says that it can't go on: a Failure is thrown, and caught at the root of the job or at the
// ABI, where it becomes the FlgResult and the sentence the host sees. None crosses the ABI.
#pragma once

#include <cinttypes>
#include <cstdarg>
#include <cstdio>
#include <exception>
#include <new>

#include "filigree/filigree.h"

namespace flg {

class Failure : public std::exception {
public:
    // `format` and what follows as for printf: a sentence that names the argument and its value.
    [[gnu::format(printf, 3, 4)]] Failure(FlgResult result, const char* format, ...) : result_(result) {
        va_list arguments;
        va_start(arguments, format);
        std::vsnprintf(message_, sizeof message_, format, arguments);
        va_end(arguments);
    }
    FlgResult result() const { return result_; }
    const char* what() const noexcept override { return message_; }

private:
    FlgResult result_;
    char message_[512];
};

// An allocation that the host's limit refuses: as if the allocator had returned null.
class MemoryLimitReached final : public std::bad_alloc {
public:
    // `name`: of the limit.
    MemoryLimitReached(const char* name, uint64_t limit, uint64_t held, uint64_t asked) {
        std::snprintf(message_, sizeof message_,
                      "%s is %" PRIu64 " bytes, which leaves no room for %" PRIu64 " beside the %" PRIu64 " in use",
                      name, limit, asked, held);
    }
    const char* what() const noexcept override { return message_; }

private:
    char message_[160];
};

}  // namespace flg
