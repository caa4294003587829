// SPDX-License-Identifier: MIT
#include "runtime/pace.h"

#include "core/failure.h"
#include "runtime/job.h"
#include "runtime/task.h"

namespace flg {

Memory* frame_memory(Pace& pace) {
    return pace.memory();
}

bool Pace::await_ready() noexcept {
    const uint64_t now_ns = host_.now_ns();
    end_chunk(now_ns);
    return now_ns < deadline_ns_ && --chunks_left_ > 0 && !job_.given_up();
}

void Pace::stage(const char* name) noexcept {
    const uint64_t now_ns = host_.now_ns();
    end_chunk(now_ns);
    job_.begin_stage(name, now_ns, slice_busy_ns());
}

void Pace::commit() noexcept {
    job_.committed.store(true, std::memory_order_relaxed);
}

void Pace::begin_revocable() noexcept {
    commit();
    revocable_ = true;
}

void Pace::throw_if_cancelled() const {
    if (job_.cancelled.load(std::memory_order_relaxed)) throw Failure(FLG_ERROR_CANCELLED, "the job was cancelled");
}

void Pace::expect(uint64_t units) noexcept {
    job_.expected_units.store(units, std::memory_order_relaxed);
}

void Pace::advance(uint64_t units) noexcept {
    job_.done_units.fetch_add(units, std::memory_order_relaxed);
}

void Pace::begin_slice(uint64_t now_ns, uint64_t deadline_ns) noexcept {
    slice_start_ns_ = chunk_start_ns_ = now_ns;
    deadline_ns_ = deadline_ns;
    chunks_left_ = 512;
    longest_ = {};
}

void Pace::end_slice(uint64_t now_ns) noexcept {
    end_chunk(now_ns);
}

void Pace::end_chunk(uint64_t now_ns) noexcept {
    const uint64_t duration_ns = now_ns - chunk_start_ns_;
    if (duration_ns > longest_.duration_ns) {
        const char* const stage = job_.stage.load(std::memory_order_relaxed);
        longest_ = {duration_ns, *stage != '\0' ? stage : "start"};
    }
    chunk_start_ns_ = now_ns;
}

}  // namespace flg
