// SPDX-License-Identifier: MIT
// Types of filigree_bake.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>The most texels a side.</summary>
        public const uint FLG_BAKE_MAX_SIZE = 16384;
        /// <summary>The most texels of padding.</summary>
        public const uint FLG_BAKE_MAX_PADDING = 256;
    }
}
