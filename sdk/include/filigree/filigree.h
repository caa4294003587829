/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Filigree: real-time expressive curves, as a C ABI.
 *
 * Grammar      flg + noun + verb (flgCurveSetCreate); types Flg...; constants FLG_....
 * Conventions  Right-handed, y up, metres, seconds, radians. Colours are linear RGBA. Strings are UTF-8.
 * Descriptors  Start with `struct_size`. Take one from its defaults function (flgCurveSetStylizeDefaults()), then
 *              change what you need. Structs grow only at the end, so old hosts run with new libraries.
 * Handles      64-bit values in a struct of their own; zero is null. Each carries a generation: using a released handle
 *              returns FLG_ERROR_INVALID_HANDLE and never crashes. A handle belongs to the context that made it.
 * Results      What can fail returns an FlgResult. flgErrorGetMessage() gives the reason in one sentence that names
 *              the argument and its value. No exception, abort or print crosses this interface. Output arguments are
 *              written on every path; on failure they hold null handles and zeros.
 * Threads      Calls on one context must not overlap, unless a function is marked [any thread]; functions marked [any
 *              thread, one per stroke] must not overlap only with calls for the same stroke. Contexts are
 *              independent. Nothing the host can observe changes outside its own calls: jobs run on workers, but
 *              flgContextTick publishes their results, finished ones in order of submission.
 * Large worlds Positions are floats relative to an `origin` in doubles, metres, that inputs name (FlgCurveSetView,
 *              FlgMeshView, ...; default 0; magnitude at most 1e30). Choose one near the object: results do not depend
 *              on it, to the bit. They have their input's origin, and their views name it. Where inputs of different
 *              origins meet, their difference is applied in doubles.
 * Waiting      No function waits for a job, except flgContextWait and flgContextRun. Each states its cost.
 * Determinism  Same inputs, same seed, same binary: same bits, under any number of workers and any budget.
 */
#ifndef FILIGREE_FILIGREE_H
#define FILIGREE_FILIGREE_H

#include <stddef.h>
#include <stdint.h>

#if defined(FLG_STATIC)
/* Exports and imports functions. Define FLG_STATIC where the library is linked statically. */
#define FLG_API
#elif defined(_WIN32)
#if defined(FLG_BUILD)
#define FLG_API __declspec(dllexport)
#else
#define FLG_API __declspec(dllimport)
#endif
#else
#define FLG_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Version ------------------------------------------------------------------------------------------------- */

/* Changes when hosts break; until 1.0 a minor version may break them, too. */
#define FLG_VERSION_MAJOR 0
/* Changes when hosts gain features. */
#define FLG_VERSION_MINOR 1
/* Changes with everything else. */
#define FLG_VERSION_PATCH 0
/* The version of this header, as one number. */
#define FLG_VERSION ((FLG_VERSION_MAJOR << 22) | (FLG_VERSION_MINOR << 12) | FLG_VERSION_PATCH)

/* [any thread] The version of the loaded library. flgContextCreate compares it with the header's: the major versions
 * must match, and while the major version is 0 the minor versions too. */
FLG_API uint32_t flgVersionGet(void);

/* ---- Results ------------------------------------------------------------------------------------------------- */

/* How a call or a job ended; negative values are failures. */
typedef enum FlgResult {
    FLG_OK = 0,                      /* done; from a function that starts a job: started */
    FLG_NOT_READY = 1,               /* asked too early: flgContextTick has not published the job yet */
    FLG_ERROR_INVALID_ARGUMENT = -1, /* a null, a value out of range, unusable data */
    FLG_ERROR_INVALID_HANDLE = -2,   /* null, released, of another kind or from another context */
    FLG_ERROR_OUT_OF_MEMORY = -3,    /* the allocator hook returned null */
    FLG_ERROR_VERSION = -4,          /* header and library do not match */
    FLG_ERROR_CANCELLED = -5,        /* the job was cancelled */
    FLG_ERROR_DEPENDENCY = -6,       /* a job this one depends on failed or was cancelled */
    FLG_ERROR_FILE = -7,             /* a file cannot be opened, read or written */
    FLG_ERROR_FORMAT = -8,           /* the file's contents violate its format */
    FLG_ERROR_LIMIT = -9,            /* a documented limit would be exceeded; the message names it */
    FLG_ERROR_INTERNAL = -10,        /* a bug in Filigree */
    FLG_RESULT_FORCE_32BIT = 0x7fffffff
} FlgResult;

/* [any thread] Why the last failing call on this thread failed: one sentence, never null, valid until the next failing
 * call on this thread. Successful calls leave it unchanged. */
FLG_API const char* flgErrorGetMessage(void);

/* [any thread] The name of a result, such as "FLG_ERROR_LIMIT"; "FLG_RESULT_UNKNOWN" for other values. */
FLG_API const char* flgResultGetName(FlgResult result);

/* ---- Handles ------------------------------------------------------------------------------------------------- */

/* Declares a handle type. */
#define FLG_HANDLE(Name)   \
    typedef struct Name {  \
        uint64_t id;       \
    } Name

/* A running or finished piece of work. */
FLG_HANDLE(FlgJob);
/* Curves in flat arrays; never changes once ready. */
FLG_HANDLE(FlgCurveSet);
/* A prepared style: guide, displacement and patch graph. Never changes once ready. */
FLG_HANDLE(FlgStyle);

/* A context owns everything else. At most 1024 exist at a time in a process. */
FLG_HANDLE(FlgContext);

/* ---- Host hooks ---------------------------------------------------------------------------------------------- */

/* All memory of a context, including that of its jobs. Called from any thread; must be thread-safe. `allocate` may
 * return null: whatever needed the memory fails with FLG_ERROR_OUT_OF_MEMORY, and nothing is lost. Both null: the C++
 * runtime's aligned new and delete. Not included: memory the C++ runtime itself takes for threads and for the
 * exceptions that stop a failing job. */
typedef struct FlgAllocator {
    uint32_t struct_size;
    void* user_data; /* passed to both */
    /* Returns `size` bytes aligned to `alignment`, a power of two, or null. */
    void* (*allocate)(void* user_data, size_t size, size_t alignment);
    /* Takes memory from `allocate`, with the size and alignment requested then. */
    void (*free)(void* user_data, void* memory, size_t size, size_t alignment);
} FlgAllocator;

FLG_API FlgResult flgAllocatorInit(FlgAllocator* allocator, uint32_t struct_size);

/* The host's own job system. With `submit` set the SDK starts no threads: it hands over tasks, and the host calls
 * run(task) once for each, on any thread, at any time, in any order. A task never blocks and ends after about 500 us.
 * At most `concurrency` (1 to 256) tasks are handed over at a time. flgContextTick, calls that start jobs, and tasks
 * themselves call `submit`. It must not call run(task) before it returns, and must not fail. */
typedef struct FlgJobSystem {
    uint32_t struct_size;
    uint32_t concurrency; /* tasks at a time. Default 1 */
    void* user_data;      /* passed to `submit` */
    /* Null: the SDK uses its own threads, or none. */
    void (*submit)(void* user_data, void (*run)(void* task), void* task);
} FlgJobSystem;

FLG_API FlgResult flgJobSystemInit(FlgJobSystem* system, uint32_t struct_size);

/* How much a message matters. */
typedef enum FlgLogLevel {
    FLG_LOG_LEVEL_INFO = 0,    /* worth knowing */
    FLG_LOG_LEVEL_WARNING = 1, /* unusual, but work continues */
    FLG_LOG_LEVEL_ERROR = 2,   /* something failed */
    FLG_LOG_LEVEL_FORCE_32BIT = 0x7fffffff
} FlgLogLevel;

