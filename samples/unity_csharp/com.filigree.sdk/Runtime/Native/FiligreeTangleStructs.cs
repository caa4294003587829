// SPDX-License-Identifier: MIT
// Structs of filigree_tangle.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    /// <summary>
    /// A part of a border. Loops are the closed borders of the seeds' regions, all regions together, also where the
    /// surface ends: in the order of their least edges, as flgBorderSample gives them. Shares of the loop's length from
    /// its first vertex on.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgBorderStretch
    {
        /// <summary>its number</summary>
        public uint loop;
        /// <summary>in [0, 1)</summary>
        public float begin;
        /// <summary>in (begin, begin + 1]</summary>
        public float end;
    }

    /// <summary>
    /// What an operator begins at: all that is named here, together. By default nothing is. Arrays are copied.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgTangleSeeds
    {
        public FlgTangleBorders borders;
        public uint stretch_count;
        /// <summary>parts of the outer borders</summary>
        public FlgBorderStretch* stretches;
        /// <summary>places on the surface as it is</summary>
        public FlgSurfacePoint* points;
        public uint point_count;
        /// <summary>Poisson samples at most; 0: as many as fit</summary>
        public uint sample_count;
        /// <summary>no two samples are nearer, nor half as near to a border, metres; 0: no samples</summary>
        public float sample_radius;
        /// <summary>points so far apart along the outer borders, metres; 0: none</summary>
        public float border_spacing;
        /// <summary>lines, of the surface as it is; null: none</summary>
        public FlgSurfaceCurves curves;
        /// <summary>whose borders these are, and where samples lie; null: those of the operator</summary>
        public uint* regions;
        public uint region_count;
        public uint reserved;
    }

    /// <summary>
    /// An operator. Parts are numbered: from the seeds outwards between isolines; along a between streams; 0 left of a
    /// polyline's curves (where most of its border is) and 1 elsewhere; else in the order of their first triangles.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgTangleDivideDesc
    {
        public uint struct_size;
        /// <summary>default FlgTangleOperator.Contour</summary>
        public FlgTangleOperator kind;
        public FlgJobOptions job;
        public FlgTangle tangle;
        /// <summary>divided together, as one piece; copied</summary>
        public uint* regions;
        /// <summary>at least 1</summary>
        public uint region_count;
        /// <summary>
        /// Isolines at delta, 2 delta, ...: at most so many; 0: as many as the field has. At most 256. Default 1.
        /// </summary>
        public uint count;
        /// <summary>b: with it the field is blended, 0 at a and 1 at b; by default it is empty</summary>
        public FlgTangleSeeds a;
        /// <summary>b: with it the field is blended, 0 at a and 1 at b; by default it is empty</summary>
        public FlgTangleSeeds b;
        /// <summary>
        /// &gt; 0. Contours: metres, or a share of the blend below 1. Streams: metres along a. Default 0.1
        /// </summary>
        public float delta;
        /// <summary>default FlgTangleGrouping.Two</summary>
        public FlgTangleGrouping grouping;
        /// <summary>groups of FlgTangleGrouping.Cycle, 1 to 65536; default 3</summary>
        public uint cycle;
        /// <summary>nonzero: the borders are not seen. Default 0</summary>
        public uint scaffold;
        /// <summary>nonzero: a polyline goes back to its first point. Default 0</summary>
        public uint closed;
        /// <summary>metres, &gt;= 0; default 0</summary>
        public float perturbation;
        /// <summary>1 / metre, &gt; 0; default 1</summary>
        public float frequency;
        public uint reserved;
        /// <summary>of samples and noise; default 1</summary>
        public ulong seed;
    }

    /// <summary>The operators that are used together most, sec. 3.4 and Fig. 13.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgTangleMacroDesc
    {
        public uint struct_size;
        /// <summary>default FlgTangleMacro.Sunburst</summary>
        public FlgTangleMacro kind;
        public FlgJobOptions job;
        public FlgTangle tangle;
        /// <summary>as of an operator; copied</summary>
        public uint* regions;
        /// <summary>at least 1</summary>
        public uint region_count;
        /// <summary>frames, petals one in another, rows of the grid: 1 to 256; default 4</summary>
        public uint count;
        /// <summary>
        /// Metres, &gt; 0; default 0.1. Strips and columns: their width along the first border; dots, lace: the radius;
        /// frames and outlines: the width of a band. Flowers and cells have none.
        /// </summary>
        public float size;
        /// <summary>Metres, &gt; 0; default 0.3: between samples, at least; between scallops.</summary>
        public float spacing;
        /// <summary>of samples; default 1</summary>
        public ulong seed;
    }

    /// <summary>
    /// Moves vertices of regions along the surface's normals: sec. 3.4, after an operator. Each leaf rises by `amount`
    /// at the place that is farthest from its borders, or everywhere `reach` and more away from them; borders stay. In
    /// between the height is the profile of the distance, by the bias and gain of Schlick (1994). Distances measured
    /// later are those on the new surface.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgTangleDisplaceDesc
    {
        public uint struct_size;
        /// <summary>metres, any finite number; default 0.1</summary>
        public float amount;
        public FlgJobOptions job;
        public FlgTangle tangle;
        /// <summary>their leaves are displaced; copied</summary>
        public uint* regions;
        /// <summary>at least 1</summary>
        public uint region_count;
        /// <summary>in (0, 1): below 0.5 spikes, above it domes; default 0.5: neither</summary>
        public float bias;
        /// <summary>in (0, 1): below 0.5 steep at half height, above it a terrace there; default 0.5: neither</summary>
        public float gain;
        /// <summary>metres, &gt;= 0; default 0: each leaf's own largest distance</summary>
        public float reach;
    }

    /// <summary>
    /// Where the seeds of an operator were: what finds them again on another mesh of the same shape. Positions are x,
    /// y, z in metres.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgTangleSeedPlaces
    {
        /// <summary>of the seeds' points, all or none</summary>
        public uint point_count;
        /// <summary>of the first vertices of the outer borders, in their order; 0: no borders were asked for</summary>
        public uint loop_count;
        /// <summary>of the samples, in the order they were chosen</summary>
        public uint sample_count;
        public uint reserved;
        /// <summary>3 a point</summary>
        public float* points;
        /// <summary>3 a loop</summary>
        public float* loops;
        /// <summary>3 a sample</summary>
        public float* samples;
        /// <summary>the seeds' lines, in place of a handle; no curves: none</summary>
        public FlgSurfaceCurvesView curves;
        /// <summary>of the curves' points; null: none</summary>
        public float* curve_points;
    }

    /// <summary>What a step was asked to do, and what it needs to be done again.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgTangleStep
    {
        public uint struct_size;
        public FlgTangleStepKind kind;
        /// <summary>of FlgTangleStepKind.Divide; handles and job options in it are null</summary>
        public FlgTangleDivideDesc* divide;
        /// <summary>of FlgTangleStepKind.Macro, likewise</summary>
        public FlgTangleMacroDesc* macro;
        /// <summary>of FlgTangleStepKind.Displace, likewise</summary>
        public FlgTangleDisplaceDesc* displace;
        /// <summary>grouped or joined</summary>
        public uint* regions;
        public uint region_count;
        /// <summary>taken apart</summary>
        public uint group;
        /// <summary>Of a and b of the operator, or of each of the macro's operators. Null and 0: not known.</summary>
        public FlgTangleSeedPlaces* places;
        public uint place_count;
        /// <summary>
        /// The regions it made have the identifiers first_region and up; inside of each there is a point of `made`: x,
        /// y, z in metres. Of a group that was taken apart: first_region is one of its regions, or FLG_NO_INDEX.
        /// </summary>
        public uint first_region;
        public uint made_count;
        /// <summary>
        /// Nonzero: it came from another mesh, so its seeds were found by `places`, and have to be again.
        /// </summary>
        public uint placed;
        /// <summary>3 a region</summary>
        public float* made;
    }

    /// <summary>
    /// All steps of a tangle: with them it can be made again, and kept in a file (flgTangleFileWrite of filigree_io.h).
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgTangleHistory
    {
        public uint struct_size;
        /// <summary>with those taken back</summary>
        public uint step_count;
        /// <summary>those not taken back</summary>
        public uint made_count;
        public uint reserved;
        /// <summary>the first one first</summary>
        public FlgTangleStep* steps;
        /// <summary>tells meshes apart: of the positions and triangles that the tangle began with, to the bit</summary>
        public ulong @base;
        /// <summary>of these positions</summary>
        public fixed float box_min[3];
        /// <summary>of these positions</summary>
        public fixed float box_max[3];
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgTangleInfo
    {
        public uint struct_size;
        /// <summary>identifiers are below it</summary>
        public uint region_count;
        /// <summary>likewise</summary>
        public uint group_count;
        /// <summary>regions that are not divided</summary>
        public uint leaf_count;
        /// <summary>steps that can be taken back, and made again</summary>
        public uint undo_count;
        /// <summary>steps that can be taken back, and made again</summary>
        public uint redo_count;
        /// <summary>of the deepest leaf; the root's is 0</summary>
        public uint depth;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgTangleRegion
    {
        public uint struct_size;
        /// <summary>FLG_NO_INDEX: the root</summary>
        public uint parent;
        /// <summary>that it is of</summary>
        public uint group;
        /// <summary>borders are seen where looks differ</summary>
        public uint look;
        /// <summary>number of the operator that made it, from 1, a macro's each by itself; the root: 0</summary>
        public uint operation;
        /// <summary>of that operator</summary>
        public uint part;
        /// <summary>children have consecutive identifiers</summary>
        public uint first_child;
        public uint child_count;
        /// <summary>the region it belongs to since they were joined; FLG_NO_INDEX: none</summary>
        public uint joined_into;
        /// <summary>nonzero: its borders are not seen</summary>
        public uint scaffold;
        /// <summary>the group of the nearest region around it, itself included, that is no scaffold's</summary>
        public uint visible_group;
        /// <summary>of the tree; the root has 0</summary>
        public uint depth;
    }
}
