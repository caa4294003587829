// SPDX-License-Identifier: MIT
#include <cmath>

#include "api/context.h"
#include "api/descriptors.h"
#include "api/error.h"
#include "api/inputs.h"
#include "stylization/prepare_style.h"

namespace flg {

namespace {

constexpr uint32_t min_points = 16;
constexpr uint32_t max_patch = 1024;

FlgStyleDesc default_style_desc() {
    const StyleRequest defaults;
    FlgStyleDesc desc{};
    desc.struct_size = sizeof desc;
    desc.point_count = defaults.point_count;
    desc.job = default_job_options();
    desc.alpha = static_cast<float>(defaults.alpha);
    desc.smoothing = static_cast<float>(defaults.smoothing);
    desc.beta = static_cast<float>(defaults.beta);
    desc.patch = defaults.patch;
    return desc;
}

void check(const FlgStyleDesc& desc) {
    check_range(desc.point_count == 0 || (desc.point_count >= min_points && desc.point_count <= style_points_max),
                "desc.point_count", desc.point_count, "0 or 16 to 16384");
    check_range(desc.alpha >= 0 && desc.alpha <= 1, "desc.alpha", desc.alpha, "0 to 1");
    check_range(desc.smoothing > 0 && std::isfinite(desc.smoothing), "desc.smoothing", desc.smoothing,
                "finite and above 0");
    check_range(desc.beta > 0 && desc.beta < 1, "desc.beta", desc.beta, "above 0 and below 1");
    check_range(desc.patch >= 1 && desc.patch <= max_patch, "desc.patch", desc.patch, "1 to 1024");
    check_range(desc.point_count == 0 || 2 * desc.patch + 1 < desc.point_count, "desc.patch", desc.patch,
                "so small that its 2p + 1 points are fewer than point_count");
}

// The style, if its job is done; FLG_NOT_READY or the job's error otherwise.
FlgResult find_style(const Context& context, FlgStyle handle, std::shared_ptr<Style>& out) {
    out = context.styles.get(handle.id, "style");
    const FlgResult result = out->visible_result();
    return result < 0 ? set_last_error(result, out->error()) : result;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgStyleDescInit(FlgStyleDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_style_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgStyleCreate(FlgContext context, const FlgStyleDesc* desc, FlgStyle* out_style, FlgJob* out_job) {
    return guarded([&] {
        require(out_style, "out_style") = {};
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const FlgStyleDesc read = read_struct(desc, default_style_desc(), "desc");
        check(read);
        Submission submission(self, read.job);
        StyleRequest request;
        request.example = self.curve_sets.get(read.style.id, "desc.style");
        submission.read(*request.example, "desc.style");
        if (read.guide.id != 0) {
            request.guide = self.curve_sets.get(read.guide.id, "desc.guide");
            submission.read(*request.guide, "desc.guide");
        }
        request.style = make_object<Style>(self, &self.memory);
        request.point_count = read.point_count;
        request.alpha = read.alpha;
        request.smoothing = read.smoothing;
        request.beta = read.beta;
        request.patch = read.patch;
        const std::shared_ptr<Style> style = request.style;
        submission.job().strand.start(prepare_style(submission.pace(), std::move(request)));
        *out_style = {submission.commit(self.styles, style, out_job)};
        return FLG_OK;
    });
}

FlgResult flgStyleGetInfo(FlgContext context, FlgStyle style, FlgStyleInfo* out_info) {
    return guarded([&] {
        FlgStyleInfo empty{};
        empty.struct_size = sizeof empty;
        write_struct(out_info, empty, "out_info");
        std::shared_ptr<Style> self;
        const FlgResult result = find_style(get_context(context), style, self);
        if (result == FLG_OK) write_struct(out_info, self->info(), "out_info");
        return result;
    });
}

FlgResult flgStyleGetGuide(FlgContext context, FlgStyle style, FlgCurveSet* out_guide) {
    return guarded([&] {
        require(out_guide, "out_guide") = {};
        Context& self = get_context(context);
        std::shared_ptr<Style> found;
        const FlgResult result = find_style(self, style, found);
        if (result == FLG_OK) *out_guide = {self.curve_sets.add(found->prepared.guide)};
        return result;
    });
}

FlgResult flgStyleRelease(FlgContext context, FlgStyle style) {
    return guarded([&] {
        get_context(context).styles.remove(style.id, "style");
        return FLG_OK;
    });
}

}  // extern "C"