/* Messages for the host's log: one sentence, no line break. Called on the host's thread, from inside its calls. Null:
 * silence. */
typedef struct FlgLog {
    uint32_t struct_size;
    void* user_data; /* passed to `write` */
    /* `message` is valid during the call. */
    void (*write)(void* user_data, FlgLogLevel level, const char* message);
} FlgLog;

FLG_API FlgResult flgLogInit(FlgLog* log, uint32_t struct_size);

/* Monotonic nanoseconds, callable from any thread. Null: the system's steady clock. Measures budgets; results never
 * depend on it. */
typedef struct FlgClock {
    uint32_t struct_size;
    void* user_data;                     /* passed to `now_ns` */
    uint64_t (*now_ns)(void* user_data); /* never decreasing */
} FlgClock;

FLG_API FlgResult flgClockInit(FlgClock* clock, uint32_t struct_size);

/* Named zones for a profiler such as Tracy or the engine's own. Called on the thread that does the work, properly
 * nested; names are string literals. Null: none. */
typedef struct FlgProfiler {
    uint32_t struct_size;
    void* user_data;                                  /* passed to both */
    void (*begin)(void* user_data, const char* name); /* both or neither */
    void (*end)(void* user_data);                     /* ends the zone most recently begun on this thread */
} FlgProfiler;

FLG_API FlgResult flgProfilerInit(FlgProfiler* profiler, uint32_t struct_size);

/* ---- Constants ----------------------------------------------------------------------------------------------- */

#define FLG_NO_INDEX 0xffffffffu  /* in place of an index: none */
#define FLG_UNLIMITED 0xffffffffu /* in place of a time or a count: as long as it takes, as many as there are */

/* ---- Context ------------------------------------------------------------------------------------------------- */

/* Settings for a new context. */
typedef struct FlgContextDesc {
    uint32_t struct_size;
    /* FLG_VERSION of the header the host was compiled with. Set by flgContextDefaults. */
    uint32_t version;
    /* Threads the context starts, 0 to 256. 0: none; flgContextTick itself advances jobs. Ignored with a job system.
     * Default 1. */
    uint32_t worker_count;
    /* Microseconds each worker may work between two calls of flgContextTick; 0 = no limit. Unused without workers. A
     * worker stops at the first pause after its budget: at most one slice (100 us) later. Default 0. */
    uint32_t worker_budget_us;
    /* The host's hooks. Each may be null: the library's own. The structs are copied; their functions and user_data must
     * live until the context is destroyed. */
    const FlgAllocator* allocator;
    const FlgJobSystem* job_system;
    const FlgLog* log;
    const FlgClock* clock;
    const FlgProfiler* profiler;
    /* The most bytes the context may hold of its allocator's, 0 = no limit. What would exceed it fails with
     * FLG_ERROR_OUT_OF_MEMORY, as if the allocator had returned null. Default 0. */
    uint64_t memory_limit;
} FlgContextDesc;

FLG_API FlgResult flgContextDescInit(FlgContextDesc* desc, uint32_t struct_size);

/* Creates a context and starts its workers. `desc` may be null: all defaults. Cost: below a millisecond. */
FLG_API FlgResult flgContextCreate(const FlgContextDesc* desc, FlgContext* out_context);

/* Cancels all jobs and frees everything the context owns, including all handles. Joins built-in workers, which takes at
 * most one slice (100 us). If the host's job system still holds Filigree's tasks, it cancels the jobs and returns
 * FLG_NOT_READY: let the job system run, then call again. Meanwhile all other calls are refused. Callbacks of the
 * cancelled jobs do not run. Null is allowed and does nothing. */
FLG_API FlgResult flgContextDestroy(FlgContext context);

/* What one flgContextTick did, and what the workers did since the previous one. */
typedef struct FlgFrameReport {
    uint32_t struct_size;
    uint32_t jobs_finished;      /* jobs published by this tick */
    uint64_t frame;              /* counts calls of flgContextTick, from 1 */
    uint32_t jobs_pending;       /* unfinished jobs, including those waiting for others */
    float tick_us;               /* wall time of this call */
    float work_us;               /* part of it spent advancing jobs (0 with workers) */
    float callback_us;           /* part of it spent in the host's callbacks */
    float worker_us;             /* time all workers spent on jobs since the last tick */
    float max_slice_us;          /* longest slice of uninterrupted work since the last tick, on any thread */
    const char* max_slice_stage; /* its stage, a string literal; "start" before a job's first, "" without a slice */
    FlgJob max_slice_job;        /* its job; may have been released since */
    uint32_t jobs_late;          /* jobs published by this tick after their deadline */
    uint32_t reserved;
} FlgFrameReport;

FLG_API FlgResult flgFrameReportInit(FlgFrameReport* report, uint32_t struct_size);

/* Runs one frame: publishes finished jobs until `budget_us` is spent (the rest next time), calls their callbacks, and,
 * in a context without workers, advances jobs until it is spent, by one slice at least. A budget of 0 publishes at most
 * one job and advances none; with FLG_UNLIMITED a context without workers runs all its jobs to the end. Ends at most
 * one slice after its budget. `report` may be null; set its struct_size. Allocates nothing in steady state. Frees
 * results released before their job was done, at the cost of their release. */
FLG_API FlgResult flgContextTick(FlgContext context, uint32_t budget_us, FlgFrameReport* report);

/* What memory is for. */
typedef enum FlgMemoryKind {
    FLG_MEMORY_KIND_TOTAL = 0,    /* all kinds together; its peak is at most the sum of theirs */
    FLG_MEMORY_KIND_STYLES = 1,   /* styles */
    FLG_MEMORY_KIND_SURFACES = 2, /* surfaces, fields, surface curves, tangles, manifolds, obstacles */
    FLG_MEMORY_KIND_CURVES = 3,   /* curve sets, live strokes, splines, motions */
    FLG_MEMORY_KIND_MODELS = 4,   /* skeletons, outlines, parts, their bodies, models, skins */
    FLG_MEMORY_KIND_CACHES = 5,   /* what is made again when it is needed: path trees of styles, solver data of
                                     surfaces */
    FLG_MEMORY_KIND_SCRATCH = 6,  /* what running jobs work with, and their results until they end */
    FLG_MEMORY_KIND_RUNTIME = 7,  /* the context itself, handles, records of jobs */
    FLG_MEMORY_KIND_FORCE_32BIT = 0x7fffffff
} FlgMemoryKind;

/* Bytes of the host's allocator that a context holds. */
typedef struct FlgMemoryUse {
    uint32_t struct_size;
    uint32_t reserved;
    uint64_t bytes;      /* held now */
    uint64_t peak_bytes; /* the most that was held at a time */
    uint64_t limit;      /* the most that may be held; 0: no limit */
} FlgMemoryUse;

FLG_API FlgResult flgMemoryUseInit(FlgMemoryUse* use, uint32_t struct_size);

/* [any thread] What the context holds of one kind, or of all. The kinds sum to what the allocator has handed out and
 * not got back, to the byte, with the 8 bytes or so that the library adds to each block. Without an allocator of the
 * host's, up to 32 MB of large blocks that are free wait to be used again; they are not counted. While jobs run, a
 * block that moves from one kind to another may be seen in both. An object counts as its kind once its job has ended;
 * the copies of inputs that a job waits with count as the kind of its result. Cost: tens of nanoseconds. Allocates
 * nothing. */
