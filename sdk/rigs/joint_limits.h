// SPDX-License-Identifier: MIT
// Where limbs bend, how far joints may turn there, and capsules around bones.
//
// A limb's upper joint is its first one that does not lie deep within what it hangs on; its end is its tip, or the
// joint before it where the last bone is short (a foot, a hand). In the middle is the joint that divides the way most
// evenly.
//
// Hinges. A knee turns about the left, an elbow about what turns the arm to the front. Where they are bent at rest,
// this says which way; an arm that is bent enough says about what, too. Legs that lie to a side bend up and down.
// Hinges go back until they are straight. Formulas are built from directions that mirror with the limb, so limits do
// too.
#pragma once

#include "bones/skin_pose.h"
#include "rigs/limb_roles.h"

namespace flg {

// After find_limbs: sets places, limits and capsules.
void set_limits(const RigSkeleton& skeleton, const RigFrame& frame, std::span<FlgRigJoint> joints);

// The rotation with twist and swing cut to the joint's limits.
Quaternion within_limits(const FlgRigJoint& joint, const Quaternion& rotation);

}  // namespace flg
