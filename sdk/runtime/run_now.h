// SPDX-License-Identifier: MIT
// Tasks without a scheduler: for callers that have no job, for tests and benchmarks. [any thread]
#pragma once

#include <limits>

#include "runtime/job.h"
#include "runtime/task.h"

namespace flg {

// Runs the task that make(pace) returns, on this thread, until it is done. The task pauses at each look at its pace;
// around(slice) calls slice() once, and may time it. Returns what the task returns and throws what it throws.
template <class Make, class Around>
auto run_haltingly(Memory* memory, const Make& make, const Around& around) {
    const Host host({}, {}, {});
    Job job(host, memory, memory, 1);
    Pace pace(job, host, memory);
    pace.begin_slice(host.now_ns(), 0);
    auto task = make(pace);
    pace.resume_point = task.handle();
    while (!task.done()) around([&] { pace.resume_point.resume(); });
    return task.result();
}

template <class Make>
auto run_haltingly(Memory* memory, const Make& make) {
    return run_haltingly(memory, make, [](const auto& slice) { slice(); });
}

// The same without a pause, unless `haltingly`.
template <class Make>
auto run_now(Memory* memory, const Make& make, bool haltingly = false) {
    if (haltingly) return run_haltingly(memory, make);
    const Host host({}, {}, {});
    Job job(host, memory, memory, 1);
    Pace pace(job, host, memory);
    pace.begin_slice(host.now_ns(), std::numeric_limits<uint64_t>::max());
    auto task = make(pace);
    task.handle().resume();
    return task.result();
}

}  // namespace flg
