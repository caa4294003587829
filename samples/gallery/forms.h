// SPDX-License-Identifier: MIT
// What tangles and distances are drawn on: surfaces of 100 to 400 thousand triangles, made here.
#pragma once

#include <string>
#include <vector>

#include "gallery/workshop.h"

namespace flg::gallery {

// The figure of the scenes, made round by Loop's subdivision: each level has four times the triangles.
filigree::Surface cat(Workshop& workshop, uint32_t levels = 4);

// Turned about the y axis. `columns` vertices around, `rows` from below to above. The border below is loop 0, that above loop 1.
filigree::Surface vase(Workshop& workshop, uint32_t columns = 640, uint32_t rows = 320);
// A shallow dish of five lobes, hollow side down, with a round hole in its middle: the outer border is loop 0, the hole's loop 1.
filigree::Surface dish(Workshop& workshop);

// A cube blown up.
filigree::Surface ball(Workshop& workshop);

// A square metre of cloth in waves, as long on all four sides. Its outline begins in the front left corner.
filigree::Surface cloth(Workshop& workshop);

// Writes the cat, the vase and the ball as .ply into a folder.
void write_forms(Workshop& workshop, const std::string& folder);

}  // namespace flg::gallery
