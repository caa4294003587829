// SPDX-License-Identifier: MIT
// Structs of filigree_tangle.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>
    /// Part of a border. Loops are the closed borders of the seeds' regions, taken together, including surface borders.
    /// They are ordered by their least edges, as flgSurfaceSampleBorders gives them. `begin` and `end` are fractions of
    /// the loop's length from its first vertex.
    /// </summary>
    public unsafe partial struct FlgBorderStretch
    {
        /// <summary>its index</summary>
        public uint loop;
        /// <summary>in [0, 1)</summary>
        public float begin;
        /// <summary>in (begin, begin + 1]</summary>
        public float end;
    }

    /// <summary>
    /// Where an operator starts: everything named here, combined. Empty by default. Arrays are copied.
    /// </summary>
    public unsafe partial struct FlgTangleSeeds
    {
        public uint struct_size;
        public FlgTangleBorders borders;
        public uint stretch_count;
        /// <summary>parts of the outer borders</summary>
        public FlgBorderStretch* stretches;
        /// <summary>points on the current surface</summary>
        public FlgSurfacePoint* points;
        public uint point_count;
        /// <summary>maximum Poisson samples; 0: as many as fit</summary>
        public uint sample_count;
        /// <summary>minimum distance between samples, metres, and half that to a border; 0: no samples</summary>
        public float sample_radius;
        /// <summary>distance between points along the outer borders, metres; 0: none</summary>
        public float border_spacing;
        /// <summary>lines on the current surface; null: none</summary>
        public FlgSurfaceCurves curves;
        /// <summary>regions that supply the borders and samples; null: the operator's</summary>
        public uint* regions;
        public uint region_count;
    }

    /// <summary>
    /// An operator. It numbers parts as follows. Between isolines: outwards from the seeds. Between streams: along a.
    /// For a polyline: 0 left of its curves (where most of the border is) and 1 elsewhere. Otherwise: in the order of
    /// their first triangles.
    /// </summary>
    public unsafe partial struct FlgTangleDivideDesc
    {
        public uint struct_size;
        /// <summary>default FlgTangleOperator.Contour</summary>
        public FlgTangleOperator kind;
        public FlgJobOptions* job;
        public FlgTangle tangle;
        /// <summary>divided together, as one piece; copied</summary>
        public uint* regions;
        /// <summary>at least 1</summary>
        public uint region_count;
        /// <summary>
        /// Maximum isolines, at delta, 2 delta, ...: up to 256; 0: as many as the field has. Default 1.
        /// </summary>
        public uint count;
        /// <summary>where the operator starts</summary>
        public FlgTangleSeeds* a;
        /// <summary>the field is blended: 0 at a and 1 at b; null: it is not</summary>
        public FlgTangleSeeds* b;
        /// <summary>
        /// &gt; 0. Contours: metres, or a fraction below 1 of the blend. Streams: metres along a; a closed border gets
        /// a multiple of two strips, or of `cycle`, where so many groups take turns. Default 0.1
        /// </summary>
        public float delta;
        /// <summary>default FlgTangleGrouping.Two</summary>
        public FlgTangleGrouping grouping;
        /// <summary>group count for FlgTangleGrouping.Cycle, 1 to 65536; default 3</summary>
        public uint cycle;
        /// <summary>nonzero: the borders are invisible. Default 0</summary>
        public uint scaffold;
        /// <summary>nonzero: a polyline returns to its first point. Default 0</summary>
        public uint closed;
        /// <summary>metres, &gt;= 0; default 0</summary>
        public float perturbation;
        /// <summary>1 / metre, &gt; 0; default 1</summary>
        public float frequency;
        public uint reserved;
        /// <summary>for samples and noise; default 1</summary>
        public ulong seed;
    }

    /// <summary>Common combinations of operators, sec. 3.4 and Fig. 13.</summary>
    public unsafe partial struct FlgTangleApplyMacroDesc
    {
        public uint struct_size;
        /// <summary>default FlgTangleMacro.Sunburst</summary>
        public FlgTangleMacro kind;
        public FlgJobOptions* job;
        public FlgTangle tangle;
        /// <summary>as for an operator; copied</summary>
        public uint* regions;
        /// <summary>at least 1</summary>
        public uint region_count;
        /// <summary>frames, nested petals, rows of the grid: 1 to 256; default 4</summary>
        public uint count;
        /// <summary>
        /// Metres, &gt; 0; default 0.1. Sunbursts and grids: width of strips and columns along the border they start
        /// from. Dots and lace: radius. Frames and outlines: band width. Unused by flowers and cells.
        /// </summary>
        public float size;
        /// <summary>
        /// Minimum distance between samples, or between scallops; metres, &gt; 0; default 0.3. Flowers have no larger
        /// one than 1.5 times the largest distance from a border: there is a petal in every strip.
        /// </summary>
        public float spacing;
        /// <summary>for samples; default 1</summary>
        public ulong seed;
        /// <summary>
        /// Sunbursts and grids: the border they start from, an index as in FlgBorderStretch. FLG_NO_INDEX (default):
        /// the longest of each connected piece.
        /// </summary>
        public uint border;
        public uint reserved;
    }

    /// <summary>
    /// Moves vertices of regions along the surface's normals, sec. 3.4, after an operator. Each leaf rises by `amount`
    /// at the point farthest from its borders, or wherever the borders are `reach` or more away; borders stay. In
    /// between, the height is a profile of the distance, by the bias and gain of Schlick (1994). The ridges of the
    /// distance are rounded, by some percent of the largest one; normals are smoothed within the regions, over up to
    /// half of `amount`. Where a triangle that is no sliver would turn over, the height is lowered. (Parts of the
    /// surface that face each other may still meet.) Later distances are measured on the new surface.
    /// </summary>
    public unsafe partial struct FlgTangleDisplaceDesc
    {
        public uint struct_size;
        /// <summary>metres, any finite number; default 0.1</summary>
        public float amount;
        public FlgJobOptions* job;
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
    /// Where an operator's seeds were: used to find them again on another mesh of the same shape. Positions are x, y, z
    /// in metres.
    /// </summary>
    public unsafe partial struct FlgTangleSeedPlaces
    {
        public uint struct_size;
        /// <summary>the seeds' points, all or none</summary>
        public uint point_count;
        /// <summary>first vertices of the outer borders, in order; 0: no borders were requested</summary>
        public uint loop_count;
        /// <summary>the samples, in the order chosen</summary>
        public uint sample_count;
        /// <summary>3 per point</summary>
        public float* points;
        /// <summary>3 per loop</summary>
        public float* loops;
        /// <summary>3 per sample</summary>
        public float* samples;
        /// <summary>the seeds' lines, in place of a handle; null: none</summary>
        public FlgSurfaceCurvesView* curves;
        /// <summary>3 for each of the curves' points; null: none</summary>
        public float* curve_points;
    }

    /// <summary>A region by how it was made: what it is known by while it is not there.</summary>
    public unsafe partial struct FlgTangleRegionName
    {
        /// <summary>that makes it: index in the history. FLG_NO_INDEX: the root, or a step that was removed</summary>
        public uint step;
        /// <summary>of the step: a macro's operators are counted from 0</summary>
        public uint operation;
        /// <summary>of the operation</summary>
        public uint part;
        /// <summary>the region it is in: index of a name before this one. FLG_NO_INDEX: this is the root</summary>
        public uint parent;
        /// <summary>a point in it: of several regions, the nearest is meant. Metres</summary>
        public fixed float place[3];
        /// <summary>one whose point is this far away is another; 0: however far. Metres, &gt;= 0</summary>
        public float reach;
    }

    /// <summary>The arguments of a step, and the data needed to repeat it.</summary>
    public unsafe partial struct FlgTangleStep
    {
        public uint struct_size;
        public FlgTangleStepKind kind;
        /// <summary>for FlgTangleStepKind.Divide; its handles and job options are null</summary>
        public FlgTangleDivideDesc* divide;
        /// <summary>for FlgTangleStepKind.Macro, likewise</summary>
        public FlgTangleApplyMacroDesc* macro;
        /// <summary>for FlgTangleStepKind.Displace, likewise</summary>
        public FlgTangleDisplaceDesc* displace;
        /// <summary>grouped or joined</summary>
        public uint* regions;
        public uint region_count;
        /// <summary>the group that was ungrouped</summary>
        public uint group;
        /// <summary>For the operator's a and b, or for each of the macro's operators. Null and 0: unknown.</summary>
        public FlgTangleSeedPlaces** places;
        public uint place_count;
        /// <summary>
        /// The regions it made have identifiers from first_region on; `made` has a point inside each: x, y, z in
        /// metres. When ungrouping, first_region is one of the group's regions, or FLG_NO_INDEX.
        /// </summary>
        public uint first_region;
        public uint made_count;
        /// <summary>
        /// Nonzero: the step came from another mesh, so `places` located its seeds and must do so again.
        /// </summary>
        public uint placed;
        /// <summary>3 per region</summary>
        public float* made;
        /// <summary>default FlgTangleStepState.Made</summary>
        public FlgTangleStepState state;
        public uint name_count;
        /// <summary>
        /// Null, or names of regions: then the step's lists of regions are indices of these, and those it cannot find
        /// now are left out; when ungrouping, the last one is of the group. Steps have names while some of their
        /// regions are not there.
        /// </summary>
        public FlgTangleRegionName* names;
        /// <summary>
        /// Why the step is lost, or which of its regions are not there: a sentence, empty if there is nothing to say.
        /// Of a history; ignored where a host describes a step.
        /// </summary>
        public byte* why;
    }

    /// <summary>
    /// All steps of a tangle: enough to make it again, or to save it in a file (flgTangleFileWrite of filigree_io.h).
    /// </summary>
    public unsafe partial struct FlgTangleHistory
    {
        public uint struct_size;
        /// <summary>including undone steps, up to the first undone edit</summary>
        public uint step_count;
        /// <summary>steps not undone</summary>
        public uint made_count;
        public uint reserved;
        /// <summary>oldest first</summary>
        public FlgTangleStep** steps;
        /// <summary>identifies the mesh: from the tangle's initial positions and triangles, to the bit</summary>
        public ulong @base;
        /// <summary>
        /// box of those positions, relative to the surface's origin, as all positions are: a history does not depend on
        /// where its mesh is
        /// </summary>
        public fixed float box_min[3];
        /// <summary>
        /// box of those positions, relative to the surface's origin, as all positions are: a history does not depend on
        /// where its mesh is
        /// </summary>
        public fixed float box_max[3];
    }

    public unsafe partial struct FlgTangleInfo
    {
        public uint struct_size;
        /// <summary>identifiers are below this</summary>
        public uint region_count;
        /// <summary>likewise</summary>
        public uint group_count;
        /// <summary>undivided regions</summary>
        public uint leaf_count;
        /// <summary>steps, and edits of the history, that can be undone and redone</summary>
        public uint undo_count;
        /// <summary>steps, and edits of the history, that can be undone and redone</summary>
        public uint redo_count;
        /// <summary>of the deepest leaf; the root's is 0</summary>
        public uint depth;
        /// <summary>operators, displacements and joins that the last change computed</summary>
        public uint computed_count;
    }

    public unsafe partial struct FlgTangleRegion
    {
        public uint struct_size;
        /// <summary>FLG_NO_INDEX: the root</summary>
        public uint parent;
        /// <summary>its group</summary>
        public uint group;
        /// <summary>visible borders lie where looks differ</summary>
        public uint look;
        /// <summary>index of the operator that made it, from 1; each operator of a macro counts; the root: 0</summary>
        public uint operation;
        /// <summary>its part of that operator</summary>
        public uint part;
        /// <summary>children have consecutive identifiers</summary>
        public uint first_child;
        public uint child_count;
        /// <summary>the region it was joined into; FLG_NO_INDEX: none</summary>
        public uint joined_into;
        /// <summary>nonzero: its borders are invisible</summary>
        public uint scaffold;
        /// <summary>
        /// the group of the nearest enclosing region, itself included, that does not belong to a scaffold
        /// </summary>
        public uint visible_group;
        /// <summary>in the tree; the root's is 0</summary>
        public uint depth;
    }
}
