// SPDX-License-Identifier: MIT
// What tangles and distances are drawn on: surfaces of 70 to 410 thousand triangles, made here.
#pragma once

#include <string>
#include <vector>

#include "gallery/workshop.h"

namespace flg::gallery {

// The figure of the scenes, made round by Loop's subdivision.
filigree::Surface cat(Workshop& workshop);

// Turned about the y axis, open above and below. The border below is loop 0, that above loop 1.
filigree::Surface vase(Workshop& workshop);
// A shallow dish of five lobes, hollow side down, with a hole in its middle. Its rim is loop 0, the hole loop 1.
filigree::Surface dish(Workshop& workshop);

// A cube blown up.
filigree::Surface ball(Workshop& workshop);

// A square metre of cloth in waves, as long on all four sides. Its outline begins in the front left corner.
filigree::Surface cloth(Workshop& workshop);

// Writes the cat, the vase and the ball as .ply into a folder.
void write_forms(Workshop& workshop, const std::string& folder);

}  // namespace flg::gallery
