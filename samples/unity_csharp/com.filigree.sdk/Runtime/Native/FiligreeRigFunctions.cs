// SPDX-License-Identifier: MIT
// Functions of filigree_rig.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Rigs that engines know: the limbs of a skeleton, names of humanoid standards, a T-pose, joint limits and capsules for
// ragdolls, test motions. Follows the grammar of filigree.h. Metres, radians.
//
// [any thread] All functions here: they need no context and keep no state. They check their input before they write
// anything: on failure arrays stay unchanged. They take joints as FlgModelView, FlgSkinView and files have them.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgRigFindDescInit(FlgRigFindDesc* desc, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgRigInit(FlgRig* rig, uint struct_size);

        /// <summary>
        /// Finds limbs, capsules and limits of a skeleton. Of several trees it looks at the largest; the others are
        /// FlgLimb.Other.
        ///   out_joints  one per joint
        ///   out_rig     refers to out_joints and the descriptor's arrays
        /// Legs reach down to the ground and lie beside the middle; seen from the side, they hang. Arms are the longest
        /// pair of mirrored limbs that is left, near the trunk; the head is the thickest and highest limb in the
        /// middle, the tail the longest of the others. Cost: 0.2 us a joint and 20 ns for two tips: 5 ms at most, for
        /// 1024 joints of which half are tips. Takes no memory for up to 64 joints, else up to 500 bytes a joint of the
        /// C++ runtime's.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgRigFind(FlgRigFindDesc* desc, FlgRigJoint* out_joints, FlgRig* out_rig);

        /// <summary>
        /// The bones of a humanoid, by the names of a standard.
        ///   out_names  one per joint: a name that lives as long as the library; null: the joint is none of the
        ///   standard's
        /// Needs two arms and two legs of at least three joints each, a head, and a joint of the spine between hips and
        /// arms. FlgResult.ErrorInvalidArgument if one is missing; the message says "no humanoid" and which. Cost: 0.1
        /// us a joint.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgRigGetNames(FlgRig* rig, FlgRigStandard standard, byte** out_names);

        /// <summary>
        /// The rotations that bring a humanoid from rest to a T-pose: each arm straight and level to its side, turned
        /// the shortest way, so that palms which face the body at rest face down. Legs stay. Take them for flgSkinPose:
        /// a skin that is deformed so, with its joints where they are then, is at rest in the T-pose.
        ///   out_rotations  4 per joint, as FlgSkinAnimation
        /// FlgResult.ErrorInvalidArgument without two arms. Cost: 0.1 us a joint.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgRigGetTPose(FlgRig* rig, float* out_rotations);

        /// <summary>
        /// The pose of a motion. Arms of those who stand on two legs hang down in all of them, however they are at
        /// rest. Motions repeat without a seam: phase 1 is phase 0. All rotations are within the limits.
        ///   phase            share of the cycle, finite
        ///   out_rotations    4 per joint, as FlgSkinAnimation
        ///   out_translation  3: of all roots, metres
        ///   out_travel       3, or null: how far the model walks in a cycle, metres: move it so, and standing feet
        ///   stay
        /// Standing feet slide by less than 0.0001 of the way of a cycle, if legs reach as far.
        /// FlgResult.ErrorInvalidArgument if the rig has no limbs for the motion; the message names them. Cost: 0.3 us
        /// a joint; takes no memory.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgRigMotionSample(
            FlgRig* rig, FlgRigMotion motion, float phase, float* out_rotations, float* out_translation, float*
            out_travel);

        public static FlgRigFindDesc flgRigFindDefaults()
        {
            FlgRigFindDesc made;
            flgRigFindDescInit(&made, (uint)sizeof(FlgRigFindDesc));
            return made;
        }

        public static FlgRig flgRigDefaults()
        {
            FlgRig made;
            flgRigInit(&made, (uint)sizeof(FlgRig));
            return made;
        }
    }
}
