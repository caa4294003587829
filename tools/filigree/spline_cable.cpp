// SPDX-License-Identifier: MIT
#include "spline_cable.h"

#include <algorithm>

#include "choices.h"
#include "documents/failure.h"

namespace flg::cli {

void add_cable_options(CLI::App& app, CableOptions& options) {
    CLI::Option* const cable = app.add_flag(
        "--cable", options.is_wanted,
        "In place of the curve, a cable that hangs from each point to the next and rests on the obstacles; "
        "SURFACE must be space");
    app.add_option("--slack", options.slack, "How much longer than their distance the cable is between points, over it")
        ->check(CLI::Range(0.0, 999.0))
        ->needs(cable)
        ->capture_default_str();
    app.add_option("--cable-lengths", options.lengths,
                   "Its length from each point to the next (metres), in place of --slack")
        ->delimiter(',')
        ->needs(cable)
        ->excludes("--slack")
        ->type_name("L,...");
    app.add_option("--gravity", options.gravity, "The direction in which it hangs; default 0,0,-1")
        ->delimiter(',')
        ->expected(3)
        ->needs(cable)
        ->type_name("X,Y,Z");
    app.add_option("--cable-segments", options.segments, "Straight pieces from a point to the next")
        ->check(CLI::Range(4u, 4096u))
        ->needs(cable)
        ->capture_default_str();
    // What makes curves, and what is made of these.
    for (const char* const name : {"--closed", "--points", "--height", "--corners", "--fit-output", "--offset",
                                   "--offset-above", "--road", "--road-output"})
        cable->excludes(name);
}

FlgCurveSet hang_cables(Session& session, const CableOptions& options, const SpaceLines& lines, FlgObstacles obstacles,
                        const std::string& subject, Report& report) {
    const std::vector<double> points(lines.positions.begin(), lines.positions.end());
    const uint32_t spans = lines.offsets.back() - lines.count();
    FlgCableHangDesc desc = flgCableHangDefaults();
    desc.points = points.data();
    desc.point_count = lines.offsets.back();
    desc.cable_offsets = lines.offsets.data();
    desc.cable_count = lines.count();
    desc.segments = options.segments;
    desc.slack = options.slack;
    if (!options.lengths.empty()) {
        if (options.lengths.size() != spans)
            throw UsageError("--cable-lengths has " + std::to_string(options.lengths.size()) + " lengths, " + subject +
                             " has " + std::to_string(spans) + " spans from a point to the next");
        desc.lengths = options.lengths.data();
    }
    if (!options.gravity.empty()) std::copy(options.gravity.begin(), options.gravity.end(), desc.gravity);
    desc.obstacles = obstacles;
    std::copy(lines.origin.begin(), lines.origin.end(), desc.origin);
    FlgCurveSet set = {};
    FlgJob job = {};
    check(flgCableHang(session.context(), &desc, &set, &job), subject);
    session.finish({{{job, subject}}}, report);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    check(flgCurveSetGetView(session.context(), set, &view), subject);
    const float* const along = flgCurveSetViewGetColumn(&view, FLG_ATTRIBUTE_TIME)->data;
    double length = 0;
    for (uint32_t k = 0; k < view.curve_count; ++k) length += double{along[view.curve_offsets[k + 1] - 1]};
    report.counts["points"] = lines.offsets.back();
    report.counts["curves"] = view.curve_count;
    report.counts["curve_points"] = view.curve_offsets[view.curve_count];
    report.quality["length"] = length;
    return set;
}

}  // namespace flg::cli
