// SPDX-License-Identifier: MIT
#include "documents/session.h"

#include <algorithm>

#include "documents/failure.h"
#include "documents/progress.h"

namespace flg::cli {
namespace {

// How long to sleep for workers before progress is shown again.
constexpr uint32_t kWaitUs = 50'000;
FlgJobStatus status_of(FlgContext context, FlgJob job) {
    FlgJobStatus status = {};
    status.struct_size = sizeof status;
    check(flgJobGetStatus(context, job, &status), "job");
    return status;
}

}  // namespace

Session::Session(const CommonOptions& common, const FlgAllocator& allocator) : common_(common) {
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = common.workers;
    desc.allocator = &allocator;
    check(flgContextCreate(&desc, &context_), "context");
}

Session::~Session() {
    flgContextDestroy(context_);
}

void Session::finish(std::span<const Pending> jobs, Report& report) {
    const auto all_finished = [&] {
        return std::all_of(jobs.begin(), jobs.end(), [&](const Pending& pending) {
            return status_of(context_, pending.job).state == FLG_JOB_STATE_FINISHED;
        });
    };
    while (!all_finished()) {
        FlgFrameReport frame = {};
        frame.struct_size = sizeof frame;
        check(flgContextTick(context_, common_.tick_budget_us(), &frame), "tick");
        times_.ticks_us.push_back(frame.tick_us);
        if (frame.max_slice_us > times_.max_slice_us) {
            times_.max_slice_us = frame.max_slice_us;
            times_.max_slice_stage = frame.max_slice_stage;
        }
        say_progress(jobs);
        if (common_.workers > 0 && frame.jobs_pending > 0) flgContextWait(context_, kWaitUs);
    }

    for (const Pending& pending : jobs) {
        const FlgJobStatus status = status_of(context_, pending.job);
        if (status.result == FLG_ERROR_DEPENDENCY) continue;  // the job it waited for says why
        if (status.result != FLG_OK) throw InputError(pending.subject + ": " + status.error);
        FlgStageTime stages[16];
        uint32_t count = 0;
        check(flgJobGetStages(context_, pending.job, stages, 16, &count), pending.subject);
        for (uint32_t i = 0; i < std::min(count, 16u); ++i) {
            report.add_stage(stages[i].name, stages[i].wall_us, stages[i].busy_us);
        }
    }
    report.set_ticks(times_);
}

void Session::say_progress(std::span<const Pending> jobs) const {
    for (const Pending& pending : jobs) {
        const FlgJobStatus status = status_of(context_, pending.job);
        if (status.state != FLG_JOB_STATE_RUNNING) continue;
        return say_share(status.stage, status.progress);
    }
}

}  // namespace flg::cli
