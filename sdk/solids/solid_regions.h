// SPDX-License-Identifier: MIT
// Which bone of a solid is nearest to a point of its surface, by the way within the solid: a gap between limbs is as
// wide as the way around it. Ways begin at the shape around a bone, so a thick trunk keeps its surface from the thin
// limbs that hang on it.
#pragma once

#include <span>

#include "skeletons/bone_tree.h"
#include "solids/solid_grid.h"

namespace flg {

// By vertex the number of a bone; what is in no cell, nor beside one, has the nearest in space. About 1 us a cell
// inside, 0.3 us a vertex.
Task<Buffer<uint32_t>> nearest_bones_within(Pace& pace, const SolidGrid& grid, const Mesh& mesh,
                                            std::span<const BoneSegment> bones);

}  // namespace flg
