// SPDX-License-Identifier: MIT
// Structs of filigree_live.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgLiveStrokeDesc
    {
        public uint struct_size;
        /// <summary>FlgStart.Auto is FlgStart.Style here.</summary>
        public FlgStart start;
        public FlgStyle style;
        /// <summary>As in FlgStylizeDesc.</summary>
        public float magnitude;
        /// <summary>the style has to be warm at this</summary>
        public float temperature;
        /// <summary>&gt; 0</summary>
        public float scale;
        /// <summary>Metres, &gt;= 0: the radius at pressure 0 and at pressure 1. Default 0.001 and 0.005.</summary>
        public float radius_min;
        /// <summary>Metres, &gt;= 0: the radius at pressure 0 and at pressure 1. Default 0.001 and 0.005.</summary>
        public float radius_max;
        /// <summary>
        /// Time constant of an exponential filter on position and pressure, seconds, &gt;= 0; exact for hands that move
        /// evenly between samples, so independent of the sample rate. A hand that moves evenly is followed this much
        /// later. 0: none. Default 0.
        /// </summary>
        public float smoothing;
        /// <summary>
        /// The longest way from one sample to the next, metres, &gt; 0: what jumps further is refused. Default 1.
        /// </summary>
        public float max_jump;
        /// <summary>
        /// Samples (1 to 2^20) and points (1 to 2^24) that memory is taken for: about 270 bytes a sample, 44 a point
        /// and 4 for each component of the style's attributes. Default 16,384 and 65,536.
        /// </summary>
        public uint max_samples;
        /// <summary>what is due beyond is cut off, see FlgLiveStrokeInfo</summary>
        public uint max_points;
        /// <summary>
        /// FlgFrameMethod.RotationMinimizing or FlgFrameMethod.Supplied: by the controller, see above.
        /// FlgFrameMethod.Frenet is refused: its normal lies between a point's neighbours, of which the later one is
        /// not drawn yet.
        /// </summary>
        public FlgFrameMethod frame;
        /// <summary>Key of all random choices. Default 1.</summary>
        public ulong seed;
        /// <summary>As in FlgStylizeDesc. Default: identity.</summary>
        public fixed float basis[9];
        public uint reserved;
    }

    /// <summary>What a controller says.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgLiveSample
    {
        /// <summary>metres, at most 1e30 in size</summary>
        public fixed float position[3];
        /// <summary>quaternion x y z w of any length; all zero: none; see Frame</summary>
        public fixed float orientation[4];
        /// <summary>0 to 1</summary>
        public float pressure;
        /// <summary>seconds on any clock; not falling</summary>
        public double time;
    }

    /// <summary>How far a stroke is.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgLiveStrokeInfo
    {
        public uint struct_size;
        public uint sample_count;
        public uint point_count;
        /// <summary>not read yet, because points of those before are due: see Delivery; 0 on the whole</summary>
        public uint waiting_samples;
        /// <summary>nonzero from flgLiveStrokeEnd to flgLiveStrokeResume</summary>
        public uint ended;
        /// <summary>metres: a step</summary>
        public float spacing;
        /// <summary>nonzero: more points were due than max_points; the stroke ends before its samples do</summary>
        public uint cut;
    }
}
