// SPDX-License-Identifier: MIT
#pragma once

#include "documents/json_place.h"

namespace flg::cli {

// `#rrggbb` as in picture editors (sRGB), or three linear numbers, 0 to 1: `color` gets three linear ones. Throws
// InputError.
void read_color(const JsonPlace& place, float* color);

}  // namespace flg::cli
