// SPDX-License-Identifier: MIT
// What the entry points share that change tangles.
#pragma once

#include "api/surface_inputs.h"
#include "tangles/tangle_jobs.h"

namespace flg {

// Whether a tangle can be seen now.
inline FlgResult visible_result_now(const Tangle& tangle) {
    const FlgResult result = tangle.visible_result();
    if (result < 0) return set_last_error(result, tangle.error());
    return result == FLG_OK ? visible_result_now(*tangle.surface) : result;
}

// Where the surface's triangles are no longer those of the tangle's regions.
inline void refuse_changed_surface(const Tangle& tangle, const char* argument) {
    if (tangle.surface->order.revision() == tangle.revision) return;
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s: its surface was changed by others, from revision %u to %u", argument,
                  tangle.revision, tangle.surface->order.revision());
}

// A job that changes a tangle.
class TangleChange {
public:
    TangleChange(Context& context, const FlgJobOptions* job, FlgTangle handle, const char* argument)
        : tangle(context.tangles.get(handle.id, argument)), submission(context, job), context_(context) {
        submission.read(*tangle, argument);
        refuse_changed_surface(*tangle, argument);
    }

    // The surface's, after the job.
    uint32_t revision() const { return tangle->revision + 1; }
    void needs_blocks() { submission.wait_for(start_blocks(context_, tangle->surface)); }
    void commit(Task<void> task, FlgJob* out_job) {
        submission.change_surface(tangle->surface, "the surface of the tangle");
        submission.job().strand.start(std::move(task));
        auto change = make_object<SurfaceChange>(context_.memory[MemoryKind::surfaces], tangle->surface, nullptr);
        submission.commit(std::move(change), MemoryKind::surfaces, out_job);
        tangle->revision = tangle->surface->order.revision();
    }

    void make_step(StepRecords records, FlgJob* out_job) {
        commit(flg::make_step(submission.pace(), tangle, std::move(records), revision()), out_job);
    }

    const std::shared_ptr<Tangle> tangle;
    Submission submission;

private:
    Context& context_;
};

}  // namespace flg
