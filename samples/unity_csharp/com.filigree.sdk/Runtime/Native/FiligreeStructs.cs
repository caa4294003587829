// SPDX-License-Identifier: MIT
// Structs of filigree.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    /// <summary>Of FlgAllocator.allocate. `size` bytes at a multiple of `alignment`, a power of two; or null</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void* FlgAllocatorAllocate(void* user_data, UIntPtr size, UIntPtr alignment);

    /// <summary>Of FlgAllocator.free. what `allocate` gave, with the size and the alignment it was asked for</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void FlgAllocatorFree(void* user_data, void* memory, UIntPtr size, UIntPtr alignment);

    /// <summary>
    /// All memory of a context, that of its jobs included. Called from any thread; must be thread-safe. `allocate` may
    /// return null: what needed the memory then fails with FlgResult.ErrorOutOfMemory, and nothing is lost. Both null:
    /// the C++ runtime's aligned new and delete. Not included: what the C++ runtime itself takes for threads and for
    /// the exceptions that a failing job is stopped with.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgAllocator
    {
        /// <summary>passed to both</summary>
        public void* user_data;
        /// <summary>
        /// A FlgAllocatorAllocate, by Marshal.GetFunctionPointerForDelegate. `size` bytes at a multiple of `alignment`,
        /// a power of two; or null
        /// </summary>
        public IntPtr allocate;
        /// <summary>
        /// A FlgAllocatorFree, by Marshal.GetFunctionPointerForDelegate. what `allocate` gave, with the size and the
        /// alignment it was asked for
        /// </summary>
        public IntPtr free;
    }

    /// <summary>Of FlgJobSystem.submit.run.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void FlgJobSystemSubmitRun(void* task);

    /// <summary>Of FlgJobSystem.submit. null: the SDK has threads of its own, or none</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void FlgJobSystemSubmit(void* user_data, IntPtr run, void* task);

    /// <summary>
    /// The host's own job system. With `submit` set the SDK starts no thread: it hands over tasks, the host calls
    /// run(task) once for each, on any thread, at any time, in any order. A task never blocks and ends after about 500
    /// us. At most `concurrency` (1 to 256) tasks are handed over at a time. `submit` is called from flgTick, from the
    /// calls that start jobs, and from inside tasks; it must not call run(task) before it returns, and must not fail.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgJobSystem
    {
        /// <summary>passed to `submit`</summary>
        public void* user_data;
        /// <summary>tasks at a time</summary>
        public uint concurrency;
        /// <summary>
        /// A FlgJobSystemSubmit, by Marshal.GetFunctionPointerForDelegate. null: the SDK has threads of its own, or
        /// none
        /// </summary>
        public IntPtr submit;
    }

    /// <summary>Of FlgLog.write. `message` is valid for the time of the call</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void FlgLogWrite(void* user_data, FlgLogLevel level, byte* message);

    /// <summary>
    /// Messages worth a line in the host's log: one sentence, no line break. Called on the host's thread, from inside
    /// its calls. Null: silence.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgLog
    {
        /// <summary>passed to `write`</summary>
        public void* user_data;
        /// <summary>
        /// A FlgLogWrite, by Marshal.GetFunctionPointerForDelegate. `message` is valid for the time of the call
        /// </summary>
        public IntPtr write;
    }

    /// <summary>Of FlgClock.now_ns. never falling</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate ulong FlgClockNowNs(void* user_data);

    /// <summary>
    /// Monotonic nanoseconds, from any thread. Null: the system's steady clock. Budgets are measured with it; results
    /// never depend on it.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgClock
    {
        /// <summary>passed to `now_ns`</summary>
        public void* user_data;
        /// <summary>A FlgClockNowNs, by Marshal.GetFunctionPointerForDelegate. never falling</summary>
        public IntPtr now_ns;
    }

    /// <summary>Of FlgProfiler.begin. both or neither</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void FlgProfilerBegin(void* user_data, byte* name);

    /// <summary>Of FlgProfiler.end. of the zone that began last on this thread</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void FlgProfilerEnd(void* user_data);

    /// <summary>
    /// Named zones for a profiler such as Tracy or the engine's own. Called on the thread that does the work, properly
    /// nested; names are string literals. Null: nothing.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgProfiler
    {
        /// <summary>passed to both</summary>
        public void* user_data;
        /// <summary>A FlgProfilerBegin, by Marshal.GetFunctionPointerForDelegate. both or neither</summary>
        public IntPtr begin;
        /// <summary>
        /// A FlgProfilerEnd, by Marshal.GetFunctionPointerForDelegate. of the zone that began last on this thread
        /// </summary>
        public IntPtr end;
    }

    /// <summary>What a context is made with.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgContextDesc
    {
        public uint struct_size;
        /// <summary>FLG_VERSION of the header the host was compiled with. Set by flgContextDefaults.</summary>
        public uint version;
        /// <summary>
        /// Threads the context starts, 0 to 256. 0: none; flgTick itself advances jobs. Ignored with a job system.
        /// Default 1.
        /// </summary>
        public uint worker_count;
        /// <summary>
        /// Microseconds each worker may work between two calls of flgTick; 0 = no limit. Not used without workers. A
        /// worker stops at the first pause after its budget: at most one chunk (100 us) later. Default 0.
        /// </summary>
        public uint worker_budget_us;
        public FlgAllocator allocator;
        public FlgJobSystem job_system;
        public FlgLog log;
        public FlgClock clock;
        public FlgProfiler profiler;
    }

    /// <summary>What one flgTick did, and what the workers did since the one before.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgFrameReport
    {
        public uint struct_size;
        /// <summary>jobs published by this tick</summary>
        public uint jobs_finished;
        /// <summary>counts calls of flgTick, from 1</summary>
        public ulong frame;
        /// <summary>jobs not finished yet, those that wait for others included</summary>
        public uint jobs_pending;
        /// <summary>wall time of this call</summary>
        public float tick_us;
        /// <summary>of it, spent advancing jobs (0 with workers)</summary>
        public float work_us;
        /// <summary>of it, spent in the host's callbacks</summary>
        public float callback_us;
        /// <summary>time all workers spent on jobs since the last tick</summary>
        public float worker_us;
        /// <summary>longest uninterrupted kernel chunk since the last tick, on any thread</summary>
        public float longest_chunk_us;
        /// <summary>the stage it belongs to, a string literal; "" when there was none</summary>
        public byte* longest_chunk_stage;
        /// <summary>the job it came from; may have been released since</summary>
        public FlgJob longest_chunk_job;
    }

    /// <summary>
    /// Of FlgJobOptions.on_finished. Called once, inside flgTick, when the job is published, whatever its result. It
    /// may call any function of this header on the context except flgTick, flgContextWait and flgContextDestroy. It
    /// must not throw. `job` is null if no handle was asked for. Null: none.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void FlgJobOptionsOnFinished(void* user_data, FlgJob job, FlgResult result);

    /// <summary>
    /// How a job is run; part of every descriptor that starts one. Inputs that another job still makes are waited for
    /// without being named here.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgJobOptions
    {
        /// <summary>
        /// Ready jobs of higher priority run first; equals run in order of submission. Default FlgPriority.Normal.
        /// </summary>
        public FlgPriority priority;
        /// <summary>
        /// Further jobs to wait for. If one of them fails, so does this, with FlgResult.ErrorDependency. Copied.
        /// </summary>
        public uint dependency_count;
        public FlgJob* dependencies;
        /// <summary>
        /// A FlgJobOptionsOnFinished, by Marshal.GetFunctionPointerForDelegate. Called once, inside flgTick, when the
        /// job is published, whatever its result. It may call any function of this header on the context except
        /// flgTick, flgContextWait and flgContextDestroy. It must not throw. `job` is null if no handle was asked for.
        /// Null: none.
        /// </summary>
        public IntPtr on_finished;
        public void* user_data;
        /// <summary>
        /// Nonzero: results may be viewed before the job is finished, as far as they are complete (flgCurveSetGetView
        /// then shows the leading curves that are done). Default 0.
        /// </summary>
        public uint partial_results;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgJobStatus
    {
        public uint struct_size;
        public FlgJobState state;
        /// <summary>FlgResult.NotReady until finished</summary>
        public FlgResult result;
        /// <summary>0 to 1, never falling; 1 exactly when finished with FlgResult.Ok</summary>
        public float progress;
        /// <summary>the stage it is in, a string literal; "" before the first</summary>
        public byte* stage;
        /// <summary>what went wrong, "" if nothing; valid until the job is released</summary>
        public byte* error;
        /// <summary>time spent on it, over all threads</summary>
        public float busy_us;
        /// <summary>its longest uninterrupted kernel chunk so far</summary>
        public float longest_chunk_us;
    }

    /// <summary>How long a stage of a job took.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgStageTime
    {
        /// <summary>string literal</summary>
        public byte* name;
        /// <summary>from the stage's start to its end</summary>
        public float wall_us;
        /// <summary>of it, time spent working, over all threads</summary>
        public float busy_us;
    }

    /// <summary>One column. As input it may be strided; columns of results are tightly packed.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgColumn
    {
        /// <summary>what the values mean</summary>
        public FlgAttribute attribute;
        /// <summary>floats a point</summary>
        public uint components;
        /// <summary>the first value</summary>
        public float* data;
        /// <summary>bytes from one point to the next, a multiple of 4; 0 = tightly packed</summary>
        public uint stride;
        public uint reserved;
    }

    /// <summary>
    /// Curves in flat arrays: curve c has the points curve_offsets[c] to curve_offsets[c + 1] - 1 of every column. Used
    /// for input (the host owns the arrays, for the time of the call) and for results (the set owns them, until
    /// released).
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgCurveSetView
    {
        public uint struct_size;
        public uint curve_count;
        /// <summary>curve_count + 1 values, from 0, not falling</summary>
        public uint* curve_offsets;
        /// <summary>curve_count values of FLG_CURVE_...; null in input: all 0</summary>
        public byte* curve_flags;
        /// <summary>POSITION first in results</summary>
        public FlgColumn* columns;
        /// <summary>1 to 16, each attribute at most once</summary>
        public uint column_count;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgResampleDesc
    {
        public uint struct_size;
        public uint reserved;
        public FlgJobOptions job;
        public FlgCurveSet curves;
        /// <summary>
        /// Wanted distance of neighbouring points along the curve, metres, &gt; 0. Each curve gets a whole number of
        /// equal steps nearest to it, at least 1 (closed: 3). No default.
        /// </summary>
        public float spacing;
        /// <summary>Frame whose TANGENT and NORMAL columns are added to the result.</summary>
        public FlgFrameMethod frame;
    }

    /// <summary>
    /// An attribute that a style transfers along with its shape. The style curves need a column for it, or
    /// flgStyleCreate refuses them (its job, if another job still makes them); values are taken where the matching
    /// leads, angles between points by the shorter way and unwrapped along the curve. A SPEED must be above 0.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgStyleAttribute
    {
        /// <summary>RADIUS, COLOR, RADII, ANGLE, WIDTH, SPEED or USER and above</summary>
        public FlgAttribute attribute;
        public FlgMetric metric;
        /// <summary>
        /// How much a difference of 1 counts among the displacements when patches are compared, metres; &gt;= 0. 0: the
        /// attribute follows the shape and does not steer it.
        /// </summary>
        public float weight;
        public uint reserved;
    }

    /// <summary>One of several patch sizes, sec. 4.5.4: distances are added up with these weights.</summary>
    [StructLayout(LayoutKind.Sequential)]
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
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgStyleDesc
    {
        public uint struct_size;
        /// <summary>
        /// Points that the style is resampled to, 16 to 16384; 0 = chosen from the input: at least its number of
        /// points, and so many that the curve turns by less than 7 degrees from one to the next; between 256 and 2048.
        /// </summary>
        public uint point_count;
        public FlgJobOptions job;
        /// <summary>
        /// The example: open curves of non-zero length, 1 to 256 of them. Their guides share out the points by length,
        /// so that one spacing holds for all, and one patch graph leads from any to any other (Fig. 3); curves too
        /// short for a patch are not jumped to, and at least one must be longer.
        /// </summary>
        public FlgCurveSet style;
        /// <summary>
        /// Its unstyled form, one open curve for each of the style's, in order, or null: made by the length-preserving
        /// flow of sec. 4.1.
        /// </summary>
        public FlgCurveSet guide;
        /// <summary>
        /// How much of its length the flow lets the guide keep, 0 to 1: dL/dt = (alpha - 1) int kappa^2. 0 is plain
        /// curve shortening, 1 keeps the length and removes little. Default 0.5.
        /// </summary>
        public float alpha;
        /// <summary>
        /// How far the flow smooths, as a multiple of what is chosen from the style; &gt; 0. Default 1.
        /// </summary>
        public float smoothing;
        /// <summary>
        /// Weight of closeness against evenness in the matching of guide and style, in (0, 1), sec. 4.2. Where the
        /// style is further from its guide than 1 / beta times its own radius of curvature (the far side of a loop),
        /// closeness wins: that stretch is skipped and comes out cut off. Default 0.2: loops stay round.
        /// </summary>
        public float beta;
        /// <summary>
        /// p: a patch is 2p + 1 points, sec. 4.4; 1 to 1024, and 2p + 1 &lt; points. Larger patches copy longer runs.
        /// Default 10.
        /// </summary>
        public uint patch;
        /// <summary>
        /// Several patch sizes instead of `patch`, at most 8; null: none. Only points with a patch of the largest are
        /// jumped to.
        /// </summary>
        public FlgPatchSize* patch_sizes;
        public uint patch_size_count;
        /// <summary>
        /// Default FlgMatching.SemiDiscrete. Discrete takes time and memory by the square of the points, at most 4096.
        /// </summary>
        public FlgMatching matching;
        /// <summary>Attributes to transfer, at most 8, each once; null: the shape alone.</summary>
        public FlgStyleAttribute* attributes;
        public uint attribute_count;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgStyleInfo
    {
        public uint struct_size;
        /// <summary>of style, guide and displacement, all curves together</summary>
        public uint point_count;
        /// <summary>p, the largest</summary>
        public uint patch;
        /// <summary>of the patch graph, the consecutive ones included</summary>
        public uint edge_count;
        /// <summary>metres, all curves together</summary>
        public float style_length;
        /// <summary>metres, likewise</summary>
        public float guide_length;
        /// <summary>guide_length / (point_count - curves): the distance of a result's points along its target</summary>
        public float spacing;
        /// <summary>metres</summary>
        public float displacement_rms;
        /// <summary>E' of sec. 4.2, square metres, as a mean over the points</summary>
        public float matching_energy;
        /// <summary>metres: what temperature 1 means, see FlgStylizeDesc</summary>
        public float temperature_unit;
        /// <summary>of the guide flow; 0 with a guide given</summary>
        public uint flow_steps;
        public uint reserved;
        /// <summary>point_count arc lengths on the style's curves, metres; lives until the style is released</summary>
        public float* matching;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgStylizeDesc
    {
        public uint struct_size;
        public FlgStart start;
        public FlgJobOptions job;
        public FlgStyle style;
        /// <summary>
        /// The curves to stylize. Their further columns are carried over, but for the attributes that the style has.
        /// </summary>
        public FlgCurveSet target;
        /// <summary>
        /// sigma, sec. 4.5.3: factor on the displacement; at most 1e30 in size, 0 gives the resampled target. Default
        /// 1.
        /// </summary>
        public float magnitude;
        /// <summary>
        /// tau, sec. 4.4.1: the cost of copying the style's next point instead of jumping; &gt;= 0. At 0 long runs of
        /// the style are copied, at 1 a dozen points at a time, at 10 and above it jumps nearly always. In units of
        /// FlgStyleInfo::temperature_unit (a tenth of the median distance of a patch to the one most like it), so that
        /// it does not depend on the style's size. Where one run ends and the next begins, displacements and attributes
        /// are blended over p points (see flgStylize): runs shorter than that, at high temperatures, get smaller by it.
        /// Default 0.
        /// </summary>
        public float temperature;
        /// <summary>Size of the style on the target, above 0 and at most 1e30: 1 = as drawn. Default 1.</summary>
        public float scale;
        public FlgFrameMethod frame;
        /// <summary>Key of all random choices. Default 1.</summary>
        public ulong seed;
        /// <summary>
        /// Row-major 3 x 3: turns the style's displacement (along tangent, first normal, second normal) within the
        /// target's frame, such as to apply a style drawn in a plane in another one, sec. 7 (Fig. 16). At most 1e30 in
        /// size. Default: identity.
        /// </summary>
        public fixed float basis[9];
        /// <summary>
        /// Nonzero: results begin and end exactly where their targets do, to the bit, sec. 4.5.2, so that curves of a
        /// network that meet still meet (ends that don't meet keep their distance). Closed results then pass through
        /// their target's first point. Default 0.
        /// </summary>
        public uint pin_ends;
        /// <summary>
        /// How often each curve is stylized, with other random choices each time, 1 to 1024, sec. 4.5.5. Stroke k of
        /// target curve c is curve c * strokes + k of the result; stroke 0 is what strokes = 1 gives, the others begin
        /// at random places of the style. Default 1.
        /// </summary>
        public uint strokes;
        /// <summary>
        /// Nonzero: the result has a DISPLACEMENT column, so that magnitude can be changed afterwards, also on the GPU:
        /// position at magnitude m = POSITION + (m - magnitude) * DISPLACEMENT, also of pinned and closed curves.
        /// Default 0.
        /// </summary>
        public uint keep_displacement;
        /// <summary>
        /// Points that the result may have, at most 2^31: a scale far too small for its target would ask for any number
        /// of them. What would get more fails with FlgResult.ErrorLimit, before memory is taken for it. 0: 2^31.
        /// Default 0.
        /// </summary>
        public uint max_points;
    }
}
