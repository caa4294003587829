// SPDX-License-Identifier: MIT
// Splines laid onto the triangles of the mesh that their manifold is made of.
#pragma once

#include "splines/spline.h"
#include "surfaces/traced_curves.h"

namespace flg {

// For each node the nearest point of the triangles: out.surface_points and how far that is at most.
Task<void> find_surface_points(Pace& pace, Spline& out);

// The whole of flgSplineTrace. `offset`: metres to the left.
Task<void> trace_spline(Pace& pace, std::shared_ptr<const Spline> spline, double offset,
                        std::shared_ptr<TracedCurves> out);

}  // namespace flg
