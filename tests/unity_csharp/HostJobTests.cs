// SPDX-License-Identifier: MIT
// The host's own job system, here .NET's thread pool: the SDK starts no thread, and its results stay the same bits.
using System;
using System.Runtime.InteropServices;
using System.Threading;
using AOT;

namespace Filigree.Tests
{
    static unsafe class HostJobTests
    {
        static readonly FlgJobSystemSubmit submit = Submit;
        static FlgJobSystemSubmitRun run;
        static int tasks;

        internal static void EqualThoseOfWorkers()
        {
            byte[] expected;
            using (var context = new FiligreeContext(2)) expected = Result(context);

            FlgContextDesc desc = Native.flgContextDefaults();
            desc.job_system.concurrency = 2;
            desc.job_system.submit = Marshal.GetFunctionPointerForDelegate(submit);
            var hosted = new FiligreeContext(desc);
            byte[] found = Result(hosted);
            Expect.True(expected.AsSpan().SequenceEqual(found), "the thread pool's results are the workers', bit for bit");
            Expect.True(tasks > 0, "the thread pool did it");
            while (!hosted.IsDisposed)
            {
                try
                {
                    hosted.Dispose();
                }
                catch (FiligreeException waiting) when (waiting.Result == FlgResult.NotReady)
                {
                    Thread.Sleep(1); // the pool still holds tasks
                }
            }
        }

        static byte[] Result(FiligreeContext context)
        {
            FlgStylizeDesc desc = Native.flgStylizeDefaults();
            desc.temperature = 1;
            desc.strokes = 50;
            CurveSet result = Scenes.Style(context).Stylize(CurveSet.Create(context, Scenes.Line), desc);
            Scenes.Finish(context);
            return MemoryMarshal.AsBytes(result.View.Floats(FlgAttribute.Position)).ToArray();
        }

        sealed class Task
        {
            internal IntPtr Argument;
        }

        [MonoPInvokeCallback(typeof(FlgJobSystemSubmit))]
        static void Submit(void* userData, IntPtr function, void* task)
        {
            if (run == null) run = Marshal.GetDelegateForFunctionPointer<FlgJobSystemSubmitRun>(function);
            Interlocked.Increment(ref tasks);
            ThreadPool.UnsafeQueueUserWorkItem(held => run((void*)((Task)held).Argument), new Task { Argument = (IntPtr)task });
        }
    }
}
