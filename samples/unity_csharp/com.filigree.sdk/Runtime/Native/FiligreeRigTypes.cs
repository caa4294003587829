// SPDX-License-Identifier: MIT
// Types of filigree_rig.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>Maximum joints of a rig.</summary>
        public const uint FLG_RIG_MAX_JOINTS = 1024;
    }

    /// <summary>What a joint belongs to.</summary>
    public enum FlgLimb
    {
        /// <summary>FLG_LIMB_TRUNK: the root, and what legs, arms and the head hang on</summary>
        Trunk = 0,
        /// <summary>FLG_LIMB_NECK</summary>
        Neck = 1,
        /// <summary>FLG_LIMB_HEAD</summary>
        Head = 2,
        /// <summary>FLG_LIMB_ARM: a pair of limbs that do not reach the ground: wings and claws too</summary>
        Arm = 3,
        /// <summary>FLG_LIMB_LEG</summary>
        Leg = 4,
        /// <summary>FLG_LIMB_TAIL</summary>
        Tail = 5,
        /// <summary>
        /// FLG_LIMB_OTHER: ears, fingers, horns: what hangs on a limb or the trunk and is none of these
        /// </summary>
        Other = 6,
    }

    /// <summary>Where an arm or a leg bends.</summary>
    public enum FlgLimbPlace
    {
        /// <summary>FLG_LIMB_PLACE_NONE: any other joint</summary>
        None = 0,
        /// <summary>FLG_LIMB_PLACE_UPPER: shoulder or hip</summary>
        Upper = 1,
        /// <summary>FLG_LIMB_PLACE_MIDDLE: elbow or knee, a hinge; limbs of two joints have none</summary>
        Middle = 2,
        /// <summary>FLG_LIMB_PLACE_END: hand or foot</summary>
        End = 3,
    }

    /// <summary>Who names the bones of a humanoid.</summary>
    public enum FlgRigStandard
    {
        /// <summary>FLG_RIG_STANDARD_VRM: VRM 1.0: hips, spine, leftUpperArm, ...</summary>
        Vrm = 0,
        /// <summary>FLG_RIG_STANDARD_UNITY: Unity's HumanBodyBones: Hips, Spine, LeftUpperArm, ...</summary>
        Unity = 1,
        /// <summary>FLG_RIG_STANDARD_UNREAL: Unreal Engine's mannequin: pelvis, spine_01, upperarm_l, ...</summary>
        Unreal = 2,
    }

    /// <summary>Motions that show whether a model moves well.</summary>
    public enum FlgRigMotion
    {
        /// <summary>
        /// FLG_RIG_MOTION_WALK: on the spot, with all legs: two in turn, four one after the other, more in two sets.
        /// 1.2 s a cycle look natural
        /// </summary>
        Walk = 0,
        /// <summary>FLG_RIG_MOTION_IDLE: breathes and looks about, on standing feet. 4 s</summary>
        Idle = 1,
        /// <summary>
        /// FLG_RIG_MOTION_WAVE: the right arm, or else the right front leg, is lifted, waves and comes back. 3 s
        /// </summary>
        Wave = 2,
    }
}
