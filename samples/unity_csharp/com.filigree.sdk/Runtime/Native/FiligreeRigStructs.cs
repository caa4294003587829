// SPDX-License-Identifier: MIT
// Structs of filigree_rig.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>A joint's place in the rig, the bone that turns with it, and how far it may turn.</summary>
    public unsafe partial struct FlgRigJoint
    {
        public FlgLimb limb;
        public FlgLimbPlace place;
        /// <summary>1: left, -1: right, 0: the middle, or not known</summary>
        public int side;
        /// <summary>of legs: 0 is the pair in front; without sides each leg is a pair. Else 0</summary>
        public uint pair;
        /// <summary>along the limb, 0 where it begins at the trunk. Of the trunk: from the root</summary>
        public uint index;
        /// <summary>the joint at the other end of its bone, where the limb goes on; FLG_NO_INDEX: a tip</summary>
        public uint next;
        /// <summary>metres, as the joint's position at rest</summary>
        public fixed float capsule_start[3];
        /// <summary>metres, likewise</summary>
        public fixed float capsule_end[3];
        /// <summary>metres; 0: a tip has no bone</summary>
        public float capsule_radius;
        /// <summary>of length 1, in the model's space</summary>
        public fixed float limit_axis[3];
        /// <summary>radians, 0 to pi</summary>
        public float limit_swing;
        /// <summary>radians, -pi to 0</summary>
        public float limit_twist_min;
        /// <summary>radians, 0 to pi</summary>
        public float limit_twist_max;
    }

    public unsafe partial struct FlgRigFindDesc
    {
        public uint struct_size;
        /// <summary>1 to FLG_RIG_MAX_JOINTS</summary>
        public uint joint_count;
        /// <summary>3 per joint, metres</summary>
        public float* joint_positions;
        /// <summary>one per joint: radius of the shape around it, metres, 0 or above</summary>
        public float* joint_radii;
        /// <summary>one per joint, lower than its own index; FLG_NO_INDEX: a root</summary>
        public uint* joint_parents;
        /// <summary>of any length above 0. Default 0 1 0</summary>
        public fixed float up[3];
        /// <summary>
        /// to the model's left, as FlgModelDesc::mirror; it looks along left x up. 0 0 0: to be found. Then the model
        /// faces +z if its limbs are mirror images, and else is drawn from the side and looks where its head is.
        /// Default 0 0 0
        /// </summary>
        public fixed float left[3];
    }

    /// <summary>What the other functions take. Refers to the host's arrays, which must live as long.</summary>
    public unsafe partial struct FlgRig
    {
        public uint struct_size;
        public uint joint_count;
        /// <summary>the descriptor's</summary>
        public float* joint_positions;
        /// <summary>the descriptor's</summary>
        public uint* joint_parents;
        /// <summary>one per joint</summary>
        public FlgRigJoint* joints;
        /// <summary>up, left and forward are at right angles, of length 1</summary>
        public fixed float up[3];
        /// <summary>to the model's left</summary>
        public fixed float left[3];
        /// <summary>where it looks</summary>
        public fixed float forward[3];
        /// <summary>metres along `up`: where the shape ends below</summary>
        public float ground;
        public uint leg_count;
        /// <summary>0 or 2</summary>
        public uint arm_count;
    }
}