FLG_API FlgResult flgContextGetMemory(FlgContext context, FlgMemoryKind kind, FlgMemoryUse* out_use);

/* Limits what the context may hold of one kind, or of all, in bytes; 0: no limit. What would exceed it fails with
 * FLG_ERROR_OUT_OF_MEMORY, as if the allocator had returned null: a call, or a job, whose result counts as its kind
 * when it ends. Takes nothing away: with more in use than the limit nothing further is taken. FlgContextDesc's
 * memory_limit is the limit of FLG_MEMORY_KIND_TOTAL from the start. Cost: nanoseconds. */
FLG_API FlgResult flgContextSetMemoryLimit(FlgContext context, FlgMemoryKind kind, uint64_t bytes);

/* For tools and loading screens: sleeps until flgContextTick has something to publish, no job is left, or the
 * timeout passes. Returns FLG_OK if there is something to publish or no job is left, FLG_NOT_READY otherwise.
 * Returns at once in a context without workers, where flgContextTick does the work. */
FLG_API FlgResult flgContextWait(FlgContext context, uint32_t timeout_us);

/* ---- Jobs ---------------------------------------------------------------------------------------------------- */

/* Which ready job runs first. */
typedef enum FlgPriority {
    FLG_PRIORITY_LOW = -1,   /* when nothing else is ready */
    FLG_PRIORITY_NORMAL = 0, /* the default */
    FLG_PRIORITY_HIGH = 1,   /* before all others, such as results the user waits for */
    FLG_PRIORITY_FORCE_32BIT = 0x7fffffff
} FlgPriority;

/* How a job runs. Every descriptor of a job points to one as `job`; functions without a descriptor take it as an
 * argument. Null: defaults. Read during the call. A job waits for inputs that another job still makes; they need not be
 * listed here. */
typedef struct FlgJobOptions {
    uint32_t struct_size;
    /* Ready jobs of higher priority run first, and a job has at least the priority of those that wait for it. Among
     * equals, those with a deadline come first, ordered by when they must go on; then jobs that have run for less than
     * 4 ms, in order of submission; the others take turns, four at a time. Default FLG_PRIORITY_NORMAL. */
    FlgPriority priority;
    /* Nonzero: the complete part of a result can be viewed before the job finishes (flgCurveSetGetView then shows the
     * leading finished curves). Default 0. */
    uint32_t partial_results;
    /* Further jobs to wait for. If one fails, this job fails with FLG_ERROR_DEPENDENCY. Copied. */
    uint32_t dependency_count;
    const FlgJob* dependencies;
    /* Called once, inside flgContextTick, when the job is published, whatever its result. It may call any function
     * of this header on the context except flgContextTick, flgContextWait and flgContextDestroy. It must not throw.
     * `job` is null if no handle was requested. Null: none. */
    void (*on_finished)(void* user_data, FlgJob job, FlgResult result);
    void* user_data;
    /* The result is wanted so many microseconds after this call, by the context's clock. What the job waits for is
     * wanted by then as well. A late job goes on, and counts in FlgFrameReport::jobs_late. Default 0: no deadline. */
    uint32_t deadline_us;
    uint32_t reserved;
} FlgJobOptions;

FLG_API FlgResult flgJobOptionsInit(FlgJobOptions* options, uint32_t struct_size);

/* Where a job is, as of the last flgContextTick. */
typedef enum FlgJobState {
    FLG_JOB_STATE_WAITING = 0,  /* for its dependencies or its turn */
    FLG_JOB_STATE_RUNNING = 1,  /* begun, not published */
    FLG_JOB_STATE_FINISHED = 2, /* published; `result` says how it ended */
    FLG_JOB_STATE_FORCE_32BIT = 0x7fffffff
} FlgJobState;

/* Why a job does not go on. */
typedef enum FlgJobWait {
    FLG_JOB_WAIT_NONE = 0,    /* it runs, or is finished */
    FLG_JOB_WAIT_INPUT = 1,   /* another job makes what it needs, or it was told to wait for it */
    FLG_JOB_WAIT_ORDER = 2,   /* a job on the same surface that was started earlier comes first */
    FLG_JOB_WAIT_TURN = 3,    /* it could begin: others run */
    FLG_JOB_WAIT_FORCE_32BIT = 0x7fffffff
} FlgJobWait;

typedef struct FlgJobStatus {
    uint32_t struct_size;
    FlgJobState state;
    FlgResult result;       /* FLG_NOT_READY until finished */
    float progress;         /* 0 to 1, never decreasing; 1 exactly when finished with FLG_OK */
    const char* stage;      /* the current stage, a string literal; "" before the first */
    const char* error;      /* what went wrong, "" if nothing; valid until the job is released */
    float busy_us;          /* time spent on it, over all threads */
    float max_slice_us;     /* its longest slice of uninterrupted work so far */
    FlgJobWait wait;        /* for what it waits, now */
    float remaining_us;     /* work that is left, by what it took so far; negative: unknown */
    FlgJob waits_for;       /* the first job that it waits for; null: none, or one without a handle */
    float late_us;          /* from its deadline to the tick that published it, or to the last tick; 0: not late */
    uint32_t reserved;
} FlgJobStatus;

FLG_API FlgResult flgJobStatusInit(FlgJobStatus* status, uint32_t struct_size);

/* The job's state as of the last flgContextTick, but for what it waits for. Cost: tens of nanoseconds, and a nanosecond
 * for each job that it waited for. */
FLG_API FlgResult flgJobGetStatus(FlgContext context, FlgJob job, FlgJobStatus* out_status);

/* How long a stage of a job took. */
typedef struct FlgStageTime {
    const char* name; /* string literal */
    float wall_us;    /* from the stage's start to its end */
    float busy_us;    /* part of it spent working, over all threads */
} FlgStageTime;

/* The stages of a finished job in order; FLG_NOT_READY before it finishes. Writes at most `capacity` stages and sets
 * `out_count` to their total (at most 16). `out_stages` may be null when capacity is 0. Cost: tens of nanoseconds. */
FLG_API FlgResult flgJobGetStages(FlgContext context, FlgJob job, FlgStageTime* out_stages, uint32_t capacity,
                                  uint32_t* out_count);

/* Requests cancellation. A later flgContextTick publishes the job with FLG_ERROR_CANCELLED, or with its result if it
 * had already finished or begun to cut a surface, which completes; a tangle's step is taken back. Its memory is freed;
 * jobs that depend on it fail. Cancelling a finished job does nothing. Cost: tens of nanoseconds. */
FLG_API FlgResult flgJobCancel(FlgContext context, FlgJob job);

/* Releases the handle; the job continues, and its callback still runs. Functions that start a job accept a null
 * `out_job` if no handle is needed. Cost: tens of nanoseconds. */
FLG_API FlgResult flgJobRelease(FlgContext context, FlgJob job);

/* For tools, tests and loading screens: ticks and sleeps until `jobs` are finished, or with a count of 0 until the
 * context has no job left, or until `seconds` (0 to 1e9, by the wall) are over. Returns FLG_OK, the result of the first
 * of `jobs` that failed, or FLG_NOT_READY when the time is over. Callbacks of jobs run as in flgContextTick. Not from
 * callbacks. */
FLG_API FlgResult flgContextRun(FlgContext context, const FlgJob* jobs, uint32_t count, double seconds);

