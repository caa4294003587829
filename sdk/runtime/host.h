// SPDX-License-Identifier: MIT
// The host's clock, log and profiler as the rest of the SDK sees them (its allocator: core/host_memory.h). One per
// context; nothing here is shared between contexts.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "filigree/filigree.h"

namespace flg {

// Clock, log and profiler. Thread-safe as the hooks are; log only on the host's thread.
class Host {
public:
    Host(const FlgClock& clock, const FlgLog& log, const FlgProfiler& profiler)
        : clock_(clock), log_(log), profiler_(profiler) {}

    uint64_t now_ns() const;

    [[gnu::format(printf, 3, 4)]] void log(FlgLogLevel level, const char* format, ...) const;

    // A warning that names an object and what became of its input, with those counts that are not 0; none if all are.
    struct Count {
        uint32_t count;
        const char* what;
    };
    void warn(const char* object, uint64_t handle, const char* change, std::initializer_list<Count> counts) const;

    void zone_begin(const char* name) const {
        if (profiler_.begin) profiler_.begin(profiler_.user_data, name);
    }
    void zone_end() const {
        if (profiler_.end) profiler_.end(profiler_.user_data);
    }

private:
    FlgClock clock_;
    FlgLog log_;
    FlgProfiler profiler_;
};

}  // namespace flg
