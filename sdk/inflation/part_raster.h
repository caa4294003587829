// SPDX-License-Identifier: MIT
// Fills the raster of an inflated part. Inside, from the triangulation: on each triangle a quadratic whose values
// between two vertices follow from slopes there, recovered as means of the triangles around; on the border the slope is
// what balances the equation (the residual of the linear elements; Carey: Derivative calculation from finite element
// solutions, 1982). Outside, from the nearest edge of the border, found by passing edges on from value to value
// (Danielsson: Euclidean distance mapping, 1980).
#pragma once

#include "inflation/inflate_part.h"

namespace flg {

// Of a part with heights, which outlives the task. At most 512 values a side; 12 bytes a value while it runs.
Task<void> part_raster(Pace& pace, InflatedPart& part);

}  // namespace flg