/* ---- Curve sets ---------------------------------------------------------------------------------------------- */

/* What a column of a curve set means, and its number of floats per point: */
typedef enum FlgAttribute {
    FLG_ATTRIBUTE_POSITION = 0,      /* 3, metres; required. Finite, magnitude at most 1e30 */
    FLG_ATTRIBUTE_RADIUS = 1,        /* 1, metres, >= 0; of a tube, or half the width of a ribbon */
    FLG_ATTRIBUTE_COLOR = 2,         /* 4, linear RGBA */
    FLG_ATTRIBUTE_TANGENT = 3,       /* 3, unit length */
    FLG_ATTRIBUTE_NORMAL = 4,        /* 3, unit length, across the tangent: the first normal of the moving frame; a
                                        ribbon's width lies along the second, tangent x normal */
    FLG_ATTRIBUTE_TIME = 5,          /* 1, seconds since the first point of the curve; may run backwards in real data */
    FLG_ATTRIBUTE_PRESSURE = 6,      /* 1, 0 to 1 */
    FLG_ATTRIBUTE_ORIENTATION = 7,   /* 4, unit quaternion x y z w of the controller; its y axis begins frames */
    FLG_ATTRIBUTE_STYLE_INDEX = 8,   /* 1, index of the style point that a stylized point copies; whole numbers */
    FLG_ATTRIBUTE_RADII = 9,         /* 3: half axes along the first and second normal, metres, >= 0, and the angle
                                        that turns them about the tangent, radians: an elliptic cross-section */
    FLG_ATTRIBUTE_ANGLE = 10,        /* 1, radians: turns a ribbon about the tangent, from first to second normal */
    FLG_ATTRIBUTE_WIDTH = 11,        /* 1, metres, >= 0: of a ribbon */
    FLG_ATTRIBUTE_SPEED = 12,        /* 1, metres a second, > 0: of a motion along the curve */
    FLG_ATTRIBUTE_DISPLACEMENT = 13, /* 3, metres: what the style adds at magnitude 1 */
    /* In no curve set: what skins, fields and brush meshes hand to the host's buffers (filigree_buffers.h). */
    FLG_ATTRIBUTE_JOINTS = 32,       /* 4 whole numbers: joints that move a vertex */
    FLG_ATTRIBUTE_WEIGHTS = 33,      /* 4, 0 to 1: of these joints, the largest first */
    FLG_ATTRIBUTE_PART = 34,         /* 1 whole number: the part that a vertex lies on */
    FLG_ATTRIBUTE_VALUE = 35,        /* 1: a field's */
    FLG_ATTRIBUTE_LABEL = 36,        /* 1 whole number: a field's nearest source */
    FLG_ATTRIBUTE_UV = 37,           /* 2: texture coordinates of a brush mesh (filigree_brush.h) */
    FLG_ATTRIBUTE_USER = 64,         /* this and above: the host's own, 1 to 16 floats, interpolated linearly */
    FLG_ATTRIBUTE_FORCE_32BIT = 0x7fffffff
} FlgAttribute;

/* One column. Input columns may be strided; result columns are tightly packed. */
typedef struct FlgColumn {
    FlgAttribute attribute; /* what the values mean */
    uint32_t components;    /* floats per point */
    const float* data;      /* the first value */
    uint32_t stride;        /* bytes between consecutive points, a multiple of 4; 0 = tightly packed */
    uint32_t reserved;
} FlgColumn;

/* How a number is stored in the host's buffers. Values beyond a format's range become the nearest that it holds; what
 * is no number (NaN) becomes its least. FLOAT32 keeps all bits. */
typedef enum FlgNumberFormat {
    FLG_NUMBER_FORMAT_FLOAT32 = 0,
    FLG_NUMBER_FORMAT_FLOAT16 = 1, /* IEEE half: -65504 to 65504, rounded to the nearest */
    FLG_NUMBER_FORMAT_UNORM8 = 2,  /* 0 to 1 as 0 to 255 */
    FLG_NUMBER_FORMAT_SNORM8 = 3,  /* -1 to 1 as -127 to 127 */
    FLG_NUMBER_FORMAT_SNORM16 = 4, /* -1 to 1 as -32767 to 32767 */
    FLG_NUMBER_FORMAT_UINT16 = 5,  /* whole numbers; indices up to 65534 */
    FLG_NUMBER_FORMAT_UINT32 = 6,  /* whole numbers, indices */
    FLG_NUMBER_FORMAT_UNORM16 = 7, /* 0 to 1 as 0 to 65535 */
    FLG_NUMBER_FORMAT_UINT8 = 8,   /* whole numbers */
    /* A direction of 3 floats as two SNORM16, 4 bytes. With n = |x| + |y| + |z| these are (x, y) / n where z >= 0, else
     * ((1 - |y|) sign x, (1 - |x|) sign y), x and y divided by n before. Off by at most 7e-5 radians; of any length, 0
     * becomes (0, 0, 1). */
    FLG_NUMBER_FORMAT_OCTAHEDRAL16 = 9,
    FLG_NUMBER_FORMAT_SRGB8 = 10,  /* linear colour as the nearest byte of its sRGB value; alpha as UNORM8 */
    FLG_NUMBER_FORMAT_FORCE_32BIT = 0x7fffffff
} FlgNumberFormat;

/* Where a column goes in the host's buffers, and as what. Formats: FLOAT32 and FLOAT16 for all numbers but whole ones;
 * SNORM8 and SNORM16 for NORMAL, TANGENT, ORIENTATION and the host's own; OCTAHEDRAL16 for NORMAL and TANGENT; UNORM8
 * and UNORM16 for COLOR, PRESSURE, WEIGHTS, VALUE and the host's own; SRGB8 for COLOR; UINT8, UINT16 and UINT32 for the
 * whole ones: JOINTS, PART, LABEL. */
typedef struct FlgBufferColumn {
    FlgAttribute attribute; /* each at most once */
    FlgNumberFormat format;
    void* data;             /* of the first row written; aligned to the numbers' size, 2 of OCTAHEDRAL16 */
    uint32_t stride;        /* bytes between rows, a multiple of the numbers' size; 0 = tightly packed */
    /* Numbers a row, at most 16: the leading ones, or more, `fill` after them. 0: as many as the result has. Of
     * OCTAHEDRAL16 0 or 3, which become two; of SRGB8 at most 4. */
    uint32_t components;
    /* Numbers that the result lacks; beyond the fourth: 0. (0, 0, 0, 1) makes positions homogeneous, and alpha 1. Each
     * finite and at most 1e30 in size; 0 for whole numbers, which can't be filled. */
    float fill[4];
    uint32_t optional;      /* nonzero: without such a column all components are `fill`. 0: it is refused */
    uint32_t reserved;
} FlgBufferColumn;

enum {
    FLG_CURVE_CLOSED = 1 /* the last point joins the first, which is not repeated */
};

/* Curves in flat arrays: curve c has the points curve_offsets[c] to curve_offsets[c + 1] - 1 of every column. For input
 * the host owns the arrays, which must live for the call; for results the set owns them until it is released. */
typedef struct FlgCurveSetView {
    uint32_t struct_size;
    uint32_t curve_count;
    const uint32_t* curve_offsets; /* curve_count + 1 values, starting at 0, never decreasing */
    const uint8_t* curve_flags;    /* curve_count values of FLG_CURVE_...; null in input: all 0 */
    const FlgColumn* columns;      /* POSITION first in results */
    uint32_t column_count;         /* 1 to 16, each attribute at most once */
    uint32_t reserved;
    double origin[3];              /* metres: what positions are relative to. Default 0 */
} FlgCurveSetView;

