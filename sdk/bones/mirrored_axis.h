// SPDX-License-Identifier: MIT
// The axis of a shape that is its own mirror image, made so to the last bit: its left half, and the image of that.
//
// Nodes on the mirror axis, or so near that their discs reach well across and that have no image, are put on it. Arcs
// across it end on it. So a branch that crosses it has an end there, and what lies on it is straight.
#pragma once

#include <optional>

#include "bones/axis.h"
#include "bones/contour_mirror.h"

namespace flg {

// None where the halves of the graph do not hang together.
Task<std::optional<PartSkeleton>> mirrored_branches(Pace& pace, const Contour& outline, const AxisGraph& graph,
                                                    MirrorAxis mirror, double spacing);

}  // namespace flg
