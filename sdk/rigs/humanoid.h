// SPDX-License-Identifier: MIT
// Humanoids: the bones that standards name, and their T-pose.
//
// Sources: VRM Consortium, VRMC_vrm-1.0, humanoid; Unity, HumanBodyBones; Epic Games, the mannequin's skeleton.
// The hips are where both legs, both arms and the head meet; the spine is the trunk from there to where the arms meet.
#pragma once

#include "rigs/rig.h"

namespace flg {

// One name a joint, null: none of the standard's. Throws where the rig is no humanoid, with what is missing.
void name_humanoid(const Rig& rig, FlgRigStandard standard, const char** names);

// Rotations as in FlgSkinAnimation. Throws without arms.
void pose_t(const Rig& rig, float* rotations);

}  // namespace flg