FLG_API FlgResult flgCurveSetViewInit(FlgCurveSetView* view, uint32_t struct_size);

/* [any thread] The view's column of an attribute, null if there is none. */
FLG_API const FlgColumn* flgCurveSetViewGetColumn(const FlgCurveSetView* view, FlgAttribute attribute);

/* Copies curves into the context. Every curve needs at least one point; magnitudes must not exceed 1e30. Accepts
 * repeated points and zero-length curves unchanged; each function documents how it treats them. Cost: one pass over the
 * data, about 2 ms for a million points. */
FLG_API FlgResult flgCurveSetCreate(FlgContext context, const FlgCurveSetView* view, FlgCurveSet* out_set);

/* The same for one curve through `count` points, at least 1, of 3 floats each, metres. `flags`: 0 or FLG_CURVE_CLOSED.
 * Cost: one pass over the points. */
FLG_API FlgResult flgCurveSetCreateFromPoints(FlgContext context, const float* points, uint32_t count, uint8_t flags,
                                              FlgCurveSet* out_set);

/* The set's arrays. They neither move nor change until the set is released, even while jobs read it. FLG_NOT_READY
 * while the job that makes the set is unpublished; with partial_results, shows the leading curves complete at the last
 * flgContextTick instead. Returns the job's error if it failed. Cost: tens of nanoseconds. */
FLG_API FlgResult flgCurveSetGetView(FlgContext context, FlgCurveSet set, FlgCurveSetView* out_view);

/* Releases the handle and its views. Jobs that read the set keep its memory until they finish. A job that makes it
 * continues; cancel the job if the result is not needed. Cost: that of freeing its arrays; for results of many
 * megabytes some allocators return pages one by one: about 50 us a megabyte. */
FLG_API FlgResult flgCurveSetRelease(FlgContext context, FlgCurveSet set);

/* Which moving frame to carry along a curve. */
typedef enum FlgFrameMethod {
    FLG_FRAME_METHOD_ROTATION_MINIMIZING = 0, /* double reflection (Wang et al. 2008); spreads the twist of closed
                                                 curves evenly. Defined everywhere */
    FLG_FRAME_METHOD_FRENET = 1,              /* principal normal; where the curvature vanishes, carried on from the
                                                 last point where it did not, around closed curves. Flips at
                                                 inflections, as Frenet frames do */
    /* the curves' NORMAL column, interpolated and made perpendicular to the tangent; where it is parallel to the
     * tangent or vanishes, carried on from the last point where it was not, around closed curves. Without that
     * column the job fails */
    FLG_FRAME_METHOD_SUPPLIED = 2,
    FLG_FRAME_METHOD_FORCE_32BIT = 0x7fffffff
} FlgFrameMethod;

typedef struct FlgCurveSetResampleDesc {
    uint32_t struct_size;
    uint32_t reserved;
    const FlgJobOptions* job;
    FlgCurveSet curves;
    /* Desired distance between neighbouring points along the curve, metres, > 0. Each curve gets the nearest whole
     * number of equal steps, at least 1 (closed: 3). No default. */
    float spacing;
    /* Frame written to the result's TANGENT and NORMAL columns. */
    FlgFrameMethod frame;
} FlgCurveSetResampleDesc;

FLG_API FlgResult flgCurveSetResampleDescInit(FlgCurveSetResampleDesc* desc, uint32_t struct_size);

/* Starts a job that redistributes points evenly by arc length along a smooth curve through the given points and carries
 * a moving frame along. The curve is a G1 cubic that keeps straight runs straight, circles round to fourth order, and
 * turns of more than 50 degrees as corners. Other columns are interpolated linearly; orientations are normalized.
 * Consecutive repeated points count once. A zero-length curve becomes one point. Cost: about 50 ns a point. */
FLG_API FlgResult flgCurveSetResample(FlgContext context, const FlgCurveSetResampleDesc* desc, FlgCurveSet* out_set,
                                      FlgJob* out_job);

typedef struct FlgCurveSetSimplifyDesc {
    uint32_t struct_size;
    uint32_t level_count;    /* 1 to 16. Default 1 */
    const FlgJobOptions* job;
    FlgCurveSet curves;
    /* One a level, metres, >= 0: how far a point that is left out may be from the line that is left, at the same arc
     * length, plus how far its RADIUS may differ. 0 keeps what is not on a straight line. A pixel at distance d covers
     * 2 d tan(fov / 2) / height metres. No default. */
    const float* tolerances;
    float color_tolerance;   /* how far COLOR may differ, a component; >= 0. Default 0.01 */
    /* Nonzero: the rims of ribbons stay within the tolerance, in place of the radius: needs RADIUS, TANGENT and NORMAL.
     * Default 0. */
    uint32_t ribbons;
    uint32_t reserved;
} FlgCurveSetSimplifyDesc;

FLG_API FlgResult flgCurveSetSimplifyDescInit(FlgCurveSetSimplifyDesc* desc, uint32_t struct_size);

/* Starts a job that keeps the points that curves need, with all their columns: levels of detail as ranges of one
 * result. With n curves, curve c at level l is curve l * n + c of the result: one vertex buffer holds all levels, and a
 * level is a range of it. Ends stay, at least every 1024th point, and three points of closed curves. Cost: about
 * 50 ns a point and level; up to 10 us where few points can be left out of wild curves. */
FLG_API FlgResult flgCurveSetSimplify(FlgContext context, const FlgCurveSetSimplifyDesc* desc, FlgCurveSet* out_set,
                                      FlgJob* out_job);

/* ---- Styles -------------------------------------------------------------------------------------------------- */

/* Distance between two values of an attribute, sec. 5. */
typedef enum FlgMetric {
    FLG_METRIC_AUTO = 0,       /* CIRCLE for ANGLE and the third component of RADII, EUCLIDEAN for all else */
    FLG_METRIC_EUCLIDEAN = 1,  /* the length of the difference */
    FLG_METRIC_CIRCLE = 2,     /* radians modulo 2 pi: a two-sided ribbon (S1). For ANGLE, one-float USER columns, and
                                  the third component of RADII; its other components are always EUCLIDEAN */
    FLG_METRIC_PROJECTIVE = 3, /* radians modulo pi: a one-sided ribbon (RP1), or an ellipse, which a half turn leaves
                                  unchanged. For the same columns */
    FLG_METRIC_FORCE_32BIT = 0x7fffffff
} FlgMetric;

/* An attribute that a style transfers along with its shape. The style curves need a column for it; otherwise
 * flgStyleCreate refuses them, or its job does if another job still makes them. Values are sampled where the matching
 * leads, angles between points the shorter way and unwrapped along the curve. A SPEED must be above 0. */
typedef struct FlgStyleAttribute {
    FlgAttribute attribute; /* RADIUS, COLOR, RADII, ANGLE, WIDTH, SPEED or USER and above */
    FlgMetric metric;
    /* Weight of a difference of 1 relative to displacements when patches are compared, metres; >= 0. 0: the attribute
     * follows the shape without steering it. */
    float weight;
    uint32_t reserved;
} FlgStyleAttribute;

/* One of several patch sizes, sec. 4.5.4: their distances are summed with these weights. */
typedef struct FlgPatchSize {
    uint32_t patch; /* p, 1 to 1024 */
    float weight;   /* > 0 */
} FlgPatchSize;

