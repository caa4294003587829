// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>

#include "api/context.h"
#include "api/descriptors.h"
#include "api/error.h"
#include "api/inputs.h"
#include "curves/sampling_job.h"
#include "stylization/apply_style.h"

namespace flg {

namespace {

constexpr uint32_t strokes_max = 1024;

FlgStylizeDesc default_stylize_desc() {
    const StylizeRequest defaults;
    FlgStylizeDesc desc{};
    desc.struct_size = sizeof desc;
    desc.start = defaults.start;
    desc.job = default_job_options();
    desc.magnitude = static_cast<float>(defaults.magnitude);
    desc.temperature = static_cast<float>(defaults.temperature);
    desc.scale = static_cast<float>(defaults.scale);
    desc.frame = defaults.frame;
    desc.seed = defaults.seed;
    std::copy(defaults.basis.begin(), defaults.basis.end(), desc.basis);
    desc.strokes = defaults.strokes;
    return desc;
}

void check(const FlgStylizeDesc& desc) {
    check_range(is_coordinate(desc.magnitude), "desc.magnitude", desc.magnitude, "finite and at most 1e30 in size");
    check_range(desc.temperature >= 0 && std::isfinite(desc.temperature), "desc.temperature", desc.temperature,
                "finite and at least 0");
    check_range(desc.scale > 0 && is_coordinate(desc.scale), "desc.scale", desc.scale,
                "finite, above 0 and at most 1e30");
    check_frame(desc.frame, "desc.frame");
    check_basis(desc.basis);
    check_range(desc.max_points <= sampled_points_max, "desc.max_points", desc.max_points, "at most 2^31");
    check_range(desc.strokes >= 1 && desc.strokes <= strokes_max, "desc.strokes", desc.strokes, "1 to 1024");
    check_enum(desc.start, FLG_START_AUTO, FLG_START_RANDOM, "desc.start", "FLG_START_");
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgStylizeDescInit(FlgStylizeDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_stylize_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgStylize(FlgContext context, const FlgStylizeDesc* desc, FlgCurveSet* out_set, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        require(out_set, "out_set") = {};
        Context& self = get_context(context);
        const FlgStylizeDesc read = read_struct(desc, default_stylize_desc(), "desc");
        check(read);
        Submission submission(self, read.job);
        StylizeRequest request;
        request.style = self.styles.get(read.style.id, "desc.style");
        request.target = self.curve_sets.get(read.target.id, "desc.target");
        submission.read(*request.style, "desc.style");
        submission.read(*request.target, "desc.target");
        request.out = make_object<CurveSet>(self, &self.memory);
        request.magnitude = read.magnitude;
        request.temperature = read.temperature;
        request.scale = read.scale;
        request.frame = read.frame;
        request.start = read.start;
        request.seed = read.seed;
        std::copy(std::begin(read.basis), std::end(read.basis), request.basis.begin());
        request.strokes = read.strokes;
        request.max_points = read.max_points;
        request.pin_ends = read.pin_ends != 0;
        request.keep_displacement = read.keep_displacement != 0;
        const std::shared_ptr<CurveSet> out = request.out;
        submission.job().strand.start(apply_style(submission.pace(), std::move(request)));
        *out_set = {submission.commit(self.curve_sets, out, out_job)};
        return FLG_OK;
    });
}

}  // extern "C"
