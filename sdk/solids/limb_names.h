// SPDX-License-Identifier: MIT
// Names for joints that nobody drew, as drawn ones have them: the limb, a number along it, and the side: body_0,
// leg_1.L, tail_0. Limbs are those of rigs/limb_roles.h; further pairs of legs are leg2, leg3, ..., what hangs on limbs
// is limb0, limb1, ...
#pragma once

#include <deque>
#include <string>

#include "skeletons/bone_tree.h"

namespace flg {

struct NamedLimbs {
    explicit NamedLimbs(Memory* memory) : names(memory) {}

    std::pmr::deque<std::pmr::string> names;  // by joint
    Vec3 left = Vec3::Zero();                 // that sides refer to; of length 0: there is none
};

// Sets the part of each joint: 0 is the trunk. `left`: to the model's left; `is_found`: it may as well be to its right,
// and is turned around if head or feet look backwards. Of trees with more than 128 joints all are of the trunk.
NamedLimbs name_limbs(BoneTree& tree, const Vec3& up, const Vec3& left, bool is_found, Memory* memory);

}  // namespace flg
