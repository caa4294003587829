// SPDX-License-Identifier: MIT
// Tasks run to their end without a scheduler.
#pragma once

#include <exception>
#include <limits>

#include "runtime/job.h"
#include "runtime/task.h"
#include "surfaces/test_meshes.h"

namespace flg::test {

// Runs the task that `make` makes of a pace; pauses at each opportunity if `haltingly`. Throws what it throws.
template <class Make>
void run_task(const Make& make, bool haltingly = false) {
    const Host host({}, {}, {});
    Job job(host, test_memory(), 1);
    Pace pace(job, host, test_memory());
    Task<void> task = make(pace);
    const uint64_t deadline = haltingly ? 0 : std::numeric_limits<uint64_t>::max();
    pace.begin_slice(host.now_ns(), deadline);
    task.handle().resume();
    while (!task.done()) pace.resume_point.resume();
    if (task.exception()) std::rethrow_exception(task.exception());
}

}  // namespace flg::test
