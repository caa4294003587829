// SPDX-License-Identifier: MIT
// Splines laid onto the triangles of the mesh that their manifold is made of.
#pragma once

#include "splines/spline.h"
#include "surfaces/traced_curves.h"
#include "surfaces/tracing/surface_path.h"

namespace flg {

// For each node the nearest point of the triangles: out.surface_points and how far that is at most.
Task<void> find_surface_points(Pace& pace, Spline& out);

// Of the triangles.
Task<SurfacePoint> nearest_point(Pace& pace, NearestPoints& nearest, Vec3 place);

// Straight over the triangles from a point, to the left of a direction, or to its right if `offset` is below 0: so many
// metres, or to the border. The point alone where left is nowhere.
Task<void> walk_aside(Pace& pace, const Mesh& mesh, SurfacePoint from, Vec3 direction, double offset, SurfacePath& out);

// The whole of flgSplineTrace. `offset`: metres to the left.
Task<void> trace_spline(Pace& pace, std::shared_ptr<const Spline> spline, double offset,
                        std::shared_ptr<TracedCurves> out);

}  // namespace flg
