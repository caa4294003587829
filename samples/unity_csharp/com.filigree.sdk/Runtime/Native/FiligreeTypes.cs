// SPDX-License-Identifier: MIT
// Types of filigree.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>Changes when hosts break; until 1.0 a minor version may break them, too.</summary>
        public const int FLG_VERSION_MAJOR = 0;
        /// <summary>Changes when hosts gain features.</summary>
        public const int FLG_VERSION_MINOR = 1;
        /// <summary>Changes with everything else.</summary>
        public const int FLG_VERSION_PATCH = 0;
        /// <summary>The version of this header, as one number.</summary>
        public const int FLG_VERSION = 4096;
        /// <summary>in place of an index: none</summary>
        public const uint FLG_NO_INDEX = 4294967295;
        /// <summary>in place of a time or a count: as long as it takes, as many as there are</summary>
        public const uint FLG_UNLIMITED = 4294967295;
        /// <summary>the last point joins the first, which is not repeated</summary>
        public const int FLG_CURVE_CLOSED = 1;
    }

    /// <summary>How a call or a job ended; negative values are failures.</summary>
    public enum FlgResult
    {
        /// <summary>FLG_OK: done; from a function that starts a job: started</summary>
        Ok = 0,
        /// <summary>FLG_NOT_READY: asked too early: flgContextTick has not published the job yet</summary>
        NotReady = 1,
        /// <summary>FLG_ERROR_INVALID_ARGUMENT: a null, a value out of range, unusable data</summary>
        ErrorInvalidArgument = -1,
        /// <summary>FLG_ERROR_INVALID_HANDLE: null, released, of another kind or from another context</summary>
        ErrorInvalidHandle = -2,
        /// <summary>FLG_ERROR_OUT_OF_MEMORY: the allocator hook returned null</summary>
        ErrorOutOfMemory = -3,
        /// <summary>FLG_ERROR_VERSION: header and library do not match</summary>
        ErrorVersion = -4,
        /// <summary>FLG_ERROR_CANCELLED: the job was cancelled</summary>
        ErrorCancelled = -5,
        /// <summary>FLG_ERROR_DEPENDENCY: a job this one depends on failed or was cancelled</summary>
        ErrorDependency = -6,
        /// <summary>FLG_ERROR_FILE: a file cannot be opened, read or written</summary>
        ErrorFile = -7,
        /// <summary>FLG_ERROR_FORMAT: the file's contents violate its format</summary>
        ErrorFormat = -8,
        /// <summary>FLG_ERROR_LIMIT: a documented limit would be exceeded; the message names it</summary>
        ErrorLimit = -9,
        /// <summary>FLG_ERROR_INTERNAL: a bug in Filigree</summary>
        ErrorInternal = -10,
    }

    /// <summary>How much a message matters.</summary>
    public enum FlgLogLevel
    {
        /// <summary>FLG_LOG_LEVEL_INFO: worth knowing</summary>
        Info = 0,
        /// <summary>FLG_LOG_LEVEL_WARNING: unusual, but work continues</summary>
        Warning = 1,
        /// <summary>FLG_LOG_LEVEL_ERROR: something failed</summary>
        Error = 2,
    }

    /// <summary>What memory is for.</summary>
    public enum FlgMemoryKind
    {
        /// <summary>FLG_MEMORY_KIND_TOTAL: all kinds together; its peak is at most the sum of theirs</summary>
        Total = 0,
        /// <summary>FLG_MEMORY_KIND_STYLES: styles</summary>
        Styles = 1,
        /// <summary>FLG_MEMORY_KIND_SURFACES: surfaces, fields, surface curves, tangles, manifolds, obstacles</summary>
        Surfaces = 2,
        /// <summary>FLG_MEMORY_KIND_CURVES: curve sets, live strokes, splines, motions</summary>
        Curves = 3,
        /// <summary>FLG_MEMORY_KIND_MODELS: skeletons, outlines, parts, their bodies, models, skins</summary>
        Models = 4,
        /// <summary>
        /// FLG_MEMORY_KIND_CACHES: what is made again when it is needed: path trees of styles, solver data of surfaces
        /// </summary>
        Caches = 5,
        /// <summary>FLG_MEMORY_KIND_SCRATCH: what running jobs work with, and their results until they end</summary>
        Scratch = 6,
        /// <summary>FLG_MEMORY_KIND_RUNTIME: the context itself, handles, records of jobs</summary>
        Runtime = 7,
    }

    /// <summary>Which ready job runs first.</summary>
    public enum FlgPriority
    {
        /// <summary>FLG_PRIORITY_LOW: when nothing else is ready</summary>
        Low = -1,
        /// <summary>FLG_PRIORITY_NORMAL: the default</summary>
        Normal = 0,
        /// <summary>FLG_PRIORITY_HIGH: before all others, such as results the user waits for</summary>
        High = 1,
    }

    /// <summary>Where a job is, as of the last flgContextTick.</summary>
    public enum FlgJobState
    {
        /// <summary>FLG_JOB_STATE_WAITING: for its dependencies or its turn</summary>
        Waiting = 0,
        /// <summary>FLG_JOB_STATE_RUNNING: begun, not published</summary>
        Running = 1,
        /// <summary>FLG_JOB_STATE_FINISHED: published; `result` says how it ended</summary>
        Finished = 2,
    }

    /// <summary>Why a job does not go on.</summary>
    public enum FlgJobWait
    {
        /// <summary>FLG_JOB_WAIT_NONE: it runs, or is finished</summary>
        None = 0,
        /// <summary>FLG_JOB_WAIT_INPUT: another job makes what it needs, or it was told to wait for it</summary>
        Input = 1,
        /// <summary>FLG_JOB_WAIT_ORDER: a job on the same surface that was started earlier comes first</summary>
        Order = 2,
        /// <summary>FLG_JOB_WAIT_TURN: it could begin: others run</summary>
        Turn = 3,
    }

    /// <summary>What a column of a curve set means, and its number of floats per point:</summary>
    public enum FlgAttribute
    {
        /// <summary>FLG_ATTRIBUTE_POSITION: 3, metres; required. Finite, magnitude at most 1e30</summary>
        Position = 0,
        /// <summary>FLG_ATTRIBUTE_RADIUS: 1, metres, &gt;= 0; of a tube, or half the width of a ribbon</summary>
        Radius = 1,
        /// <summary>FLG_ATTRIBUTE_COLOR: 4, linear RGBA</summary>
        Color = 2,
        /// <summary>FLG_ATTRIBUTE_TANGENT: 3, unit length</summary>
        Tangent = 3,
        /// <summary>
        /// FLG_ATTRIBUTE_NORMAL: 3, unit length, across the tangent: the first normal of the moving frame; a ribbon's
        /// width lies along the second, tangent x normal
        /// </summary>
        Normal = 4,
        /// <summary>
        /// FLG_ATTRIBUTE_TIME: 1, seconds since the first point of the curve; may run backwards in real data
        /// </summary>
        Time = 5,
        /// <summary>FLG_ATTRIBUTE_PRESSURE: 1, 0 to 1</summary>
        Pressure = 6,
        /// <summary>
        /// FLG_ATTRIBUTE_ORIENTATION: 4, unit quaternion x y z w of the controller; its y axis begins frames
        /// </summary>
        Orientation = 7,
        /// <summary>
        /// FLG_ATTRIBUTE_STYLE_INDEX: 1, index of the style point that a stylized point copies; whole numbers
        /// </summary>
        StyleIndex = 8,
        /// <summary>
        /// FLG_ATTRIBUTE_RADII: 3: half axes along the first and second normal, metres, &gt;= 0, and the angle that
        /// turns them about the tangent, radians: an elliptic cross-section
        /// </summary>
        Radii = 9,
        /// <summary>
        /// FLG_ATTRIBUTE_ANGLE: 1, radians: turns a ribbon about the tangent, from first to second normal
        /// </summary>
        Angle = 10,
        /// <summary>FLG_ATTRIBUTE_WIDTH: 1, metres, &gt;= 0: of a ribbon</summary>
        Width = 11,
        /// <summary>FLG_ATTRIBUTE_SPEED: 1, metres a second, &gt; 0: of a motion along the curve</summary>
        Speed = 12,
        /// <summary>FLG_ATTRIBUTE_DISPLACEMENT: 3, metres: what the style adds at magnitude 1</summary>
        Displacement = 13,
        /// <summary>FLG_ATTRIBUTE_JOINTS: 4 whole numbers: joints that move a vertex</summary>
        Joints = 32,
        /// <summary>FLG_ATTRIBUTE_WEIGHTS: 4, 0 to 1: of these joints, the largest first</summary>
        Weights = 33,
        /// <summary>FLG_ATTRIBUTE_PART: 1 whole number: the part that a vertex lies on</summary>
        Part = 34,
        /// <summary>FLG_ATTRIBUTE_VALUE: 1: a field's</summary>
        Value = 35,
        /// <summary>FLG_ATTRIBUTE_LABEL: 1 whole number: a field's nearest source</summary>
        Label = 36,
        /// <summary>FLG_ATTRIBUTE_UV: 2: texture coordinates of a brush mesh (filigree_brush.h)</summary>
        Uv = 37,
        /// <summary>FLG_ATTRIBUTE_USER: this and above: the host's own, 1 to 16 floats, interpolated linearly</summary>
        User = 64,
    }

    /// <summary>
    /// How a number is stored in the host's buffers. Values beyond a format's range become the nearest that it holds;
    /// what is no number (NaN) becomes its least. FLOAT32 keeps all bits.
    /// </summary>
    public enum FlgNumberFormat
    {
        /// <summary>FLG_NUMBER_FORMAT_FLOAT32</summary>
        Float32 = 0,
        /// <summary>FLG_NUMBER_FORMAT_FLOAT16: IEEE half: -65504 to 65504, rounded to the nearest</summary>
        Float16 = 1,
        /// <summary>FLG_NUMBER_FORMAT_UNORM8: 0 to 1 as 0 to 255</summary>
        Unorm8 = 2,
        /// <summary>FLG_NUMBER_FORMAT_SNORM8: -1 to 1 as -127 to 127</summary>
        Snorm8 = 3,
        /// <summary>FLG_NUMBER_FORMAT_SNORM16: -1 to 1 as -32767 to 32767</summary>
        Snorm16 = 4,
        /// <summary>FLG_NUMBER_FORMAT_UINT16: whole numbers; indices up to 65534</summary>
        Uint16 = 5,
        /// <summary>FLG_NUMBER_FORMAT_UINT32: whole numbers, indices</summary>
        Uint32 = 6,
        /// <summary>FLG_NUMBER_FORMAT_UNORM16: 0 to 1 as 0 to 65535</summary>
        Unorm16 = 7,
        /// <summary>FLG_NUMBER_FORMAT_UINT8: whole numbers</summary>
        Uint8 = 8,
        /// <summary>
        /// FLG_NUMBER_FORMAT_OCTAHEDRAL16: A direction of 3 floats as two SNORM16, 4 bytes. With n = |x| + |y| + |z|
        /// these are (x, y) / n where z &gt;= 0, else ((1 - |y|) sign x, (1 - |x|) sign y), x and y divided by n
        /// before. Off by at most 7e-5 radians; of any length, 0 becomes (0, 0, 1).
        /// </summary>
        Octahedral16 = 9,
        /// <summary>
        /// FLG_NUMBER_FORMAT_SRGB8: linear colour as the nearest byte of its sRGB value; alpha as UNORM8
        /// </summary>
        Srgb8 = 10,
    }

    /// <summary>Which moving frame to carry along a curve.</summary>
    public enum FlgFrameMethod
    {
        /// <summary>
        /// FLG_FRAME_METHOD_ROTATION_MINIMIZING: double reflection (Wang et al. 2008); spreads the twist of closed
        /// curves evenly. Defined everywhere
        /// </summary>
        RotationMinimizing = 0,
        /// <summary>
        /// FLG_FRAME_METHOD_FRENET: principal normal; where the curvature vanishes, carried on from the last point
        /// where it did not, around closed curves. Flips at inflections, as Frenet frames do
        /// </summary>
        Frenet = 1,
        /// <summary>
        /// FLG_FRAME_METHOD_SUPPLIED: the curves' NORMAL column, interpolated and made perpendicular to the tangent;
        /// where it is parallel to the tangent or vanishes, carried on from the last point where it was not, around
        /// closed curves. Without that column the job fails
        /// </summary>
        Supplied = 2,
    }

    /// <summary>Distance between two values of an attribute, sec. 5.</summary>
    public enum FlgMetric
    {
        /// <summary>
        /// FLG_METRIC_AUTO: CIRCLE for ANGLE and the third component of RADII, EUCLIDEAN for all else
        /// </summary>
        Auto = 0,
        /// <summary>FLG_METRIC_EUCLIDEAN: the length of the difference</summary>
        Euclidean = 1,
        /// <summary>
        /// FLG_METRIC_CIRCLE: radians modulo 2 pi: a two-sided ribbon (S1). For ANGLE, one-float USER columns, and the
        /// third component of RADII; its other components are always EUCLIDEAN
        /// </summary>
        Circle = 2,
        /// <summary>
        /// FLG_METRIC_PROJECTIVE: radians modulo pi: a one-sided ribbon (RP1), or an ellipse, which a half turn leaves
        /// unchanged. For the same columns
        /// </summary>
        Projective = 3,
    }

    /// <summary>Where on the style a target curve begins.</summary>
    public enum FlgStyleStart
    {
        /// <summary>
        /// FLG_STYLE_START_AUTO: a lone target curve as FlgStyleStart.Style, several as FlgStyleStart.Random
        /// </summary>
        Auto = 0,
        /// <summary>
        /// FLG_STYLE_START_STYLE: at the style's own start, closed targets a little further; the first run goes to its
        /// end: an open target as long as the guide gets the whole style once
        /// </summary>
        Style = 1,
        /// <summary>FLG_STYLE_START_RANDOM: at a random point, chosen by seed and curve index</summary>
        Random = 2,
    }

    /// <summary>What a column of the target can drive along it.</summary>
    public enum FlgStyleDriven
    {
        /// <summary>FLG_STYLE_DRIVEN_MAGNITUDE: a factor on `magnitude`; at most 1e30 in size</summary>
        Magnitude = 0,
        /// <summary>
        /// FLG_STYLE_DRIVEN_SCALE: a factor on `scale`, above 0 and at most 1e30: the style's waves get shorter, its
        /// displacements and its attributes' lengths smaller, points denser
        /// </summary>
        Scale = 1,
        /// <summary>
        /// FLG_STYLE_DRIVEN_TEMPERATURE: temperatures in place of `temperature`, &gt;= 0: between the two, each point
        /// goes on by a path of the one or the other, by chance, weighted. One drive at most
        /// </summary>
        Temperature = 2,
        /// <summary>FLG_STYLE_DRIVEN_RADIUS: a factor on the result's RADIUS, &gt;= 0</summary>
        Radius = 3,
        /// <summary>
        /// FLG_STYLE_DRIVEN_STYLE: which style: 0 is `style`, k the k-th of `further_styles`, 0 to their number; in
        /// between the nearest one. One drive at most
        /// </summary>
        Style = 4,
    }

    /// <summary>What a style does at the corners of its targets.</summary>
    public enum FlgStyleCorners
    {
        /// <summary>FLG_STYLE_CORNERS_THROUGH: it goes on as elsewhere</summary>
        Through = 0,
        /// <summary>
        /// FLG_STYLE_CORNERS_MITRE: it goes on, and both sides meet in the plane that halves the corner. Close to it,
        /// within 3 displacement_rms or half a side, displacements slide along the target for that. At tips they get
        /// smaller; sides without room are gone through
        /// </summary>
        Mitre = 1,
        /// <summary>
        /// FLG_STYLE_CORNERS_MOTIFS: whole motifs from corner to corner, fitted as `fit` says (at 0: as at 1), so that
        /// all corners have the same phase of the style; mitred too. Closed targets without corners are stylized as
        /// elsewhere
        /// </summary>
        Motifs = 2,
    }

    /// <summary>A running or finished piece of work.</summary>
    public partial struct FlgJob : IEquatable<FlgJob>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgJob other) => id == other.id;
        public override bool Equals(object other) => other is FlgJob handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>Curves in flat arrays; never changes once ready.</summary>
    public partial struct FlgCurveSet : IEquatable<FlgCurveSet>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgCurveSet other) => id == other.id;
        public override bool Equals(object other) => other is FlgCurveSet handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>A prepared style: guide, displacement and patch graph. Never changes once ready.</summary>
    public partial struct FlgStyle : IEquatable<FlgStyle>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgStyle other) => id == other.id;
        public override bool Equals(object other) => other is FlgStyle handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>A context owns everything else. At most 1024 exist at a time in a process.</summary>
    public partial struct FlgContext : IEquatable<FlgContext>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgContext other) => id == other.id;
        public override bool Equals(object other) => other is FlgContext handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }
}
