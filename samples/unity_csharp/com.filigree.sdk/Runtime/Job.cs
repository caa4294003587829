// SPDX-License-Identifier: MIT
// How far a job is, as of the last tick.
namespace Filigree
{
    /// <summary>The job behind a result, which owns it: valid as long as the result is not disposed.</summary>
    public readonly unsafe struct Job
    {
        readonly FiligreeContext context;

        public FlgJob Handle { get; }

        internal Job(FiligreeContext context, FlgJob handle)
        {
            this.context = context;
            Handle = handle;
        }

        /// <summary>False for what was made without a job, and for default(Job).</summary>
        public bool Exists => !Handle.IsNull;

        public bool IsFinished => !Exists || Status.state == FlgJobState.Finished;

        /// <summary>0 to 1, never falling.</summary>
        public float Progress => Exists ? Status.progress : 1;

        /// <summary>Its stage; allocates the string.</summary>
        public string Stage => Exists ? FiligreeException.ToString(Status.stage) : "";

        public FlgJobStatus Status
        {
            get
            {
                FlgJobStatus status;
                status.struct_size = (uint)sizeof(FlgJobStatus);
                FiligreeException.Check(Native.flgJobGetStatus(context.Handle, Handle, &status));
                return status;
            }
        }

        /// <summary>Throws the job's own error if it failed or was cancelled.</summary>
        public void ThrowIfFailed()
        {
            if (!Exists) return;
            FlgJobStatus status = Status;
            if (status.result < 0) throw new FiligreeException(status.result, FiligreeException.ToString(status.error));
        }

        public void Cancel()
        {
            if (Exists) FiligreeException.Check(Native.flgJobCancel(context.Handle, Handle));
        }
    }
}
