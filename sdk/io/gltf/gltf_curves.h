// SPDX-License-Identifier: MIT
// Curves in glTF 2.0 files: read as lines from .gltf and .glb, written to .glb as lines, ribbons and tubes.
#pragma once

#include <filesystem>
#include <string>

#include "core/origin.h"
#include "filigree/filigree_io.h"
#include "io/base/checked_views.h"
#include "io/base/curve_data.h"

namespace flg::io {

CurveData read_gltf(const std::filesystem::path& path, const Origin& origin);

std::string write_glb(const CheckedView& view, const FlgCurveFileWriteDesc& desc);

}  // namespace flg::io
