// SPDX-License-Identifier: MIT
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/style_drives.h"
#include "core/failure.h"
#include "curves/sampling_job.h"
#include "stylization/apply_style.h"

namespace flg {

namespace {

constexpr uint32_t strokes_max = 1024;
constexpr uint32_t default_max_points = 1u << 26;  // some 2 GB of columns: a mistake rather than a wish
constexpr float corner_angle_rad = 0.87266463f;    // 50 degrees, from which on smooth curves have corners too
constexpr float half_turn_rad = 3.1415927f;

FlgCurveSetStylizeDesc default_stylize_desc() {
    auto desc = sized<FlgCurveSetStylizeDesc>();
    desc.magnitude = desc.scale = 1;
    desc.seed = desc.strokes = 1;
    desc.corner_angle = corner_angle_rad;
    desc.max_points = default_max_points;
    desc.basis[0] = desc.basis[4] = desc.basis[8] = 1;
    return desc;
}

void check(const FlgCurveSetStylizeDesc& desc) {
    check_range(is_coordinate(desc.magnitude), "desc.magnitude", desc.magnitude, "finite and at most 1e30 in size");
    check_range(desc.temperature >= 0 && std::isfinite(desc.temperature), "desc.temperature", desc.temperature,
                "finite and at least 0");
    check_range(desc.scale >= 0 && is_coordinate(desc.scale), "desc.scale", desc.scale,
                "finite, at least 0 and at most 1e30");
    check_frame(desc.frame, "desc.frame");
    check_basis(desc.basis);
    check_range(desc.max_points <= sampled_points_max, "desc.max_points", desc.max_points, "at most 2^31");
    check_range(desc.strokes >= 1 && desc.strokes <= strokes_max, "desc.strokes", desc.strokes, "1 to 1024");
    if (desc.exact_spacing != 0 && desc.pin_ends != 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.exact_spacing is set, and so is desc.pin_ends: exact steps do not come to a curve's end");
    }
    check_range(desc.fit >= 0 && desc.fit <= 1, "desc.fit", desc.fit, "0 to 1");
    if (desc.exact_spacing != 0 && desc.fit > 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.exact_spacing is set, and desc.fit is %g: exact steps do not fit motifs to a length",
                      static_cast<double>(desc.fit));
    }
    check_further_styles(desc);
    if (desc.smooth_junctions != 0 && desc.pin_ends == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.smooth_junctions is set, but desc.pin_ends is not: results do not meet in junctions");
    }
    check_enum(desc.corners, FLG_STYLE_CORNERS_THROUGH, FLG_STYLE_CORNERS_MOTIFS, "desc.corners", "FLG_STYLE_CORNERS_");
    check_range(desc.corner_angle > 0 && desc.corner_angle < half_turn_rad, "desc.corner_angle", desc.corner_angle,
                "above 0 and below pi");
    if (desc.exact_spacing != 0 && desc.corners != FLG_STYLE_CORNERS_THROUGH) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.exact_spacing is set, and desc.corners is %d: exact steps do not come to corners",
                      number_of(desc.corners));
    }
    if (desc.corner_caps != 0 && desc.corners != FLG_STYLE_CORNERS_MOTIFS) {
        throw Failure(
            FLG_ERROR_INVALID_ARGUMENT,
            "desc.corner_caps is set, and desc.corners is %d: only FLG_STYLE_CORNERS_MOTIFS has ends at corners",
            number_of(desc.corners));
    }
    check_enum(desc.start, FLG_STYLE_START_AUTO, FLG_STYLE_START_RANDOM, "desc.start", "FLG_STYLE_START_");
}

void read_further_styles(Context& context, Submission& submission, StylizeRequest& request) {
    const FlgCurveSetStylizeDesc& desc = request.desc;
    for (uint32_t k = 0; k < desc.further_style_count; ++k) {
        const StyleArgument argument(k + 1);
        request.further_styles[k] = context.styles.get(desc.further_styles[k].id, argument.name);
        submission.read(*request.further_styles[k], argument.name);
    }
    request.further_style_count = desc.further_style_count;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgCurveSetStylizeDescInit(FlgCurveSetStylizeDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_stylize_desc());
}

FlgResult flgCurveSetStylize(FlgContext context, const FlgCurveSetStylizeDesc* desc, FlgCurveSet* out_set,
                             FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_set, "out_set", out_job);
        const FlgCurveSetStylizeDesc read = read_struct(desc, default_stylize_desc(), "desc");
        check(read);
        const StyleDrives drives = read_drives(read.drives, read.drive_count);
        check_style_drive(drives, read.further_style_count);
        Submission submission(self, read.job);
        const auto style = self.styles.get(read.style.id, "desc.style");
        const auto target = self.curve_sets.get(read.target.id, "desc.target");
        submission.read(*style, "desc.style");
        submission.read(*target, "desc.target");
        // If the curves are there already: else the job finds out.
        if (target->visible_result() == FLG_OK) check_drive_columns(*target, drives);
        const auto out = self.make(self.curve_sets);
        out->origin = target->origin;
        StylizeRequest request{style, target, out, read, drives};
        read_further_styles(self, submission, request);
        submission.job().strand.start(apply_style(submission.pace(), std::move(request)));
        *out_set = {submission.commit(self.curve_sets, out, out_job)};
    });
}

}  // extern "C"
