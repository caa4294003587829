// SPDX-License-Identifier: MIT
// Types of filigree_pick.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>Embree's acceleration structures over copies of surfaces and curves.</summary>
    public partial struct FlgPickScene
    {
        public IntPtr pointer;
        public bool IsNull => pointer == IntPtr.Zero;
    }
}
