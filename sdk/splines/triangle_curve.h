// SPDX-License-Identifier: MIT
// A spline's curve over the triangles of a mesh (surface_bezier.h): there before the first round of the optimizer, and
// the result where the smooth surface can't be reached.
//
// Invariants: it passes through the points of the triangles that are nearest to the given ones; its nodes are on
// triangles; there is one on any connected mesh.
#pragma once

#include "splines/spline.h"

namespace flg {

// Makes the curve, as request.out->bezier, and shows it if the host wants to see rounds. Segments of `before`, unless
// null, stay where the points are the same. Fails, and names the points, where no way leads from one to the next.
Task<void> lay_triangle_curve(Pace& pace, const SplineRequest& request, const Spline* before);

// What was laid becomes the spline.
Task<void> keep_triangle_curve(Pace& pace, const SplineRequest& request);

}  // namespace flg
