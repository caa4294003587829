// SPDX-License-Identifier: MIT
// Structs of filigree_live.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    public unsafe partial struct FlgLiveStrokeDesc
    {
        public uint struct_size;
        /// <summary>FlgStyleStart.Auto is FlgStyleStart.Style here.</summary>
        public FlgStyleStart start;
        public FlgStyle style;
        /// <summary>As in FlgCurveSetStylizeDesc.</summary>
        public float magnitude;
        /// <summary>the style must be warm at this temperature</summary>
        public float temperature;
        /// <summary>
        /// &gt; 0, or 0 = chosen from the radii, as a stroke's length is not known while it is drawn: the mean of the
        /// two radii below becomes 0.14 of the style's swing, scale * displacement_rms, so that turns stay apart. 1 if
        /// both are 0 or the style has no displacement. FlgLiveStrokeInfo::scale has the one chosen. Default 1.
        /// </summary>
        public float scale;
        /// <summary>Radius at pressure 0 and at pressure 1, metres, &gt;= 0. Default 0.001 and 0.005.</summary>
        public float min_radius;
        /// <summary>Radius at pressure 0 and at pressure 1, metres, &gt;= 0. Default 0.001 and 0.005.</summary>
        public float max_radius;
        /// <summary>
        /// Time constant of an exponential filter on position and pressure, seconds, &gt;= 0; adds that much lag to a
        /// steady hand. Exact for hands that move evenly between samples, so independent of the sample rate. 0: none.
        /// Default 0.
        /// </summary>
        public float smoothing;
        /// <summary>
        /// Maximum distance between consecutive samples, metres, &gt; 0; longer jumps are refused. Default 1.
        /// </summary>
        public float max_jump;
        /// <summary>
        /// Capacity in samples (1 to 2^20) and points (1 to 2^24): about 400 bytes a sample (with several styles 350
        /// more for each), 44 a point and 4 for each component of the style's attributes; 257 more points for the tip.
        /// Default 16,384 and 65,536.
        /// </summary>
        public uint max_samples;
        /// <summary>points beyond this are cut off, see FlgLiveStrokeInfo</summary>
        public uint max_points;
        /// <summary>
        /// FlgFrameMethod.RotationMinimizing or FlgFrameMethod.Supplied (by the controller, see above).
        /// FlgFrameMethod.Frenet is refused: its normal needs a point's next neighbour, which is not drawn yet.
        /// </summary>
        public FlgFrameMethod frame;
        /// <summary>Key for all random choices. Default 1.</summary>
        public ulong seed;
        /// <summary>As in FlgCurveSetStylizeDesc. Default: identity.</summary>
        public fixed float basis[9];
        public uint reserved;
        /// <summary>
        /// metres: what samples and points are relative to. flgLiveStrokeReplay takes its samples' instead. Default 0
        /// </summary>
        public fixed double origin[3];
        /// <summary>
        /// What the hand drives along the stroke, at most 8; null: nothing. By PRESSURE, or by SPEED: metres a second
        /// from the sample before (infinite in no time), for which samples need times. The style must be warm at both
        /// temperatures of a drive. Copied by flgLiveStrokeBegin.
        /// </summary>
        public FlgStyleDrive* drives;
        public uint drive_count;
        /// <summary>
        /// Nonzero: what flgLiveStrokeEnd and flgLiveStrokeReplay make ends with the style's end cap, see Caps. It is
        /// drawn once more for that, as a job. Default 0.
        /// </summary>
        public uint end_cap;
        /// <summary>
        /// More styles, at most 7, among which a drive of FlgStyleDriven.Style chooses while the hand draws; null:
        /// none. They must be prepared and warm like `style`, and transfer the same attributes. The stroke's points are
        /// as close together as those of the style with the smallest spacing. STYLE_INDEX counts through the points of
        /// all styles, one style behind the other, and is that of the style that counts most. See Several styles.
        /// </summary>
        public FlgStyle* further_styles;
        public uint further_style_count;
        /// <summary>
        /// Over which length of the stroke one style turns into the next, metres, &gt;= 0: it begins where the choice
        /// changes and goes on evenly, in direction too. 0: two patches of the style whose points are farthest apart.
        /// Default 0.
        /// </summary>
        public float style_blend;
    }

    /// <summary>Samples of the controller, as columns: arrays of the host, or members of an array of structs.</summary>
    public unsafe partial struct FlgLiveSampleView
    {
        public uint struct_size;
        public uint sample_count;
        /// <summary>
        /// bytes from a sample to the next in every column: the size of the host's struct. Default 0: every column is
        /// packed
        /// </summary>
        public uint stride;
        public uint reserved;
        /// <summary>3 per sample, metres, magnitude at most 1e30</summary>
        public float* positions;
        /// <summary>
        /// 4 per sample: a quaternion x y z w of any length; all zero: none; see Frame. Default null: none
        /// </summary>
        public float* orientations;
        /// <summary>one per sample, 0 to 1. Default null: 1</summary>
        public float* pressures;
        /// <summary>
        /// one per sample, seconds on any clock; never decreasing. `smoothing` needs them. Default null: 0
        /// </summary>
        public double* times;
    }

    /// <summary>Progress of a stroke.</summary>
    public unsafe partial struct FlgLiveStrokeInfo
    {
        public uint struct_size;
        public uint sample_count;
        public uint point_count;
        /// <summary>not read yet, because earlier samples still have points to make: see Delivery; usually 0</summary>
        public uint waiting_samples;
        /// <summary>nonzero from flgLiveStrokeEnd to flgLiveStrokeResume</summary>
        public uint ended;
        /// <summary>metres: one step</summary>
        public float spacing;
        /// <summary>
        /// nonzero: the samples need more than max_points points; the stroke ends before its samples do
        /// </summary>
        public uint cut;
        /// <summary>of the style: FlgLiveStrokeDesc::scale, or the one chosen for 0</summary>
        public float scale;
        /// <summary>
        /// about how many points the samples so far still have to get; usually 0. Every sample to come makes 1,024 of
        /// them at most: see Delivery
        /// </summary>
        public uint waiting_points;
        /// <summary>
        /// samples from which on the stroke has had more than 64 points to the next: pushing them takes longer. A
        /// larger scale or more samples a second make it fewer
        /// </summary>
        public uint dense_samples;
    }
}
