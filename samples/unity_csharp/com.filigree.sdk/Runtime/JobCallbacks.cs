// SPDX-License-Identifier: MIT
// Actions that are called when jobs are published. Native code holds a GCHandle for each, which is freed when the job
// is called back, is refused, or is cut off by the end of its context.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using AOT;

namespace Filigree
{
    sealed unsafe class JobCallbacks
    {
        static readonly FlgJobOptionsOnFinished onFinished = OnFinished;
        static readonly IntPtr onFinishedPointer = Marshal.GetFunctionPointerForDelegate(onFinished);

        readonly List<Waiting> waiting = new List<Waiting>();
        Exception thrown;

        sealed class Waiting
        {
            internal JobCallbacks Owner;
            internal Action<FlgResult> Action;
            internal GCHandle Handle;
        }

        /// <summary>Fills in the options of a job that is about to be started; nothing for a null action.</summary>
        internal void Attach(ref FlgJobOptions options, Action<FlgResult> action)
        {
            if (action == null) return;
            var entry = new Waiting { Owner = this, Action = action };
            entry.Handle = GCHandle.Alloc(entry);
            waiting.Add(entry);
            options.on_finished = onFinishedPointer;
            options.user_data = (void*)GCHandle.ToIntPtr(entry.Handle);
        }

        /// <summary>Throws if the job was refused; then it is not called back either.</summary>
        internal void Check(FlgResult result, FlgJobOptions options)
        {
            if (result >= 0) return;
            FiligreeException failure = FiligreeException.Last(result);
            if (options.on_finished == onFinishedPointer) Take(options.user_data);
            throw failure;
        }

        internal void Rethrow()
        {
            if (thrown == null) return;
            Exception exception = thrown;
            thrown = null;
            throw new InvalidOperationException("a job's callback threw: " + exception.Message, exception);
        }

        internal void Free()
        {
            foreach (Waiting entry in waiting) entry.Handle.Free();
            waiting.Clear();
        }

        static Waiting Take(void* userData)
        {
            var entry = (Waiting)GCHandle.FromIntPtr((IntPtr)userData).Target;
            entry.Owner.waiting.Remove(entry);
            entry.Handle.Free();
            return entry;
        }

        [MonoPInvokeCallback(typeof(FlgJobOptionsOnFinished))]
        static void OnFinished(void* userData, FlgJob job, FlgResult result)
        {
            Waiting entry = Take(userData);
            try
            {
                entry.Action(result);
            }
            catch (Exception exception)
            {
                // Native code lies between here and Tick, which throws it again; the first one, as it would be.
                if (entry.Owner.thrown == null) entry.Owner.thrown = exception;
            }
        }
    }
}
