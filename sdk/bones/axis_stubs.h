// SPDX-License-Identifier: MIT
// Branches of an axis that lead into no limb. Two kinds end freely and are cut off:
//
// - Corners beside a limb, as of a skirt's hem: they end in a point, and all along the branch the shape is as wide as a
//   wedge of 47 degrees, as it is where a single arc to a corner is cut off (axis.h). A limb keeps its width for a
//   while. Where the corner begins a longer one does, which goes on: so an ear stays.
// - Valleys, as between two fingers: where several reflex points lie side by side, their arcs meet and go on as one
//   into the shape. There the front was much faster than its distance from the contour grew.
//
// Where nothing else meets they stay.
#pragma once

#include "bones/axis.h"

namespace flg {

// Takes up to 40 ns an edge of the contour and end of the axis.
Task<AxisGraph> without_stubs(Pace& pace, const Contour& contour, AxisGraph graph);

}  // namespace flg
