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
