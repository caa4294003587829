// SPDX-License-Identifier: MIT
// Tasks without a scheduler: for callers that have no job, for tests and benchmarks. [any thread]
#pragma once

#include <limits>

#include "runtime/job.h"
#include "runtime/task.h"

namespace flg {

namespace detail {

template <class Make, class Around>
auto run(Memory* memory, const Make& make, uint64_t deadline_ns, const Around& around) {
    const Host host({}, {}, {});
    Job job(host, memory, memory, 1);
    Pace pace(job, host, memory);
    pace.begin_slice(host.now_ns(), deadline_ns);
    auto task = make(pace);
    pace.resume_point = task.handle();
    while (!task.done()) {
        around([&] { pace.resume_point.resume(); });
        pace.begin_slice(host.now_ns(), deadline_ns);
    }
    return task.result();
}

}  // namespace detail

// Runs the task that make(pace) returns, on this thread, until it is done. The task pauses at each look at its pace;
// around(slice) calls slice() once, and may time it. Returns what the task returns and throws what it throws.
template <class Make, class Around>
auto run_haltingly(Memory* memory, const Make& make, const Around& around) {
    return detail::run(memory, make, 0, around);
}

template <class Make>
auto run_haltingly(Memory* memory, const Make& make) {
    return run_haltingly(memory, make, [](const auto& slice) { slice(); });
}

// The same in slices without a deadline, unless `haltingly`.
template <class Make>
auto run_now(Memory* memory, const Make& make, bool haltingly = false) {
    const uint64_t deadline_ns = haltingly ? 0 : std::numeric_limits<uint64_t>::max();
    return detail::run(memory, make, deadline_ns, [](const auto& slice) { slice(); });
}

}  // namespace flg
