// SPDX-License-Identifier: MIT
// What a painting program's brush leaves: a flat band or a round tube.
#pragma once

#include <string_view>
#include <vector>

#include "support/curve_source.h"

namespace flg::samples {

// Brushes that are not known by name are flat, as most are.
FlgCurveGeometry shape_of_brush(std::string_view brush);

// Of each curve; empty if the file says nothing of brushes.
std::vector<FlgCurveGeometry> shapes_of_strokes(const CurveSource& source);

}  // namespace flg::samples
