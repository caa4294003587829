// SPDX-License-Identifier: MIT
// The blend of two distance fields, sec. 3.2 of Nazzaro, Puppo, Pellacini: geoTangle (2021): from / (from + to), 0 at the
// first's sources and 1 at the second's.
#pragma once

#include "surfaces/distance_field.h"

namespace flg {

// In the middle where both are 0, `unreachable` where both are; else where one of them is unreachable it is the other's
// end. Values below 0 count as 0.
inline float blend(float from, float to) {
    if (from == unreachable) return to == unreachable ? unreachable : 1.0f;
    if (to == unreachable) return 0.0f;
    const double a = from > 0 ? from : 0, b = to > 0 ? to : 0;
    return a + b > 0 ? static_cast<float>(a / (a + b)) : 0.5f;
}

}  // namespace flg
