// SPDX-License-Identifier: MIT
// Smooth weights of many joints become those of four a vertex, and stay as smooth as four can be.
//
// Each vertex chooses its four by itself: the joint whose motion others make up for best gives its weight to these,
// until four are left. Choices end at lines on the surface. There, weights would jump, or fall steeply where five are
// about alike. So near such lines they are spread again, each joint only among the vertices that chose it: what
// neighbours have of others goes to those that move alike. The less a vertex lost, the more it keeps what it had.
#pragma once

#include "inflation/bone_weights.h"

namespace flg {

// All outlive the task. Takes about 1 us a vertex, 5 where more than four joints matter.
Task<BoneWeights> keep_four_joints(Pace& pace, const MergedMesh& mesh, const ManyWeights& many, BoneRig rig);

}  // namespace flg
