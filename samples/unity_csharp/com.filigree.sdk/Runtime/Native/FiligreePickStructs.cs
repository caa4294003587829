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
        /// <summary>for Embree's builds; 0: one per core. Default 1: the calling thread</summary>
        public uint threads;
        /// <summary>
        /// Metres: what rays, points and hits are relative to. Objects near it are picked most precisely. Default 0
        /// </summary>
        public fixed double origin[3];
    }

    /// <summary>A ray.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgRay
    {
        /// <summary>magnitude at most 1e18; likewise for positions of surfaces, and points below</summary>
        public fixed float origin[3];
        /// <summary>ignores hits before this, in lengths of the direction, &gt;= 0</summary>
        public float nearest;
        /// <summary>of any length but 0</summary>
        public fixed float direction[3];
        /// <summary>ignores hits after this, likewise; may be infinite</summary>
        public float furthest;
    }

    /// <summary>The hit of a ray or a point.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgHit
    {
        /// <summary>the host's index; FLG_NO_INDEX: nothing was hit</summary>
        public uint @object;
        /// <summary>the triangle; for curves the point at which the segment begins</summary>
        public uint element;
        /// <summary>as in FlgSurfacePoint; for curves u is the fraction along the segment, 0 to 1, and v is 0</summary>
        public float u;
        /// <summary>as in FlgSurfacePoint; for curves u is the fraction along the segment, 0 to 1, and v is 0</summary>
        public float v;
        /// <summary>metres</summary>
        public fixed float position[3];
        /// <summary>
        /// for rays, in lengths of their direction; for the nearest point, metres (0 inside a curve's tube)
        /// </summary>
        public float distance;
        /// <summary>of the flat triangle, or away from the curve; unit length</summary>
        public fixed float normal[3];
        /// <summary>the triangle's label; for curves the curve's index</summary>
        public uint region;
    }
}
