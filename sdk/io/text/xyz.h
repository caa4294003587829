// SPDX-License-Identifier: MIT
// Curves as text (.xyz, .txt).
#pragma once

#include <string_view>

#include "core/origin.h"
#include "filigree/filigree_io.h"
#include "io/base/checked_views.h"
#include "io/base/curve_data.h"
#include "io/base/files.h"
#include "io/base/memory.h"

namespace flg::io {

CurveData read_xyz(std::string_view text, const Origin& origin);
void write_xyz(const CheckedView& view, const FlgCurveFileWriteDesc& desc, FileWriter& file);

}  // namespace flg::io
