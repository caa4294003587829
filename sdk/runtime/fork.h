// SPDX-License-Identifier: MIT
// Fork and join inside a job:
//
//     co_await fork(pace, count, body, context);
//
// runs body(pace, context, i) for every i in [0, count), on as many strands as the context has threads, and goes on
// when all are done. Which strand takes which i is left to chance, so bodies must write only what belongs to i. If
// bodies throw, the exception of the smallest i is thrown here, after all others have run. Only a job's first strand
// forks; branches don't.
#pragma once

#include <algorithm>
#include <atomic>
#include <deque>

#include "runtime/job.h"
#include "runtime/strand.h"

namespace flg {

class Fork {
public:
    Fork(Pace& pace, Strand& first_strand) : parent(first_strand), branches(pace.memory()) {}

    Strand& parent;
    std::pmr::deque<Strand> branches;
    uint32_t unfinished = 0;  // branches still running; guarded by the scheduler's mutex
    std::atomic<uint32_t> next_index{0};

    // The failure of the smallest index, as each branch saw it.
    struct Thrown {
        uint32_t index = UINT32_MAX;
        std::exception_ptr exception;
    };
};

namespace detail {

template <class Context>
using ForkBody = Task<void> (*)(Pace&, Context&, uint32_t);

template <class Context>
Task<void> run_branch(Pace& pace, Fork& fork, uint32_t count, ForkBody<Context> body, Context& context,
                      Fork::Thrown& thrown) {
    for (uint32_t i; (i = fork.next_index.fetch_add(1, std::memory_order_relaxed)) < count;) {
        std::exception_ptr exception;
        try {
            co_await body(pace, context, i);
        } catch (...) {
            exception = std::current_exception();
        }
        if (exception && i < thrown.index) thrown = {i, exception};
    }
}

// Suspends the parent; the scheduler starts the branches once the parent's slice is over.
struct WaitForBranches {
    Pace& pace;
    Fork& fork;
    bool await_ready() const noexcept { return false; }
    void await_suspend(std::coroutine_handle<> point) const noexcept {
        pace.resume_point = point;
        pace.forked = &fork;
    }
    void await_resume() const noexcept {}
};

}  // namespace detail

template <class Context>
Task<void> fork(Pace& pace, uint32_t count, detail::ForkBody<Context> body, Context& context) {
    Job& job = pace.job();
    const uint32_t branch_count = std::min(count, job.concurrency);
    Fork forked(pace, job.strand);
    std::pmr::vector<Fork::Thrown> thrown(std::max(1u, branch_count), pace.memory());
    if (branch_count <= 1) {
        co_await detail::run_branch<Context>(pace, forked, count, body, context, thrown[0]);
    } else {
        for (uint32_t b = 0; b < branch_count; ++b) {
            Strand& branch = forked.branches.emplace_back(job, job.host, pace.memory());
            branch.member_of = &forked;
            branch.start(detail::run_branch<Context>(branch.pace, forked, count, body, context, thrown[b]));
        }
        forked.unfinished = branch_count;
        co_await detail::WaitForBranches{pace, forked};
    }
    const auto first =
        std::min_element(thrown.begin(), thrown.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
    if (first->exception) std::rethrow_exception(first->exception);
}

}  // namespace flg
