// SPDX-License-Identifier: MIT
// Splines with corners and with tangents at given points: between these they are curves of their own, so each piece is
// minimized by itself, with its ends natural or clamped.
#pragma once

#include "splines/spline.h"

namespace flg {

// Minimizes the pieces of a chain that has begun, `nodes` of them in all in the end, and joins them to out's chain.
// Needs handles. The ends of pieces are fixed, whatever the smoothing.
Task<void> minimize_pieces(Pace& pace, const SplineRequest& request, SplineProblem& whole, uint32_t nodes, Spline& out);

}  // namespace flg
