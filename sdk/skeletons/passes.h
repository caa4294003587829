// SPDX-License-Identifier: MIT
// each() for arrays that are mostly short: a drawn contour has some ten or hundred points, and all passes over it take
// tens of microseconds, of which the frames of each() would be a tenth. Arrays of one slice are worked on at once.
#pragma once

#include "runtime/each.h"

namespace flg {

class [[nodiscard]] Pass {
public:
    explicit Pass(Pace& pace) : pace_(pace) {}
    explicit Pass(Pace& pace, Task<void> task) : pace_(pace), task_(std::move(task)), is_long_(true) {}

    bool await_ready() noexcept { return !is_long_ && pace_.await_ready(); }
    std::coroutine_handle<> await_suspend(std::coroutine_handle<> awaiting) noexcept {
        if (is_long_) return std::move(task_).operator co_await().await_suspend(awaiting);
        pace_.await_suspend(awaiting);
        return std::noop_coroutine();
    }
    void await_resume() {
        if (is_long_) task_.result();
    }

private:
    Pace& pace_;
    Task<void> task_;
    bool is_long_ = false;
};

// body(i) for every i in [0, count).
template <class Body>
Pass pass(Pace& pace, size_t count, Cost cost, Body body) {
    if (count > static_cast<uint32_t>(cost)) return Pass(pace, each(pace, count, cost, std::move(body)));
    detail::run_steps(body, 0, static_cast<uint32_t>(count));
    return Pass(pace);
}

}  // namespace flg
