// SPDX-License-Identifier: MIT
// The strokes of a .tilt sketch (its member data.sketch).
#pragma once

#include <string>
#include <vector>

#include "io/curve_data.h"
#include "io/file_bytes.h"

namespace flg::io {

// `part` is what failures name, `brushes` the GUIDs that strokes refer to. The result is in metres and right-handed.
CurveData read_tilt_strokes(Bytes bytes, const char* part, const std::vector<std::string>& brushes);

}  // namespace flg::io
