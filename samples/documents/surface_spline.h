// SPDX-License-Identifier: MIT
// Smooth curves through points of a surface, for operations of scripts. All throw InputError; `subject` is what errors
// are about.
#pragma once

#include <span>
#include <string>

#include "documents/report.h"
#include "documents/session.h"
#include "filigree/filigree_spline.h"

namespace flg::cli {

FlgManifold create_manifold(Session& session, FlgSurface surface, const std::string& subject, Report& report);

// The spline of least bending, as a curve in space.
FlgCurveSet spline_through(Session& session, FlgManifold manifold, const FlgSurfaceView& surface,
                           std::span<const FlgSurfacePoint> points, bool closed, const std::string& subject,
                           Report& report);

}  // namespace flg::cli
