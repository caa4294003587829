// SPDX-License-Identifier: MIT
// Whether faces can be those of a straight skeleton, by what has to hold of one:
//
// - Nodes are as far from the lines of their faces' edges as their time says.
// - Each face turns counter-clockwise and is monotone along its edge. With arcs that are of two faces each, as they
//   were drawn, that makes a partition.
// - Arcs between two edges on one line, of which distances say nothing, are perpendicular to it.
// - Nodes and arcs are as many as those of a plane graph with that many holes.
// - At each node the front goes on as it has to, which is what tells the straight skeleton from other roofs over the
//   same walls: of two arcs of a face that rise from a node with less than a half turn between them something would
//   stay unswept, and so it would of two that do not rise with more; level arcs run against their face's edge.
// - No face is pinched: no node of it is on another of its arcs. (There a front edge without length did not vanish.)
#pragma once

#include <span>

#include "runtime/task.h"
#include "skeletons/skeleton_graph.h"

namespace flg {

// Of what chain_faces() made of the same points, which may have been moved by up to `perturbation`, a share of `size`,
// the contour's diagonal. Also measures the skeleton's residual. All outlive the task, whose scratch is in `memory`.
// About 0.5 us a face.
Task<bool> can_be_straight_skeleton(Pace& pace, std::span<const Point2> points, std::span<const uint32_t> next,
                                    uint32_t ring_count, double size, double perturbation, StraightSkeleton& skeleton,
                                    Memory* memory);

}  // namespace flg
