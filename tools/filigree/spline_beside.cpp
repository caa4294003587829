// SPDX-License-Identifier: MIT
#include "spline_beside.h"

#include <algorithm>

#include "choices.h"
#include "documents/failure.h"

namespace flg::cli {

void add_beside_options(CLI::App& app, BesideOptions& options) {
    app.add_option("--offset", options.left,
                   "In place of the curve, one so far to its left (metres): on a surface straight over it, with "
                   "--on-mesh over the triangles")
        ->check(finite());
    app.add_option("--offset-above", options.above, "And so far above (metres)")->check(finite());
    app.add_option("--offset-up", options.up,
                   "What is upwards: 0,0,1. Else a surface's normals; in space left and up turn about the curve as "
                   "little as may be, from +z on")
        ->delimiter(',')
        ->expected(3)
        ->type_name("X,Y,Z");
    app.add_flag("--offset-turns-least", options.turns_least, "--offset-up counts at the curve's beginning only");
    app.add_flag("--offset-loops", options.keeps_loops,
                 "Keeps the loops where it is farther away than a bend is wide; else they are cut off");
}

void check_beside_options(const BesideOptions& options, bool on_mesh) {
    if (on_mesh && options.is_more_than_left())
        throw UsageError(
            "--on-mesh takes --offset alone, none of --offset-above, --offset-up, --offset-turns-least "
            "and --offset-loops");
    if (!options.is_wanted() && options.is_more_than_left())
        throw UsageError("--offset-up, --offset-turns-least and --offset-loops need --offset or --offset-above");
}

FlgCurveSetView curve_beside(Session& session, const BesideOptions& options, FlgSpline spline,
                             const std::string& subject, Report& report) {
    FlgSplineOffsetDesc desc = flgSplineOffsetDefaults();
    desc.spline = spline;
    desc.left = options.left;
    desc.above = options.above;
    desc.turns_least = options.turns_least;
    desc.keeps_loops = options.keeps_loops;
    std::copy(options.up.begin(), options.up.end(), desc.up);
    FlgCurveSet set = {};
    FlgJob job = {};
    check(flgSplineOffset(session.context(), &desc, &set, &job), subject);
    session.finish({{{job, subject}}}, report);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    check(flgCurveSetGetView(session.context(), set, &view), subject);
    return view;
}

}  // namespace flg::cli
