// SPDX-License-Identifier: MIT
// Seeds of another mesh of the same shape, found again on this one: the nearest point of the surface stands for each.
#pragma once

#include "surfaces/mesh/nearest_points.h"
#include "tangles/step_record.h"

namespace flg {

// The point of the mesh that is nearest to each place. `nearest` is built.
Task<Buffer<SurfacePoint>> locate(Pace& pace, NearestPoints& nearest, const Buffer<Position>& places);

// Points, curves and samples of the operator, as far as its anchors are given. Borders are found again when they are
// needed (anchor_loops). Cost: 0.2 us a triangle of the mesh if there are any, some 10 us each.
Task<void> locate_seeds(Pace& pace, const Mesh& mesh, StepRecord& record);

}  // namespace flg
