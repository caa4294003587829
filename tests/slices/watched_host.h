// SPDX-License-Identifier: MIT
// A host without workers that watches how long it is held: by slices of jobs, by ticks beyond their budget, by calls.
// Its clock says what "long" means: counted work, or processor time.
#pragma once

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "filigree/filigree_all.h"

namespace flg::slices {

struct Longest {
    double us = 0;
    std::string where;

    void note(double candidate_us, const std::string& candidate) {
        if (candidate_us > us) *this = {candidate_us, candidate};
    }
};

class WatchedHost {
public:
    static constexpr uint32_t budget_us = 1000;

    WatchedHost(const FlgClock& clock, const FlgAllocator* allocator) : clock_(clock) {
        FlgContextDesc desc = flgContextDefaults();
        desc.worker_count = 0;
        desc.clock = &clock_;
        desc.allocator = allocator;
        check("flgContextCreate", flgContextCreate(&desc, &context_));
    }
    ~WatchedHost() { flgContextDestroy(context_); }
    WatchedHost(const WatchedHost&) = delete;
    WatchedHost& operator=(const WatchedHost&) = delete;

    FlgContext context() const { return context_; }

    // A call of the SDK that returns at once.
    template <class... Parameters, class... Arguments>
    void call(const char* name, FlgResult (*function)(FlgContext, Parameters...), Arguments&&... arguments) {
        calls.note(time(name, function, std::forward<Arguments>(arguments)...), name);
    }
    // A call that copies, or looks at, what the host hands over: it takes as long as that is large.
    template <class... Parameters, class... Arguments>
    void copy(const char* name, FlgResult (*function)(FlgContext, Parameters...), Arguments&&... arguments) {
        copies.note(time(name, function, std::forward<Arguments>(arguments)...), name);
    }
    FlgJob* job() { return &jobs_.emplace_back(); }
    // What was made is released by release_all(), the last first.
    template <class Handle>
    void made(const char* name, FlgResult (*release)(FlgContext, Handle), Handle handle) {
        releases_.push_back([=, this] { call(name, release, handle); });
    }

    // Ticks until all jobs have ended, well or with this failure unless one was cancelled.
    void finish(FlgResult expected = FLG_OK) {
        run_ticks(UINT32_MAX);
        for (const FlgJob job : jobs_) {
            FlgJobStatus status = flgJobStatusDefaults();
            check("flgJobGetStatus", flgJobGetStatus(context_, job, &status));
            if (status.result != expected && !cancelled_) throw std::runtime_error(status.error);
            flgJobRelease(context_, job);
        }
        jobs_.clear();
        if (cancelled_) throw Cancelled();
    }
    // Its releases, and what ticks give back after them.
    void release_all() {
        while (!releases_.empty()) {
            const auto release = std::move(releases_.back());
            releases_.pop_back();
            release();
        }
        for (int i = 0; i < 64; ++i) tick("after release");
    }

    // Thrown by finish() once the jobs that were there at that tick were cancelled.
    struct Cancelled {};
    void cancel_at_tick(uint32_t number) { cancel_at_ = number; }

    Longest slices, ticks, calls, copies;
    uint32_t tick_count = 0;

private:
    static void check(const char* name, FlgResult result) {
        if (result < 0) throw std::runtime_error(std::string(name) + ": " + flgErrorGetMessage());
    }
    uint64_t now() const { return clock_.now_ns(clock_.user_data); }
    template <class... Parameters, class... Arguments>
    double time(const char* name, FlgResult (*function)(FlgContext, Parameters...), Arguments&&... arguments) {
        const uint64_t start = now();
        const FlgResult result = function(context_, std::forward<Arguments>(arguments)...);
        const double us = 1e-3 * static_cast<double>(now() - start);
        check(name, result);
        return us;
    }
    uint32_t tick(const std::string& where) {
        FlgFrameReport report = flgFrameReportDefaults();
        const uint64_t start = now();
        check("flgContextTick", flgContextTick(context_, budget_us, &report));
        const double us = 1e-3 * static_cast<double>(now() - start);
        ++tick_count;
        slices.note(static_cast<double>(report.max_slice_us), report.max_slice_stage);
        ticks.note(us - budget_us, where.empty() ? stage_ : where);
        if (report.max_slice_stage[0] != '\0') stage_ = std::string("near ") + report.max_slice_stage;
        return report.jobs_pending;
    }
    void run_ticks(uint32_t most) {
        while (most-- > 0) {
            if (tick_count + 1 == cancel_at_ && !jobs_.empty()) cancel();
            if (tick("") == 0) return;
        }
    }
    void cancel() {
        cancelled_ = true;
        for (const FlgJob job : jobs_) call("flgJobCancel", flgJobCancel, job);
    }

    FlgClock clock_;
    FlgContext context_{};
    std::vector<FlgJob> jobs_;
    std::vector<std::function<void()>> releases_;
    std::string stage_;
    uint32_t cancel_at_ = 0;
    bool cancelled_ = false;
};

}  // namespace flg::slices
