// SPDX-License-Identifier: MIT
// Splines as few cubic pieces, for engines: Hermite keys, as animation tracks have them (glTF's CUBICSPLINE). From
// these Bezier's points are a third of a step away. There is a key at each given point, and there are more, halving,
// until each piece is within the tolerance of the cubic spline through the nodes.
#pragma once

#include "splines/spline.h"

namespace flg {

// Makes out.keys of its chain. `breaks_everywhere`: the curve may have a corner at each given point. About 200 ns a
// node each time that pieces are halved.
Task<void> fit_keys(Pace& pace, double tolerance, bool breaks_everywhere, Spline& out);

}  // namespace flg
