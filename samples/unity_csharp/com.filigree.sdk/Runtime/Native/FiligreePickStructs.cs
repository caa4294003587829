// SPDX-License-Identifier: MIT
// Structs of filigree_pick.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    /// <summary>
    /// Of FlgPickSceneDesc.embree_memory. Told of Embree's memory, which no hook provides: of `bytes` that it is about
    /// to take (above 0) or gave back (below 0: the return value is not used). 0 refuses: what needed the memory
    /// returns FlgResult.ErrorOutOfMemory; set that object and commit again. Called from Embree's threads, too. Null:
    /// all is granted.
    /// </summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate uint FlgPickSceneDescEmbreeMemory(void* user_data, long bytes);

    public unsafe partial struct FlgPickSceneDesc
    {
        public uint struct_size;
        /// <summary>for Embree's builds; 0: one per core. Default 1: the calling thread</summary>
        public uint threads;
        /// <summary>
        /// Metres: what rays, points and hits are relative to. Objects near it are picked most precisely. Default 0
        /// </summary>
        public fixed double origin[3];
        /// <summary>
        /// The scene's memory: copies of positions, triangles and curves, and what queries need. Called from any
        /// thread. Null: the C++ runtime's. Not included: Embree's structures and buffers, which are half of the whole
        /// and more.
        /// </summary>
        public FlgAllocator* allocator;
        /// <summary>
        /// A FlgPickSceneDescEmbreeMemory, by Marshal.GetFunctionPointerForDelegate. Told of Embree's memory, which no
        /// hook provides: of `bytes` that it is about to take (above 0) or gave back (below 0: the return value is not
        /// used). 0 refuses: what needed the memory returns FlgResult.ErrorOutOfMemory; set that object and commit
        /// again. Called from Embree's threads, too. Null: all is granted.
        /// </summary>
        public IntPtr embree_memory;
        /// <summary>passed to embree_memory</summary>
        public void* user_data;
    }

    /// <summary>A ray.</summary>
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
