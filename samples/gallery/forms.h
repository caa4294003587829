// SPDX-License-Identifier: MIT
// What tangles and distances are drawn on: surfaces of 70 thousand to 1.5 million triangles, made here.
#pragma once

#include <string>
#include <vector>

#include "gallery/workshop.h"

namespace flg::gallery {

filigree::Surface surface_of(Workshop& workshop, const scenes::Mesh& mesh, float weld_distance = 0.0f);

// The figure of the scenes, made round by Loop's subdivision: 4 levels are 88 thousand triangles, each further one
// four times as many.
filigree::Surface cat(Workshop& workshop, uint32_t levels = 4);
constexpr uint32_t kFineCat = 5;

// Turned about the y axis, open above and below, of so many vertices around. The border below is loop 0, that above
// loop 1.
filigree::Surface vase(Workshop& workshop, uint32_t columns = 640);
constexpr uint32_t kFineVase = 960;

// A shallow dish of five lobes, hollow side down, with a hole in its middle. Its rim is loop 0, the hole loop 1.
filigree::Surface dish(Workshop& workshop);

// A cube blown up.
filigree::Surface ball(Workshop& workshop);

// A metre high, standing on its blunt end; 1.5 million triangles.
filigree::Surface egg(Workshop& workshop);

// A square metre of cloth in waves, as long on all four sides. Its outline begins in the front left corner.
filigree::Surface cloth(Workshop& workshop);

// Writes a surface as a mesh, by the extension.
void write_form(const filigree::Surface& surface, const std::string& path);
// Writes all that scripts decorate as .ply into a folder.
void write_forms(Workshop& workshop, const std::string& folder);

}  // namespace flg::gallery
