// SPDX-License-Identifier: MIT
#include "bones/bone_segments.h"

namespace flg {

std::pmr::vector<BoneSegment> bone_segments(const BoneTree& tree, std::span<const uint32_t> part_joints,
                                            Memory* memory) {
    std::pmr::vector<BoneSegment> segments(memory);
    segments.reserve(tree.joints.size() + part_joints.size());
    std::pmr::vector<bool> has_bone(part_joints.size(), false, memory);
    for (const BoneJoint& joint : tree.joints) {
        if (joint.parent == no_joint) continue;
        const BoneJoint& parent = tree.joints[joint.parent];
        // A bone into another part lies in this one, however thin the other is.
        const double radius = joint.part == parent.part ? joint.radius : parent.radius;
        segments.push_back({parent.at, joint.at, parent.radius, radius, joint.parent, parent.part});
        has_bone[parent.part] = true;
    }
    for (uint32_t p = 0; p < part_joints.size(); ++p) {
        if (has_bone[p]) continue;
        const BoneJoint& joint = tree.joints[part_joints[p]];
        segments.push_back({joint.at, joint.at, joint.radius, joint.radius, part_joints[p], p});
    }
    return segments;
}

}  // namespace flg
