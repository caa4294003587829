// SPDX-License-Identifier: MIT
// Structs of filigree_project.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    public unsafe partial struct FlgCurveSetProjectDesc
    {
        public uint struct_size;
        public uint reserved;
        public FlgJobOptions* job;
        public FlgSurface surface;
        /// <summary>open and closed; only their POSITION is used</summary>
        public FlgCurveSet curves;
    }
}
