// SPDX-License-Identifier: MIT
// Functions of filigree.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Filigree: real-time expressive curves, as a C ABI.
//
// Grammar      flg + noun + verb (flgCurveSetCreate); types Flg...; constants FLG_....
// Conventions  Right-handed, y up, metres, seconds, radians. Colours are linear RGBA. Strings are UTF-8.
// Descriptors  Start with `struct_size`; take them from their defaults function (flgStylizeDefaults()), then
//              change what you need. Structs only ever grow at the end, so old hosts run with new libraries.
// Handles      64-bit values in a struct of their own; zero is null. Each carries a generation: one that was
//              released is FlgResult.ErrorInvalidHandle, never a crash. They belong to the context that made them.
// Results      Every function returns an FlgResult; flgLastError() says what was wrong in one sentence that
//              names the argument and its value. No exception, abort or print crosses this interface. Output
//              arguments are written on every path: on failure with null handles and zeros.
// Threads      Calls on one context must not overlap, unless a function says [any thread]. Different contexts are
//              independent. Nothing the host can observe changes outside the host's own calls: jobs run on
//              workers, but what they made becomes visible inside flgTick; what is done by then in order of submission.
// Waiting      No function waits for a job, but for flgContextWait, which exists to wait. Each says its cost.
// Determinism  Same inputs, same seed, same binary: same bits, under any number of workers and any budget.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>
        /// [any thread] The version of the loaded library. flgContextCreate compares it with the header's: the major
        /// versions must be equal, and while the major version is 0 the minor ones too.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern uint flgVersion();

        /// <summary>
        /// [any thread] Why the last failing call on this thread failed: one sentence, never null, valid until the next
        /// failing call on this thread. Calls that succeed leave it as it is.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* flgLastError();

        /// <summary>
        /// [any thread] The name of a result, such as "FLG_ERROR_LIMIT"; "FLG_RESULT_UNKNOWN" for other values.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* flgResultName(FlgResult result);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContextDescInit(FlgContextDesc* desc, uint struct_size);

        /// <summary>
        /// Makes a context and starts its workers. `desc` may be null: all defaults. Cost: below a millisecond.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContextCreate(FlgContextDesc* desc, FlgContext* out_context);

        /// <summary>
        /// Cancels all jobs and frees everything the context owns, all handles with it. Built-in workers are joined: at
        /// most one kernel chunk (100 us). With a host's job system that still holds tasks of ours it returns
        /// FlgResult.NotReady, having cancelled the jobs: let the job system run, then call again (all other calls are
        /// refused by then). Jobs that this cuts off are not called back. Null is allowed and does nothing.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContextDestroy(FlgContext context);

        /// <summary>
        /// One frame of the runtime: publishes what finished (at most until `budget_us` is used up, the rest next
        /// time), calls the callbacks of those jobs, and, in a context without workers, advances jobs until the budget
        /// is spent. budget_us = 0 means no limit: a context without workers then runs all its jobs to the end. It ends
        /// at most one kernel chunk after its budget. `report` may be null; set its struct_size. Allocates nothing in
        /// steady state. Results that were released before their job was done are freed in here, at the cost of their
        /// release.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTick(FlgContext context, uint budget_us, FlgFrameReport* report);

        /// <summary>
        /// For tools and loading screens: sleeps until flgTick has something to publish, no job is left, or the time is
        /// over. Returns FlgResult.Ok if there is something to publish or no job is left, FlgResult.NotReady otherwise.
        /// A context without workers returns at once (there flgTick does the work).
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContextWait(FlgContext context, uint timeout_us);

        /// <summary>The job's state as of the last flgTick. Cost: tens of nanoseconds.</summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgJobGetStatus(FlgContext context, FlgJob job, FlgJobStatus* out_status);

        /// <summary>
        /// The stages of a finished job in order; FlgResult.NotReady before. Writes at most `capacity` of them and
        /// their whole number (at most 16) to `out_count`; `out_stages` may be null when capacity is 0. Cost: tens of
        /// nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgJobGetStages(
            FlgContext context, FlgJob job, FlgStageTime* out_stages, uint capacity, uint* out_count);

        /// <summary>
        /// Asks a job to end. It is published with FlgResult.ErrorCancelled by a later flgTick (or with its result, if
        /// it was finished already, or has begun to change a surface, which it then does whole); what it held is freed,
        /// jobs that depend on it fail. Cancelling a finished job does nothing. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgJobCancel(FlgContext context, FlgJob job);

        /// <summary>
        /// Gives the handle back; the job goes on, and its callback is still called. Functions that start a job take a
        /// null `out_job` if no handle is wanted. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgJobRelease(FlgContext context, FlgJob job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetViewInit(FlgCurveSetView* view, uint struct_size);

        /// <summary>
        /// Copies curves into the context. Every curve needs at least one point; values must be at most 1e30 in size.
        /// Repeated points and curves of zero length are taken as they are; each function that computes with them says
        /// what it makes of them. Cost: one pass over the data, about 2 ms for a million points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetCreate(
            FlgContext context, FlgCurveSetView* view, FlgCurveSet* out_set);

        /// <summary>
        /// The set's arrays. They live, unmoved, until the set is released, also while jobs read it. FlgResult.NotReady
        /// while the job that makes the set has not been published (with partial_results: shows the leading curves that
        /// were complete at the last flgTick); the job's error if it failed. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetGetView(
            FlgContext context, FlgCurveSet set, FlgCurveSetView* out_view);

        /// <summary>
        /// Gives the handle and its views back. Jobs that read the set keep its memory until they are done; a job that
        /// was to make it goes on, cancel it if its result is not wanted. Cost: that of freeing its arrays, which for
        /// results of many megabytes some allocators give back to the system page by page: about 50 us a megabyte.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetRelease(FlgContext context, FlgCurveSet set);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgResampleDescInit(FlgResampleDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that redistributes points evenly by arc length along a smooth curve through the given points (a
        /// G1 cubic that keeps straight runs straight, circles round to fourth order, and turns of more than 50 degrees
        /// as corners) and carries a moving frame along. Other columns are interpolated linearly, orientations
        /// normalized. Points repeated in a row count once. A curve without length becomes one point. Cost: about 100
        /// ns a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgResample(
            FlgContext context, FlgResampleDesc* desc, FlgCurveSet* out_set, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleDescInit(FlgStyleDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that prepares a style: guide, matching, displacement, patch graph. The handle can be used at
        /// once in flgStylize, whose job then waits for this one. Cost: below 11 ms of work for 600 points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleCreate(
            FlgContext context, FlgStyleDesc* desc, FlgStyle* out_style, FlgJob* out_job);

        /// <summary>
        /// FlgResult.NotReady until the style is prepared, its job's error if that failed. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleGetInfo(FlgContext context, FlgStyle style, FlgStyleInfo* out_info);

        /// <summary>
        /// The guide as a curve set of its own, as many curves as the style has, with TANGENT and NORMAL columns; to be
        /// released by the caller. Cost: one copy.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleGetGuide(FlgContext context, FlgStyle style, FlgCurveSet* out_guide);

        /// <summary>
        /// The prepared style as bytes, to be kept in a file or an asset: the same style gives the same bytes. Writes
        /// their number to `out_size`, and the bytes unless `out_data` is null; FlgResult.ErrorLimit if `capacity` is
        /// less than their number. FlgResult.NotReady until the style is prepared. Cost: about a millisecond a
        /// megabyte; a style has 150 to 250 bytes a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleGetData(
            FlgContext context, FlgStyle style, void* out_data, UIntPtr capacity, UIntPtr* out_size);

        /// <summary>
        /// A style from such bytes, ready at once; it gives the same results, bit by bit. The bytes need no alignment
        /// and are not needed afterwards. FlgResult.ErrorFormat for bytes that are cut off, damaged, of another format
        /// version, or made to do harm. Cost: about a millisecond a megabyte.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleCreateFromData(
            FlgContext context, void* data, UIntPtr size, FlgStyle* out_style);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleRelease(FlgContext context, FlgStyle style);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStylizeDescInit(FlgStylizeDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that applies a style to curves (Algorithm 1, ApplyStyle). The result has the target's curves,
        /// each so many times as there are strokes, resampled to the style's spacing times scale, with the columns
        /// POSITION, TANGENT and NORMAL (the target's frame), STYLE_INDEX, DISPLACEMENT if wanted, the style's
        /// attributes and the target's other columns. A target curve shorter than one step gets two points, one without
        /// length gets one, not displaced; targets shorter than the style get a part of it. Closed targets come out
        /// closed: the displacement is corrected in proportion to the arc length so that it comes back to where it
        /// began (sec. 4.5.1), attributes likewise, angles the shorter way; so sizes, frames and ribbons go over the
        /// seam as evenly as elsewhere. Displacements are those of the style at STYLE_INDEX; behind a jump from point i
        /// to point j of the style, the gap d[i + 1] - d[j] is added, fading linearly to nothing over p points, so that
        /// results have no steps that the style hasn't. Attributes have the values of the style at STYLE_INDEX, RADIUS,
        /// WIDTH and the half axes of RADII times scale, and behind jumps are blended as displacements are: angles the
        /// shorter way round, others kept within the least and the largest value that the style has. Angles are
        /// continuous along a curve, whole turns (PROJECTIVE: half turns) being added as needed; as floats, they have
        /// 1e-4 rad left after 150 turns. ANGLE also turns the result's NORMAL about its tangent. With SPEED the result
        /// has TIME: from the target's first TIME value, or 0, on; each step takes its length by the mean speed of its
        /// ends. Results hold what curve sets may hold: if a coordinate, a length or a time would pass 1e30, the job
        /// fails with FlgResult.ErrorInvalidArgument and says what would. Cost: about 100 ns a point of the result, and
        /// once for each style and temperature the path trees, 0.1 ms each.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStylize(
            FlgContext context, FlgStylizeDesc* desc, FlgCurveSet* out_set, FlgJob* out_job);

        public static FlgContextDesc flgContextDefaults()
        {
            FlgContextDesc made;
            flgContextDescInit(&made, (uint)sizeof(FlgContextDesc));
            return made;
        }

        public static FlgCurveSetView flgCurveSetViewDefaults()
        {
            FlgCurveSetView made;
            flgCurveSetViewInit(&made, (uint)sizeof(FlgCurveSetView));
            return made;
        }

        public static FlgResampleDesc flgResampleDefaults()
        {
            FlgResampleDesc made;
            flgResampleDescInit(&made, (uint)sizeof(FlgResampleDesc));
            return made;
        }

        public static FlgStyleDesc flgStyleDefaults()
        {
            FlgStyleDesc made;
            flgStyleDescInit(&made, (uint)sizeof(FlgStyleDesc));
            return made;
        }

        public static FlgStylizeDesc flgStylizeDefaults()
        {
            FlgStylizeDesc made;
            flgStylizeDescInit(&made, (uint)sizeof(FlgStylizeDesc));
            return made;
        }
    }
}
