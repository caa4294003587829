// SPDX-License-Identifier: MIT
// Columns that a host computes itself from a result's: positions at a magnitude that changes from place to place,
// colours by any attribute.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "gallery/columns.h"

namespace flg::gallery {

// A view with one column more, or another one.
class Painted {
public:
    // COLOR, linear RGB, by the values of an attribute.
    Painted(const FlgCurveSetView& view, FlgAttribute attribute,
            const std::function<glm::vec3(const float* value)>& color);
    Painted(const Painted&) = delete;
    Painted& operator=(const Painted&) = delete;
    const Columns& columns() const { return columns_; }

private:
    std::vector<glm::vec4> colors_;
    Columns columns_;
};

// Magnitude that changes long after the curves were stylized: what a vertex shader does with a result's DISPLACEMENT
// column.
class Ramp {
public:
    // `view`: a result with keep_displacement, made at magnitude 1. `magnitude` of a position.
    Ramp(const FlgCurveSetView& view, const std::function<float(const glm::vec3& position)>& magnitude);
    Ramp(const Ramp&) = delete;
    Ramp& operator=(const Ramp&) = delete;
    const Columns& columns() const { return columns_; }

private:
    std::vector<glm::vec3> positions_;
    Columns columns_;
};

}  // namespace flg::gallery
