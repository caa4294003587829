// SPDX-License-Identifier: MIT
// VR sketches (.tilt), as one file or as a directory.
#pragma once

#include <filesystem>

#include "io/base/curve_data.h"

namespace flg::io {

CurveData read_tilt(const std::filesystem::path& path);

}  // namespace flg::io
