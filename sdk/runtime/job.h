// SPDX-License-Identifier: MIT
// A job: a task with a place in the queue, dependencies, and what the host may know of it.
//
// Three kinds of members, by who may touch them:
// - set at submission, read by all;
// - live: atomics, or guarded by the scheduler's mutex;
// - published: what the host sees, written only inside flgContextTick on the host's thread.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <vector>

#include "runtime/context_memory.h"
#include "runtime/strand.h"

namespace flg {

class Fork;
class Job;

// What a job makes. The host sees it through a handle; what the handle shows changes when these are called.
class Output {
public:
    virtual ~Output() = default;
    virtual void publish_partial() noexcept = 0;  // for jobs with partial_results, each flgContextTick while they run
    virtual void publish(const Job& job) noexcept = 0;
    // One sentence for the host's log, if the input was repaired or something of it was lost: after a good job was
    // published.
    virtual void warn(const Host&) const noexcept {}

    uint64_t handle = 0;  // of the object, for such sentences
};

// A job that another one waits for.
struct Prerequisite {
    Prerequisite(std::shared_ptr<Job> awaited, bool for_order_only = false)
        : job(std::move(awaited)), order_only(for_order_only) {}
    std::shared_ptr<Job> job;
    bool order_only;  // it has to be done, but may have failed
};

// That one job waits for another: kept in the waiting job, listed by the other until that is done.
struct Dependency {
    std::shared_ptr<Job> waiting;
    Job* awaited = nullptr;
    Dependency* next = nullptr;
    bool order_only = false;
};

struct StageTime {
    const char* name = "";
    uint64_t start_ns = 0, end_ns = 0;
    uint64_t busy_start_ns = 0, busy_end_ns = 0;
};

class Job : public std::enable_shared_from_this<Job> {
public:
    static constexpr uint32_t max_stages = 16;

    Job(const Host& job_host, Memory* record_memory, Memory* scratch, uint32_t threads)
        : host(job_host), concurrency(threads), strand(*this, job_host, scratch), dependencies(record_memory) {}

    const Host& host;
    const uint32_t concurrency;  // strands a fork may use
    bool partial_results = false;
    uint64_t serial = 0;                // order of submission
    uint64_t deadline_ns = UINT64_MAX;  // by the host's clock; UINT64_MAX: none
    FlgJob handle{};
    JobMemory memory;
    void (*on_finished)(void*, FlgJob, FlgResult) = nullptr;
    void* user_data = nullptr;
    std::shared_ptr<Output> output;
    Strand strand;

    // Live, any thread.
    std::atomic<bool> cancelled{false};
    std::atomic<bool> committed{false};  // see Pace::commit
    bool given_up() const {
        return cancelled.load(std::memory_order_relaxed) && !committed.load(std::memory_order_relaxed);
    }
    std::atomic<const char*> stage{""};
    std::atomic<uint64_t> expected_units{0}, done_units{0};

    // Live, guarded by the scheduler's mutex. The stages belong to the job's first strand while it runs.
    FlgPriority priority = FLG_PRIORITY_NORMAL;  // at least that of every job that waits for this one
    uint64_t wanted_ns = UINT64_MAX;             // the deadline, or the least of those that wait for this one
    // When it has to go on at the latest: when it is wanted, less the work that is left by what it took so far.
    uint64_t latest_ns() const { return wanted_ns - std::min(wanted_ns, static_cast<uint64_t>(remaining_ns())); }
    bool started = false;
    bool done = false;
    Fork* fork = nullptr;                       // whose branches run now
    uint32_t waiting_for = 0;                   // dependencies that are not done
    uint32_t first_undone = 0;                  // those before it are done
    std::pmr::vector<Dependency> dependencies;  // what this job waits for
    const Dependency& first_awaited() {         // while it waits for one
        while (!dependencies[first_undone].awaited) ++first_undone;
        return dependencies[first_undone];
    }
    Dependency* dependents = nullptr;  // who waits for this job
    FlgResult result = FLG_NOT_READY;
    char error[256] = "";
    uint64_t busy_ns = 0;
    uint64_t usual_ns = 0;  // what jobs of its kind took lately; 0: there were none
    uint64_t max_slice_ns = 0;
    std::array<StageTime, max_stages> stages;
    uint32_t stage_count = 0;
    std::shared_ptr<Job> next_started;  // in the scheduler's list of started jobs
    Job* next_finished = nullptr;       // in its list of finished ones
    Job* previous_finished = nullptr;
    std::shared_ptr<Job> next_settling;  // in its list of jobs that are done and whose dependents are to be told
    Job* next_raised = nullptr;          // while a priority spreads

    // The scheduler's list of all jobs that are not published yet; it owns them. Host's thread only.
    std::shared_ptr<Job> self;
    Job* previous_pending = nullptr;
    Job* next_pending = nullptr;

    // Published.
    static constexpr FlgJobStatus first_status{.struct_size = sizeof(FlgJobStatus),
                                               .state = FLG_JOB_STATE_WAITING,
                                               .result = FLG_NOT_READY,
                                               .progress = 0,
                                               .stage = "",
                                               .error = "",
                                               .busy_us = 0,
                                               .max_slice_us = 0,
                                               .wait = FLG_JOB_WAIT_NONE,
                                               .remaining_us = -1,
                                               .waits_for = {},
                                               .late_us = 0,
                                               .reserved = 0};
    FlgJobStatus status = first_status;

    // The share that is done, 0 to 1; 0 also if that is not known.
    double done_share() const {
        const auto expected = static_cast<double>(expected_units.load(std::memory_order_relaxed));
        const auto finished = static_cast<double>(done_units.load(std::memory_order_relaxed));
        return expected > 0 ? std::min(finished / expected, 1.0) : 0;
    }
    // Work that is left at the rate so far, or else as others of its kind take; 0 also if that is not known.
    double remaining_ns() const {
        const double share = done_share();
        if (share > 0) return static_cast<double>(busy_ns) * (1 - share) / share;
        return static_cast<double>(usual_ns - std::min(usual_ns, busy_ns));
    }
    bool knows_remaining() const { return usual_ns > 0 || done_share() > 0; }

    void begin_stage(const char* name, uint64_t now_ns, uint64_t slice_busy_ns) noexcept {
        end_stage(now_ns, slice_busy_ns);
        stage.store(name, std::memory_order_relaxed);
        if (stage_count < max_stages) {
            const uint64_t busy = busy_ns + slice_busy_ns;
            stages[stage_count++] = {name, now_ns, now_ns, busy, busy};
        }
    }
    // Also ends the last stage when the job is done.
    void end_stage(uint64_t now_ns, uint64_t slice_busy_ns) noexcept {
        if (stage_count == 0) return;
        stages[stage_count - 1].end_ns = now_ns;
        stages[stage_count - 1].busy_end_ns = busy_ns + slice_busy_ns;
    }
};

}  // namespace flg
