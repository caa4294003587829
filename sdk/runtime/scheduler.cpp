// SPDX-License-Identifier: MIT
#include "runtime/scheduler.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <new>
#include <utility>

#include "core/failure.h"
#include "runtime/fork.h"

namespace flg {

namespace {

// The sentence of the first failure is passed on as it is, however long the chain.
void describe_failed_dependency(const Job& failed, Job& dependent) {
    constexpr char prefix[] = "a job it depends on failed: ";
    const bool has_prefix = std::strncmp(failed.error, prefix, sizeof prefix - 1) == 0;
    std::snprintf(dependent.error, sizeof dependent.error, "%s%.220s", has_prefix ? "" : prefix, failed.error);
}

float late_us(const Job& job, uint64_t now_ns) {
    return job.deadline_ns < now_ns ? static_cast<float>(now_ns - job.deadline_ns) * 1e-3f : 0;
}

}  // namespace

Scheduler::~Scheduler() {
    // One by one: lists of shared pointers would free themselves recursively.
    const auto forget_dependents = [](Job& job) {
        while (Dependency* dependency = job.dependents) {
            job.dependents = dependency->next;
            const std::shared_ptr<Job> waiting = std::move(dependency->waiting);
        }
    };
    while (started_) started_ = std::exchange(started_->next_started, nullptr);
    while (const std::shared_ptr<Job> job = std::move(first_settling_)) {
        first_settling_ = std::move(job->next_settling);
        forget_dependents(*job);
    }
    while (first_pending_) {
        const std::shared_ptr<Job> job = first_pending_->self;
        forget_dependents(*job);
        remove_pending(*job);
    }
}

// ---- queues (mutex held) ---------------------------------------------------------------------------------------

ReadyQueue& Scheduler::queue_of(const Job& job) {
    if (job.given_up()) return ready_.back();
    const auto priority = static_cast<size_t>(job.priority - FLG_PRIORITY_LOW);
    return ready_[2 * priority + (job.busy_ns < short_ns ? 1 : 0)];
}

// Null: at the end. Not of a job that has a deadline.
void Scheduler::insert(Strand& strand, Strand* before) {
    ReadyQueue& queue = queue_of(strand.job);
    ++ready_count_;
    strand.queue = &queue;
    strand.next = before;
    strand.previous = before ? before->previous : queue.last;
    (strand.previous ? strand.previous->next : queue.first) = &strand;
    (before ? before->previous : queue.last) = &strand;
}

void Scheduler::push_wanted(Strand& strand) {
    ++ready_count_;
    heap_of(strand.job).insert(strand);
}

void Scheduler::push_back(Strand& strand) {
    if (is_wanted(strand.job)) return push_wanted(strand);
    insert(strand, nullptr);
}

void Scheduler::push_front(Strand& strand) {
    if (is_wanted(strand.job)) return push_wanted(strand);
    insert(strand, queue_of(strand.job).first);
}

void Scheduler::push_for_next_turn(Strand& strand, uint64_t busy_ns) {
    const Job& job = strand.job;
    if (is_wanted(job)) return push_wanted(strand);
    if (job.busy_ns < short_ns) return push_front(strand);
    if (job.busy_ns - busy_ns < short_ns) return push_back(strand);
    Strand* before = queue_of(job).first;
    for (uint32_t i = 1; i < turns && before; ++i) before = before->next;
    insert(strand, before);
}

void Scheduler::remove(Strand& strand) {
    --ready_count_;
    if (strand.heap) return strand.heap->remove(strand);
    (strand.previous ? strand.previous->next : strand.queue->first) = strand.next;
    (strand.next ? strand.next->previous : strand.queue->last) = strand.previous;
    strand.queue = nullptr;
}

// The queue it belongs in is another one now.
void Scheduler::requeue(Job& job) {
    const auto move = [this](Strand& strand) {
        if (!strand.queue && !strand.heap) return;
        remove(strand);
        push_back(strand);
    };
    move(job.strand);
    if (job.fork)
        for (Strand& branch : job.fork->branches) move(branch);
}

// What the job waits for: to its priority and its deadline.
void Scheduler::raise(Job& job) {
    job.next_raised = nullptr;
    for (Job *raised = &job, *last = &job; raised; raised = raised->next_raised) {
        if (raised != &job) requeue(*raised);
        for (const Dependency& dependency : raised->dependencies) {
            Job* const awaited = dependency.awaited;
            if (!awaited || (awaited->priority >= job.priority && awaited->wanted_ns <= job.wanted_ns)) continue;
            awaited->priority = std::max(awaited->priority, job.priority);
            awaited->wanted_ns = std::min(awaited->wanted_ns, job.wanted_ns);
            awaited->next_raised = nullptr;
            last = last->next_raised = awaited;
        }
    }
}

Strand* Scheduler::pop() {
    for (size_t q = ready_.size(); q-- > 0;) {
        Strand* strand = ready_[q].first;
        // A priority's short jobs come after those with a deadline.
        const bool of_priority = q + 1 < ready_.size() && q % 2 == 1;
        if (of_priority && wanted_[q / 2].first()) strand = wanted_[q / 2].first();
        if (!strand) continue;
        remove(*strand);
        return strand;
    }
    return nullptr;
}

// ---- running (any thread) ----------------------------------------------------------------------------------------

bool Scheduler::unmap_piece() {
    if (!large_blocks_.has_unwanted()) return false;
    const uint64_t start_ns = host_.now_ns();
    if (!large_blocks_.unmap_piece()) return false;
    const uint64_t duration_ns = host_.now_ns() - start_ns;
    std::lock_guard lock(mutex_);
    statistics_.busy_ns += duration_ns;
    if (duration_ns > statistics_.longest.duration_ns) {
        statistics_.longest = {duration_ns, "memory"};
        statistics_.max_job = {};
    }
    return true;
}

bool Scheduler::run_next(uint64_t deadline_ns) {
    if (unmap_piece()) return true;
    Strand* strand;
    {
        std::lock_guard lock(mutex_);
        if (tell_dependents()) return true;
        strand = pop();
        if (!strand) return false;
        Job& job = strand->job;
        if (!job.started) {
            job.started = true;
            job.next_started = std::move(started_);
            started_ = job.shared_from_this();
        }
    }
    if (!strand->job.given_up()) {
        strand->pace.begin_slice(host_.now_ns(), deadline_ns);
        const char* const stage = strand->job.stage.load(std::memory_order_relaxed);
        host_.zone_begin(*stage != '\0' ? stage : "filigree job");
        {
            const JobMemory::Slice slice(strand->job.memory);
            strand->pace.resume_point.resume();
        }
        host_.zone_end();
        strand->pace.end_slice(host_.now_ns());
    } else {
        strand->pace.begin_slice(0, 0);
    }
    end_slice(*strand);
    return true;
}

void Scheduler::end_slice(Strand& strand) {
    Job& job = strand.job;
    const std::shared_ptr<Job> keep_alive = job.shared_from_this();
    const bool first = strand.member_of == nullptr;
    const bool given_up = job.given_up();
    const bool done = given_up || strand.root.done();
    FlgResult result = FLG_OK;
    char error[sizeof job.error] = "";
    if (first && done && !strand.pace.forked) {
        // The outcome is read, and what the job holds is freed, before others hear of it and outside the mutex.
        if (given_up && !strand.root.done()) {
            result = FLG_ERROR_CANCELLED;
            std::snprintf(error, sizeof error, "the job was cancelled");
        } else if (strand.root.exception()) {
            try {
                std::rethrow_exception(strand.root.exception());
            } catch (const Failure& failure) {
                result = failure.result();
                std::snprintf(error, sizeof error, "%s", failure.what());
            } catch (const MemoryLimitReached& reached) {
                result = FLG_ERROR_OUT_OF_MEMORY;
                std::snprintf(error, sizeof error, "%s, during %s", reached.what(), job.stage.load());
            } catch (const std::bad_alloc&) {
                result = FLG_ERROR_OUT_OF_MEMORY;
                std::snprintf(error, sizeof error, "the allocator returned null during %s", job.stage.load());
            } catch (const std::exception& e) {
                result = FLG_ERROR_INTERNAL;
                std::snprintf(error, sizeof error, "%s", e.what());
            } catch (...) {
                result = FLG_ERROR_INTERNAL;
                std::snprintf(error, sizeof error, "unknown exception during %s", job.stage.load());
            }
        }
        job.end_stage(host_.now_ns(), strand.pace.slice_busy_ns());
        strand.root.reset();
        if (const auto reached = job.memory.settle(); reached && result == FLG_OK) {
            result = FLG_ERROR_OUT_OF_MEMORY;
            std::snprintf(error, sizeof error, "%s: the job's result", reached->what());
        }
    }

    bool woke = false;
    {
        std::lock_guard lock(mutex_);
        const Chunk& chunk = strand.pace.max_slice();
        const uint64_t busy_ns = strand.pace.slice_busy_ns();
        job.busy_ns += busy_ns;
        job.max_slice_ns = std::max(job.max_slice_ns, chunk.duration_ns);
        statistics_.busy_ns += busy_ns;
        if (chunk.duration_ns > statistics_.longest.duration_ns) {
            statistics_.longest = chunk;
            statistics_.max_job = job.handle;
        }
        if (Fork* fork = strand.pace.forked) {
            // The branches start only now, when nothing refers to the parent's slice any more.
            strand.pace.forked = nullptr;
            job.fork = fork;
            for (Strand& branch : fork->branches) push_back(branch);
            woke = true;
        } else if (!done) {
            push_for_next_turn(strand, busy_ns);
        } else if (first) {
            complete(job, result, error);
            woke = true;
        } else {
            finish_branch(strand);
        }
    }
    if (woke) wake();
}

void Scheduler::finish_branch(Strand& strand) {
    Fork& fork = *strand.member_of;
    if (--fork.unfinished > 0) return;
    fork.parent.job.fork = nullptr;
    push_front(fork.parent);
}

// Mutex held.
void Scheduler::complete(Job& job, FlgResult result, const char* error) {
    job.done = true;
    job.result = result;
    if (result == FLG_OK) usual_times_.add(job.strand.kind, job.busy_ns);
    if (error != job.error) std::snprintf(job.error, sizeof job.error, "%s", error);
    add_finished(job);
    if (job.dependents) {
        Job* const before = std::exchange(last_settling_, &job);
        (before ? before->next_settling : first_settling_) = job.shared_from_this();
        if (!before) tell_dependents();
    }
    publishable_.notify_all();
}

// Mutex held. Those of a failed job fail too, however long the chain. False if there is nobody to be told.
bool Scheduler::tell_dependents() {
    if (!first_settling_) return false;
    for (uint32_t told = 0; told < most_told && first_settling_; ++told) {
        Job& job = *first_settling_;
        Dependency* const dependency = job.dependents;
        job.dependents = dependency->next;
        dependency->awaited = nullptr;
        const std::shared_ptr<Job> dependent = std::move(dependency->waiting);
        const bool goes_on = job.result == FLG_OK || dependency->order_only;
        if (!dependent->done && goes_on) {
            if (--dependent->waiting_for == 0) push_back(dependent->strand);
        } else if (!dependent->done) {
            describe_failed_dependency(job, *dependent);
            complete(*dependent, FLG_ERROR_DEPENDENCY, dependent->error);
        }
        if (job.dependents) continue;
        const std::shared_ptr<Job> settled = std::move(first_settling_);
        first_settling_ = std::move(settled->next_settling);
        if (!first_settling_) last_settling_ = nullptr;
    }
    return true;
}

// Into the list of finished jobs, which is in order of submission. Most belong near its end.
void Scheduler::add_finished(Job& job) {
    Job* before = last_finished_;
    while (before && before->serial > job.serial) before = before->previous_finished;
    Job* const after = before ? before->next_finished : first_finished_;
    job.previous_finished = before;
    job.next_finished = after;
    (before ? before->next_finished : first_finished_) = &job;
    (after ? after->previous_finished : last_finished_) = &job;
}

// ---- host's thread -------------------------------------------------------------------------------------------------

std::shared_ptr<Job> Scheduler::make_job(Memory* scratch) {
    return std::allocate_shared<Job>(std::pmr::polymorphic_allocator<Job>(memory_), host_, memory_, scratch,
                                     std::max(1u, threads_));
}

void Scheduler::submit(std::shared_ptr<Job> job, const std::pmr::vector<Prerequisite>& prerequisites) {
    // All memory is taken before anything changes, so that a failing allocator leaves no trace.
    if (running_.capacity() <= pending_) running_.reserve(std::max(size_t{8}, size_t{pending_} * 2));
    job->dependencies.resize(prerequisites.size());
    if (next_serial_ == 1) usual_times_.make_table();
    job->serial = next_serial_++;
    job->wanted_ns = job->deadline_ns;
    bool ready = false;
    {
        std::lock_guard lock(mutex_);
        job->usual_ns = usual_times_.of(job->strand.kind);
        const Job* failed = nullptr;
        for (size_t i = 0; i < prerequisites.size(); ++i) {
            Job& other = *prerequisites[i].job;
            if (!other.done) {
                job->dependencies[i] = {job, &other, other.dependents, prerequisites[i].order_only};
                other.dependents = &job->dependencies[i];
                ++job->waiting_for;
            } else if (other.result != FLG_OK && !prerequisites[i].order_only && !failed) {
                failed = &other;
            }
        }
        if (failed) {
            describe_failed_dependency(*failed, *job);
            complete(*job, FLG_ERROR_DEPENDENCY, job->error);
        } else if (job->waiting_for == 0) {
            push_back(job->strand);
            ready = true;
        } else {
            raise(*job);
        }
    }
    append_pending(std::move(job));
    if (ready) wake();
}

void Scheduler::append_pending(std::shared_ptr<Job> job) {
    ++pending_;
    job->previous_pending = last_pending_;
    (last_pending_ ? last_pending_->next_pending : first_pending_) = job.get();
    last_pending_ = job.get();
    last_pending_->self = std::move(job);
}

void Scheduler::remove_pending(Job& job) {
    --pending_;
    (job.previous_pending ? job.previous_pending->next_pending : first_pending_) = job.next_pending;
    (job.next_pending ? job.next_pending->previous_pending : last_pending_) = job.previous_pending;
    job.self.reset();
}

void Scheduler::cancel(Job& job) {
    bool woke = false;
    {
        std::lock_guard lock(mutex_);
        if (job.done) return;
        job.cancelled.store(true, std::memory_order_relaxed);
        if (job.waiting_for > 0) {
            complete(job, FLG_ERROR_CANCELLED, "the job was cancelled");
            woke = true;
        } else {
            if (job.given_up()) requeue(job);
        }
    }
    if (woke) wake();
}

void Scheduler::cancel_all() {
    for (Job* job = first_pending_; job; job = job->next_pending) {
        job->committed.store(false, std::memory_order_relaxed);
        cancel(*job);
    }
}

void Scheduler::publish_progress() {
    std::shared_ptr<Job> started;
    {
        std::lock_guard lock(mutex_);
        started = std::move(started_);
    }
    while (started) {
        // Within its capacity, see submit. A job that was published meanwhile is not running any more.
        if (started->status.state != FLG_JOB_STATE_FINISHED) running_.push_back(started.get());
        started = std::move(started->next_started);
    }
    for (Job* job : running_) {
        FlgJobStatus& status = job->status;
        status.state = FLG_JOB_STATE_RUNNING;
        status.stage = job->stage.load(std::memory_order_relaxed);
        constexpr double highest_unfinished = 0.999;
        const double share = job->done_share();
        status.progress = std::max(status.progress, static_cast<float>(std::min(share, highest_unfinished)));
        status.late_us = late_us(*job, host_.now_ns());
        {
            std::lock_guard lock(mutex_);
            if (job->knows_remaining()) status.remaining_us = static_cast<float>(job->remaining_ns()) * 1e-3f;
            status.busy_us = static_cast<float>(job->busy_ns) * 1e-3f;
            status.max_slice_us = static_cast<float>(job->max_slice_ns) * 1e-3f;
        }
        if (job->partial_results && job->output) job->output->publish_partial();
    }
}

void Scheduler::fill_wait(Job& job, FlgJobStatus& status) {
    std::lock_guard lock(mutex_);
    if (job.done || job.started) return;
    if (job.knows_remaining()) status.remaining_us = static_cast<float>(job.remaining_ns()) * 1e-3f;
    status.wait = FLG_JOB_WAIT_TURN;
    if (job.waiting_for == 0) return;
    const Dependency* dependency = &job.first_awaited();
    status.wait = dependency->order_only ? FLG_JOB_WAIT_ORDER : FLG_JOB_WAIT_INPUT;
    // The library's own jobs have no handle; those they wait for may.
    while (dependency->awaited->handle.id == 0 && dependency->awaited->waiting_for > 0)
        dependency = &dependency->awaited->first_awaited();
    status.waits_for = dependency->awaited->handle;
}

Scheduler::Published Scheduler::publish(uint64_t deadline_ns, float* callback_us) {
    Published published;
    do {
        std::shared_ptr<Job> job;
        {
            std::lock_guard lock(mutex_);
            if (!first_finished_) break;
            job = first_finished_->self;
            first_finished_ = job->next_finished;
            (first_finished_ ? first_finished_->previous_finished : last_finished_) = nullptr;
        }
        publish_job(*job);
        ++published.count;
        if (job->status.late_us > 0) ++published.late;
        if (job->on_finished) {
            const uint64_t start_ns = host_.now_ns();
            job->on_finished(job->user_data, job->handle, job->result);
            *callback_us += static_cast<float>(host_.now_ns() - start_ns) * 1e-3f;
        }
    } while (host_.now_ns() < deadline_ns);
    return published;
}

void Scheduler::publish_job(Job& job) {
    FlgJobStatus& status = job.status;
    status.state = FLG_JOB_STATE_FINISHED;
    status.result = job.result;
    if (job.result == FLG_OK) status.progress = 1;
    status.remaining_us = 0;
    status.late_us = late_us(job, host_.now_ns());
    status.error = job.error;
    status.stage = job.stage.load(std::memory_order_relaxed);
    status.busy_us = static_cast<float>(job.busy_ns) * 1e-3f;
    status.max_slice_us = static_cast<float>(job.max_slice_ns) * 1e-3f;
    if (job.output) {
        job.output->publish(job);
        if (job.result == FLG_OK) job.output->warn(host_);
    }
    job.output.reset();
    job.strand.root.reset();  // of a job that never ran; others freed it when they were done
    std::erase(running_, &job);
    remove_pending(job);
    if (job.result != FLG_OK && job.result != FLG_ERROR_CANCELLED) {
        host_.log(FLG_LOG_LEVEL_ERROR, "job %llu failed: %s", static_cast<unsigned long long>(job.serial), job.error);
    }
}

bool Scheduler::wait_publishable(uint32_t timeout_us) {
    if (pending_ == 0) return true;
    std::unique_lock lock(mutex_);
    return publishable_.wait_for(lock, std::chrono::microseconds(timeout_us),
                                 [this] { return first_finished_ != nullptr; });
}

Scheduler::Statistics Scheduler::take_statistics() {
    std::lock_guard lock(mutex_);
    return std::exchange(statistics_, {});
}

}  // namespace flg
