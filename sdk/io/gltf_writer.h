// SPDX-License-Identifier: MIT
// Curves as glTF 2.0, binary.
#pragma once

#include <string>

#include "filigree/filigree_io.h"
#include "io/checked_view.h"

namespace flg::io {

std::string write_glb(const CheckedView& view, const FlgCurveWriteDesc& desc);

}  // namespace flg::io
