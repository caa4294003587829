// SPDX-License-Identifier: MIT
// Splines of R^d among obstacles (Hofer, Pottmann 2004, sec. 5): minimizers on barriers around them whose radius
// shrinks.
#pragma once

#include "splines/spline.h"

namespace flg {

// What make_spline() does where the request has obstacles.
Task<void> make_obstacle_spline(Pace& pace, SplineRequest& request);

}  // namespace flg
