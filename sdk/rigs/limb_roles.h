// SPDX-License-Identifier: MIT
// Which limb each joint of a skeleton belongs to: from the hierarchy, the mirror plane and positions alone.
//
// 1. Tips (joints without children) near the ground are feet if they lie beside the middle, or hang, where nothing lies
//    beside the middle. Tips that branch apart near their ends are one foot. With four feet, limbs that end a little
//    higher are legs too.
// 2. The trunk is what two feet hang on, and the root. Seen from the side it goes on along thick level bones.
// 3. Arms are the two mirrored tips with the longest ways to the joint where they meet; those with no head between
//    them, as ears, come last. With two legs or less this may be anywhere above the trunk, and is trunk then; with more
//    it must be the trunk itself. Where none are mirrored, two of about the same length on both sides.
// 4. The head is, of the limbs in the middle, the thickest and highest. Where it hangs on an arm, that part is trunk.
// 5. The tail is the longest other limb in the middle that does not hang on the chest.
// What branches off a limb, and what else hangs on the trunk, is none of these.
#pragma once

#include <cstdint>
#include <span>

#include "core/memory.h"
#include "core/vec.h"
#include "filigree/filigree_rig.h"

namespace flg {

struct RigSkeleton {
    std::span<const Vec3> at;
    std::span<const double> radii;
    std::span<const uint32_t> parents;  // come first; FLG_NO_INDEX: a root
};

struct RigFrame {
    Vec3 up, left, forward;  // of length 1
    double ground;           // along `up`
};

// `left` of length 0: to be found. Sets limb, side, pair, index and next.
RigFrame find_limbs(const RigSkeleton& skeleton, const Vec3& up, const Vec3& left, std::span<FlgRigJoint> joints,
                    Memory* memory);

}  // namespace flg
