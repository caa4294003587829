// SPDX-License-Identifier: MIT
// The scheduler: which strand runs next, what happens when its slice is over, and what the host gets to see of it.
//
//   submit -> [wait for dependencies] -> ready queue -> slices -> done -> published by tick
//
// Strands are run by whoever calls run_next: the tick itself, built-in workers or tasks in the host's job system (see
// workers.h). Ready strands run by priority: first what has to be taken down, and a job has at least the priority of
// those that wait for it. Among equals, jobs with a deadline come first, by the time at which they have to go on at the
// latest; then jobs that have run for less than 4 ms, in order of arrival; the others take turns, slice by slice, four
// at a time, so that a hundred jobs do not hold their memory at once.
// One mutex guards the queues; it is held for some tens of instructions (to tell dependents: for 64 of them at most)
// and never while work, a callback or the allocator runs (but to free a cancelled job that another one still listed).
#pragma once

#include <array>
#include <condition_variable>
#include <memory>
#include <mutex>

#include "runtime/job.h"
#include "runtime/large_blocks.h"
#include "runtime/strand_heap.h"
#include "runtime/usual_times.h"

namespace flg {

class Fork;

// How the host pays for work.
enum class Threading { none, workers, host };

class Scheduler {
public:
    Scheduler(const Host& host, Memory* memory, LargeBlocks& large_blocks, uint32_t threads, uint32_t worker_budget_us)
        : host_(host),
          memory_(memory),
          large_blocks_(large_blocks),
          threads_(threads),
          worker_budget_ns_(worker_budget_us * uint64_t{1000}) {}

    ~Scheduler();

    // ---- host's thread ----

    // A job ready to be filled in: output, task (job->strand.start), options. Its tasks work in `scratch`.
    std::shared_ptr<Job> make_job(Memory* scratch);
    // Queues it once all `prerequisites` are done; fails it if one of them failed, but for those of order only.
    void submit(std::shared_ptr<Job> job, const std::pmr::vector<Prerequisite>& prerequisites);
    void cancel(Job& job);
    // At the end of the context: also jobs that are committed.
    void cancel_all();

    // What a job waits for now.
    void fill_wait(Job& job, FlgJobStatus& status);

    // Publishes done jobs in order of submission until `deadline_ns`, at least one. Returns how many.
    struct Published {
        uint32_t count = 0, late = 0;
    };
    Published publish(uint64_t deadline_ns, float* callback_us);
    // Copies progress and partial results of running jobs to where the host sees them.
    void publish_progress();
    // Whether publish would find something; waits for it until `timeout_us` if not.
    bool wait_publishable(uint32_t timeout_us);
    uint32_t pending() const { return pending_; }

    // Since the last call: time spent by workers and the longest chunk with the job it came from.
    struct Statistics {
        uint64_t busy_ns = 0;
        Chunk longest;
        FlgJob max_job{};
    };
    Statistics take_statistics();

    // ---- any thread ----

    // Runs one slice of the first ready strand, or unmaps a piece of unwanted memory; false if there was neither.
    bool run_next(uint64_t deadline_ns);

    // For the threads that run strands.
    std::mutex& mutex() { return mutex_; }
    // Strands, and one each for dependents to be told and memory to be unmapped. With the mutex held.
    uint32_t ready_count() const {
        return ready_count_ + (first_settling_ ? 1 : 0) + (large_blocks_.has_unwanted() ? 1 : 0);
    }
    const Host& host() const { return host_; }
    Memory* memory() const { return memory_; }
    uint32_t threads() const { return threads_; }
    uint64_t worker_budget_ns() const { return worker_budget_ns_; }

    // Told, outside the mutex, when more strands became ready than the thread that made them so will run itself. Set
    // once, before the first job.
    void set_wake(void (*function)(void* context), void* context) {
        wake_ = function;
        wake_context_ = context;
    }

private:
    static constexpr int priority_count = 3;
    static constexpr uint64_t short_ns = 4'000'000;
    static constexpr uint32_t turns = 4;
    static constexpr uint32_t most_told = 64;

    static bool is_wanted(const Job& job) { return job.wanted_ns != UINT64_MAX && !job.given_up(); }
    StrandHeap& heap_of(const Job& job) { return wanted_[static_cast<size_t>(job.priority - FLG_PRIORITY_LOW)]; }
    ReadyQueue& queue_of(const Job& job);
    void insert(Strand& strand, Strand* before);
    void push_wanted(Strand& strand);
    void push_back(Strand& strand);
    void push_front(Strand& strand);
    // After a slice of so long.
    void push_for_next_turn(Strand& strand, uint64_t busy_ns);
    void remove(Strand& strand);
    void requeue(Job& job);
    void raise(Job& job);
    Strand* pop();
    bool unmap_piece();
    void end_slice(Strand& strand);
    void finish_branch(Strand& strand);
    void complete(Job& job, FlgResult result, const char* error);
    void add_finished(Job& job);
    bool tell_dependents();
    void publish_job(Job& job);
    void append_pending(std::shared_ptr<Job> job);
    void remove_pending(Job& job);
    void wake() {
        if (wake_) wake_(wake_context_);
    }

    const Host& host_;
    Memory* memory_;
    LargeBlocks& large_blocks_;
    uint32_t threads_;
    uint64_t worker_budget_ns_;
    void (*wake_)(void*) = nullptr;
    void* wake_context_ = nullptr;

    std::mutex mutex_;
    std::condition_variable publishable_;
    std::array<ReadyQueue, 2 * priority_count + 1> ready_;  // the last first
    std::array<StrandHeap, priority_count> wanted_;         // jobs with a deadline
    UsualTimes usual_times_{memory_};
    uint32_t ready_count_ = 0;
    std::shared_ptr<Job> started_;         // list of jobs that ran for the first time since the last tick
    std::shared_ptr<Job> first_settling_;  // jobs that are done and whose dependents are to be told
    Job* last_settling_ = nullptr;
    Job* first_finished_ = nullptr;  // done and not published, in order of submission
    Job* last_finished_ = nullptr;
    Statistics statistics_;

    // Host's thread only.
    uint64_t next_serial_ = 1;
    uint32_t pending_ = 0;
    Job* first_pending_ = nullptr;  // not yet published, in order of submission
    Job* last_pending_ = nullptr;
    std::pmr::vector<Job*> running_{memory_};
};

}  // namespace flg
