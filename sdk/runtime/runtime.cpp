// SPDX-License-Identifier: MIT
#include "runtime/runtime.h"

namespace flg {

namespace {

Threading threading_of(const FlgContextDesc& desc) {
    if (desc.job_system && desc.job_system->submit) return Threading::host;
    return desc.worker_count > 0 ? Threading::workers : Threading::none;
}

template <class Hook>
Hook hook_or_none(const Hook* hook) {
    return hook ? *hook : Hook{};
}

uint32_t thread_count_of(const FlgContextDesc& desc) {
    return threading_of(desc) == Threading::host ? desc.job_system->concurrency : desc.worker_count;
}

}  // namespace

Runtime::Runtime(const FlgContextDesc& desc, Memory* memory, LargeBlocks& large_blocks)
    : memory_(memory),
      large_blocks_(large_blocks),
      host_(hook_or_none(desc.clock), hook_or_none(desc.log), hook_or_none(desc.profiler)),
      threading_(threading_of(desc)),
      scheduler_(host_, memory, large_blocks, thread_count_of(desc), desc.worker_budget_us) {
    if (threading_ == Threading::workers) crew_ = &workers_.emplace(scheduler_, desc.worker_count, memory);
    if (threading_ == Threading::host) crew_ = &host_tasks_.emplace(scheduler_, *desc.job_system);
}

Runtime::~Runtime() {
    stop();
}

bool Runtime::stop() {
    stopping_ = true;
    scheduler_.cancel_all();
    return !crew_ || crew_->stop();
}

FlgFrameReport Runtime::tick(uint32_t budget_us) {
    const uint64_t start_ns = host_.now_ns();
    const uint64_t deadline_ns = budget_us == FLG_UNLIMITED ? UINT64_MAX : start_ns + budget_us * uint64_t{1000};
    FlgFrameReport report{};
    report.struct_size = sizeof report;
    report.frame = ++frame_;
    large_blocks_.begin_frame();
    if (crew_) crew_->begin_frame();
    scheduler_.publish_progress();
    Scheduler::Published published = scheduler_.publish(deadline_ns, &report.callback_us);
    if (threading_ == Threading::none) {
        const uint64_t work_start_ns = host_.now_ns();
        float callbacks_us = 0;
        // Jobs that finish here are published at once if there is time; their callbacks may start new ones.
        // A budget that was spent before advances one slice still: every job comes to an end.
        bool goes_on = budget_us > 0;
        while (goes_on && scheduler_.run_next(deadline_ns)) {
            scheduler_.publish_progress();
            if (host_.now_ns() >= deadline_ns) break;
            const Scheduler::Published more = scheduler_.publish(deadline_ns, &callbacks_us);
            published.count += more.count;
            published.late += more.late;
            goes_on = host_.now_ns() < deadline_ns;
        }
        report.callback_us += callbacks_us;
        report.work_us = static_cast<float>(host_.now_ns() - work_start_ns) * 1e-3f - callbacks_us;
    }
    report.jobs_finished = published.count;
    report.jobs_late = published.late;
    const Scheduler::Statistics statistics = scheduler_.take_statistics();
    if (threading_ != Threading::none) report.worker_us = static_cast<float>(statistics.busy_ns) * 1e-3f;
    report.max_slice_us = static_cast<float>(statistics.longest.duration_ns) * 1e-3f;
    report.max_slice_stage = statistics.longest.stage;
    report.max_slice_job = statistics.max_job;
    report.jobs_pending = scheduler_.pending();
    report.tick_us = static_cast<float>(host_.now_ns() - start_ns) * 1e-3f;
    return report;
}

bool Runtime::wait(uint32_t timeout_us) {
    return threading_ == Threading::none || scheduler_.wait_publishable(timeout_us);
}

}  // namespace flg
