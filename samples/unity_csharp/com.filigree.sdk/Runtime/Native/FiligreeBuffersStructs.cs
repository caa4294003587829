// SPDX-License-Identifier: MIT
// Structs of filigree_buffers.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>The buffers, and which part of a result they get.</summary>
    public unsafe partial struct FlgBufferOutput
    {
        public uint struct_size;
        /// <summary>0 to 16</summary>
        public uint column_count;
        /// <summary>those that are wanted</summary>
        public FlgBufferColumn* columns;
        /// <summary>rows that every column has room for</summary>
        public ulong row_capacity;
        /// <summary>default 0</summary>
        public uint first_row;
        /// <summary>default FLG_UNLIMITED: all the rest</summary>
        public uint row_count;
        /// <summary>default 0</summary>
        public uint first_triangle;
        /// <summary>default FLG_UNLIMITED: all the rest</summary>
        public uint triangle_count;
        /// <summary>three a triangle, for meshes alone; null: not wanted</summary>
        public void* indices;
        /// <summary>indices that `indices` has room for</summary>
        public ulong index_capacity;
        /// <summary>a label a triangle, for surfaces alone; null: not wanted</summary>
        public void* regions;
        /// <summary>labels that `regions` has room for</summary>
        public ulong region_capacity;
        /// <summary>UINT32 or UINT16. Default UINT32</summary>
        public FlgNumberFormat index_format;
        /// <summary>UINT32, UINT16 or UINT8. Default UINT32</summary>
        public FlgNumberFormat region_format;
        /// <summary>
        /// 3 doubles, metres, magnitude at most 1e30, read during the call: what the host counts positions from. The
        /// result's own origin minus this is added in doubles. Null: positions stay as they are, relative to the
        /// result's origin.
        /// </summary>
        public double* origin;
        /// <summary>added to all indices: the buffer's vertices before these. Default 0</summary>
        public uint base_vertex;
        /// <summary>
        /// Nonzero: for left-handed hosts with y up. Negates z of positions, normals, tangents and displacements, x and
        /// y of orientations, angles about the tangent; and reverses triangles. Default 0.
        /// </summary>
        public uint left_handed;
    }

    /// <summary>Columns of any view, and where they go.</summary>
    public unsafe partial struct FlgColumnsWriteDesc
    {
        public uint struct_size;
        /// <summary>1 to 16, each attribute at most once</summary>
        public uint column_count;
        /// <summary>those of a view, or made of its arrays: FlgAttribute.Value of a field's, say</summary>
        public FlgColumn* columns;
        /// <summary>rows that every column has</summary>
        public uint row_count;
        public uint reserved;
        public FlgBufferOutput* output;
        /// <summary>metres: what positions are relative to; the view's. Default 0</summary>
        public fixed double origin[3];
    }
}
