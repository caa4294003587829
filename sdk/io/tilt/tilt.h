// SPDX-License-Identifier: MIT
// VR sketches (.tilt), as one file or as a directory.
#pragma once

#include "io/base/curve_data.h"
#include "io/base/files.h"

namespace flg::io {

CurveData read_tilt(const Path& path);

}  // namespace flg::io
