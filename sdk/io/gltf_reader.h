// SPDX-License-Identifier: MIT
// Lines of glTF 2.0 files, .gltf and .glb.
#pragma once

#include <filesystem>

#include "io/curve_data.h"

namespace flg::io {

CurveData read_gltf(const std::filesystem::path& path);

}  // namespace flg::io
