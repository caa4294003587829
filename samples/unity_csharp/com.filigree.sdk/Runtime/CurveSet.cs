// SPDX-License-Identifier: MIT
// Curve sets: made of the host's arrays, or by jobs.
using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    /// <summary>Curves that never change once they are ready.</summary>
    public sealed unsafe class CurveSet : Resource
    {
        public FlgCurveSet Handle { get; }

        internal CurveSet(FiligreeContext context, FlgCurveSet handle, FlgJob job) : base(context, job)
        {
            Handle = handle;
        }

        /// <summary>One curve through points of x, y, z, in metres. The numbers are copied.</summary>
        public static CurveSet Create(FiligreeContext context, ReadOnlySpan<float> positions, bool closed = false)
        {
            if (positions.Length % 3 != 0)
            {
                throw new ArgumentException(positions.Length + " numbers are not points of three", nameof(positions));
            }
            fixed (float* data = &MemoryMarshal.GetReference(positions))
            {
                uint* offsets = stackalloc uint[2];
                offsets[0] = 0;
                offsets[1] = (uint)(positions.Length / 3);
                byte flags = closed ? (byte)Native.FLG_CURVE_CLOSED : (byte)0;
                FlgColumn column = new FlgColumn { attribute = FlgAttribute.Position, components = 3, data = data };
                FlgCurveSetView view = Native.flgCurveSetViewDefaults();
                view.curve_count = 1;
                view.curve_offsets = offsets;
                view.curve_flags = &flags;
                view.columns = &column;
                view.column_count = 1;
                return Create(context, view);
            }
        }

        /// <summary>Any curves with any columns. The arrays are read during the call only.</summary>
        public static CurveSet Create(FiligreeContext context, FlgCurveSetView view)
        {
            FlgCurveSet made;
            FiligreeException.Check(Native.flgCurveSetCreate(context.Handle, &view, &made));
            return new CurveSet(context, made, default(FlgJob));
        }

        /// <summary>Whether it can be viewed. Throws the job's error if it failed. Costs tens of nanoseconds.</summary>
        public bool IsReady
        {
            get
            {
                FlgCurveSetView view;
                return GetView(&view) == FlgResult.Ok;
            }
        }

        /// <summary>Its arrays, which live until it is disposed. Throws if it is not ready.</summary>
        public CurveSetView View
        {
            get
            {
                FlgCurveSetView view;
                FlgResult result = GetView(&view);
                if (result != FlgResult.Ok) throw FiligreeException.Last(result);
                return new CurveSetView(view);
            }
        }

        FlgResult GetView(FlgCurveSetView* view)
        {
            *view = default(FlgCurveSetView);
            view->struct_size = (uint)sizeof(FlgCurveSetView);
            return FiligreeException.Check(Native.flgCurveSetGetView(Context.Handle, Handle, view));
        }

        internal override FlgResult Release(FlgContext owner)
        {
            return Native.flgCurveSetRelease(owner, Handle);
        }
    }
}
