// SPDX-License-Identifier: MIT
// How work inside the SDK says that it can't go on: a Failure is thrown, and caught at the root of the job or at the
// ABI, where it becomes the FlgResult and the sentence the host sees. None crosses the ABI.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <exception>

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

}  // namespace flg
