// SPDX-License-Identifier: MIT
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "curves/sampling_job.h"

using namespace flg;

extern "C" {

FlgResult flgCurveSetResampleDescInit(FlgCurveSetResampleDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgCurveSetResampleDesc>());
}

FlgResult flgCurveSetResample(FlgContext context, const FlgCurveSetResampleDesc* desc, FlgCurveSet* out_set,
                              FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_set, "out_set", out_job);
        Memory* const memory = self.memory[MemoryKind::curves];
        const FlgCurveSetResampleDesc read = read_struct(desc, sized<FlgCurveSetResampleDesc>(), "desc");
        check_range(read.spacing > 0 && std::isfinite(read.spacing), "desc.spacing", read.spacing,
                    "finite and above 0");
        check_frame(read.frame, "desc.frame");
        Submission submission(self, read.job);
        const auto in = self.curve_sets.get(read.curves.id, "desc.curves");
        const auto out = make_object<CurveSet>(memory, memory);
        out->origin = in->origin;
        submission.read(*in, "desc.curves");
        submission.job().strand.start(resample_curves(submission.pace(), in, read.spacing, read.frame, out));
        *out_set = {submission.commit(self.curve_sets, out, out_job)};
    });
}

}  // extern "C"
