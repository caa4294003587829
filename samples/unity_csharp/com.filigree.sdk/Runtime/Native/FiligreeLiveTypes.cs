// SPDX-License-Identifier: MIT
// Types of filigree_live.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>A stroke being drawn. Strokes are independent of each other.</summary>
    public partial struct FlgLiveStroke : IEquatable<FlgLiveStroke>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgLiveStroke other) => id == other.id;
        public override bool Equals(object other) => other is FlgLiveStroke handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }
}
