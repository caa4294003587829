// SPDX-License-Identifier: MIT
// Texels beside charts become copies of the nearest texel of a chart, up to the padding away.
#pragma once

#include "baking/texel_painter.h"

namespace flg {

// Band by band, side by side: reads texels that are covered, writes others.
Task<void> pad_charts(Pace& pace, const Canvas& canvas);

}  // namespace flg
