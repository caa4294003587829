// SPDX-License-Identifier: MIT
// Types of filigree_skeleton.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>The straight skeleton of a contour. Never changes once ready.</summary>
    public partial struct FlgStraightSkeleton : IEquatable<FlgStraightSkeleton>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgStraightSkeleton other) => id == other.id;
        public override bool Equals(object other) => other is FlgStraightSkeleton handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }
}
