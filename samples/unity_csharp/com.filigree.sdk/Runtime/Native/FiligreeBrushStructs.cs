// SPDX-License-Identifier: MIT
// Structs of filigree_brush.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>What to make, and of which curves.</summary>
    public unsafe partial struct FlgBrushMeshDesc
    {
        public uint struct_size;
        /// <summary>default FlgBrushShape.Tube</summary>
        public FlgBrushShape shape;
        /// <summary>
        /// The curves. Columns read: POSITION; RADIUS, a tube's, or half the width of a ribbon; COLOR; NORMAL by
        /// ribbons. They must live for the call.
        /// </summary>
        public FlgCurveSetView* curves;
        /// <summary>default 0</summary>
        public uint first_curve;
        /// <summary>at least 1. Default FLG_UNLIMITED: all the rest</summary>
        public uint curve_count;
        /// <summary>of each curve of the range. Default 0</summary>
        public uint first_point;
        /// <summary>of a tube, 3 to 64; also sets how fine round caps and joins are. Default 8</summary>
        public uint sides;
        /// <summary>
        /// Metres, &gt;= 0: a curve gets as few sides as keep its tube within it of a round one, 3 to `sides`: for
        /// levels of detail. 0: always `sides`. Must be 0 with a state. Default 0.
        /// </summary>
        public float tolerance;
        /// <summary>metres, &gt;= 0, without a RADIUS column. Default 0.005</summary>
        public float default_radius;
        /// <summary>&gt;= 0: factor on all radii. Default 1</summary>
        public float radius_scale;
        /// <summary>linear RGBA, without a COLOR column. Default white</summary>
        public fixed float default_color[4];
        /// <summary>default FlgBrushCap.Flat</summary>
        public FlgBrushCap start_cap;
        /// <summary>default FlgBrushCap.Flat</summary>
        public FlgBrushCap end_cap;
        /// <summary>of tapered caps, in radii, &gt;= 0, at most 1000. Default 2</summary>
        public float cap_length;
        /// <summary>default FlgBrushJoin.Miter</summary>
        public FlgBrushJoin join;
        /// <summary>radians, 0 to pi: larger turns are corners for BEVEL and ROUND. Default pi / 4</summary>
        public float corner_angle;
        /// <summary>nonzero: each side of a tube is flat, with vertices of its own. Default 0</summary>
        public uint hard_normals;
        /// <summary>
        /// Nonzero: vertices for texture coordinates: where these jump, from the last side of a tube to the first and
        /// from the end of a closed curve to its start, vertices are repeated. Default 0: shared; no UV column.
        /// </summary>
        public uint uv;
        /// <summary>the first coordinate. UNIT must not be used with a state. Default METRES</summary>
        public FlgBrushUv uv_along;
        /// <summary>the second: around a tube, across a ribbon. Default UNIT</summary>
        public FlgBrushUv uv_around;
        /// <summary>
        /// Nonzero: for left-handed hosts with y up. Negates z of positions, normals and tangents, and reverses
        /// triangles. Default 0.
        /// </summary>
        public uint left_handed;
        /// <summary>added to all indices: the buffer's vertices before this mesh. Default 0</summary>
        public uint base_vertex;
        /// <summary>0</summary>
        public uint reserved;
    }

    /// <summary>Where a growing stroke is. One per stroke; plain data that the host may copy, but not change.</summary>
    public unsafe partial struct FlgBrushMeshState
    {
        public uint struct_size;
        /// <summary>0 until points were written</summary>
        public uint begun;
        /// <summary>of the stroke as it is in the buffers, with its end's cap</summary>
        public ulong vertex_count;
        /// <summary>likewise</summary>
        public ulong index_count;
        /// <summary>the library's own</summary>
        public fixed double opaque[44];
    }

    /// <summary>What a call of flgBrushMeshWrite writes.</summary>
    public unsafe partial struct FlgBrushMeshSizes
    {
        public uint struct_size;
        public uint reserved;
        /// <summary>with a state: the mesh's first vertex that is written; else 0</summary>
        public ulong first_vertex;
        /// <summary>vertices that are written</summary>
        public ulong vertex_count;
        /// <summary>likewise</summary>
        public ulong first_index;
        /// <summary>three per triangle</summary>
        public ulong index_count;
    }

    /// <summary>
    /// The buffers. They must not overlap each other, nor the input. Written from front to back and never read: mapped
    /// memory of a graphics card will do.
    /// </summary>
    public unsafe partial struct FlgBrushMeshOutput
    {
        public uint struct_size;
        /// <summary>0 to 5</summary>
        public uint column_count;
        /// <summary>those that are wanted</summary>
        public FlgBufferColumn* columns;
        /// <summary>vertices that every column has room for</summary>
        public ulong vertex_capacity;
        /// <summary>null: not wanted</summary>
        public void* indices;
        /// <summary>indices that `indices` has room for</summary>
        public ulong index_capacity;
        /// <summary>UINT32 or UINT16. Default UINT32</summary>
        public FlgNumberFormat index_format;
        public uint reserved;
    }
}
