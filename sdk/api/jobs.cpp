// SPDX-License-Identifier: MIT
// Jobs as the host sees them.
#include "api/descriptors.h"

using namespace flg;

extern "C" {

FlgResult flgJobStatusInit(FlgJobStatus* status, uint32_t struct_size) {
    return init(status, struct_size, Job::first_status, "status");
}

FlgResult flgJobGetStatus(FlgContext context, FlgJob job, FlgJobStatus* out_status) {
    return guarded([&] {
        write_struct(out_status, Job::first_status, "out_status");
        Context& self = get_context(context);
        const auto of_job = self.jobs.get(job.id, "job");
        FlgJobStatus status = of_job->status;
        self.runtime.scheduler().fill_wait(*of_job, status);
        write_struct(out_status, status, "out_status");
    });
}

FlgResult flgJobGetStages(FlgContext context, FlgJob job, FlgStageTime* out_stages, uint32_t capacity,
                          uint32_t* out_count) {
    return guarded([&] {
        require(out_count, "out_count") = 0;
        if (capacity > 0) require(out_stages, "out_stages");
        const Job& self = *get_context(context).jobs.get(job.id, "job");
        if (self.status.state != FLG_JOB_STATE_FINISHED) return FLG_NOT_READY;
        constexpr float us_per_ns = 1e-3f;
        for (uint32_t i = 0; i < std::min(capacity, self.stage_count); ++i) {
            const StageTime& stage = self.stages[i];
            out_stages[i] = {stage.name, static_cast<float>(stage.end_ns - stage.start_ns) * us_per_ns,
                             static_cast<float>(stage.busy_end_ns - stage.busy_start_ns) * us_per_ns};
        }
        *out_count = self.stage_count;
        return FLG_OK;
    });
}

FlgResult flgJobCancel(FlgContext context, FlgJob job) {
    return guarded([&] {
        Context& self = get_context(context);
        self.runtime.scheduler().cancel(*self.jobs.get(job.id, "job"));
    });
}

FlgResult flgJobRelease(FlgContext context, FlgJob job) {
    return release(context, &Context::jobs, job, "job");
}

}  // extern "C"
