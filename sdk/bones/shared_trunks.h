// SPDX-License-Identifier: MIT
// Where the axis of a trunk forks long before its limbs part. Between two legs the straight skeleton's front comes up
// into the body, so the axis forks as high as the chest and both its branches run down inside of the trunk. Animators
// expect one spine there, and a pelvis that the legs hang on.
//
// At a junction, two branches that run side by side become one trunk while they are nearer to each other than half of
// the trunk's width: its joints lie in the middle between them. That counts if the trunk becomes longer than 0.6 of
// what merges junctions, is about as wide at its end as both limbs, and these go about the same way, within 40 degrees:
// two fingers of a hand, or arms of a star, do not. On the mirror axis of a part only what becomes a trunk on the axis
// does.
//
// This is none of the paper's (Ma, Wang, Li, Zhang 2021), and only done where `detail` is not 0.
#pragma once

#include "bones/bone_graph.h"
#include "bones/model.h"
#include "runtime/task.h"

namespace flg {

// `graph` is that of one part, refined; `merge` is the length that merged its junctions. The end of a trunk is pinned,
// so that it is not merged with its junction later. Takes about 50 ns a step along two branches, a sixteenth of their
// trunk's width.
Task<void> share_trunks(Pace& pace, const ModelPart& part, double merge, BoneGraph& graph);

// How many bones a stretch becomes, by its length over its width.
uint32_t pieces_of(double length, double width, double detail);

}  // namespace flg
