// SPDX-License-Identifier: MIT
#include "path_curves.h"

#include "documents/extensions.h"
#include "documents/failure.h"
#include "documents/text_file.h"
#include "filigree/filigree_io.h"

namespace flg::cli {

void require_curve_output(const std::string& path) {
    if (!ends_with_one_of(path, {".xyz", ".txt", ".obj", ".glb"})) {
        throw UsageError(path + ": curves are written as .xyz, .obj or .glb");
    }
    require_writable(path);
}

FlgSurfaceCurvesView view_of(FlgContext context, FlgSurfaceCurves curves) {
    FlgSurfaceCurvesView view;
    flgSurfaceCurvesViewInit(&view, sizeof view);
    check(flgSurfaceCurvesGetView(context, curves, &view), "curves");
    return view;
}

FlgCurveSet lift(Session& session, FlgSurfaceCurves curves, const std::string& subject, Report& report) {
    FlgSurfaceCurvesLiftDesc desc;
    flgSurfaceCurvesLiftDescInit(&desc, sizeof desc);
    desc.curves = curves;
    FlgCurveSet lifted = {};
    FlgJob job = {};
    check(flgSurfaceCurvesLift(session.context(), &desc, &lifted, &job), subject);
    session.finish({{{job, subject}}}, report);
    return lifted;
}

uint32_t write_curves(FlgContext context, FlgCurveSet curves, const std::string& path) {
    FlgCurveSetView view = flgCurveSetViewDefaults();
    check(flgCurveSetGetView(context, curves, &view), "curves");
    if (flgCurveFileWrite(path.c_str(), &view, nullptr) != FLG_OK) throw InputError(flgIoErrorGetMessage());
    return view.curve_offsets[view.curve_count];
}

}  // namespace flg::cli
