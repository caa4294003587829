// SPDX-License-Identifier: MIT
// Outlines of SVG drawings as curves: the part of the format that filigree_io.h names.
#pragma once

#include "io/base/curve_data.h"

namespace flg::io {

CurveData read_svg(std::string_view text);

}  // namespace flg::io
