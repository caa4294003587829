// SPDX-License-Identifier: MIT
// Curves beside splines of R^3, so far to the left and so far above.
//
// Left and above are those of a frame along the curve: of the surface's normals, where the way to the left goes
// straight over the surface (manifold_walk.h); of an up vector; or of a frame that turns as little as may be
// (moving_frame.h).
//
// Loops: farther than the radius of a bend a curve beside another runs back between two cusps. There it is cut off from
// where it crosses itself: what goes are the places around the cusps that are nearer to the curve beyond the bend than
// to where they come from. In the plane those are the loops exactly; in space the two ends meet half way.
#pragma once

#include "splines/spline.h"

namespace flg {

struct OffsetShape {
    double left = 0, above = 0;  // metres
    double spacing = 0;          // metres, as for rows_along()
    Vec3 up = Vec3::Zero();      // 0: the surface's normals; in free space +z at the beginning
    bool turns_least = false;    // `up` counts at the beginning only
    bool keeps_loops = false;
};

// The whole of flgSplineOffset. `out` has its origin.
Task<void> offset_spline(Pace& pace, std::shared_ptr<const Spline> spline, OffsetShape shape,
                         std::shared_ptr<CurveSet> out);

}  // namespace flg
