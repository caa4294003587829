// SPDX-License-Identifier: MIT
// The host's hooks (allocator, clock, log, profiler) as the rest of the SDK sees them. One per context; nothing here is
// shared between contexts.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory_resource>

#include "core/memory.h"
#include "filigree/filigree.h"

namespace flg {

// The host's allocator as a memory resource; std::bad_alloc when the hook returns null.
class HostMemory final : public std::pmr::memory_resource {
public:
    // A hook with null functions stands for aligned operator new and delete.
    explicit HostMemory(const FlgAllocator& allocator) : allocator_(allocator) {}

private:
    void* do_allocate(size_t size, size_t alignment) override;
    void do_deallocate(void* memory, size_t size, size_t alignment) override;
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    FlgAllocator allocator_;
};

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
