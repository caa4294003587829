// SPDX-License-Identifier: MIT
// Functions of filigree.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Filigree: real-time expressive curves, as a C ABI.
//
// Grammar      flg + noun + verb (flgCurveSetCreate); types Flg...; constants FLG_....
// Conventions  Right-handed, y up, metres, seconds, radians. Colours are linear RGBA. Strings are UTF-8.
// Descriptors  Start with `struct_size`. Take one from its defaults function (flgCurveSetStylizeDefaults()), then
//              change what you need. Structs grow only at the end, so old hosts run with new libraries.
// Handles      64-bit values in a struct of their own; zero is null. Each carries a generation: using a released handle
//              returns FlgResult.ErrorInvalidHandle and never crashes. A handle belongs to the context that made it.
// Results      What can fail returns an FlgResult. flgErrorGetMessage() gives the reason in one sentence that names
//              the argument and its value. No exception, abort or print crosses this interface. Output arguments are
//              written on every path; on failure they hold null handles and zeros.
// Threads      Calls on one context must not overlap, unless a function is marked [any thread]; functions marked [any
//              thread, one per stroke] must not overlap only with calls for the same stroke. Contexts are
//              independent. Nothing the host can observe changes outside its own calls: jobs run on workers, but
//              flgContextTick publishes their results, finished ones in order of submission.
// Large worlds Positions are floats relative to an `origin` in doubles, metres, that inputs name (FlgCurveSetView,
//              FlgMeshView, ...; default 0; magnitude at most 1e30). Choose one near the object: results do not depend
//              on it, to the bit. They have their input's origin, and their views name it. Where inputs of different
//              origins meet, their difference is applied in doubles.
// Waiting      No function waits for a job, except flgContextWait and flgContextRun. Each states its cost.
// Determinism  Same inputs, same seed, same binary: same bits, under any number of workers and any budget.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>
        /// [any thread] The version of the loaded library. flgContextCreate compares it with the header's: the major
        /// versions must match, and while the major version is 0 the minor versions too.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern uint flgVersionGet();

        /// <summary>
        /// [any thread] Why the last failing call on this thread failed: one sentence, never null, valid until the next
        /// failing call on this thread. Successful calls leave it unchanged.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern byte* flgErrorGetMessage();

        /// <summary>
        /// [any thread] The name of a result, such as "FLG_ERROR_LIMIT"; "FLG_RESULT_UNKNOWN" for other values.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern byte* flgResultGetName(FlgResult result);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgAllocatorInit(FlgAllocator* allocator, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgJobSystemInit(FlgJobSystem* system, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLogInit(FlgLog* log, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgClockInit(FlgClock* clock, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgProfilerInit(FlgProfiler* profiler, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContextDescInit(FlgContextDesc* desc, uint struct_size);

        /// <summary>
        /// Creates a context and starts its workers. `desc` may be null: all defaults. Cost: below a millisecond.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContextCreate(FlgContextDesc* desc, FlgContext* out_context);

        /// <summary>
        /// Cancels all jobs and frees everything the context owns, including all handles. Joins built-in workers, which
        /// takes at most one slice (100 us). If the host's job system still holds Filigree's tasks, it cancels the jobs
        /// and returns FlgResult.NotReady: let the job system run, then call again. Meanwhile all other calls are
        /// refused. Callbacks of the cancelled jobs do not run. Null is allowed and does nothing.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContextDestroy(FlgContext context);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFrameReportInit(FlgFrameReport* report, uint struct_size);

        /// <summary>
        /// Runs one frame: publishes finished jobs until `budget_us` is spent (the rest next time), calls their
        /// callbacks, and, in a context without workers, advances jobs until it is spent, by one slice at least. A
        /// budget of 0 publishes at most one job and advances none; with FLG_UNLIMITED a context without workers runs
        /// all its jobs to the end. Ends at most one slice after its budget. `report` may be null; set its struct_size.
        /// Allocates nothing in steady state. Frees results released before their job was done, at the cost of their
        /// release.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContextTick(FlgContext context, uint budget_us, FlgFrameReport* report);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMemoryUseInit(FlgMemoryUse* use, uint struct_size);

        /// <summary>
        /// [any thread] What the context holds of one kind, or of all. The kinds sum to what the allocator has handed
        /// out and not got back, to the byte, with the 8 bytes or so that the library adds to each block. Without an
        /// allocator of the host's, up to 32 MB of large blocks that are free wait to be used again; they are not
        /// counted. While jobs run, a block that moves from one kind to another may be seen in both. An object counts
        /// as its kind once its job has ended; the copies of inputs that a job waits with count as the kind of its
        /// result. Cost: tens of nanoseconds. Allocates nothing.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContextGetMemory(
            FlgContext context, FlgMemoryKind kind, FlgMemoryUse* out_use);

        /// <summary>
        /// Limits what the context may hold of one kind, or of all, in bytes; 0: no limit. What would exceed it fails
        /// with FlgResult.ErrorOutOfMemory, as if the allocator had returned null: a call, or a job, whose result
        /// counts as its kind when it ends. Takes nothing away: with more in use than the limit nothing further is
        /// taken. FlgContextDesc's memory_limit is the limit of FlgMemoryKind.Total from the start. Cost: nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContextSetMemoryLimit(FlgContext context, FlgMemoryKind kind, ulong bytes);

        /// <summary>
        /// For tools and loading screens: sleeps until flgContextTick has something to publish, no job is left, or the
        /// timeout passes. Returns FlgResult.Ok if there is something to publish or no job is left, FlgResult.NotReady
        /// otherwise. Returns at once in a context without workers, where flgContextTick does the work.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContextWait(FlgContext context, uint timeout_us);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgJobOptionsInit(FlgJobOptions* options, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgJobStatusInit(FlgJobStatus* status, uint struct_size);

        /// <summary>
        /// The job's state as of the last flgContextTick, but for what it waits for. Cost: tens of nanoseconds, and a
        /// nanosecond for each job that it waited for.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgJobGetStatus(FlgContext context, FlgJob job, FlgJobStatus* out_status);

        /// <summary>
        /// The stages of a finished job in order; FlgResult.NotReady before it finishes. Writes at most `capacity`
        /// stages and sets `out_count` to their total (at most 16). `out_stages` may be null when capacity is 0. Cost:
        /// tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgJobGetStages(
            FlgContext context, FlgJob job, FlgStageTime* out_stages, uint capacity, uint* out_count);

        /// <summary>
        /// Requests cancellation. A later flgContextTick publishes the job with FlgResult.ErrorCancelled, or with its
        /// result if it had already finished or begun to cut a surface, which completes; a tangle's step is taken back.
        /// Its memory is freed; jobs that depend on it fail. Cancelling a finished job does nothing. Cost: tens of
        /// nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgJobCancel(FlgContext context, FlgJob job);

        /// <summary>
        /// Releases the handle; the job continues, and its callback still runs. Functions that start a job accept a
        /// null `out_job` if no handle is needed. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgJobRelease(FlgContext context, FlgJob job);

        /// <summary>
        /// For tools, tests and loading screens: ticks and sleeps until `jobs` are finished, or with a count of 0 until
        /// the context has no job left, or until `seconds` (0 to 1e9, by the wall) are over. Returns FlgResult.Ok, the
        /// result of the first of `jobs` that failed, or FlgResult.NotReady when the time is over. Callbacks of jobs
        /// run as in flgContextTick. Not from callbacks.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContextRun(FlgContext context, FlgJob* jobs, uint count, double seconds);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetViewInit(FlgCurveSetView* view, uint struct_size);

        /// <summary>[any thread] The view's column of an attribute, null if there is none.</summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgColumn* flgCurveSetViewGetColumn(FlgCurveSetView* view, FlgAttribute attribute);

        /// <summary>
        /// Copies curves into the context. Every curve needs at least one point; magnitudes must not exceed 1e30.
        /// Accepts repeated points and zero-length curves unchanged; each function documents how it treats them. Cost:
        /// one pass over the data, about 2 ms for a million points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetCreate(
            FlgContext context, FlgCurveSetView* view, FlgCurveSet* out_set);

        /// <summary>
        /// The same for one curve through `count` points, at least 1, of 3 floats each, metres. `flags`: 0 or
        /// FLG_CURVE_CLOSED. Cost: one pass over the points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetCreateFromPoints(
            FlgContext context, float* points, uint count, byte flags, FlgCurveSet* out_set);

        /// <summary>
        /// The set's arrays. They neither move nor change until the set is released, even while jobs read it.
        /// FlgResult.NotReady while the job that makes the set is unpublished; with partial_results, shows the leading
        /// curves complete at the last flgContextTick instead. Returns the job's error if it failed. Cost: tens of
        /// nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetGetView(
            FlgContext context, FlgCurveSet set, FlgCurveSetView* out_view);

        /// <summary>
        /// Releases the handle and its views. Jobs that read the set keep its memory until they finish. A job that
        /// makes it continues; cancel the job if the result is not needed. Cost: that of freeing its arrays; for
        /// results of many megabytes some allocators return pages one by one: about 50 us a megabyte.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetRelease(FlgContext context, FlgCurveSet set);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetResampleDescInit(FlgCurveSetResampleDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that redistributes points evenly by arc length along a smooth curve through the given points
        /// and carries a moving frame along. The curve is a G1 cubic that keeps straight runs straight, circles round
        /// to fourth order, and turns of more than 50 degrees as corners. Other columns are interpolated linearly;
        /// orientations are normalized. Consecutive repeated points count once. A zero-length curve becomes one point.
        /// Cost: about 50 ns a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetResample(
            FlgContext context, FlgCurveSetResampleDesc* desc, FlgCurveSet* out_set, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetSimplifyDescInit(FlgCurveSetSimplifyDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that keeps the points that curves need, with all their columns: levels of detail as ranges of
        /// one result. With n curves, curve c at level l is curve l * n + c of the result: one vertex buffer holds all
        /// levels, and a level is a range of it. Ends stay, at least every 1024th point, and three points of closed
        /// curves. Cost: about 50 ns a point and level; up to 10 us where few points can be left out of wild curves.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetSimplify(
            FlgContext context, FlgCurveSetSimplifyDesc* desc, FlgCurveSet* out_set, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleDescInit(FlgStyleDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that prepares a style: guide, matching, displacement, patch graph. The handle can be passed to
        /// flgCurveSetStylize at once; its job then waits for this one. Cost: below 2 ms of work for 600 points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleCreate(
            FlgContext context, FlgStyleDesc* desc, FlgStyle* out_style, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleInfoInit(FlgStyleInfo* info, uint struct_size);

        /// <summary>
        /// FlgResult.NotReady until the style is prepared; its job's error if that failed. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleGetInfo(FlgContext context, FlgStyle style, FlgStyleInfo* out_info);

        /// <summary>
        /// The guide as a curve set with as many curves as the style and with TANGENT and NORMAL columns, relative to
        /// the example's origin (of a loaded style 0). The caller releases it. Cost: one copy.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleGetGuide(FlgContext context, FlgStyle style, FlgCurveSet* out_guide);

        /// <summary>
        /// Serializes the prepared style for a file or an asset; the same style gives the same bytes. Writes their
        /// number to `out_size`, and the bytes unless `out_data` is null. FlgResult.ErrorLimit if `capacity` is too
        /// small. FlgResult.NotReady until the style is prepared. Cost: about a millisecond a megabyte; a style has 150
        /// to 250 bytes a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleGetData(
            FlgContext context, FlgStyle style, void* out_data, UIntPtr capacity, UIntPtr* out_size);

        /// <summary>
        /// Loads a style from such bytes, ready at once; it gives the same results, bit for bit. The bytes need no
        /// alignment and may be freed afterwards. FlgResult.ErrorFormat for truncated, damaged or malicious bytes, or
        /// another format version. Cost: about a millisecond a megabyte.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleCreateFromData(
            FlgContext context, void* data, UIntPtr size, FlgStyle* out_style);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleRelease(FlgContext context, FlgStyle style);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetStylizeDescInit(FlgCurveSetStylizeDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that applies a style to curves (Algorithm 1, ApplyStyle). The result has each target curve once
        /// per stroke, resampled to the style's spacing times scale. Columns: POSITION, TANGENT and NORMAL (the
        /// target's frame), STYLE_INDEX, DISPLACEMENT if requested, the style's attributes and the target's other
        /// columns. A target curve shorter than one step gets two points; a zero-length curve gets one, not displaced.
        /// Targets shorter than the style get part of it. Closed targets give closed results: their last path, of up to
        /// 256 points, leads back to the style point that the curve began with, by one jump. The runs before and behind
        /// it are cross-faded over 6 p points, if need be on over the curve's first ones. For that curves begin 64
        /// points into the style at least, or in the middle of a shorter one. So sizes, frames and ribbons cross the
        /// curve's start as evenly as elsewhere. Displacements are those of the style at STYLE_INDEX. After a jump from
        /// style point i to point j, the gap d[i + 1] - d[j] and that of the steps there are added and fade to zero by
        /// a cubic over p to 4 p points: results go on where they were and as they went, with no steps and turns that
        /// the style lacks. Attributes take the style's values at STYLE_INDEX; RADIUS, WIDTH and the half axes of RADII
        /// are multiplied by scale. After jumps attributes blend as displacements do: angles the shorter way round,
        /// others kept within the style's least and largest value. Angles are continuous along a curve: whole turns
        /// (PROJECTIVE: half turns) are added as needed. As floats, they keep a precision of 1e-4 rad after 150 turns.
        /// ANGLE also turns the result's NORMAL about its tangent. With SPEED the result has TIME, starting at the
        /// target's first TIME value, or 0; each step takes its length divided by the mean speed of its ends. Results
        /// obey the limits of curve sets: if a coordinate, a length or a time would exceed 1e30, the job fails with
        /// FlgResult.ErrorInvalidArgument and names it. Cost: about 50 ns a point of the result, and once for each
        /// style and temperature the path trees, 0.1 ms each.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetStylize(
            FlgContext context, FlgCurveSetStylizeDesc* desc, FlgCurveSet* out_set, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetScalesInit(FlgCurveSetScales* scales, uint struct_size);

        /// <summary>
        /// The scale of each curve that flgCurveSetStylize has made: the one given, or the one chosen for scale 0.
        /// Times FlgStyleInfo::displacement_rms it is how far the style swings, metres; 0.14 of that is a good radius
        /// for curves that have none. FlgResult.NotReady until the result is published, its job's error if that failed.
        /// Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetGetScales(
            FlgContext context, FlgCurveSet set, FlgCurveSetScales* out_scales);

        public static FlgStyleInfo flgStyleInfoDefaults()
        {
            FlgStyleInfo made;
            flgStyleInfoInit(&made, (uint)sizeof(FlgStyleInfo));
            return made;
        }

        public static FlgJobStatus flgJobStatusDefaults()
        {
            FlgJobStatus made;
            flgJobStatusInit(&made, (uint)sizeof(FlgJobStatus));
            return made;
        }

        public static FlgFrameReport flgFrameReportDefaults()
        {
            FlgFrameReport made;
            flgFrameReportInit(&made, (uint)sizeof(FlgFrameReport));
            return made;
        }

        public static FlgAllocator flgAllocatorDefaults()
        {
            FlgAllocator made;
            flgAllocatorInit(&made, (uint)sizeof(FlgAllocator));
            return made;
        }

        public static FlgJobSystem flgJobSystemDefaults()
        {
            FlgJobSystem made;
            flgJobSystemInit(&made, (uint)sizeof(FlgJobSystem));
            return made;
        }

        public static FlgLog flgLogDefaults()
        {
            FlgLog made;
            flgLogInit(&made, (uint)sizeof(FlgLog));
            return made;
        }

        public static FlgClock flgClockDefaults()
        {
            FlgClock made;
            flgClockInit(&made, (uint)sizeof(FlgClock));
            return made;
        }

        public static FlgProfiler flgProfilerDefaults()
        {
            FlgProfiler made;
            flgProfilerInit(&made, (uint)sizeof(FlgProfiler));
            return made;
        }

        public static FlgJobOptions flgJobOptionsDefaults()
        {
            FlgJobOptions made;
            flgJobOptionsInit(&made, (uint)sizeof(FlgJobOptions));
            return made;
        }

        public static FlgContextDesc flgContextDefaults()
        {
            FlgContextDesc made;
            flgContextDescInit(&made, (uint)sizeof(FlgContextDesc));
            return made;
        }

        public static FlgMemoryUse flgMemoryUseDefaults()
        {
            FlgMemoryUse made;
            flgMemoryUseInit(&made, (uint)sizeof(FlgMemoryUse));
            return made;
        }

        public static FlgCurveSetView flgCurveSetViewDefaults()
        {
            FlgCurveSetView made;
            flgCurveSetViewInit(&made, (uint)sizeof(FlgCurveSetView));
            return made;
        }

        public static FlgCurveSetResampleDesc flgCurveSetResampleDefaults()
        {
            FlgCurveSetResampleDesc made;
            flgCurveSetResampleDescInit(&made, (uint)sizeof(FlgCurveSetResampleDesc));
            return made;
        }

        public static FlgStyleDesc flgStyleDefaults()
        {
            FlgStyleDesc made;
            flgStyleDescInit(&made, (uint)sizeof(FlgStyleDesc));
            return made;
        }

        public static FlgCurveSetSimplifyDesc flgCurveSetSimplifyDefaults()
        {
            FlgCurveSetSimplifyDesc made;
            flgCurveSetSimplifyDescInit(&made, (uint)sizeof(FlgCurveSetSimplifyDesc));
            return made;
        }

        public static FlgCurveSetScales flgCurveSetScalesDefaults()
        {
            FlgCurveSetScales made;
            flgCurveSetScalesInit(&made, (uint)sizeof(FlgCurveSetScales));
            return made;
        }

        public static FlgCurveSetStylizeDesc flgCurveSetStylizeDefaults()
        {
            FlgCurveSetStylizeDesc made;
            flgCurveSetStylizeDescInit(&made, (uint)sizeof(FlgCurveSetStylizeDesc));
            return made;
        }
    }
}
