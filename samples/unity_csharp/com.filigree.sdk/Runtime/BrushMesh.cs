// SPDX-License-Identifier: MIT
// Tubes and ribbons as triangles.
using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    /// <summary>
    /// The mesh of a curve that grows: each call writes what its points add into arrays that hold all of it, and says
    /// which ranges these are. As Unity has it, z points away and front faces are clockwise. Allocates nothing after it
    /// is made.
    /// </summary>
    public sealed unsafe class BrushMesh
    {
        FlgBrushMeshDesc desc;
        FlgBrushMeshState state;

        /// <param name="desc">From Native.flgBrushMeshDefaults, with what you changed.</param>
        public BrushMesh(FlgBrushMeshDesc desc)
        {
            this.desc = desc;
            this.desc.left_handed = 1;
            Clear();
        }

        public int VertexCount => (int)state.vertex_count;

        public int IndexCount => (int)state.index_count;

        /// <summary>The next points begin another curve.</summary>
        public void Clear()
        {
            state = Native.flgBrushMeshStateDefaults();
        }

        /// <summary>
        /// Appends the points of a view of one open curve, from number `first` on. The last ring is written again:
        /// only now it is known where the curve goes on. Throws if the arrays are too short; then nothing is written.
        /// </summary>
        /// <param name="vertices">A vertex begins with its position and its normal, three floats each.</param>
        /// <param name="indices">Three for a triangle.</param>
        public FlgBrushMeshSizes Append<TVertex>(CurveSetView points, int first, TVertex[] vertices, uint[] indices)
            where TVertex : struct
        {
            FlgBrushMeshSizes sizes = Native.flgBrushMeshSizesDefaults();
            if (first >= points.PointCount) return sizes;
            FlgCurveSetView view = points.Struct;
            desc.curves = &view;
            desc.first_point = (uint)first;
            Span<byte> memory = MemoryMarshal.AsBytes(vertices.AsSpan());
            fixed (FlgBrushMeshDesc* from = &desc)
            fixed (FlgBrushMeshState* at = &state)
            fixed (byte* bytes = &MemoryMarshal.GetReference(memory))
            fixed (uint* numbers = indices)
            {
                FiligreeException.Check(Native.flgBrushMeshGetSizes(from, at, &sizes));
                FlgBrushMeshOutput output = Native.flgBrushMeshOutputDefaults();
                FlgBufferColumn* columns = stackalloc FlgBufferColumn[2];
                if (sizes.vertex_count > 0) // a curve's first point is no mesh yet
                {
                    uint stride = (uint)(memory.Length / vertices.Length);
                    byte* next = bytes + sizes.first_vertex * stride;
                    columns[0] = new FlgBufferColumn { attribute = FlgAttribute.Position, data = next };
                    columns[1] = new FlgBufferColumn { attribute = FlgAttribute.Normal, data = next + 12 };
                    columns[0].stride = columns[1].stride = stride;
                    output.columns = columns;
                    output.column_count = 2;
                    output.vertex_capacity = Left(vertices.Length, sizes.first_vertex);
                    output.indices = numbers + sizes.first_index;
                    output.index_capacity = Left(indices.Length, sizes.first_index);
                }
                FiligreeException.Check(Native.flgBrushMeshWrite(from, at, &output, null));
            }
            return sizes;
        }

        static ulong Left(int length, ulong first)
        {
            return (ulong)length > first ? (ulong)length - first : 0;
        }
    }
}
