// SPDX-License-Identifier: MIT
// The built-in scene's curves as the SDK takes them: flat arrays, a column each.
#pragma once

#include <span>
#include <vector>

#include "filigree/filigree.h"
#include "scenes/scenes.h"

namespace flg::samples {

// Columns: POSITION and COLOR; RADIUS, ANGLE and NORMAL where all curves have them.
class CurveArrays {
public:
    CurveArrays() = default;
    explicit CurveArrays(std::span<const scenes::Curve> curves);
    // Their arrays keep their places when moved; copies would not.
    CurveArrays(CurveArrays&&) = default;
    CurveArrays& operator=(CurveArrays&&) = default;
    CurveArrays(const CurveArrays&) = delete;
    CurveArrays& operator=(const CurveArrays&) = delete;

    // Lives as long as the arrays.
    FlgCurveSetView view() const;

private:
    std::vector<float> positions_, colors_, radii_, angles_, normals_;
    std::vector<uint32_t> offsets_ = {0};
    std::vector<uint8_t> flags_;
    std::vector<FlgColumn> columns_;
};

}  // namespace flg::samples