/* How a style is prepared (Minarcik, Fiser, Sykora: Example-Based Authoring of Expressive Space Curves, sec. 4.1 to
 * 4.4). */
typedef struct FlgStyleDesc {
    uint32_t struct_size;
    /* Points the style is resampled to, 16 to 16384; 0 = chosen from the input: at least its number of points, enough
     * that the curve turns by less than 7 degrees between points, and between 256 and 2048. */
    uint32_t point_count;
    const FlgJobOptions* job;
    /* The example: 1 to 256 open curves of non-zero length. Their guides share the points by length, so that all have
     * one spacing, and one patch graph leads from any to any other (Fig. 3). Curves too short for a patch are never
     * jumped to; at least one must be long enough. */
    FlgCurveSet style;
    /* The unstyled form: one open curve for each style curve, in order. Null: made by the flow of sec. 4.1, along the
     * middle line of the style's waves; a style without waves is its own guide. */
    FlgCurveSet guide;
    /* How much of its length the guide keeps in the flow, 0 to 1: dL/dt = (alpha - 1) int kappa^2. 0 is plain curve
     * shortening; 1 keeps the length and removes little. Default 0.5. */
    float alpha;
    /* How long the flow lasts, as a multiple of the time that the style's waves ask for; > 0. Default 1. */
    float smoothing;
    /* Weight of closeness against evenness in the matching of guide and style, in (0, 1), sec. 4.2. Nothing is cut off
     * at any weight: from one point of the guide to the next the matching goes on along the style by at most 1.4 times
     * the mean. Towards 0 every piece of the guide gets an equal share of the style. Default 0.2. */
    float beta;
    /* p: a patch is 2p + 1 points, sec. 4.4; 1 to 1024, with 2p + 1 < points. Larger patches copy longer runs. Default
     * 10. */
    uint32_t patch;
    /* Several patch sizes in place of `patch`, at most 8; null: none. Jumps lead only to points with a patch of the
     * largest size. */
    const FlgPatchSize* patch_sizes;
    uint32_t patch_size_count;
    uint32_t attribute_count;
    /* Attributes to transfer, at most 8, each once; null: the shape alone. */
    const FlgStyleAttribute* attributes;
    /* Caps: how much of the example's first curve at its start, and of its last curve at its end, belongs to a stroke's
     * ends alone, metres along the example. Open targets begin with the one and end with the other, once, as drawn: the
     * guide goes on straight there, but for one of your own. No jump leads into a cap. Targets too short for both get
     * them smaller in all directions; closed ones get none, live strokes the end cap when they end, if asked for. 0:
     * none. Below 0: found, as what comes before the first and after the last repetition; where there is no period, of
     * patches as long as a sixteenth of the style or `patch` (FlgStyleInfo says how long caps are; the style is made
     * twice for it). What is left must be long enough for two patches. Default 0. */
    float start_cap, end_cap;
} FlgStyleDesc;

FLG_API FlgResult flgStyleDescInit(FlgStyleDesc* desc, uint32_t struct_size);

/* Starts a job that prepares a style: guide, matching, displacement, patch graph. The handle can be passed to
 * flgCurveSetStylize at once; its job then waits for this one. Cost: below 2 ms of work for 600 points. */
FLG_API FlgResult flgStyleCreate(FlgContext context, const FlgStyleDesc* desc, FlgStyle* out_style, FlgJob* out_job);

typedef struct FlgStyleInfo {
    uint32_t struct_size;
    uint32_t point_count;      /* of style, guide and displacement, over all curves */
    uint32_t patch;            /* p, the largest */
    uint32_t edge_count;       /* in the patch graph, including consecutive ones */
    float style_length;        /* metres, over all curves */
    float guide_length;        /* metres, likewise */
    float spacing;             /* guide_length / (point_count - curves): the distance between a result's points along
                                  its target */
    float displacement_rms;    /* metres */
    float matching_energy;     /* E' of sec. 4.2, square metres, mean over the points */
    float temperature_unit;    /* metres: what temperature 1 means, see FlgCurveSetStylizeDesc */
    uint32_t flow_steps;       /* of the guide flow; 0 with a guide given */
    uint32_t reserved;
    const float* matching;     /* point_count arc lengths on the style's curves, metres; lives until the style is
                                  released */
    uint32_t start_cap_points; /* the first points of the style, so many, are its start cap */
    uint32_t end_cap_points;   /* likewise the last ones its end cap */
} FlgStyleInfo;

FLG_API FlgResult flgStyleInfoInit(FlgStyleInfo* info, uint32_t struct_size);

/* FLG_NOT_READY until the style is prepared; its job's error if that failed. Cost: tens of nanoseconds. */
FLG_API FlgResult flgStyleGetInfo(FlgContext context, FlgStyle style, FlgStyleInfo* out_info);

/* The guide as a curve set with as many curves as the style and with TANGENT and NORMAL columns, relative to the
 * example's origin (of a loaded style 0). The caller releases it. Cost: one copy. */
FLG_API FlgResult flgStyleGetGuide(FlgContext context, FlgStyle style, FlgCurveSet* out_guide);

/* Serializes the prepared style for a file or an asset; the same style gives the same bytes. Writes their number to
 * `out_size`, and the bytes unless `out_data` is null. FLG_ERROR_LIMIT if `capacity` is too small. FLG_NOT_READY until
 * the style is prepared. Cost: about a millisecond a megabyte; a style has 150 to 250 bytes a point. */
FLG_API FlgResult flgStyleGetData(FlgContext context, FlgStyle style, void* out_data, size_t capacity,
                                  size_t* out_size);

/* Loads a style from such bytes, ready at once; it gives the same results, bit for bit. The bytes need no alignment and
 * may be freed afterwards. FLG_ERROR_FORMAT for truncated, damaged or malicious bytes, or another format version. Cost:
 * about a millisecond a megabyte. */
FLG_API FlgResult flgStyleCreateFromData(FlgContext context, const void* data, size_t size, FlgStyle* out_style);

FLG_API FlgResult flgStyleRelease(FlgContext context, FlgStyle style);

/* ---- Stylization --------------------------------------------------------------------------------------------- */

/* Where on the style a target curve begins. */
typedef enum FlgStyleStart {
    FLG_STYLE_START_AUTO = 0,   /* a lone target curve as FLG_STYLE_START_STYLE, several as FLG_STYLE_START_RANDOM */
    FLG_STYLE_START_STYLE = 1,  /* at the style's own start, closed targets a little further; the first run goes to its
                                   end: an open target as long as the guide gets the whole style once */
    FLG_STYLE_START_RANDOM = 2, /* at a random point, chosen by seed and curve index */
    FLG_STYLE_START_FORCE_32BIT = 0x7fffffff
} FlgStyleStart;

/* What a column of the target can drive along it. */
typedef enum FlgStyleDriven {
    FLG_STYLE_DRIVEN_MAGNITUDE = 0,   /* a factor on `magnitude`; at most 1e30 in size */
    FLG_STYLE_DRIVEN_SCALE = 1,       /* a factor on `scale`, above 0 and at most 1e30: the style's waves get shorter,
                                         its displacements and its attributes' lengths smaller, points denser */
    FLG_STYLE_DRIVEN_TEMPERATURE = 2, /* temperatures in place of `temperature`, >= 0: between the two, each point goes
                                         on by a path of the one or the other, by chance, weighted. One drive at most */
    FLG_STYLE_DRIVEN_RADIUS = 3,      /* a factor on the result's RADIUS, >= 0 */
    FLG_STYLE_DRIVEN_STYLE = 4,       /* which style: 0 is `style`, k the k-th of `further_styles`, 0 to their number;
                                         in between the nearest one. One drive at most */
    FLG_STYLE_DRIVEN_FORCE_32BIT = 0x7fffffff
} FlgStyleDriven;

