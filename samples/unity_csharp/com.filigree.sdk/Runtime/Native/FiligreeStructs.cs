// SPDX-License-Identifier: MIT
// Structs of filigree.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    /// <summary>
    /// Of FlgAllocator.allocate. Returns `size` bytes aligned to `alignment`, a power of two, or null.
    /// </summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate void* FlgAllocatorAllocate(void* user_data, UIntPtr size, UIntPtr alignment);

    /// <summary>
    /// Of FlgAllocator.free. Takes memory from `allocate`, with the size and alignment requested then.
    /// </summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate void FlgAllocatorFree(void* user_data, void* memory, UIntPtr size, UIntPtr alignment);

    /// <summary>
    /// All memory of a context, including that of its jobs. Called from any thread; must be thread-safe. `allocate` may
    /// return null: whatever needed the memory fails with FlgResult.ErrorOutOfMemory, and nothing is lost. Both null:
    /// the C++ runtime's aligned new and delete. Not included: memory the C++ runtime itself takes for threads and for
    /// the exceptions that stop a failing job.
    /// </summary>
    public unsafe partial struct FlgAllocator
    {
        public uint struct_size;
        /// <summary>passed to both</summary>
        public void* user_data;
        /// <summary>
        /// A FlgAllocatorAllocate, by Marshal.GetFunctionPointerForDelegate. Returns `size` bytes aligned to
        /// `alignment`, a power of two, or null.
        /// </summary>
        public IntPtr allocate;
        /// <summary>
        /// A FlgAllocatorFree, by Marshal.GetFunctionPointerForDelegate. Takes memory from `allocate`, with the size
        /// and alignment requested then.
        /// </summary>
        public IntPtr free;
    }

    /// <summary>Of FlgJobSystem.submit.run.</summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate void FlgJobSystemSubmitRun(void* task);

    /// <summary>Of FlgJobSystem.submit. Null: the SDK uses its own threads, or none.</summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate void FlgJobSystemSubmit(void* user_data, IntPtr run, void* task);

    /// <summary>
    /// The host's own job system. With `submit` set the SDK starts no threads: it hands over tasks, and the host calls
    /// run(task) once for each, on any thread, at any time, in any order. A task never blocks and ends after about 500
    /// us. At most `concurrency` (1 to 256) tasks are handed over at a time. flgContextTick, calls that start jobs, and
    /// tasks themselves call `submit`. It must not call run(task) before it returns, and must not fail.
    /// </summary>
    public unsafe partial struct FlgJobSystem
    {
        public uint struct_size;
        /// <summary>tasks at a time. Default 1</summary>
        public uint concurrency;
        /// <summary>passed to `submit`</summary>
        public void* user_data;
        /// <summary>
        /// A FlgJobSystemSubmit, by Marshal.GetFunctionPointerForDelegate. Null: the SDK uses its own threads, or none.
        /// </summary>
        public IntPtr submit;
    }

    /// <summary>Of FlgLog.write. `message` is valid during the call.</summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate void FlgLogWrite(void* user_data, FlgLogLevel level, byte* message);

    /// <summary>
    /// Messages for the host's log: one sentence, no line break. Called on the host's thread, from inside its calls.
    /// Null: silence.
    /// </summary>
    public unsafe partial struct FlgLog
    {
        public uint struct_size;
        /// <summary>passed to `write`</summary>
        public void* user_data;
        /// <summary>
        /// A FlgLogWrite, by Marshal.GetFunctionPointerForDelegate. `message` is valid during the call.
        /// </summary>
        public IntPtr write;
    }

    /// <summary>Of FlgClock.now_ns. never decreasing</summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate ulong FlgClockNowNs(void* user_data);

    /// <summary>
    /// Monotonic nanoseconds, callable from any thread. Null: the system's steady clock. Measures budgets; results
    /// never depend on it.
    /// </summary>
    public unsafe partial struct FlgClock
    {
        public uint struct_size;
        /// <summary>passed to `now_ns`</summary>
        public void* user_data;
        /// <summary>A FlgClockNowNs, by Marshal.GetFunctionPointerForDelegate. never decreasing</summary>
        public IntPtr now_ns;
    }

    /// <summary>Of FlgProfiler.begin. both or neither</summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate void FlgProfilerBegin(void* user_data, byte* name);

    /// <summary>Of FlgProfiler.end. ends the zone most recently begun on this thread</summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate void FlgProfilerEnd(void* user_data);

    /// <summary>
    /// Named zones for a profiler such as Tracy or the engine's own. Called on the thread that does the work, properly
    /// nested; names are string literals. Null: none.
    /// </summary>
    public unsafe partial struct FlgProfiler
    {
        public uint struct_size;
        /// <summary>passed to both</summary>
        public void* user_data;
        /// <summary>A FlgProfilerBegin, by Marshal.GetFunctionPointerForDelegate. both or neither</summary>
        public IntPtr begin;
        /// <summary>
        /// A FlgProfilerEnd, by Marshal.GetFunctionPointerForDelegate. ends the zone most recently begun on this thread
        /// </summary>
        public IntPtr end;
    }

    /// <summary>Settings for a new context.</summary>
    public unsafe partial struct FlgContextDesc
    {
        public uint struct_size;
        /// <summary>FLG_VERSION of the header the host was compiled with. Set by flgContextDefaults.</summary>
        public uint version;
        /// <summary>
        /// Threads the context starts, 0 to 256. 0: none; flgContextTick itself advances jobs. Ignored with a job
        /// system. Default 1.
        /// </summary>
        public uint worker_count;
        /// <summary>
        /// Microseconds each worker may work between two calls of flgContextTick; 0 = no limit. Unused without workers.
        /// A worker stops at the first pause after its budget: at most one slice (100 us) later. Default 0.
        /// </summary>
        public uint worker_budget_us;
        /// <summary>
        /// The host's hooks. Each may be null: the library's own. The structs are copied; their functions and user_data
        /// must live until the context is destroyed.
        /// </summary>
        public FlgAllocator* allocator;
        public FlgJobSystem* job_system;
        public FlgLog* log;
        public FlgClock* clock;
        public FlgProfiler* profiler;
        /// <summary>
        /// The most bytes the context may hold of its allocator's, 0 = no limit. What would exceed it fails with
        /// FlgResult.ErrorOutOfMemory, as if the allocator had returned null. Default 0.
        /// </summary>
        public ulong memory_limit;
    }

    /// <summary>What one flgContextTick did, and what the workers did since the previous one.</summary>
    public unsafe partial struct FlgFrameReport
    {
        public uint struct_size;
        /// <summary>jobs published by this tick</summary>
        public uint jobs_finished;
        /// <summary>counts calls of flgContextTick, from 1</summary>
        public ulong frame;
        /// <summary>unfinished jobs, including those waiting for others</summary>
        public uint jobs_pending;
        /// <summary>wall time of this call</summary>
        public float tick_us;
        /// <summary>part of it spent advancing jobs (0 with workers)</summary>
        public float work_us;
        /// <summary>part of it spent in the host's callbacks</summary>
        public float callback_us;
        /// <summary>time all workers spent on jobs since the last tick</summary>
        public float worker_us;
        /// <summary>longest slice of uninterrupted work since the last tick, on any thread</summary>
        public float max_slice_us;
        /// <summary>its stage, a string literal; "start" before a job's first, "" without a slice</summary>
        public byte* max_slice_stage;
        /// <summary>its job; may have been released since</summary>
        public FlgJob max_slice_job;
        /// <summary>jobs published by this tick after their deadline</summary>
        public uint jobs_late;
        public uint reserved;
    }

    /// <summary>Bytes of the host's allocator that a context holds.</summary>
    public unsafe partial struct FlgMemoryUse
    {
        public uint struct_size;
        public uint reserved;
        /// <summary>held now</summary>
        public ulong bytes;
        /// <summary>the most that was held at a time</summary>
        public ulong peak_bytes;
        /// <summary>the most that may be held; 0: no limit</summary>
        public ulong limit;
    }

    /// <summary>
    /// Of FlgJobOptions.on_finished. Called once, inside flgContextTick, when the job is published, whatever its
    /// result. It may call any function of this header on the context except flgContextTick, flgContextWait and
    /// flgContextDestroy. It must not throw. `job` is null if no handle was requested. Null: none.
    /// </summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate void FlgJobOptionsOnFinished(void* user_data, FlgJob job, FlgResult result);

    /// <summary>
    /// How a job runs. Every descriptor of a job points to one as `job`; functions without a descriptor take it as an
    /// argument. Null: defaults. Read during the call. A job waits for inputs that another job still makes; they need
    /// not be listed here.
    /// </summary>
    public unsafe partial struct FlgJobOptions
    {
        public uint struct_size;
        /// <summary>
        /// Ready jobs of higher priority run first, and a job has at least the priority of those that wait for it.
        /// Among equals, those with a deadline come first, ordered by when they must go on; then jobs that have run for
        /// less than 4 ms, in order of submission; the others take turns, four at a time. Default FlgPriority.Normal.
        /// </summary>
        public FlgPriority priority;
        /// <summary>
        /// Nonzero: the complete part of a result can be viewed before the job finishes (flgCurveSetGetView then shows
        /// the leading finished curves). Default 0.
        /// </summary>
        public uint partial_results;
        /// <summary>
        /// Further jobs to wait for. If one fails, this job fails with FlgResult.ErrorDependency. Copied.
        /// </summary>
        public uint dependency_count;
        public FlgJob* dependencies;
        /// <summary>
        /// A FlgJobOptionsOnFinished, by Marshal.GetFunctionPointerForDelegate. Called once, inside flgContextTick,
        /// when the job is published, whatever its result. It may call any function of this header on the context
        /// except flgContextTick, flgContextWait and flgContextDestroy. It must not throw. `job` is null if no handle
        /// was requested. Null: none.
        /// </summary>
        public IntPtr on_finished;
        public void* user_data;
        /// <summary>
        /// The result is wanted so many microseconds after this call, by the context's clock. What the job waits for is
        /// wanted by then as well. A late job goes on, and counts in FlgFrameReport::jobs_late. Default 0: no deadline.
        /// </summary>
        public uint deadline_us;
        public uint reserved;
    }

    public unsafe partial struct FlgJobStatus
    {
        public uint struct_size;
        public FlgJobState state;
        /// <summary>FlgResult.NotReady until finished</summary>
        public FlgResult result;
        /// <summary>0 to 1, never decreasing; 1 exactly when finished with FlgResult.Ok</summary>
        public float progress;
        /// <summary>the current stage, a string literal; "" before the first</summary>
        public byte* stage;
        /// <summary>what went wrong, "" if nothing; valid until the job is released</summary>
        public byte* error;
        /// <summary>time spent on it, over all threads</summary>
        public float busy_us;
        /// <summary>its longest slice of uninterrupted work so far</summary>
        public float max_slice_us;
        /// <summary>for what it waits, now</summary>
        public FlgJobWait wait;
        /// <summary>
        /// work that is left, by what it took so far; of a job that tells no share of its work by what the last of its
        /// kind took in this context; negative: unknown
        /// </summary>
        public float remaining_us;
        /// <summary>the first job that it waits for; null: none, or one without a handle</summary>
        public FlgJob waits_for;
        /// <summary>from its deadline to the tick that published it, or to the last tick; 0: not late</summary>
        public float late_us;
        public uint reserved;
    }

    /// <summary>How long a stage of a job took.</summary>
    public unsafe partial struct FlgStageTime
    {
        /// <summary>string literal</summary>
        public byte* name;
        /// <summary>from the stage's start to its end</summary>
        public float wall_us;
        /// <summary>part of it spent working, over all threads</summary>
        public float busy_us;
    }

    /// <summary>One column. Input columns may be strided; result columns are tightly packed.</summary>
    public unsafe partial struct FlgColumn
    {
        /// <summary>what the values mean</summary>
        public FlgAttribute attribute;
        /// <summary>floats per point</summary>
        public uint components;
        /// <summary>the first value</summary>
        public float* data;
        /// <summary>bytes between consecutive points, a multiple of 4; 0 = tightly packed</summary>
        public uint stride;
        public uint reserved;
    }

    /// <summary>
    /// Where a column goes in the host's buffers, and as what. Formats: FLOAT32 and FLOAT16 for all numbers but whole
    /// ones; SNORM8 and SNORM16 for NORMAL, TANGENT, ORIENTATION and the host's own; OCTAHEDRAL16 for NORMAL and
    /// TANGENT; UNORM8 and UNORM16 for COLOR, PRESSURE, WEIGHTS, VALUE and the host's own; SRGB8 for COLOR; UINT8,
    /// UINT16 and UINT32 for the whole ones: JOINTS, PART, LABEL.
    /// </summary>
    public unsafe partial struct FlgBufferColumn
    {
        /// <summary>each at most once</summary>
        public FlgAttribute attribute;
        public FlgNumberFormat format;
        /// <summary>of the first row written; aligned to the numbers' size, 2 of OCTAHEDRAL16</summary>
        public void* data;
        /// <summary>bytes between rows, a multiple of the numbers' size; 0 = tightly packed</summary>
        public uint stride;
        /// <summary>
        /// Numbers a row, at most 16: the leading ones, or more, `fill` after them. 0: as many as the result has. Of
        /// OCTAHEDRAL16 0 or 3, which become two; of SRGB8 at most 4.
        /// </summary>
        public uint components;
        /// <summary>
        /// Numbers that the result lacks; beyond the fourth: 0. (0, 0, 0, 1) makes positions homogeneous, and alpha 1.
        /// Each finite and at most 1e30 in size; 0 for whole numbers, which can't be filled.
        /// </summary>
        public fixed float fill[4];
        /// <summary>nonzero: without such a column all components are `fill`. 0: it is refused</summary>
        public uint optional;
        public uint reserved;
    }

    /// <summary>
    /// Curves in flat arrays: curve c has the points curve_offsets[c] to curve_offsets[c + 1] - 1 of every column. For
    /// input the host owns the arrays, which must live for the call; for results the set owns them until it is
    /// released.
    /// </summary>
    public unsafe partial struct FlgCurveSetView
    {
        public uint struct_size;
        public uint curve_count;
        /// <summary>curve_count + 1 values, starting at 0, never decreasing</summary>
        public uint* curve_offsets;
        /// <summary>curve_count values of FLG_CURVE_...; null in input: all 0</summary>
        public byte* curve_flags;
        /// <summary>POSITION first in results</summary>
        public FlgColumn* columns;
        /// <summary>1 to 16, each attribute at most once</summary>
        public uint column_count;
        public uint reserved;
        /// <summary>metres: what positions are relative to. Default 0</summary>
        public fixed double origin[3];
    }

    public unsafe partial struct FlgCurveSetResampleDesc
    {
        public uint struct_size;
        public uint reserved;
        public FlgJobOptions* job;
        public FlgCurveSet curves;
        /// <summary>
        /// Desired distance between neighbouring points along the curve, metres, &gt; 0. Each curve gets the nearest
        /// whole number of equal steps, at least 1 (closed: 3). No default.
        /// </summary>
        public float spacing;
        /// <summary>Frame written to the result's TANGENT and NORMAL columns.</summary>
        public FlgFrameMethod frame;
    }

    public unsafe partial struct FlgCurveSetSimplifyDesc
    {
        public uint struct_size;
        /// <summary>1 to 16. Default 1</summary>
        public uint level_count;
        public FlgJobOptions* job;
        public FlgCurveSet curves;
        /// <summary>
        /// One a level, metres, &gt;= 0: how far a point that is left out may be from the line that is left, at the
        /// same arc length, plus how far its RADIUS may differ. 0 keeps what is not on a straight line. A pixel at
        /// distance d covers 2 d tan(fov / 2) / height metres. No default.
        /// </summary>
        public float* tolerances;
        /// <summary>how far COLOR may differ, a component; &gt;= 0. Default 0.01</summary>
        public float color_tolerance;
        /// <summary>
        /// Nonzero: the rims of ribbons stay within the tolerance, in place of the radius: needs RADIUS, TANGENT and
        /// NORMAL. Default 0.
        /// </summary>
        public uint ribbons;
        public uint reserved;
    }

    /// <summary>
    /// An attribute that a style transfers along with its shape. The style curves need a column for it; otherwise
    /// flgStyleCreate refuses them, or its job does if another job still makes them. Values are sampled where the
    /// matching leads, angles between points the shorter way and unwrapped along the curve. A SPEED must be above 0.
    /// </summary>
    public unsafe partial struct FlgStyleAttribute
    {
        /// <summary>RADIUS, COLOR, RADII, ANGLE, WIDTH, SPEED or USER and above</summary>
        public FlgAttribute attribute;
        public FlgMetric metric;
        /// <summary>
        /// Weight of a difference of 1 relative to displacements when patches are compared, metres; &gt;= 0. 0: the
        /// attribute follows the shape without steering it.
        /// </summary>
        public float weight;
        public uint reserved;
    }

    /// <summary>One of several patch sizes, sec. 4.5.4: their distances are summed with these weights.</summary>
    public unsafe partial struct FlgPatchSize
    {
        /// <summary>p, 1 to 1024</summary>
        public uint patch;
        /// <summary>&gt; 0</summary>
        public float weight;
    }

    /// <summary>
    /// How a style is prepared (Minarcik, Fiser, Sykora: Example-Based Authoring of Expressive Space Curves, sec. 4.1
    /// to 4.4).
    /// </summary>
    public unsafe partial struct FlgStyleDesc
    {
        public uint struct_size;
        /// <summary>
        /// Points the style is resampled to, 16 to 16384; 0 = chosen from the input: at least its number of points,
        /// enough that the curve turns by less than 7 degrees between points, and between 256 and 2048.
        /// </summary>
        public uint point_count;
        public FlgJobOptions* job;
        /// <summary>
        /// The example: 1 to 256 open curves of non-zero length. Their guides share the points by length, so that all
        /// have one spacing, and one patch graph leads from any to any other (Fig. 3). Curves too short for a patch are
        /// never jumped to; at least one must be long enough.
        /// </summary>
        public FlgCurveSet style;
        /// <summary>
        /// The unstyled form: one open curve for each style curve, in order. Null: made by the flow of sec. 4.1, along
        /// the middle line of the style's waves; a style without waves is its own guide.
        /// </summary>
        public FlgCurveSet guide;
        /// <summary>
        /// How much of its length the guide keeps in the flow, 0 to 1: dL/dt = (alpha - 1) int kappa^2. 0 is plain
        /// curve shortening; 1 keeps the length and removes little. Default 0.5.
        /// </summary>
        public float alpha;
        /// <summary>
        /// How long the flow lasts, as a multiple of the time that the style's waves ask for; &gt; 0. Default 1.
        /// </summary>
        public float smoothing;
        /// <summary>
        /// Weight of closeness against evenness in the matching of guide and style, in (0, 1), sec. 4.2. Nothing is cut
        /// off at any weight: from one point of the guide to the next the matching goes on along the style by at most
        /// 1.4 times the mean. Towards 0 every piece of the guide gets an equal share of the style. Default 0.2.
        /// </summary>
        public float beta;
        /// <summary>
        /// p: a patch is 2p + 1 points, sec. 4.4; 1 to 1024, with 2p + 1 &lt; points. Larger patches copy longer runs.
        /// Default 10.
        /// </summary>
        public uint patch;
        /// <summary>
        /// Several patch sizes in place of `patch`, at most 8; null: none. Jumps lead only to points with a patch of
        /// the largest size.
        /// </summary>
        public FlgPatchSize* patch_sizes;
        public uint patch_size_count;
        public uint attribute_count;
        /// <summary>Attributes to transfer, at most 8, each once; null: the shape alone.</summary>
        public FlgStyleAttribute* attributes;
        /// <summary>
        /// Caps: how much of the example's first curve at its start, and of its last curve at its end, belongs to a
        /// stroke's ends alone, metres along the example. Open targets begin with the one and end with the other, once,
        /// as drawn: the guide goes on straight there, but for one of your own. No jump leads into a cap. Targets too
        /// short for both get them smaller in all directions; closed ones get none, live strokes the end cap when they
        /// end, if asked for. 0: none. Below 0: found, as what comes before the first and after the last repetition;
        /// where there is no period, of patches as long as a sixteenth of the style or `patch` (FlgStyleInfo says how
        /// long caps are; the style is made twice for it). What is left must be long enough for two patches. Default 0.
        /// </summary>
        public float start_cap;
        /// <summary>
        /// Caps: how much of the example's first curve at its start, and of its last curve at its end, belongs to a
        /// stroke's ends alone, metres along the example. Open targets begin with the one and end with the other, once,
        /// as drawn: the guide goes on straight there, but for one of your own. No jump leads into a cap. Targets too
        /// short for both get them smaller in all directions; closed ones get none, live strokes the end cap when they
        /// end, if asked for. 0: none. Below 0: found, as what comes before the first and after the last repetition;
        /// where there is no period, of patches as long as a sixteenth of the style or `patch` (FlgStyleInfo says how
        /// long caps are; the style is made twice for it). What is left must be long enough for two patches. Default 0.
        /// </summary>
        public float end_cap;
    }

    public unsafe partial struct FlgStyleInfo
    {
        public uint struct_size;
        /// <summary>of style, guide and displacement, over all curves</summary>
        public uint point_count;
        /// <summary>p, the largest</summary>
        public uint patch;
        /// <summary>in the patch graph, including consecutive ones</summary>
        public uint edge_count;
        /// <summary>metres, over all curves</summary>
        public float style_length;
        /// <summary>metres, likewise</summary>
        public float guide_length;
        /// <summary>
        /// guide_length / (point_count - curves): the distance between a result's points along its target
        /// </summary>
        public float spacing;
        /// <summary>metres</summary>
        public float displacement_rms;
        /// <summary>E' of sec. 4.2, square metres, mean over the points</summary>
        public float matching_energy;
        /// <summary>metres: what temperature 1 means, see FlgCurveSetStylizeDesc</summary>
        public float temperature_unit;
        /// <summary>of the guide flow; 0 with a guide given</summary>
        public uint flow_steps;
        public uint reserved;
        /// <summary>point_count arc lengths on the style's curves, metres; lives until the style is released</summary>
        public float* matching;
        /// <summary>the first points of the style, so many, are its start cap</summary>
        public uint start_cap_points;
        /// <summary>likewise the last ones its end cap</summary>
        public uint end_cap_points;
    }

    /// <summary>
    /// Steers a style along its targets: where the column is `from`, `driven` has the value `at_from`, where it is
    /// `to`, the value `at_to`; in between in proportion, beyond them no further. So at the target's points; values go
    /// evenly from one point to the next. Several drives of the same thing are multiplied.
    /// </summary>
    public unsafe partial struct FlgStyleDrive
    {
        /// <summary>
        /// a column of one float: PRESSURE, RADIUS, WIDTH, a USER one, ... SPEED, where it lacks, is made from TIME:
        /// metres a second from the point before (infinite in no time)
        /// </summary>
        public FlgAttribute attribute;
        public FlgStyleDriven driven;
        /// <summary>finite, not equal; `from` may be above `to`</summary>
        public float from;
        /// <summary>finite, not equal; `from` may be above `to`</summary>
        public float to;
        /// <summary>finite; see FlgStyleDriven</summary>
        public float at_from;
        /// <summary>finite; see FlgStyleDriven</summary>
        public float at_to;
    }

    public unsafe partial struct FlgCurveSetStylizeDesc
    {
        public uint struct_size;
        public FlgStyleStart start;
        public FlgJobOptions* job;
        public FlgStyle style;
        /// <summary>
        /// The curves to stylize. Results keep their other columns, except the attributes the style has.
        /// </summary>
        public FlgCurveSet target;
        /// <summary>
        /// sigma, sec. 4.5.3: factor on the displacement; magnitude at most 1e30; 0 gives the resampled target. Default
        /// 1.
        /// </summary>
        public float magnitude;
        /// <summary>
        /// tau, sec. 4.4.1: the cost of copying the style's next point instead of jumping; &gt;= 0. At 0 the result
        /// copies long runs of the style, at 1 a dozen points at a time; at 10 and above it jumps nearly always. In
        /// units of FlgStyleInfo::temperature_unit (a tenth of the median distance between a patch and the one most
        /// like it), so it does not depend on the style's size. Displacements and attributes blend over p to 4 p points
        /// at seams (see flgCurveSetStylize): this shrinks shorter runs, at high temperatures. Default 0.
        /// </summary>
        public float temperature;
        /// <summary>
        /// Size of the style on the target, above 0 and at most 1e30: 1 = as drawn. 0 = chosen for each target curve by
        /// itself, and kept for the host to read (flgCurveSetGetScales): s = size of the target curve / size of the
        /// guide, the proportion that the example has. Size is D (D / L)^(1/3), with L the curve's length and D
        /// sqrt(12) times the root mean square distance of its points from their centre: the length if it is straight,
        /// less where it winds. If the target has a RADIUS, of mean r along the curve, the style swings as wide as the
        /// stroke was painted: 1.2 r / FlgStyleInfo::displacement_rms, but at least s / 8 and at most 1.25 s. That
        /// RADIUS is then made thinner where the style's turns would touch: multiplied by one factor for each curve, so
        /// that its mean is 0.14 * scale * displacement_rms at most; but not if the style has a RADIUS, nor at
        /// magnitude 0. The choice depends neither on place, direction or unit of style and target nor on the other
        /// curves. A curve without length has scale 1. Default 1.
        /// </summary>
        public float scale;
        public FlgFrameMethod frame;
        /// <summary>Key for all random choices. Default 1.</summary>
        public ulong seed;
        /// <summary>
        /// Row-major 3 x 3: rotates the style's displacement (along tangent, first normal, second normal) within the
        /// target's frame, such as to apply a style drawn in one plane in another, sec. 7 (Fig. 16). Magnitude at most
        /// 1e30. Default: identity.
        /// </summary>
        public fixed float basis[9];
        /// <summary>
        /// Nonzero: results begin and end exactly where their targets do, to the bit, sec. 4.5.2. Curves that meet in a
        /// network still meet; ends that do not meet keep their distance. Closed results then pass through their
        /// target's first point. Default 0.
        /// </summary>
        public uint pin_ends;
        /// <summary>
        /// How often each curve is stylized, with other random choices each time, 1 to 1024, sec. 4.5.5. Stroke k of
        /// target curve c is curve c * strokes + k of the result. Stroke 0 equals the result for strokes = 1; the
        /// others begin at random places in the style. Default 1.
        /// </summary>
        public uint strokes;
        /// <summary>
        /// Nonzero: the result has a DISPLACEMENT column, so the magnitude can be changed afterwards, also on the GPU:
        /// position at magnitude m = POSITION + (m - magnitude) * DISPLACEMENT, also for pinned and closed curves.
        /// Default 0.
        /// </summary>
        public uint keep_displacement;
        /// <summary>
        /// Maximum points in the result, at most 2^31: guards against a scale far too small for the target. A larger
        /// result fails with FlgResult.ErrorLimit before memory is taken for it. 0: 2^31. Default 2^26.
        /// </summary>
        public uint max_points;
        /// <summary>
        /// Nonzero: points of open curves are exactly FlgStyleInfo::spacing * scale apart, as those of live strokes:
        /// the last lies up to one step before the target's end, and no run goes on to the style's end for it. So a
        /// live stroke's samples give the same bits (filigree_live.h). Curves shorter than one step keep their two
        /// points. Not with pin_ends. 0: the whole number of equal steps that comes nearest. Default 0.
        /// </summary>
        public uint exact_spacing;
        public uint reserved;
        /// <summary>What columns of the target drive along it, at most 8; null: nothing, the same everywhere.</summary>
        public FlgStyleDrive* drives;
        public uint drive_count;
        /// <summary>
        /// Above 0, up to 1: open targets get whole motifs, one after the other (`start` and `temperature` have no
        /// effect), as many as come nearest to the length, stretched to fill it, at least one. A motif is one
        /// repetition of the style's first curve that has patches, without caps, or all of it if nothing repeats: that
        /// is stretched by r^fit alone, r being the length over that of the motifs, and a jump in the last one skips or
        /// repeats the rest. A target too short for a motif gets it smaller in all directions; one shorter than a patch
        /// a whole one. 0: copies, cut off where a target ends. Closed targets: see corners. Not with exact_spacing.
        /// Default 0.
        /// </summary>
        public float fit;
        /// <summary>
        /// What happens at corners. Other than THROUGH, each corner gets a point of the result, closed results begin at
        /// their target's first corner, and from corner to corner there is a whole number of steps, at least 1: not
        /// with exact_spacing. Default THROUGH.
        /// </summary>
        public FlgStyleCorners corners;
        /// <summary>
        /// What a corner turns by, radians, above 0 and below pi: by more than that and twice what the points next to
        /// it turn by in its direction, or by more than 1.7 times that. Smooth curves with 8 points around have none. A
        /// corner may be drawn round: a bend of up to 160 degrees that is no longer than a patch of `style` as scaled
        /// (2 p + 1 steps) or 2.4 of its displacement_rms. Its sides are nearly straight and three times as long. The
        /// corner is where the bend turns most. Default 50 degrees.
        /// </summary>
        public float corner_angle;
        /// <summary>
        /// Nonzero: the style's caps come at corners too, as at ends: the end cap before, the start cap behind each.
        /// Only with FlgStyleCorners.Motifs. Default 0.
        /// </summary>
        public uint corner_caps;
        /// <summary>
        /// Nonzero, with pin_ends: where ends of open targets are the same point, to the bit, results that go on into
        /// each other have one direction there. Ends are paired by the smallest turn, up to 60 degrees, each once; at
        /// points with more than 64 ends none are. Results are bent for it over their first 4 p points, or half of a
        /// shorter one's. Default 0.
        /// </summary>
        public uint smooth_junctions;
        /// <summary>
        /// More styles, at most 7, among which a drive of FlgStyleDriven.Style chooses along the way; null: none. The
        /// result has the points of the style whose points are closest together; the others' displacements and
        /// attributes are interpolated between theirs. All styles must transfer the same attributes. STYLE_INDEX counts
        /// through the points of all styles, one style behind the other. A `scale` above 0 is that of each; at 0 each
        /// has its own.
        /// </summary>
        public FlgStyle* further_styles;
        public uint further_style_count;
        /// <summary>
        /// Over which length of the target one style turns into the next, metres, &gt;= 0: half of it before the place
        /// where the choice changes, half behind, evenly in direction too. 0: two patches of the style whose points are
        /// farthest apart. Default 0.
        /// </summary>
        public float style_blend;
    }

    /// <summary>In which size a style was drawn on each curve of a result.</summary>
    public unsafe partial struct FlgCurveSetScales
    {
        public uint struct_size;
        /// <summary>of the result; 0 for sets that no style was applied to</summary>
        public uint curve_count;
        /// <summary>
        /// curve_count factors on the style, as FlgCurveSetStylizeDesc::scale; null if there are none. They live until
        /// the set is released
        /// </summary>
        public float* scales;
    }
}
