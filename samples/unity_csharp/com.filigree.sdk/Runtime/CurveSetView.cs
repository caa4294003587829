// SPDX-License-Identifier: MIT
// The SDK's own arrays, seen from C#: no copy, no allocation.
using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    /// <summary>
    /// Curves in flat arrays: curve c has the points Offsets[c] to Offsets[c + 1] - 1 of every column. The arrays are
    /// the SDK's and live as its comments say; as a ref struct the view can't outlast the method that asked for it.
    /// </summary>
    public readonly unsafe ref struct CurveSetView
    {
        readonly FlgCurveSetView view;

        internal CurveSetView(FlgCurveSetView view)
        {
            this.view = view;
        }

        internal FlgCurveSetView Struct => view;

        public int CurveCount => (int)view.curve_count;

        public int PointCount => view.curve_count == 0 ? 0 : (int)view.curve_offsets[view.curve_count];

        /// <summary>CurveCount + 1 numbers.</summary>
        public ReadOnlySpan<uint> Offsets => new ReadOnlySpan<uint>(view.curve_offsets, CurveCount + 1);

        public bool IsClosed(int curve)
        {
            if ((uint)curve >= view.curve_count) throw new ArgumentOutOfRangeException(nameof(curve));
            return view.curve_flags != null && (view.curve_flags[curve] & Native.FLG_CURVE_CLOSED) != 0;
        }

        /// <summary>
        /// A column's first number and how many each point has; null and 0 if there is no such column.
        /// </summary>
        public float* Pointer(FlgAttribute attribute, out int components)
        {
            for (uint i = 0; i < view.column_count; ++i)
            {
                if (view.columns[i].attribute != attribute) continue;
                components = (int)view.columns[i].components;
                return view.columns[i].data;
            }
            components = 0;
            return null;
        }

        public bool Has(FlgAttribute attribute)
        {
            int components;
            return Pointer(attribute, out components) != null;
        }

        /// <summary>All numbers of a column; empty if there is no such column.</summary>
        public ReadOnlySpan<float> Floats(FlgAttribute attribute)
        {
            int components;
            float* data = Pointer(attribute, out components);
            return new ReadOnlySpan<float>(data, checked(PointCount * components));
        }

        /// <summary>
        /// A column as structs of so many floats, such as Vector3 for positions. In the SDK's right-handed coordinates,
        /// whatever the struct is called.
        /// </summary>
        public ReadOnlySpan<T> Column<T>(FlgAttribute attribute) where T : struct
        {
            ReadOnlySpan<T> values = MemoryMarshal.Cast<float, T>(Floats(attribute));
            if (values.Length != PointCount && Has(attribute))
            {
                throw new ArgumentException(typeof(T).Name + " is not what a point of the column " + attribute + " is");
            }
            return values;
        }

        /// <summary>
        /// Writes a column into the vertices of a mesh, `offset` bytes into each, such as positions as Float32 or
        /// colours as Unorm8. As Unity has it: z points away. Throws if there is no such column or not enough room;
        /// then nothing is written. Allocates nothing.
        /// </summary>
        public void Write<TVertex>(FlgAttribute attribute, FlgNumberFormat format, Span<TVertex> vertices,
            int offset = 0)
            where TVertex : struct
        {
            if (PointCount == 0) return;
            if (vertices.Length == 0) throw new ArgumentException("there are none", nameof(vertices));
            Span<byte> memory = MemoryMarshal.AsBytes(vertices);
            uint size = (uint)(memory.Length / vertices.Length);
            if ((uint)offset >= size) throw new ArgumentOutOfRangeException(nameof(offset));
            fixed (byte* bytes = &MemoryMarshal.GetReference(memory))
            {
                FlgBufferColumn column = new FlgBufferColumn { attribute = attribute, format = format };
                column.data = bytes + offset;
                column.stride = size;
                FlgBufferOutput output = Native.flgBufferOutputDefaults();
                output.columns = &column;
                output.column_count = 1;
                output.row_capacity = (ulong)vertices.Length;
                output.left_handed = 1;
                FlgColumnsWriteDesc desc = Native.flgColumnsWriteDefaults();
                desc.columns = view.columns;
                desc.column_count = view.column_count;
                desc.row_count = (uint)PointCount;
                desc.output = &output;
                FiligreeException.Check(Native.flgColumnsWrite(&desc));
            }
        }
    }
}
