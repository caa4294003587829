// SPDX-License-Identifier: MIT
#include "runtime/workers.h"

#include <algorithm>
#include <utility>

namespace flg {

// ---- threads of our own --------------------------------------------------------------------------------------------

Workers::Workers(Scheduler& scheduler, uint32_t count, Memory* memory) : scheduler_(scheduler), threads_(memory) {
    scheduler.set_wake([](void* self) { static_cast<Workers*>(self)->wake_.notify_all(); }, this);
    threads_.reserve(count);
    try {
        for (uint32_t i = 0; i < count; ++i) threads_.emplace_back([this] { work(); });
    } catch (...) {
        stop();
        throw;
    }
}

void Workers::begin_frame() {
    bool has_work;
    {
        std::lock_guard lock(scheduler_.mutex());
        ++frame_;
        has_work = scheduler_.ready_count() > 0;
    }
    if (has_work) wake_.notify_all();
}

bool Workers::stop() {
    {
        std::lock_guard lock(scheduler_.mutex());
        stopping_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    return true;
}

void Workers::work() {
    const Host& host = scheduler_.host();
    const uint64_t budget_ns = scheduler_.worker_budget_ns();
    uint64_t frame = 0;
    uint64_t used_ns = 0;
    bool told = false;  // the others, that this one's budget is spent
    for (;;) {
        {
            std::unique_lock lock(scheduler_.mutex());
            for (;;) {
                if (stopping_) return;
                if (frame != frame_) {
                    frame = frame_;
                    used_ns = 0;
                    told = false;
                }
                const bool spent = budget_ns != 0 && used_ns >= budget_ns;
                if (scheduler_.ready_count() > 0) {
                    if (!spent) break;
                    // Once a frame, or spent workers would go on waking each other.
                    if (!std::exchange(told, true)) wake_.notify_all();
                }
                wake_.wait(lock);
            }
        }
        const uint64_t start_ns = host.now_ns();
        const uint64_t slice_ns = budget_ns == 0 ? worker_slice_ns : std::min(worker_slice_ns, budget_ns - used_ns);
        scheduler_.run_next(start_ns + slice_ns);
        used_ns += host.now_ns() - start_ns;
    }
}

// ---- the host's job system ----

HostTasks::HostTasks(Scheduler& scheduler, const FlgJobSystem& system) : scheduler_(scheduler), system_(system) {
    scheduler.set_wake([](void* self) { static_cast<HostTasks*>(self)->hand_over(); }, this);
}

bool HostTasks::may_go_on() const {
    const uint64_t budget_ns = scheduler_.worker_budget_ns() * system_.concurrency;
    return !stopping_ && scheduler_.ready_count() > 0 && (budget_ns == 0 || used_ns_ < budget_ns);
}

void HostTasks::hand_over() {
    uint32_t count = 0;
    {
        std::lock_guard lock(scheduler_.mutex());
        if (may_go_on()) {
            const uint32_t unserved = scheduler_.ready_count() - std::min(scheduler_.ready_count(), not_begun_);
            count = std::min(system_.concurrency - handed_over_, unserved);
        }
        handed_over_ += count;
        not_begun_ += count;
    }
    for (uint32_t i = 0; i < count; ++i) {
        system_.submit(
            system_.user_data, [](void* self) { static_cast<HostTasks*>(self)->run(); }, this);
    }
}

void HostTasks::run() {
    const Host& host = scheduler_.host();
    const uint64_t start_ns = host.now_ns();
    uint64_t slice_ns = worker_slice_ns;
    bool works;
    {
        std::lock_guard lock(scheduler_.mutex());
        --not_begun_;
        works = may_go_on();
        // The slice is booked before it is used, so that tasks side by side keep to the budget together.
        if (const uint64_t budget_ns = scheduler_.worker_budget_ns(); works && budget_ns != 0) {
            slice_ns = std::min({slice_ns, budget_ns, budget_ns * system_.concurrency - used_ns_});
        }
        if (works) used_ns_ += slice_ns;
    }
    if (works) scheduler_.run_next(start_ns + slice_ns);
    {
        std::lock_guard lock(scheduler_.mutex());
        if (works) {
            used_ns_ += host.now_ns() - start_ns;
            used_ns_ -= std::min(used_ns_, slice_ns);  // a tick may have begun a new frame meanwhile
        }
        if (!may_go_on()) {
            --handed_over_;
            return;
        }
        ++not_begun_;
    }
    system_.submit(
        system_.user_data, [](void* self) { static_cast<HostTasks*>(self)->run(); }, this);
}

void HostTasks::begin_frame() {
    {
        std::lock_guard lock(scheduler_.mutex());
        used_ns_ = 0;
    }
    hand_over();
}

bool HostTasks::stop() {
    std::lock_guard lock(scheduler_.mutex());
    stopping_ = true;
    return handed_over_ == 0;
}

}  // namespace flg
