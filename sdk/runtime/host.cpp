// SPDX-License-Identifier: MIT
#include "runtime/host.h"

#include <chrono>
#include <cinttypes>
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

void Host::warn(const char* object, uint64_t handle, const char* change, std::initializer_list<Count> counts) const {
    char list[384] = "";
    size_t length = 0;
    for (const auto& [count, what] : counts) {
        if (count == 0 || length >= sizeof list) continue;
        const char* const separator = length == 0 ? "" : ", ";
        const int written = std::snprintf(list + length, sizeof list - length, "%s%u %s", separator, count, what);
        length += static_cast<size_t>(written);
    }
    if (length > 0) log(FLG_LOG_LEVEL_WARNING, "%s (0x%" PRIx64 ") %s: %s", object, handle, change, list);
}

}  // namespace flg
