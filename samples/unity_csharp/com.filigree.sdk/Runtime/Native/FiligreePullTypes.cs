// SPDX-License-Identifier: MIT
// Types of filigree_pull.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>Maximum handles of a pulled mesh.</summary>
        public const uint FLG_PULL_MAX_HANDLES = 256;
    }

    /// <summary>What pulling needs of a mesh. Never changes once ready.</summary>
    public partial struct FlgPull : IEquatable<FlgPull>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgPull other) => id == other.id;
        public override bool Equals(object other) => other is FlgPull handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>A mesh as handles pull it. Never changes once ready.</summary>
    public partial struct FlgPulled : IEquatable<FlgPulled>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgPulled other) => id == other.id;
        public override bool Equals(object other) => other is FlgPulled handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }
}
