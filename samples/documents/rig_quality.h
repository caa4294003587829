// SPDX-License-Identifier: MIT
// How well a skin follows its joints: each joint is turned by itself, and the surface is looked at edge by edge.
#pragma once

#include "filigree/filigree_model.h"

namespace flg::cli {

struct RigQuality {
    double largest_stretch = 1;   // of an edge, by its length at rest
    uint32_t stretch_joint = 0;   // that was turned then
    uint32_t stretch_vertex = 0;  // where
    double largest_jump = 0;      // of one joint's weight from one end of an edge to the other
    uint32_t jump_joint = 0, jump_vertex = 0;
};

// Linear blending; every joint in turn by 30 degrees either way about x, y and z. Takes about 20 ns for each edge and
// pose that moves it.
RigQuality measure_rig(const FlgSkinView& skin);

// How many pieces the surface is in that no triangle joins.
uint32_t count_pieces(const FlgSkinView& skin);

}  // namespace flg::cli
