// SPDX-License-Identifier: MIT
// Ribbons and roads along splines: a mesh of rows across the curve.
//
// A ribbon that conforms to a mesh has its rows on the triangles: from the curve straight over the surface to both
// sides (Polthier, Schmies 1998, straight_walk.h). Another is straight across: upright on the surface or, given an up,
// level, but for banking: it leans into bends by the angle whose tangent is the curvature times `bank`.
//
// Invariant: rows do not cross their neighbours. On the inner side of a bend tighter than the ribbon is wide they end
// before they would; WIDTH tells.
#pragma once

#include "splines/spline.h"
#include "surfaces/surface.h"

namespace flg {

struct RibbonShape {
    uint32_t columns = 4;
    double width = 1;           // metres
    double spacing = 0;         // metres, as for rows_along()
    double height = 0;          // metres
    double bank = 0;            // metres
    double texture_length = 0;  // metres; 0: the width
    Vec3 up = Vec3::Zero();     // 0: the surface's normals
    bool conforms = false;      // to the triangles of the spline's manifold
};

// The whole of flgSplineSweep. `out` has its origin.
Task<void> make_ribbon(Pace& pace, std::shared_ptr<const Spline> spline, RibbonShape shape,
                       std::shared_ptr<Surface> out);

}  // namespace flg
