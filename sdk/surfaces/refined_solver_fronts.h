// SPDX-License-Identifier: MIT
// Where the fronts of two sources meet, or those of a curve with itself. Unfolding (refined_solver_step.h) takes both ends of
// an edge v-n to have their distances from one point; where v has its from one front and n from another, that point is
// none of either's, and what lies behind the edge would get a distance that is too short, by up to half an edge.
//
// A wave that comes to the edge through the triangle v-n-m has passed m: if the unfolded point is nearer to m than to the
// edge's ends, then m has at most that distance. Else the ends have different fronts. Then v's own front is unfolded across
// the edge v-m, or the next one around v for which the same holds, and goes on through the triangles between. No paper has
// this that we know of.
#pragma once

#include <optional>

#include "surfaces/refined_solver_step.h"

namespace flg {

// How far, by v's own front, the neighbour at `lane` is that the step reached across the edge to the lane behind it, or before
// it. Nothing where the edge's ends have one front: the step's distance holds.
std::optional<float> distance_by_own_front(const GeodesicBlock& block, const WaveState* states, const WaveState& own,
                                           uint32_t lane, bool across_next);

}  // namespace flg
