// SPDX-License-Identifier: MIT
// Who runs strands besides the tick: threads of our own, or tasks in the host's job system. Both keep to the budget
// that workers have between two ticks.
#pragma once

#include <condition_variable>
#include <thread>
#include <vector>

#include "runtime/scheduler.h"

namespace flg {

// How long a worker runs one strand before it looks for something more urgent.
constexpr uint64_t worker_slice_ns = 500'000;

class Crew {
public:
    virtual ~Crew() = default;
    // The tick: budgets start anew.
    virtual void begin_frame() = 0;
    // Asks all to stop. Returns whether none is left that could touch the scheduler.
    virtual bool stop() = 0;
};

// Threads of our own. stop() joins them.
class Workers final : public Crew {
public:
    Workers(Scheduler& scheduler, uint32_t count, Memory* memory);
    ~Workers() override { stop(); }
    void begin_frame() override;
    bool stop() override;

private:
    void work();

    Scheduler& scheduler_;
    std::condition_variable wake_;
    uint64_t frame_ = 0;     // guarded by the scheduler's mutex
    bool stopping_ = false;  // likewise
    std::pmr::vector<std::thread> threads_;
};

// Tasks in the host's job system; at most `concurrency` handed over at a time.
class HostTasks final : public Crew {
public:
    HostTasks(Scheduler& scheduler, const FlgJobSystem& system);
    void begin_frame() override;
    bool stop() override;

private:
    void hand_over();
    void run();
    bool may_go_on() const;

    Scheduler& scheduler_;
    FlgJobSystem system_;
    // Guarded by the scheduler's mutex.
    uint32_t handed_over_ = 0;
    uint32_t not_begun_ = 0;  // of them, waiting in the host's queue
    uint64_t used_ns_ = 0;    // by all tasks, this frame
    bool stopping_ = false;
};

}  // namespace flg
