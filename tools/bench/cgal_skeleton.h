// SPDX-License-Identifier: MIT
// The peer of straight skeletons, where it is installed.
#pragma once

#include <cstdint>

namespace flg::bench {

// Makes the straight skeleton of a ring (2 numbers a point, counter-clockwise) and drops it. False if CGAL found none.
bool cgal_skeleton(const double* points, uint32_t count);

}  // namespace flg::bench