/* Steers a style along its targets: where the column is `from`, `driven` has the value `at_from`, where it is `to`, the
 * value `at_to`; in between in proportion, beyond them no further. So at the target's points; values go evenly from one
 * point to the next. Several drives of the same thing are multiplied. */
typedef struct FlgStyleDrive {
    FlgAttribute attribute; /* a column of one float: PRESSURE, RADIUS, WIDTH, a USER one, ... SPEED, where it lacks,
                               is made from TIME: metres a second from the point before (infinite in no time) */
    FlgStyleDriven driven;
    float from, to;         /* finite, not equal; `from` may be above `to` */
    float at_from, at_to;   /* finite; see FlgStyleDriven */
} FlgStyleDrive;

/* What a style does at the corners of its targets. */
typedef enum FlgStyleCorners {
    FLG_STYLE_CORNERS_THROUGH = 0, /* it goes on as elsewhere */
    FLG_STYLE_CORNERS_MITRE = 1,   /* it goes on, and both sides meet in the plane that halves the corner. Close to it,
                                      within 3 displacement_rms or half a side, displacements slide along the target
                                      for that. At tips they get smaller; sides without room are gone through */
    FLG_STYLE_CORNERS_MOTIFS = 2,  /* whole motifs from corner to corner, fitted as `fit` says (at 0: as at 1), so that
                                      all corners have the same phase of the style; mitred too. Closed targets without
                                      corners are stylized as elsewhere */
    FLG_STYLE_CORNERS_FORCE_32BIT = 0x7fffffff
} FlgStyleCorners;

typedef struct FlgCurveSetStylizeDesc {
    uint32_t struct_size;
    FlgStyleStart start;
    const FlgJobOptions* job;
    FlgStyle style;
    /* The curves to stylize. Results keep their other columns, except the attributes the style has. */
    FlgCurveSet target;
    /* sigma, sec. 4.5.3: factor on the displacement; magnitude at most 1e30; 0 gives the resampled target. Default
     * 1. */
    float magnitude;
    /* tau, sec. 4.4.1: the cost of copying the style's next point instead of jumping; >= 0. At 0 the result copies long
     * runs of the style, at 1 a dozen points at a time; at 10 and above it jumps nearly always. In units of
     * FlgStyleInfo::temperature_unit (a tenth of the median distance between a patch and the one most like it), so it
     * does not depend on the style's size. Displacements and attributes blend over p to 4 p points at seams (see
     * flgCurveSetStylize): this shrinks shorter runs, at high temperatures. Default 0. */
    float temperature;
    /* Size of the style on the target, above 0 and at most 1e30: 1 = as drawn. 0 = chosen for each target curve by
     * itself, and kept for the host to read (flgCurveSetGetScales): s = size of the target curve / size of the guide,
     * the proportion that the example has. Size is D (D / L)^(1/3), with L the curve's length and D sqrt(12) times the
     * root mean square distance of its points from their centre: the length if it is straight, less where it winds. If
     * the target has a RADIUS, of mean r along the curve, the style swings as wide as the stroke was painted: 1.2 r /
     * FlgStyleInfo::displacement_rms, but at least s / 8 and at most 1.25 s. That RADIUS is then made thinner where the
     * style's turns would touch: multiplied by one factor for each curve, so that its mean is 0.14 * scale *
     * displacement_rms at most; but not if the style has a RADIUS, nor at magnitude 0. The choice depends neither on
     * place, direction or unit of style and target nor on the other curves. A curve without length has scale 1.
     * Default 1. */
    float scale;
    FlgFrameMethod frame;
    /* Key for all random choices. Default 1. */
    uint64_t seed;
    /* Row-major 3 x 3: rotates the style's displacement (along tangent, first normal, second normal) within the
     * target's frame, such as to apply a style drawn in one plane in another, sec. 7 (Fig. 16). Magnitude at most 1e30.
     * Default: identity. */
    float basis[9];
    /* Nonzero: results begin and end exactly where their targets do, to the bit, sec. 4.5.2. Curves that meet in a
     * network still meet; ends that do not meet keep their distance. Closed results then pass through their target's
     * first point. Default 0. */
    uint32_t pin_ends;
    /* How often each curve is stylized, with other random choices each time, 1 to 1024, sec. 4.5.5. Stroke k of target
     * curve c is curve c * strokes + k of the result. Stroke 0 equals the result for strokes = 1; the others begin at
     * random places in the style. Default 1. */
    uint32_t strokes;
    /* Nonzero: the result has a DISPLACEMENT column, so the magnitude can be changed afterwards, also on the GPU:
     * position at magnitude m = POSITION + (m - magnitude) * DISPLACEMENT, also for pinned and closed curves.
     * Default 0. */
    uint32_t keep_displacement;
    /* Maximum points in the result, at most 2^31: guards against a scale far too small for the target. A larger result
     * fails with FLG_ERROR_LIMIT before memory is taken for it. 0: 2^31. Default 2^26. */
    uint32_t max_points;
    /* Nonzero: points of open curves are exactly FlgStyleInfo::spacing * scale apart, as those of live strokes: the
     * last lies up to one step before the target's end, and no run goes on to the style's end for it. So a live
     * stroke's samples give the same bits (filigree_live.h). Curves shorter than one step keep their two points. Not
     * with pin_ends. 0: the whole number of equal steps that comes nearest. Default 0. */
    uint32_t exact_spacing;
    uint32_t reserved;
    /* What columns of the target drive along it, at most 8; null: nothing, the same everywhere. */
    const FlgStyleDrive* drives;
    uint32_t drive_count;
    /* Above 0, up to 1: open targets get whole motifs, one after the other (`start` and `temperature` have no effect),
     * as many as come nearest to the length, stretched to fill it, at least one. A motif is one repetition of the
     * style's first curve that has patches, without caps, or all of it if nothing repeats: that is stretched by r^fit
     * alone, r being the length over that of the motifs, and a jump in the last one skips or repeats the rest. A target
     * too short for a motif gets it smaller in all directions; one shorter than a patch a whole one.
     * 0: copies, cut off where a target ends. Closed targets: see corners. Not with exact_spacing. Default 0. */
    float fit;
    /* What happens at corners. Other than THROUGH, each corner gets a point of the result, closed results begin at
     * their target's first corner, and from corner to corner there is a whole number of steps, at least 1: not with
     * exact_spacing. Default THROUGH. */
    FlgStyleCorners corners;
    /* What a corner turns by, radians, above 0 and below pi: by more than that and twice what the points next to it
     * turn by in its direction, or by more than 1.7 times that. Smooth curves with 8 points around have none. A corner
     * may be drawn round: a bend of up to 160 degrees that is no longer than a patch of `style` as scaled (2 p + 1
     * steps) or 2.4 of its displacement_rms. Its sides are nearly straight and three times as long. The corner is where
     * the bend turns most. Default 50 degrees. */
    float corner_angle;
    /* Nonzero: the style's caps come at corners too, as at ends: the end cap before, the start cap behind each. Only
     * with FLG_STYLE_CORNERS_MOTIFS. Default 0. */
    uint32_t corner_caps;
    /* Nonzero, with pin_ends: where ends of open targets are the same point, to the bit, results that go on into each
     * other have one direction there. Ends are paired by the smallest turn, up to 60 degrees, each once; at points with
     * more than 64 ends none are. Results are bent for it over their first 4 p points, or half of a shorter one's.
     * Default 0. */
    uint32_t smooth_junctions;
    /* More styles, at most 7, among which a drive of FLG_STYLE_DRIVEN_STYLE chooses along the way; null: none. The
     * result has the points of the style whose points are closest together; the others' displacements and attributes
     * are interpolated between theirs. All styles must transfer the same attributes. STYLE_INDEX counts through the
     * points of all styles, one style behind the other. A `scale` above 0 is that of each; at 0 each has its own. */
    const FlgStyle* further_styles;
    uint32_t further_style_count;
    /* Over which length of the target one style turns into the next, metres, >= 0: half of it before the place where
     * the choice changes, half behind, evenly in direction too. 0: two patches of the style whose points are farthest
     * apart. Default 0. */
    float style_blend;
} FlgCurveSetStylizeDesc;

