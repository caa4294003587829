// SPDX-License-Identifier: MIT
// What is wrong is said in the SDK's words, and what is gone is an error.
using System;

namespace Filigree.Tests
{
    static unsafe class ErrorTests
    {
        internal static void Run()
        {
            using (var context = new FiligreeContext(0))
            {
                ExceptionsCarryTheSentence(context);
                HandlesThatAreGoneAreErrors(context);
                JobsFailInTheirOwnWords(context);
            }
            ContextsEnd();
        }

        static void ExceptionsCarryTheSentence(FiligreeContext context)
        {
            Style style = Scenes.Style(context);
            style.Warm(0);
            Scenes.Finish(context);
            FlgLiveStrokeDesc desc = Native.flgLiveStrokeDefaults();
            desc.min_radius = -2.5f;
            var failure = Expect.Throws<FiligreeException>(() => LiveStroke.TryBegin(style, desc), "a negative radius");
            Expect.Equal(FlgResult.ErrorInvalidArgument, failure.Result, "a negative radius");
            Expect.Equal(FiligreeException.ToString(Native.flgErrorGetMessage()), failure.Message, "the sentence");
            Expect.Contains("min_radius", failure.Message, "the argument");
            Expect.Contains("-2.5", failure.Message, "its value");

            failure = Expect.Throws<FiligreeException>(
                () => CurveSet.Create(context, new[] { 0, float.NaN, 0 }), "not a number");
            Expect.Contains("finite", failure.Message, "not a number");
            Expect.Throws<ArgumentException>(() => CurveSet.Create(context, new float[4]), "four numbers");
            failure = Expect.Throws<FiligreeException>(() => CurveSet.Create(context, new float[0]), "no numbers");
            Expect.Equal(FlgResult.ErrorInvalidArgument, failure.Result, "no numbers");
            failure = Expect.Throws<FiligreeException>(() => Style.Load(context, new byte[100]), "zeros as a style");
            Expect.Equal(FlgResult.ErrorFormat, failure.Result, "zeros as a style");

            FlgContextDesc other = Native.flgContextDefaults();
            other.version += 1 << 12;
            failure = Expect.Throws<FiligreeException>(() => new FiligreeContext(other), "another version");
            Expect.Equal(FlgResult.ErrorVersion, failure.Result, "another version");
        }

        static void HandlesThatAreGoneAreErrors(FiligreeContext context)
        {
            CurveSet set = CurveSet.Create(context, Scenes.Line);
            FlgCurveSet stale = set.Handle;
            set.Dispose();
            set.Dispose(); // twice is once
            FlgCurveSetView view = Native.flgCurveSetViewDefaults();
            FlgResult viewed = Native.flgCurveSetGetView(context.Handle, stale, &view);
            Expect.Equal(FlgResult.ErrorInvalidHandle, viewed, "a view of what is released");
            Expect.True(view.columns == null && view.curve_count == 0, "nothing is shown");
            FlgResult released = Native.flgCurveSetRelease(context.Handle, stale);
            Expect.Equal(FlgResult.ErrorInvalidHandle, released, "released again");
            Expect.Throws<ObjectDisposedException>(() => { bool ready = set.IsReady; }, "disposed of");

            using (var stranger = new FiligreeContext(0))
            using (CurveSet theirs = CurveSet.Create(stranger, Scenes.Line))
            using (Style ours = Scenes.Style(context))
            {
                var failure = Expect.Throws<FiligreeException>(() => ours.Stylize(theirs), "of another context");
                Expect.Equal(FlgResult.ErrorInvalidHandle, failure.Result, "of another context");
            }
        }

        static void JobsFailInTheirOwnWords(FiligreeContext context)
        {
            Style style = Scenes.Style(context);
            CurveSet target = CurveSet.Create(context, Scenes.Line);
            CurveSet early = style.Stylize(target);
            var failure = Expect.Throws<FiligreeException>(() => { int points = early.View.PointCount; }, "too early");
            Expect.Equal(FlgResult.NotReady, failure.Result, "too early");
            Expect.True(!early.IsReady && !early.Job.IsFinished && early.Job.Progress < 1, "too early to be ready");
            early.Job.Cancel();
            Scenes.Finish(context);
            failure = Expect.Throws<FiligreeException>(() => { bool ready = early.IsReady; }, "cancelled");
            Expect.Equal(FlgResult.ErrorCancelled, failure.Result, "cancelled");

            FlgCurveSetStylizeDesc desc = Native.flgCurveSetStylizeDefaults();
            desc.frame = FlgFrameMethod.Supplied; // but the target has no normals
            CurveSet failed = style.Stylize(target, desc);
            Scenes.Finish(context);
            failure = Expect.Throws<FiligreeException>(() => { bool ready = failed.IsReady; }, "a job that failed");
            Expect.Contains("NORMAL", failure.Message, "why the job failed");
            var thrown = Expect.Throws<FiligreeException>(() => failed.Job.ThrowIfFailed(), "a job that failed");
            Expect.Contains("NORMAL", thrown.Message, "why the job failed");
            failed.Dispose();
        }

        static void ContextsEnd()
        {
            var context = new FiligreeContext(1);
            Style style = Scenes.Style(context);
            CurveSet running = style.Stylize(CurveSet.Create(context, Scenes.Line));
            context.Dispose();
            context.Dispose();
            running.Dispose(); // went with its context
            style.Dispose();
            Expect.Throws<ObjectDisposedException>(
                () => context.Tick(FiligreeContext.Unlimited), "a context that is gone");
            Expect.Throws<ObjectDisposedException>(() => CurveSet.Create(context, Scenes.Line), "curves in it");
        }
    }
}
