// SPDX-License-Identifier: MIT
#include "corner_options.h"

#include <numbers>

#include "choices.h"
#include "documents/failure.h"

namespace flg::cli {
namespace {

const std::map<std::string, FlgStyleCorners> kCorners = {
    {"through", FLG_STYLE_CORNERS_THROUGH}, {"mitre", FLG_STYLE_CORNERS_MITRE}, {"motif", FLG_STYLE_CORNERS_MOTIFS}};
constexpr double kHalfTurn = 180.0;

}  // namespace

void CornerOptions::add_to(CLI::App& app) {
    add_choice(
        app, "--corners", corners_, kCorners,
        "At corners of the curves the style goes on as elsewhere, or both sides are cut at the plane that halves "
        "the corner, or they have whole motifs from corner to corner (see --fit) and are cut too");
    angle_ = app.add_option("--corner-angle", angle_deg_, "What a corner turns by at least, degrees, between 0 and 180")
                 ->capture_default_str()
                 ->check(number_that([](double v) { return v > 0.0 && v < kHalfTurn; }, "a number between 0 and 180"));
    app.add_flag("--corner-caps", caps_, "With --corners motif: the style's caps at corners too");
    app.add_flag("--smooth-junctions", smooth_junctions_,
                 "With --network: curves that go on into each other where they meet have one direction there")
        ->needs("--network");
}

void CornerOptions::describe(Report& report) const {
    if (corners_ != FLG_STYLE_CORNERS_THROUGH) {
        report.parameters["corners"] = name_of(kCorners, corners_);
        report.parameters["corner_angle"] = as_written(angle_deg_);
        report.parameters["corner_caps"] = caps_;
    }
    if (smooth_junctions_) report.parameters["smooth_junctions"] = true;
}

void CornerOptions::set(FlgCurveSetStylizeDesc& desc) const {
    desc.corners = corners_;
    desc.corner_angle = static_cast<float>(double{angle_deg_} * (std::numbers::pi / kHalfTurn));
    desc.corner_caps = caps_ ? 1 : 0;
    desc.smooth_junctions = smooth_junctions_ ? 1 : 0;
}

void CornerOptions::check_usage() const {
    if (angle_->count() > 0 && corners_ == FLG_STYLE_CORNERS_THROUGH) {
        throw UsageError("--corner-angle: corners mean nothing to the style without --corners mitre or motif");
    }
    if (caps_ && !motifs()) throw UsageError("--corner-caps: only --corners motif has ends at corners");
}

}  // namespace flg::cli
