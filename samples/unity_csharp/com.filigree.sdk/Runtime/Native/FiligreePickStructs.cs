// SPDX-License-Identifier: MIT
// Structs of filigree_pick.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgPickSceneDesc
    {
        public uint struct_size;
        /// <summary>that Embree may build with; 0: one a core. Default 1: the calling one</summary>
        public uint threads;
    }

    /// <summary>Where a ray begins and goes.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgRay
    {
        /// <summary>at most 1e18 in size; so are the positions of surfaces, and points below</summary>
        public fixed float origin[3];
        /// <summary>hits before this are not seen, in lengths of the direction, &gt;= 0</summary>
        public float nearest;
        /// <summary>of any length but 0</summary>
        public fixed float direction[3];
        /// <summary>likewise hits after this; may be infinite</summary>
        public float furthest;
    }

    /// <summary>What a ray or a point met.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgHit
    {
        /// <summary>the host's number; FLG_NO_INDEX: nothing was hit</summary>
        public uint @object;
        /// <summary>the triangle; of curves the point at which the segment begins</summary>
        public uint element;
        /// <summary>as in FlgSurfacePoint; of curves u is the way along the segment, 0 to 1, and v is 0</summary>
        public float u;
        /// <summary>as in FlgSurfacePoint; of curves u is the way along the segment, 0 to 1, and v is 0</summary>
        public float v;
        /// <summary>metres</summary>
        public fixed float position[3];
        /// <summary>
        /// of rays, in lengths of their direction; of the nearest point, metres (0 inside a curve's tube)
        /// </summary>
        public float distance;
        /// <summary>of the flat triangle, or away from the curve; unit length</summary>
        public fixed float normal[3];
        /// <summary>the triangle's label; of curves the curve's number</summary>
        public uint region;
    }
}
