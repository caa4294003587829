// SPDX-License-Identifier: MIT
// Curves as text (.xyz, .txt).
#pragma once

#include <string>
#include <string_view>

#include "filigree/filigree_io.h"
#include "io/base/checked_views.h"
#include "io/base/curve_data.h"

namespace flg::io {

CurveData read_xyz(std::string_view text);
std::string write_xyz(const CheckedView& view, const FlgCurveWriteDesc& desc);

}  // namespace flg::io
