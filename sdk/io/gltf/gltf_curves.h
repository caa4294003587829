// SPDX-License-Identifier: MIT
// Curves in glTF 2.0 files: read as lines from .gltf and .glb, written to .glb as lines, ribbons and tubes.
#pragma once

#include "core/origin.h"
#include "filigree/filigree_io.h"
#include "io/base/checked_views.h"
#include "io/base/curve_data.h"
#include "io/base/files.h"
#include "io/base/memory.h"

namespace flg::io {

CurveData read_gltf(const Path& path, const Origin& origin);

String write_glb(const CheckedView& view, const FlgCurveFileWriteDesc& desc);

}  // namespace flg::io
