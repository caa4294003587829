// SPDX-License-Identifier: MIT
// A context: its workers, its frame, its end. Everything else of this layer belongs to one, and is gone with it.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using AOT;

namespace Filigree
{
    /// <summary>
    /// Use a context, and all that it made, from one thread, such as Unity's main thread: calls must not overlap.
    /// Ticking, pushing samples and viewing results allocate no managed memory. Nothing here has a finalizer, because
    /// views are pointers that the collector does not see: dispose of contexts. Those that still live when the scripts'
    /// domain is unloaded, as the Editor does, end then.
    /// </summary>
    public sealed unsafe class FiligreeContext : IDisposable
    {
        // The SDK keeps a pointer to this delegate, so it lives as long as the program.
        static readonly FlgLogWrite writeLog = WriteLog;
        static readonly List<FiligreeContext> living = new List<FiligreeContext>();

        FlgContext handle;
        FlgFrameReport report;
        GCHandle log;

        internal JobCallbacks Callbacks { get; } = new JobCallbacks();

        static FiligreeContext()
        {
#if UNITY_EDITOR || !UNITY_5_3_OR_NEWER
            AppDomain.CurrentDomain.DomainUnload += (domain, ending) => DestroyAll();
#endif
        }

        /// <param name="workers">Threads that work between frames. 0: Tick does the work, within its budget.</param>
        /// <param name="workerBudgetUs">What each may use between two ticks, in microseconds; 0 is no limit.</param>
        /// <param name="log">Gets the SDK's messages, on the thread that calls the SDK; may be null.</param>
        public FiligreeContext(int workers = 1, int workerBudgetUs = 0, Action<FlgLogLevel, string> log = null)
        {
            FlgContextDesc desc = Native.flgContextDefaults();
            desc.worker_count = checked((uint)workers);
            desc.worker_budget_us = checked((uint)workerBudgetUs);
            FlgLog hook = Native.flgLogDefaults();
            if (log != null)
            {
                this.log = GCHandle.Alloc(log);
                hook.user_data = (void*)GCHandle.ToIntPtr(this.log);
                hook.write = Marshal.GetFunctionPointerForDelegate(writeLog);
                desc.log = &hook;
            }
            Create(desc);
        }

        /// <summary>
        /// With the host's own hooks. What they point to has to live until the context is disposed of.
        /// </summary>
        public FiligreeContext(FlgContextDesc desc)
        {
            Create(desc);
        }

        void Create(FlgContextDesc desc)
        {
            FlgContext made;
            FlgResult result = Native.flgContextCreate(&desc, &made);
            if (result < 0)
            {
                FreeLog();
                throw FiligreeException.Last(result);
            }
            handle = made;
            report.struct_size = (uint)sizeof(FlgFrameReport);
            lock (living) living.Add(this);
        }

        public bool IsDisposed => handle.IsNull;

        /// <summary>For the functions of Native that this layer has no class for.</summary>
        public FlgContext Handle
        {
            get
            {
                if (handle.IsNull) throw new ObjectDisposedException(nameof(FiligreeContext));
                return handle;
            }
        }

        /// <summary>In place of a budget: as long as it takes.</summary>
        public const int Unlimited = -1;

        /// <summary>What the last Tick did.</summary>
        public FlgFrameReport Report => report;

        /// <summary>
        /// One frame of the SDK: what finished becomes visible, callbacks of jobs run. Ends at most 100 us after the
        /// budget. An exception of a callback comes out here, once all is done.
        /// </summary>
        /// <param name="budgetUs">Microseconds; Unlimited: without workers all jobs run to their end.</param>
        public void Tick(int budgetUs)
        {
            FlgContext context = Handle;
            uint budget = budgetUs == Unlimited ? Native.FLG_UNLIMITED : checked((uint)budgetUs);
            fixed (FlgFrameReport* written = &report)
            {
                FiligreeException.Check(Native.flgContextTick(context, budget, written));
            }
            Callbacks.Rethrow();
        }

        /// <summary>
        /// For loading screens and tools: sleeps until Tick has something to publish or no job is left; false when the
        /// time was over first.
        /// </summary>
        public bool Wait(int timeoutUs)
        {
            return FiligreeException.Check(Native.flgContextWait(Handle, checked((uint)timeoutUs))) == FlgResult.Ok;
        }

        /// <summary>
        /// Ends all jobs, without calling them back, joins the workers and frees all that the context made. With a job
        /// system of the host that still holds tasks it throws: let them run, then dispose again.
        /// </summary>
        public void Dispose()
        {
            if (handle.IsNull) return;
            FlgResult result = Native.flgContextDestroy(handle);
            if (result != FlgResult.Ok) throw FiligreeException.Last(result);
            handle = default(FlgContext);
            Callbacks.Free();
            FreeLog();
            lock (living) living.Remove(this);
        }

        static void DestroyAll()
        {
            lock (living)
            {
                foreach (FiligreeContext context in living) Native.flgContextDestroy(context.handle);
                living.Clear();
            }
        }

        void FreeLog()
        {
            if (log.IsAllocated) log.Free();
        }

        [MonoPInvokeCallback(typeof(FlgLogWrite))]
        static void WriteLog(void* log, FlgLogLevel level, byte* message)
        {
            try
            {
                var write = (Action<FlgLogLevel, string>)GCHandle.FromIntPtr((IntPtr)log).Target;
                write(level, FiligreeException.ToString(message));
            }
            catch (Exception)
            {
                // No exception may pass through native code, and a log has nowhere to complain to.
            }
        }
    }
}
