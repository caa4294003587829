// SPDX-License-Identifier: MIT
#include "api/context.h"
#include "api/descriptors.h"
#include "api/error.h"
#include "api/inputs.h"
#include "surfaces/surface.h"

namespace flg {

namespace {

FlgJobOptions default_job_options() {
    auto options = sized<FlgJobOptions>();
    options.priority = FLG_PRIORITY_NORMAL;
    return options;
}

}  // namespace

Submission::Submission(Context& context, const FlgJobOptions* job)
    : context_(context),
      dependencies_(context.memory[MemoryKind::runtime]),
      turns_(context.memory[MemoryKind::runtime]) {
    refuse_after_destroy(context);
    const FlgJobOptions options = job ? read_struct(job, default_job_options(), "job") : default_job_options();
    check_enum(options.priority, FLG_PRIORITY_LOW, FLG_PRIORITY_HIGH, "job.priority", "FLG_PRIORITY_");
    if (options.dependency_count > 0 && !options.dependencies) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "job.dependencies is null, but dependency_count is %u",
                      options.dependency_count);
    }
    for (uint32_t i = 0; i < options.dependency_count; ++i) {
        dependencies_.push_back(context.jobs.get(options.dependencies[i].id, "a handle in job.dependencies"));
    }
    job_ = context.runtime.scheduler().make_job(context.memory[MemoryKind::scratch]);
    job_->memory.open(context.memory);
    job_->priority = options.priority;
    job_->partial_results = options.partial_results != 0;
    job_->on_finished = options.on_finished;
    job_->user_data = options.user_data;
    if (options.deadline_us != 0)
        job_->deadline_ns = context.runtime.host().now_ns() + uint64_t{1000} * options.deadline_us;
}

void Submission::use_surface(const std::shared_ptr<Surface>& surface, bool changes, const char* argument) {
    read(*surface, argument);
    surface->order.add_prerequisites(changes, dependencies_);
    turns_.push_back({surface, changes});
}

void Submission::queue(FlgJob* out_job) {
    if (out_job) job_->handle = {context_.jobs.add(job_)};
    try {
        context_.runtime.scheduler().submit(job_, dependencies_);
    } catch (...) {
        if (out_job) context_.jobs.remove(job_->handle.id, "job");
        throw;
    }
    for (const Turn& turn : turns_) turn.surface->order.enter(job_, turn.changes);
    if (out_job) *out_job = job_->handle;
}

}  // namespace flg

using namespace flg;

FlgResult flgJobOptionsInit(FlgJobOptions* options, uint32_t struct_size) {
    return init(options, struct_size, default_job_options(), "options");
}
