// SPDX-License-Identifier: MIT
// What all that a context owns has in common: it is given back once, and not used afterwards.
using System;

namespace Filigree
{
    /// <summary>
    /// Dispose of it when it is no longer wanted; what never is lives until its context is disposed of. There is no
    /// finalizer: the collector's thread may not call the SDK beside yours, nor does it see views.
    /// </summary>
    public abstract class Resource : IDisposable
    {
        readonly FiligreeContext context;
        FlgJob job;
        bool disposed;

        internal Resource(FiligreeContext context, FlgJob job)
        {
            this.context = context;
            this.job = job;
        }

        /// <summary>The context it belongs to; throws once either is disposed.</summary>
        public FiligreeContext Context
        {
            get
            {
                if (disposed) throw new ObjectDisposedException(GetType().Name);
                return context;
            }
        }

        /// <summary>The job that makes it, or none.</summary>
        public Job Job => new Job(Context, job);

        public void Dispose()
        {
            if (disposed) return;
            disposed = true;
            if (context.IsDisposed) return; // it went with its context
            FlgContext owner = context.Handle;
            if (!job.IsNull) FiligreeException.Check(Native.flgJobRelease(owner, job));
            FiligreeException.Check(Release(owner));
        }

        internal abstract FlgResult Release(FlgContext owner);
    }
}
