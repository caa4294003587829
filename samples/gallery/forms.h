// SPDX-License-Identifier: MIT
// Surfaces of the scenes.
#pragma once

#include "gallery/workshop.h"

namespace flg::gallery {

filigree::Surface surface_of(Workshop& workshop, const scenes::Mesh& mesh, float weld_distance = 0.0f);

// The figure of the scenes, made round by Loop's subdivision: 4 levels are 88 thousand triangles, each further one
// four times as many.
filigree::Surface cat(Workshop& workshop, uint32_t levels = 4);

}  // namespace flg::gallery
