// SPDX-License-Identifier: MIT
// Jobs for the runtime's tests: they compute something that shows in which order and how often they were run.
#pragma once

#include <atomic>
#include <memory_resource>
#include <vector>

#include "core/failure.h"
#include "core/random.h"
#include "runtime/fork.h"
#include "runtime/runtime.h"

namespace flg::test {

// Counts what is allocated and not freed; can be told to fail.
class CountingMemory final : public std::pmr::memory_resource {
public:
    std::atomic<int64_t> live{0};
    std::atomic<int64_t> calls{0};
    std::atomic<int64_t> fail_at{-1};  // the call that fails, -1 = none
    LargeBlocks large_blocks;          // for the runtime to tidy

private:
    void* do_allocate(size_t size, size_t alignment) override {
        if (calls.fetch_add(1) == fail_at.load()) throw std::bad_alloc();
        live.fetch_add(static_cast<int64_t>(size));
        return std::pmr::new_delete_resource()->allocate(size, alignment);
    }
    void do_deallocate(void* memory, size_t size, size_t alignment) override {
        live.fetch_sub(static_cast<int64_t>(size));
        std::pmr::new_delete_resource()->deallocate(memory, size, alignment);
    }
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
};

// A clock that moves only when told to, or by a fixed step each time it is asked.
struct ManualClock {
    std::atomic<uint64_t> now_ns{1000};
    uint64_t step_ns = 0;
    const FlgClock* hook() const { return &hook_; }

    const FlgClock hook_{sizeof(FlgClock), this, [](void* self) {
                             auto& clock = *static_cast<ManualClock*>(self);
                             return clock.now_ns.fetch_add(clock.step_ns);
                         }};
};

// Adds up `count` hashes in chunks of `chunk`, pausing after each.
inline Task<uint64_t> hash_sum(Pace& pace, uint32_t count, uint32_t chunk) {
    uint64_t sum = 0;
    for (uint32_t i = 0; i < count;) {
        for (uint32_t end = std::min(count, i + chunk); i < end; ++i) sum += mix64(i);
        pace.advance(chunk);
        co_await pace;
    }
    co_return sum;
}

inline uint64_t expected_hash_sum(uint32_t count) {
    uint64_t sum = 0;
    for (uint32_t i = 0; i < count; ++i) sum += mix64(i);
    return sum;
}

inline Task<void> store_hash_sum(Pace& pace, uint32_t count, uint32_t chunk, uint64_t* out) {
    pace.stage("hash");
    pace.expect(count);
    *out = co_await hash_sum(pace, count, chunk);
}

template <class Make>
std::shared_ptr<Job> submit(Runtime& runtime, Make&& make, FlgPriority priority = FLG_PRIORITY_NORMAL,
                            std::initializer_list<Prerequisite> prerequisites = {}, uint64_t deadline_ns = UINT64_MAX) {
    std::shared_ptr<Job> job = runtime.scheduler().make_job(runtime.memory());
    job->priority = priority;
    job->deadline_ns = deadline_ns;
    job->strand.start(make(job->strand.pace));
    std::pmr::vector<Prerequisite> wait_for(prerequisites, runtime.memory());
    runtime.scheduler().submit(job, wait_for);
    return job;
}

inline void tick_until_done(Runtime& runtime, uint32_t budget_us = 2000) {
    while (runtime.tick(budget_us).jobs_pending > 0) runtime.wait(1000);
}

}  // namespace flg::test
