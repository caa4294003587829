// SPDX-License-Identifier: MIT
// Curves on a surface, written as curves in space.
#pragma once

#include "documents/report.h"
#include "documents/session.h"
#include "filigree/filigree_surface.h"

namespace flg::cli {

// Refuses files that curves aren't written to, before any work is done. Throws UsageError, InputError.
void require_curve_output(const std::string& path);

FlgSurfaceCurvesView view_of(FlgContext context, FlgSurfaceCurves curves);

// The curves, of which there must be one, in space. Errors are about `subject`. Throws InputError.
FlgCurveSet lift(Session& session, FlgSurfaceCurves curves, const std::string& subject, Report& report);

// Writes curves by their extension; returns how many points they have. Throws InputError.
uint32_t write_curves(FlgContext context, FlgCurveSet curves, const std::string& path);

}  // namespace flg::cli
