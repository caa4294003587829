// SPDX-License-Identifier: MIT
// Styles: learnt from an example stroke or loaded, then applied to curves.
using System;

namespace Filigree
{
    /// <summary>
    /// A style, prepared by a job. It can be used at once: what needs it waits for it. Descriptors come from Native's
    /// defaults functions, and have all parameters; their handles are filled in here.
    /// </summary>
    public sealed unsafe class Style : Resource
    {
        public FlgStyle Handle { get; }

        Style(FiligreeContext context, FlgStyle handle, FlgJob job) : base(context, job)
        {
            Handle = handle;
        }

        /// <summary>Learns the style of a stroke, with default parameters.</summary>
        public static Style Create(CurveSet example)
        {
            return Create(example, Native.flgStyleDefaults());
        }

        /// <param name="example">The strokes to learn from. They may be disposed of at once.</param>
        /// <param name="desc">From Native.flgStyleDefaults, with what you changed.</param>
        /// <param name="guide">The example without its style; null: found.</param>
        /// <param name="finished">Called inside of the Tick that publishes the job; null: nobody.</param>
        public static Style Create(CurveSet example, FlgStyleDesc desc, CurveSet guide = null,
            Action<FlgResult> finished = null)
        {
            FiligreeContext context = example.Context;
            FlgContext owner = context.Handle;
            FlgStyle made;
            FlgJob job;
            desc.style = example.Handle;
            if (guide != null) desc.guide = guide.Handle;
            FlgJobOptions options = desc.job != null ? *desc.job : Native.flgJobOptionsDefaults();
            context.Callbacks.Attach(ref options, finished);
            desc.job = &options;
            FlgResult result = Native.flgStyleCreate(owner, &desc, &made, &job);
            context.Callbacks.Check(result, options);
            return new Style(context, made, job);
        }

        /// <summary>A style from the bytes that Save made, such as those of a TextAsset; ready at once.</summary>
        public static Style Load(FiligreeContext context, byte[] data)
        {
            FlgStyle made;
            fixed (byte* bytes = data)
            {
                UIntPtr size = (UIntPtr)(uint)data.Length;
                FiligreeException.Check(Native.flgStyleCreateFromData(context.Handle, bytes, size, &made));
            }
            return new Style(context, made, default(FlgJob));
        }

        /// <summary>The prepared style as bytes, to be kept as an asset. Throws if it is not ready.</summary>
        public byte[] Save()
        {
            UIntPtr size;
            FlgResult result = Native.flgStyleGetData(Context.Handle, Handle, null, UIntPtr.Zero, &size);
            if (result != FlgResult.Ok) throw FiligreeException.Last(result);
            var data = new byte[(ulong)size];
            fixed (byte* bytes = data)
            {
                FiligreeException.Check(Native.flgStyleGetData(Context.Handle, Handle, bytes, size, &size));
            }
            return data;
        }

        /// <summary>Whether it is prepared. Throws its job's error if that failed.</summary>
        public bool IsReady
        {
            get
            {
                FlgStyleInfo info;
                return GetInfo(&info) == FlgResult.Ok;
            }
        }

        /// <summary>Throws if it is not ready.</summary>
        public FlgStyleInfo Info
        {
            get
            {
                FlgStyleInfo info;
                FlgResult result = GetInfo(&info);
                if (result != FlgResult.Ok) throw FiligreeException.Last(result);
                return info;
            }
        }

        FlgResult GetInfo(FlgStyleInfo* info)
        {
            *info = default(FlgStyleInfo);
            info->struct_size = (uint)sizeof(FlgStyleInfo);
            return FiligreeException.Check(Native.flgStyleGetInfo(Context.Handle, Handle, info));
        }

        /// <summary>Starts the job that live strokes at a temperature need done once, ahead of time.</summary>
        public void Warm(float temperature)
        {
            FiligreeException.Check(Native.flgStyleWarm(Context.Handle, Handle, temperature, null, null));
        }

        /// <summary>Applies the style to curves, with default parameters.</summary>
        public CurveSet Stylize(CurveSet target)
        {
            return Stylize(target, Native.flgCurveSetStylizeDefaults());
        }

        /// <param name="target">The curves to stylize. They may be disposed of at once.</param>
        /// <param name="desc">From Native.flgCurveSetStylizeDefaults, with what you changed.</param>
        /// <param name="finished">Called inside of the Tick that publishes the job; null: nobody.</param>
        public CurveSet Stylize(CurveSet target, FlgCurveSetStylizeDesc desc, Action<FlgResult> finished = null)
        {
            FiligreeContext context = Context;
            FlgContext owner = context.Handle;
            FlgCurveSet made;
            FlgJob job;
            desc.style = Handle;
            desc.target = target.Handle;
            FlgJobOptions options = desc.job != null ? *desc.job : Native.flgJobOptionsDefaults();
            context.Callbacks.Attach(ref options, finished);
            desc.job = &options;
            FlgResult result = Native.flgCurveSetStylize(owner, &desc, &made, &job);
            context.Callbacks.Check(result, options);
            return new CurveSet(context, made, job);
        }

        internal override FlgResult Release(FlgContext owner)
        {
            return Native.flgStyleRelease(owner, Handle);
        }
    }
}
