// SPDX-License-Identifier: MIT
#include <cmath>

#include "api/context.h"
#include "api/descriptors.h"
#include "api/error.h"
#include "api/inputs.h"
#include "curves/sampling_job.h"

namespace flg {

namespace {

FlgResampleDesc default_resample_desc() {
    FlgResampleDesc desc{};
    desc.struct_size = sizeof desc;
    desc.job = default_job_options();
    return desc;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgResampleDescInit(FlgResampleDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_resample_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgResample(FlgContext context, const FlgResampleDesc* desc, FlgCurveSet* out_set, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        require(out_set, "out_set") = {};
        Context& self = get_context(context);
        const FlgResampleDesc read = read_struct(desc, default_resample_desc(), "desc");
        check_range(read.spacing > 0 && std::isfinite(read.spacing), "desc.spacing", read.spacing,
                    "finite and above 0");
        check_frame(read.frame, "desc.frame");
        Submission submission(self, read.job);
        const auto in = self.curve_sets.get(read.curves.id, "desc.curves");
        const auto out = make_object<CurveSet>(self, &self.memory);
        submission.read(*in, "desc.curves");
        submission.job().strand.start(
            resample_curves(submission.pace(), ResampleRequest{in, out, read.spacing, read.frame}));
        *out_set = {submission.commit(self.curve_sets, out, out_job)};
        return FLG_OK;
    });
}

}  // extern "C"
