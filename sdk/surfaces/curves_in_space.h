// SPDX-License-Identifier: MIT
// Curves in space laid onto a surface, so that they can be cut in; and curves on a surface lifted into space, with its
// smooth normals as the NORMAL of their frames, so that stylization and ribbons follow the surface.
//
// Each point of a curve that is laid goes to the surface's point nearest to it; from one of these to the next the
// curve follows the plane through both and the surface's normal (surface_walk.h) and, where no such way leads there, a
// shortest path.
#pragma once

#include <span>

#include "curves/curve_set.h"
#include "surfaces/mesh/nearest_points.h"
#include "surfaces/traced_curves.h"

namespace flg {

// Curve c has the points offsets[c] to offsets[c + 1] - 1.
struct CurvesInSpace {
    std::span<const uint32_t> offsets;  // one more than there are curves
    std::span<const uint8_t> flags;     // FLG_CURVE_CLOSED
    const float* positions;             // x, y, z a point, metres; finite
    Vec3 shift = Vec3::Zero();          // that makes positions relative to the surface's origin
};

// Appends to `out`, values being lengths. Curves that come to a single point are left out. `nearest` is built, of the
// surface's mesh; the surface has its blocks. `argument`: what errors call the curves. Fails if two consecutive points
// come to parts of the surface that do not hang together.
Task<void> lay_curves(Pace& pace, Surface& surface, NearestPoints& nearest, CurvesInSpace curves, const char* argument,
                      SurfaceCurves& out);

// The whole of flgCurveSetProject.
Task<void> project_curves(Pace& pace, std::shared_ptr<const CurveSet> set, std::shared_ptr<TracedCurves> out);

// The whole of flgSurfaceCurvesLift. `height`: metres along the normal. Fails with FLG_ERROR_INVALID_ARGUMENT if there
// are no curves, as no curve set is empty.
Task<void> lift_curves(Pace& pace, std::shared_ptr<const TracedCurves> traced, float height,
                       std::shared_ptr<CurveSet> out);

}  // namespace flg
