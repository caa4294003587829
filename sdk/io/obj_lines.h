// SPDX-License-Identifier: MIT
// Polylines of Wavefront OBJ files.
#pragma once

#include <string>
#include <string_view>

#include "io/checked_view.h"
#include "io/curve_data.h"

namespace flg::io {

CurveData read_obj(std::string_view text);
std::string write_obj(const CheckedView& view);

}  // namespace flg::io
