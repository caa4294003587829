// SPDX-License-Identifier: MIT
// Skeletons made coarser (Ma, Wang, Li, Zhang 2021, sec. 3.3), each step on whole models and, with other thresholds, on
// parts. Whatever they do a tree stays one, and never loses its last joint.
//
// - Merging: junctions with less than a threshold of bone between them become one, that with the largest radius.
// - Pruning: branches from a junction to an end that are shorter than a threshold are removed, all at once.
// - Collapsing: bones shorter than a threshold whose ends both have other bones are contracted, the shortest first, to
//   the end that is a junction, else to the one with the larger radius.
//
// Departures: short branches are pruned before junctions are merged as well; else the twigs at the teeth of a scribbled
// outline make a limb a chain of junctions, which become one. Branches that nowhere reach beyond the ball of their
// junction by more than `bulge` of its radius are pruned too, until there is none, and those that begin within the
// widest ball of their part, by the same measure: those of a round part's corners, which are no limbs. Junctions become
// one too where one is within `hub` of the other's radius and five limbs or more leave them: a palm is one, for all its
// fingers. Joints that are pinned stay as they are. Where an end on the mirror axis of its part and its mirror image
// could be kept, that end is; and of several junctions as wide as each other, one on the axis or their middle. So
// mirror images stay mirror images.
//
// A threshold of a part is for branches and bones that are all of it; what goes from part to part has the model's.
#pragma once

#include <span>

#include "bones/bone_graph.h"
#include "runtime/task.h"

namespace flg {

struct RefinementThresholds {
    double merge, prune, collapse;  // lengths in the model's space
    double bulge = 0;               // of a junction's radius
    double hub = 0;                 // likewise
    Vec3 widest_at = Vec3::Zero();  // the widest ball of a part alone
    double widest = 0;              // its radius; 0: none
};

// thresholds[p] are those of part p, the last ones the model's. Both outlive the task.
Task<void> refine(Pace& pace, BoneGraph& graph, std::span<const RefinementThresholds> thresholds);

}  // namespace flg
