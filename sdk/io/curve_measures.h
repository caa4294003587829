// SPDX-License-Identifier: MIT
// What all formats' curves are asked: extent, length, and repeated points.
#pragma once

#include "io/curve_data.h"

namespace flg::io {

struct CurveMeasures {
    float box_min[3] = {0, 0, 0};
    float box_max[3] = {0, 0, 0};
    float total_length = 0;
};

// Adds warnings to `data` for what it finds odd.
CurveMeasures measure(CurveData& data);

}  // namespace flg::io
