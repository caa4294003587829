// SPDX-License-Identifier: MIT
// The joints of a model and the bones between them, as meshes are bound to them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/memory.h"
#include "core/vec.h"

namespace flg {

inline constexpr uint32_t no_joint = 0xffffffffu;

struct BoneJoint {
    Vec3 at;
    double radius;    // of the shape around it
    uint32_t parent;  // comes before it; no_joint: a root
    uint32_t part;    // that it was made for
};

// Joints, parents first. A forest: one tree for each part that meets no earlier one.
struct BoneTree {
    explicit BoneTree(Memory* memory) : joints(memory) {}

    std::pmr::vector<BoneJoint> joints;
};

// What moves with a joint: the bone from it to one of its children, which may be of another part. A joint without
// children moves nothing, unless it is the only one of its part: then the bone is the point itself.
struct BoneSegment {
    Vec3 from, to;
    double from_radius, to_radius;
    uint32_t joint;  // the one at `from`, which the bone turns with
    uint32_t part;   // of that joint
};

}  // namespace flg
