// SPDX-License-Identifier: MIT
// The bones of a tree, each with the joint it turns with.
#pragma once

#include <span>

#include "skeletons/bone_tree.h"

namespace flg {

// A bone from each joint's parent to it. A part that no bone begins in (its joints are ends, or became those of other
// parts) gets one that is a point: that of its joint in `part_joints`. Linear, about 20 ns a joint.
std::pmr::vector<BoneSegment> bone_segments(const BoneTree& tree, std::span<const uint32_t> part_joints,
                                            Memory* memory);

}  // namespace flg
