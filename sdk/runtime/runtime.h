// SPDX-License-Identifier: MIT
// The frame-budgeted runtime of one context (design, section 2): jobs are coroutines over sliced kernels; the host
// calls tick once a frame, and all it can observe changes in there.
//
// What lives in this room: tasks and their pace, forks, jobs, the scheduler, workers, the host's hooks, handles.
// What does not: anything that knows what the jobs compute.
#pragma once

#include <optional>

#include "runtime/host.h"
#include "runtime/scheduler.h"
#include "runtime/workers.h"

namespace flg {

class Runtime {
public:
    // Hooks may be null; they are copied.
    Runtime(const FlgContextDesc& desc, Memory* memory, LargeBlocks& large_blocks);
    ~Runtime();

    FlgFrameReport tick(uint32_t budget_us);
    bool wait(uint32_t timeout_us);
    // Cancels all jobs and stops all workers. False if the host's job system still holds tasks.
    bool stop();
    // stop() was called: no job may be added any more.
    bool stopping() const { return stopping_; }

    Scheduler& scheduler() { return scheduler_; }
    Memory* memory() const { return memory_; }
    const Host& host() const { return host_; }

private:
    Memory* memory_;
    LargeBlocks& large_blocks_;
    Host host_;
    Threading threading_;
    Scheduler scheduler_;
    std::optional<Workers> workers_;
    std::optional<HostTasks> host_tasks_;
    Crew* crew_ = nullptr;
    uint64_t frame_ = 0;
    bool stopping_ = false;
};

}  // namespace flg
