// SPDX-License-Identifier: MIT
// Which points of a solid's curves become joints, by the thresholds that drawn parts have: where curves branch and
// end, where limbs leave the trunk, where they bend or narrow, and between these as often as the bones are long for
// their width.
#pragma once

#include "bones/bone_graph.h"
#include "filigree/filigree_model.h"
#include "solids/curve_skeleton.h"

namespace flg {

// The curves' joints and the images of those that are not in the mirror's plane, as a tree whose root is the curves'.
// `size`: what thresholds are shares of, metres. About 1 us a node.
Task<BoneTree> curve_joints(Pace& pace, const CurveSkeleton& curves, const SolidFrame& frame,
                            FlgBoneThresholds thresholds, double size);

}  // namespace flg