FLG_API FlgResult flgCurveSetStylizeDescInit(FlgCurveSetStylizeDesc* desc, uint32_t struct_size);

/* Starts a job that applies a style to curves (Algorithm 1, ApplyStyle). The result has each target curve once per
 * stroke, resampled to the style's spacing times scale. Columns: POSITION, TANGENT and NORMAL (the target's frame),
 * STYLE_INDEX, DISPLACEMENT if requested, the style's attributes and the target's other columns. A target curve
 * shorter than one step gets two points; a zero-length curve gets one, not displaced. Targets shorter than the style
 * get part of it.
 * Closed targets give closed results: their last path, of up to 256 points, leads back to the style point that the
 * curve began with, by one jump. The runs before and behind it are cross-faded over 6 p points, if need be on over the
 * curve's first ones. For that curves begin 64 points into the style at least, or in the middle of a shorter one. So
 * sizes, frames and ribbons cross the curve's start as evenly as elsewhere.
 * Displacements are those of the style at STYLE_INDEX. After a jump from style point i to point j, the gap d[i + 1]
 * - d[j] and that of the steps there are added and fade to zero by a cubic over p to 4 p points: results go on where
 * they were and as they went, with no steps and turns that the style lacks.
 * Attributes take the style's values at STYLE_INDEX; RADIUS, WIDTH and the half axes of RADII are multiplied by
 * scale. After jumps attributes blend as displacements do: angles the shorter way round, others kept within the
 * style's least and largest value. Angles are continuous along a curve: whole turns (PROJECTIVE: half turns) are
 * added as needed. As floats, they keep a precision of 1e-4 rad after 150 turns. ANGLE also turns the result's
 * NORMAL about its tangent. With SPEED the result has TIME, starting at the target's first TIME value, or 0; each
 * step takes its length divided by the mean speed of its ends. Results obey the limits of curve sets: if a
 * coordinate, a length or a time would exceed 1e30, the job fails with FLG_ERROR_INVALID_ARGUMENT and names it.
 * Cost: about 50 ns a point of the result, and once for each style and temperature the path trees, 0.1 ms each. */
FLG_API FlgResult flgCurveSetStylize(FlgContext context, const FlgCurveSetStylizeDesc* desc, FlgCurveSet* out_set,
                                     FlgJob* out_job);

/* In which size a style was drawn on each curve of a result. */
typedef struct FlgCurveSetScales {
    uint32_t struct_size;
    uint32_t curve_count; /* of the result; 0 for sets that no style was applied to */
    const float* scales;  /* curve_count factors on the style, as FlgCurveSetStylizeDesc::scale; null if there are none.
                             They live until the set is released */
} FlgCurveSetScales;

FLG_API FlgResult flgCurveSetScalesInit(FlgCurveSetScales* scales, uint32_t struct_size);

/* The scale of each curve that flgCurveSetStylize has made: the one given, or the one chosen for scale 0. Times
 * FlgStyleInfo::displacement_rms it is how far the style swings, metres; 0.14 of that is a good radius for curves that
 * have none. FLG_NOT_READY until the result is published, its job's error if that failed. Cost: tens of nanoseconds. */
FLG_API FlgResult flgCurveSetGetScales(FlgContext context, FlgCurveSet set, FlgCurveSetScales* out_scales);

/* ---- Defaults by value --------------------------------------------------------------------------------------- */
/* The struct is filled in the host's code, at the host's size: safe with any library version. */

static inline FlgStyleInfo flgStyleInfoDefaults(void) {
    FlgStyleInfo info;
    flgStyleInfoInit(&info, (uint32_t)sizeof info);
    return info;
}

static inline FlgJobStatus flgJobStatusDefaults(void) {
    FlgJobStatus status;
    flgJobStatusInit(&status, (uint32_t)sizeof status);
    return status;
}

static inline FlgFrameReport flgFrameReportDefaults(void) {
    FlgFrameReport report;
    flgFrameReportInit(&report, (uint32_t)sizeof report);
    return report;
}

static inline FlgAllocator flgAllocatorDefaults(void) {
    FlgAllocator allocator;
    flgAllocatorInit(&allocator, (uint32_t)sizeof allocator);
    return allocator;
}

static inline FlgJobSystem flgJobSystemDefaults(void) {
    FlgJobSystem system;
    flgJobSystemInit(&system, (uint32_t)sizeof system);
    return system;
}

static inline FlgLog flgLogDefaults(void) {
    FlgLog log;
    flgLogInit(&log, (uint32_t)sizeof log);
    return log;
}

static inline FlgClock flgClockDefaults(void) {
    FlgClock clock;
    flgClockInit(&clock, (uint32_t)sizeof clock);
    return clock;
}

static inline FlgProfiler flgProfilerDefaults(void) {
    FlgProfiler profiler;
    flgProfilerInit(&profiler, (uint32_t)sizeof profiler);
    return profiler;
}

static inline FlgJobOptions flgJobOptionsDefaults(void) {
    FlgJobOptions options;
    flgJobOptionsInit(&options, (uint32_t)sizeof options);
    return options;
}

static inline FlgContextDesc flgContextDefaults(void) {
    FlgContextDesc desc;
    flgContextDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgMemoryUse flgMemoryUseDefaults(void) {
    FlgMemoryUse use;
    flgMemoryUseInit(&use, (uint32_t)sizeof use);
    return use;
}

static inline FlgCurveSetView flgCurveSetViewDefaults(void) {
    FlgCurveSetView view;
    flgCurveSetViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgCurveSetResampleDesc flgCurveSetResampleDefaults(void) {
    FlgCurveSetResampleDesc desc;
    flgCurveSetResampleDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgStyleDesc flgStyleDefaults(void) {
    FlgStyleDesc desc;
    flgStyleDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgCurveSetSimplifyDesc flgCurveSetSimplifyDefaults(void) {
    FlgCurveSetSimplifyDesc desc;
    flgCurveSetSimplifyDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgCurveSetScales flgCurveSetScalesDefaults(void) {
    FlgCurveSetScales scales;
    flgCurveSetScalesInit(&scales, (uint32_t)sizeof scales);
    return scales;
}

static inline FlgCurveSetStylizeDesc flgCurveSetStylizeDefaults(void) {
    FlgCurveSetStylizeDesc desc;
    flgCurveSetStylizeDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

#ifdef __cplusplus
}
#endif

#endif
