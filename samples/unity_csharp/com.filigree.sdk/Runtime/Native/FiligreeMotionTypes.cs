// SPDX-License-Identifier: MIT
// Types of filigree_motion.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>Maximum keys of a motion.</summary>
        public const uint FLG_MOTION_MAX_KEYS = 65536;
        /// <summary>Maximum positions of a motion.</summary>
        public const uint FLG_MOTION_MAX_POSITIONS = 1048576;
    }

    /// <summary>How times of keys come about.</summary>
    public enum FlgMotionTiming
    {
        /// <summary>FLG_MOTION_TIMING_GIVEN</summary>
        Given = 0,
        /// <summary>FLG_MOTION_TIMING_CHORD: in proportion to the keys' distances</summary>
        Chord = 1,
        /// <summary>FLG_MOTION_TIMING_CENTRIPETAL: to their square roots: calmer where distances differ much</summary>
        Centripetal = 2,
    }

    /// <summary>How fast the path is passed.</summary>
    public enum FlgMotionPacing
    {
        /// <summary>FLG_MOTION_PACING_KEYS: as the times of keys say</summary>
        Keys = 0,
        /// <summary>FLG_MOTION_PACING_PATH: the barycentre keeps its speed from pause to pause</summary>
        Path = 1,
        /// <summary>
        /// FLG_MOTION_PACING_BODY: the root mean square of the speeds of the body's points is kept: turns count too
        /// </summary>
        Body = 2,
    }

    /// <summary>Where the body's -z points, with its +y upwards, as a camera.</summary>
    public enum FlgMotionLook
    {
        /// <summary>FLG_MOTION_LOOK_KEYS: as the keys' rotations say</summary>
        Keys = 0,
        /// <summary>FLG_MOTION_LOOK_TARGET: from its barycentre to a point, or to another one that moves</summary>
        Target = 1,
        /// <summary>FLG_MOTION_LOOK_PATH: ahead along the path</summary>
        Path = 2,
    }

    /// <summary>A motion of a rigid body. Never changes once ready.</summary>
    public partial struct FlgMotion : IEquatable<FlgMotion>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgMotion other) => id == other.id;
        public override bool Equals(object other) => other is FlgMotion handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }
}
