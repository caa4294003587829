// SPDX-License-Identifier: MIT
// The host's own curves (samples/scenes) handed to the SDK.
#pragma once

#include <vector>

#include "filigree/filigree.hpp"
#include "scenes/scenes.h"

namespace viewer {

// One set of all of them, with their radii and colours. The SDK copies them.
filigree::CurveSet curve_set(filigree::Context& context, const std::vector<flg::scenes::Curve>& curves);

}  // namespace viewer
