// SPDX-License-Identifier: MIT
// The pace of one strand of work: how long it may go on now, and what it reports while it does.
//
//     while (!kernel.run(256)) co_await pace;
//
// goes on without suspending while the slice has time left. Kernels are told how much to do in units of work, never in
// time, so results cannot depend on the speed of the machine.
#pragma once

#include <coroutine>
#include <cstdint>

#include "core/memory.h"
#include "runtime/host.h"

namespace flg {

class Job;
class Fork;

// The longest run of work between two pauses.
struct Chunk {
    uint64_t duration_ns = 0;
    const char* stage = "";
};

class Pace {
public:
    Pace(Job& job, const Host& host, Memory* memory) : job_(job), host_(host), memory_(memory) {}
    Pace(const Pace&) = delete;
    Pace& operator=(const Pace&) = delete;

    // Awaiting a pace ends the chunk; suspends when the slice's time is over, after 512 chunks, or when the job was
    // cancelled. The number of chunks bounds the stack of compilers that make no tail calls (unoptimized code, thread
    // sanitizer): there every task that was awaited since the slice began keeps its frame.
    bool await_ready() noexcept;
    void await_suspend(std::coroutine_handle<> point) noexcept { resume_point = point; }
    void await_resume() const {
        if (revocable_) throw_if_cancelled();
    }

    // Begins a named stage of the job (a string literal); for the job's first strand only. At most 16 a job.
    void stage(const char* name) noexcept;
    // From here on the job goes on to its end although it may be cancelled: it changes what outlives it, and a half of
    // that is worse than all of it. Only the end of the context stops it. For the job's first strand only.
    void commit() noexcept;
    // The same, but up to settle() awaiting the pace of a job that was cancelled throws FLG_ERROR_CANCELLED: what
    // awaits takes back what was changed. For the job's first strand only.
    void begin_revocable() noexcept;
    void settle() noexcept { revocable_ = false; }
    bool is_revocable() const { return revocable_; }
    // Progress in units that the job chooses: what there is in all, and what was done just now (any strand).
    void expect(uint64_t units) noexcept;
    void advance(uint64_t units) noexcept;

    Memory* memory() const { return memory_; }
    Job& job() const { return job_; }

    // For the scheduler: one slice is begin, resume, end.
    void begin_slice(uint64_t now_ns, uint64_t deadline_ns) noexcept;
    void end_slice(uint64_t now_ns) noexcept;
    uint64_t slice_busy_ns() const { return chunk_start_ns_ - slice_start_ns_; }
    const Chunk& max_slice() const { return longest_; }

    // Where the strand goes on.
    std::coroutine_handle<> resume_point;
    // Set when the strand has suspended to wait for the strands of a fork.
    Fork* forked = nullptr;

private:
    void end_chunk(uint64_t now_ns) noexcept;
    void throw_if_cancelled() const;

    Job& job_;
    const Host& host_;
    Memory* memory_;
    uint64_t slice_start_ns_ = 0;
    uint64_t deadline_ns_ = 0;
    uint64_t chunk_start_ns_ = 0;
    uint32_t chunks_left_ = 0;
    bool revocable_ = false;
    Chunk longest_;
};

}  // namespace flg
