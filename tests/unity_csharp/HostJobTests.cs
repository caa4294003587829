// SPDX-License-Identifier: MIT
// The host's own job system, in C#: the SDK starts no thread, and its results stay the same bits.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Threading;
using AOT;

namespace Filigree.Tests
{
    static unsafe class HostJobTests
    {
        static readonly FlgJobSystemSubmit submit = Submit;
        static readonly Queue<IntPtr> tasks = new Queue<IntPtr>();
        static FlgJobSystemSubmitRun run;
        static int done;
        static bool over;

        internal static void EqualThoseOfWorkers()
        {
            byte[] expected;
            using (var context = new FiligreeContext(2)) expected = Result(context);

            Thread[] threads = { new Thread(Work) { IsBackground = true }, new Thread(Work) { IsBackground = true } };
            foreach (Thread thread in threads) thread.Start();
            FlgContextDesc desc = Native.flgContextDefaults();
            FlgJobSystem system = Native.flgJobSystemDefaults();
            system.concurrency = 2;
            system.submit = Marshal.GetFunctionPointerForDelegate(submit);
            desc.job_system = &system;
            var hosted = new FiligreeContext(desc);
            byte[] found = Result(hosted);
            while (!hosted.IsDisposed)
            {
                try
                {
                    hosted.Dispose();
                }
                catch (FiligreeException waiting) when (waiting.Result == FlgResult.NotReady)
                {
                    Thread.Sleep(1); // the threads still hold tasks
                }
            }
            lock (tasks)
            {
                over = true;
                Monitor.PulseAll(tasks);
            }
            foreach (Thread thread in threads) thread.Join();
            Expect.True(expected.AsSpan().SequenceEqual(found), "the host's threads make what workers make");
            Expect.True(done > 0, "they did it");
        }

        static byte[] Result(FiligreeContext context)
        {
            FlgCurveSetStylizeDesc desc = Native.flgCurveSetStylizeDefaults();
            desc.temperature = 1;
            desc.strokes = 50;
            CurveSet result = Scenes.Style(context).Stylize(CurveSet.Create(context, Scenes.Line), desc);
            Scenes.Finish(context);
            return MemoryMarshal.AsBytes(result.View.Floats(FlgAttribute.Position)).ToArray();
        }

        [MonoPInvokeCallback(typeof(FlgJobSystemSubmit))]
        static void Submit(void* userData, IntPtr function, void* task)
        {
            lock (tasks)
            {
                if (run == null) run = Marshal.GetDelegateForFunctionPointer<FlgJobSystemSubmitRun>(function);
                tasks.Enqueue((IntPtr)task);
                Monitor.Pulse(tasks);
            }
        }

        static void Work()
        {
            while (true)
            {
                IntPtr task;
                lock (tasks)
                {
                    while (tasks.Count == 0 && !over) Monitor.Wait(tasks);
                    if (tasks.Count == 0) return;
                    task = tasks.Dequeue();
                }
                run((void*)task);
                Interlocked.Increment(ref done);
            }
        }
    }
}
