// SPDX-License-Identifier: MIT
// What the entry points share that change tangles.
#pragma once

#include <cmath>

#include "api/surface_inputs.h"
#include "tangles/tangle_jobs.h"

namespace flg {

inline bool is_positive(float value) {
    return value > 0 && std::isfinite(value);
}

inline std::pmr::vector<RegionId> read_region_ids(const uint32_t* regions, uint32_t count, const char* argument,
                                                  Memory* memory) {
    std::pmr::vector<RegionId> list(memory);
    if (count > 0) list.assign(&require(regions, argument), regions + count);
    return list;
}

// A job that changes a tangle.
class TangleChange {
public:
    TangleChange(Context& context, const FlgJobOptions& options, FlgTangle handle, const char* argument)
        : tangle(context.tangles.get(handle.id, argument)), submission(context, options), context_(context) {
        submission.read(*tangle, argument);
        if (tangle->surface->order.revision() != tangle->revision) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s: its surface was changed by others, from revision %u to %u",
                          argument, tangle->revision, tangle->surface->order.revision());
        }
    }

    // The surface's, after the job.
    uint32_t revision() const { return tangle->revision + 1; }
    void needs_blocks() { submission.wait_for(start_blocks(context_, tangle->surface)); }
    void commit(Task<void> task, FlgJob* out_job) {
        submission.change_surface(tangle->surface, "the surface of the tangle");
        submission.job().strand.start(std::move(task));
        submission.commit(make_object<SurfaceChange>(context_, tangle->surface, nullptr), out_job);
        tangle->revision = tangle->surface->order.revision();
    }

    const std::shared_ptr<Tangle> tangle;
    Submission submission;

private:
    Context& context_;
};

}  // namespace flg
