// SPDX-License-Identifier: MIT
#include "runtime/host.h"

#include <chrono>
#include <cstdarg>
#include <cstdio>

namespace flg {

uint64_t Host::now_ns() const {
    if (clock_.now_ns) return clock_.now_ns(clock_.user_data);
    const auto since_epoch = std::chrono::steady_clock::now().time_since_epoch();
    return static_cast<uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(since_epoch).count());
}

void Host::log(FlgLogLevel level, const char* format, ...) const {
    if (!log_.write) return;
    char message[512];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    log_.write(log_.user_data, level, message);
}

}  // namespace flg
