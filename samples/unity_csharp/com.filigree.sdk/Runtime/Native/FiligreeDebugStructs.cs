// SPDX-License-Identifier: MIT
// Structs of filigree_debug.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>An end of a line, or a point.</summary>
    public unsafe partial struct FlgDebugVertex
    {
        /// <summary>metres</summary>
        public fixed float position[3];
        /// <summary>linear RGBA, 8 bits each, red lowest: on little-endian machines the bytes R, G, B, A</summary>
        public uint color;
    }

    /// <summary>What to draw, and how.</summary>
    public unsafe partial struct FlgDebugDrawDesc
    {
        public uint struct_size;
        /// <summary>of FlgDebugPart; 0: those that the function draws by default. Default 0</summary>
        public uint parts;
        /// <summary>first element of each part. Default 0</summary>
        public uint first;
        /// <summary>elements of each part, as far as there are so many. Default FLG_UNLIMITED</summary>
        public uint count;
        /// <summary>
        /// draws frames, displacements, slices and normals of manifolds at every n-th point only; at least 1. Default 1
        /// </summary>
        public uint every;
        /// <summary>
        /// length of the axes of frames and of normals, metres, above 0 and at most 1e30. Default 0.05
        /// </summary>
        public float size;
        /// <summary>of what has no colour of its own, as in FlgDebugVertex. Default 0xffffffff: white</summary>
        public uint color;
        public uint reserved;
        /// <summary>metres: what the drawing is relative to. Default 0</summary>
        public fixed double origin[3];
    }

    /// <summary>A drawing. The host owns the arrays; an array that is null is counted, but not written.</summary>
    public unsafe partial struct FlgDebugDrawing
    {
        public uint struct_size;
        /// <summary>lines that `lines` has room for. Default 0</summary>
        public uint line_capacity;
        /// <summary>points that `points` has room for. Default 0</summary>
        public uint point_capacity;
        /// <summary>always written</summary>
        public uint line_count;
        /// <summary>likewise</summary>
        public uint point_count;
        public uint reserved;
        /// <summary>2 per line</summary>
        public FlgDebugVertex* lines;
        /// <summary>one per point</summary>
        public FlgDebugVertex* points;
    }
}
