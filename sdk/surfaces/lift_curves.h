// SPDX-License-Identifier: MIT
// Curves on a surface as curves in space, with the surface's smooth normals as the NORMAL of their frames, so that
// stylization and ribbons follow the surface.
#pragma once

#include "curves/curve_set.h"
#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/traced_curves.h"

namespace flg {

// The whole of flgSurfaceCurvesLift. `height`: metres along the normal. Fails with FLG_ERROR_INVALID_ARGUMENT if there
// are no curves, as no curve set is empty.
Task<void> lift_curves(Pace& pace, std::shared_ptr<const TracedCurves> traced, float height,
                       std::shared_ptr<CurveSet> out);

}  // namespace flg
