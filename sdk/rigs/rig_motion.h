// SPDX-License-Identifier: MIT
// Test motions by limbs: poses at phases of a cycle, from nothing but the rig. Each pose is made anew and takes no
// memory.
//
// Walk. Feet follow a path: while they stand, straight back at an even speed; then up and to the front, smoothly
// joined. A leg reaches its foot's place by its hinge, which sets the distance of its end from the hip, and by the
// shortest turn of the hip. So that legs reach, hips are lowered; where that is not enough strides become shorter. Legs
// without a hinge swing: their feet go the same way, and the body rises and falls with them.
// Two legs take turns; four step hind left, front left, hind right, front right; more alternate in two sets, as an
// insect's.
#pragma once

#include "rigs/rig.h"

namespace flg {

struct MotionPose {
    float* rotations;  // as FlgSkinAnimation
    Vec3 translation = Vec3::Zero();
    Vec3 travel = Vec3::Zero();  // in a cycle
};

// Throws where the rig has no limbs for the motion. `phase` from 0 to 1.
void sample_motion(const Rig& rig, FlgRigMotion motion, double phase, MotionPose& pose);

}  // namespace flg
