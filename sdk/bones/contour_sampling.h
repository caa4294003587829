// SPDX-License-Identifier: MIT
// Drawn lines made even and short (Ma, Wang, Li, Zhang: Real-time skeletonization for sketch-based modeling, 2021, sec.
// 3.1): points at equal distances smooth a hand's noise out, then the algorithm of Douglas and Peucker keeps those that
// matter.
#pragma once

#include "runtime/task.h"
#include "skeletons/contour.h"

namespace flg {

// All rings with points every `spacing` along them; the spacing of each is rounded so that a whole number of at least 8
// fits. Points that an edge as long as that begins or ends at are corners that somebody meant: they stay, and each
// stretch between two of them begins anew. Lines drawn by hand have points much nearer to each other, and no such
// corners. Takes about 10 ns a point read or made. Throws if there would be more than 2^24 points.
Task<Contour> even_contour(Pace& pace, const Contour& contour, double spacing);

// Of all rings the points that are needed to stay within `tolerance` of them (Douglas, Peucker 1973). A ring is halved
// at the point farthest from the middle of its points and the point farthest from that one, so that it doesn't matter
// where it begins. A ring keeps at least three points. Looks at about n log n points on drawings, n squared at worst,
// 5 ns each.
Task<Contour> simplified_contour(Pace& pace, const Contour& contour, double tolerance);

}  // namespace flg
