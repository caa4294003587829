// SPDX-License-Identifier: MIT
// Magnitude that changes from place to place, long after the curves were stylized: what a vertex shader does with a result's
// DISPLACEMENT column.
#pragma once

#include <functional>
#include <vector>

#include "gallery/columns.h"

namespace flg::gallery {

class Ramp {
public:
    // `view`: a result with keep_displacement, made at magnitude 1. `magnitude` of a position.
    Ramp(const FlgCurveSetView& view, const std::function<float(const float* position)>& magnitude);
    const Columns& columns() const { return columns_; }
    Ramp(const Ramp&) = delete;
    Ramp& operator=(const Ramp&) = delete;

private:
    std::vector<float> positions_;
    Columns columns_;
};

}  // namespace flg::gallery
