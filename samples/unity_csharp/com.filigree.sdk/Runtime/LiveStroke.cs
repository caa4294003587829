// SPDX-License-Identifier: MIT
// Strokes that are stylized while they are drawn.
using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    /// <summary>
    /// Push what the hand did each frame, and append the points that come back to a mesh: a point, once made, never
    /// moves. Pushing allocates nothing, neither here nor in the SDK. Push, Points, Tip, Info and Undo may run on an
    /// input thread while the game's thread ticks; calls for the same stroke must not overlap.
    /// </summary>
    public sealed unsafe class LiveStroke : Resource
    {
        public FlgLiveStroke Handle { get; }

        LiveStroke(FiligreeContext context, FlgLiveStroke handle) : base(context, default(FlgJob))
        {
            Handle = handle;
        }

        /// <summary>
        /// Begins a stroke; null as long as the style is not prepared, or not warm at the descriptor's temperature.
        /// </summary>
        /// <param name="style">Warm: see Style.Warm.</param>
        /// <param name="desc">From Native.flgLiveStrokeDefaults, with what you changed.</param>
        public static LiveStroke TryBegin(Style style, FlgLiveStrokeDesc desc)
        {
            FiligreeContext context = style.Context;
            FlgLiveStroke made;
            desc.style = style.Handle;
            FlgResult result = Native.flgLiveStrokeBegin(context.Handle, &desc, &made);
            return FiligreeException.Check(result) == FlgResult.Ok ? new LiveStroke(context, made) : null;
        }

        /// <summary>
        /// Takes a sample, and shows the points it made: often none, as geometry is one sample behind.
        /// </summary>
        public CurveSetView Push(LiveSample sample)
        {
            return Push(&sample, 1);
        }

        /// <summary>Takes samples: all, or, if it throws, none.</summary>
        public CurveSetView Push(ReadOnlySpan<LiveSample> samples)
        {
            fixed (LiveSample* data = &MemoryMarshal.GetReference(samples)) return Push(data, samples.Length);
        }

        CurveSetView Push(LiveSample* samples, int count)
        {
            FlgLiveSampleView view = Native.flgLiveSampleViewDefaults();
            view.sample_count = (uint)count;
            view.stride = (uint)sizeof(LiveSample);
            view.positions = samples->position;
            view.orientations = samples->orientation;
            view.pressures = &samples->pressure;
            view.times = &samples->time;
            FlgCurveSetView made = Empty();
            FiligreeException.Check(Native.flgLiveStrokePush(Context.Handle, Handle, &view, &made));
            return new CurveSetView(made);
        }

        /// <summary>All points so far. The view lives until the next call for this stroke.</summary>
        public CurveSetView Points
        {
            get
            {
                FlgCurveSetView points = Empty();
                FiligreeException.Check(Native.flgLiveStrokeGetPoints(Context.Handle, Handle, &points));
                return new CurveSetView(points);
            }
        }

        /// <summary>
        /// Where the stroke would be if it ended now: its last point, if there is one, and those up to the last
        /// sample. Draw it for a frame; it never becomes part of the stroke. The view lives until the next tip.
        /// </summary>
        public CurveSetView Tip
        {
            get
            {
                FlgCurveSetView tip = Empty();
                FiligreeException.Check(Native.flgLiveStrokeGetTip(Context.Handle, Handle, &tip));
                return new CurveSetView(tip);
            }
        }

        public FlgLiveStrokeInfo Info
        {
            get
            {
                FlgLiveStrokeInfo info;
                info.struct_size = (uint)sizeof(FlgLiveStrokeInfo);
                FiligreeException.Check(Native.flgLiveStrokeGetInfo(Context.Handle, Handle, &info));
                return info;
            }
        }

        /// <summary>Takes the last samples back, and the points they made; returns how many points are left.</summary>
        public int Undo(int samples)
        {
            uint left;
            FiligreeException.Check(Native.flgLiveStrokeUndo(Context.Handle, Handle, checked((uint)samples), &left));
            return (int)left;
        }

        /// <summary>
        /// Ends the stroke: a job makes a set of the whole stylized curve. The stroke itself stays, for Resume, until
        /// it is disposed of.
        /// </summary>
        public CurveSet End(Action<FlgResult> finished = null)
        {
            FiligreeContext context = Context;
            FlgContext owner = context.Handle;
            FlgJobOptions options = Native.flgJobOptionsDefaults();
            FlgCurveSet stylized;
            FlgJob job;
            context.Callbacks.Attach(ref options, finished);
            FlgResult result = Native.flgLiveStrokeEnd(owner, Handle, &options, &stylized, null, &job);
            context.Callbacks.Check(result, options);
            return new CurveSet(context, stylized, job);
        }

        /// <summary>Goes on with an ended stroke; false while the job of End still reads it.</summary>
        public bool Resume()
        {
            return FiligreeException.Check(Native.flgLiveStrokeResume(Context.Handle, Handle)) == FlgResult.Ok;
        }

        static FlgCurveSetView Empty()
        {
            var view = default(FlgCurveSetView);
            view.struct_size = (uint)sizeof(FlgCurveSetView);
            return view;
        }

        internal override FlgResult Release(FlgContext owner)
        {
            return Native.flgLiveStrokeRelease(owner, Handle);
        }
    }
}
