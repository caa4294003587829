// SPDX-License-Identifier: MIT
// Functions of filigree_tangle.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Tangles: recursive ornament on surfaces (Nazzaro, Puppo, Pellacini: geoTangle, 2021). It follows the grammar of
// filigree.h
// and filigree_surface.h.
//
// A tangle is a tree of regions of a surface, sec. 3 and appendix A of the paper. The root, region 0, is the whole
// surface;
// operators divide regions along isolines and streamlines of geodesic fields, and the parts become their children.
// Leaves
// partition the surface; the label of a triangle is its leaf. An operator on a region that was divided before divides
// its
// leaves: their borders stay, its own go through all of them.
//
// Groups       Each region is of one group, which materials and scripts go by. How an operator groups what it makes is
//              its
//              `grouping`; parts of leaves are in one group if their part of the operator and the leaf's own group are
//              the same.
// Scaffolds    A scaffold's borders are not seen: its regions look like the region they lie in, and help to place
// others.
// Looks        Two leaves look the same if no visible border may lie between them; borders are where looks differ.
// History      Each operator, macro, grouping and join is a step, which can be taken back and made again, to the bit.
// Surface      The tangle changes its surface by jobs, in the order they were started. Do not cut a tangle's surface by
//              other
//              means, nor make another tangle of it: then all further changes of this one are refused. Fields, tracing,
//              picking and drawing go on as with any surface.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>
        /// Starts a job that makes the whole of a surface the root of a tangle: all labels become 0. The surface may
        /// still be in the making. Cost: about 5 ns a triangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleCreate(
            FlgContext context, FlgSurface surface, FlgTangle* out_tangle, FlgJob* out_job);

        /// <summary>Gives the handle back; the surface stays as it is.</summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleRelease(FlgContext context, FlgTangle tangle);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleDivideDescInit(FlgTangleDivideDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that divides regions by an operator. One that leaves them whole (delta beyond the field, no
        /// room for samples, a line that does not separate) is a step that changes nothing. Fails if a region does not
        /// exist, if borders are asked for where there are none, if streams have no line to begin on, or with more than
        /// FLG_REGION_MAX regions. Cost: a field (40 ns a triangle of the regions; with b two, with samples two more),
        /// the cut (flgCutIsolines), and several passes over the surface (2 million triangles: 40 to 60 ms, however
        /// small the regions).
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleDivide(FlgContext context, FlgTangleDivideDesc* desc, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleMacroDescInit(FlgTangleMacroDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that applies a macro: one step, to be taken back at once. Parts are grouped as
        /// FlgTangleGrouping.Two does. Fails as its operators do; sunbursts and grids also if the regions together have
        /// fewer than two borders. Cost: its operators'.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleApplyMacro(
            FlgContext context, FlgTangleMacroDesc* desc, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleDisplaceDescInit(FlgTangleDisplaceDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that displaces regions; a step. Fails if they have no borders. Cost: a field and about 2 us a
        /// vertex that moves.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleDisplace(
            FlgContext context, FlgTangleDisplaceDesc* desc, FlgJob* out_job);

        /// <summary>
        /// Starts a job that gives all these regions one new group, sec. 3.4 and appendix A; a step. Any region may be
        /// named, leaf or not; it fails if one does not exist. Cost: tens of nanoseconds a region.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleGroup(
            FlgContext context, FlgTangle tangle, uint* regions, uint region_count, FlgJob* out_job);

        /// <summary>
        /// Starts a job that gives each region of the group a new group of its own; a step. It fails if there is no
        /// such group. Cost: tens of nanoseconds a region of the tangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleUngroup(
            FlgContext context, FlgTangle tangle, uint group, FlgJob* out_job);

        /// <summary>
        /// Starts a job that makes the leaves of these regions one region, with the lowest of their identifiers; a
        /// step. It fails if they are not connected. Cost: about 20 ns a triangle of the surface.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleJoin(
            FlgContext context, FlgTangle tangle, uint* regions, uint region_count, FlgJob* out_job);

        /// <summary>
        /// Starts a job that gives the borders that are seen as curves on the surface, chains of its edges: to lift
        /// into space (flgLiftCurves), to stylize, to draw as ribbons and tubes. Open ones from meeting point to
        /// meeting point, then closed ones; curve_values are lengths. Where looks are all the same there are none.
        /// Cost: about 30 ns a triangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleBorders(
            FlgContext context, FlgTangle tangle, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        /// <summary>
        /// Starts a job that takes the last step back; it fails if there is none (steps whose job failed are none).
        /// Cost: that of what the step changed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleUndo(FlgContext context, FlgTangle tangle, FlgJob* out_job);

        /// <summary>
        /// Starts a job that makes the step again that was taken back last. A new step forgets those. Cost: that of
        /// what the step changes.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleRedo(FlgContext context, FlgTangle tangle, FlgJob* out_job);

        /// <summary>
        /// The arrays live until a job that changes the tangle is started, the function is called again for it, or the
        /// tangle is released. Not ready when the info isn't. Cost: about 1 us a step and some ns a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleGetHistory(
            FlgContext context, FlgTangle tangle, FlgTangleHistory* out_history);

        /// <summary>
        /// Starts a job that makes all steps of a history again on a tangle that has none, and takes those back that
        /// were: afterwards the tangle has them as its own. On the same mesh, to the bit, it becomes the tangle that
        /// the history is of, to the bit. On another mesh of that shape, such as a finer one, points, samples, lines,
        /// borders and regions are found by where they were: the nearest point of the surface stands for each. All is
        /// copied in this call. Fails, and changes nothing, if the tangle has steps; if a step fails, naming it; if the
        /// meshes' boxes differ by more than 1/20 of their diagonal. What the arguments of flgTangleDivide and the
        /// others may not be is refused here too. Cost: that of the steps; on another mesh also about 0.2 us a triangle
        /// for each step that has points or made regions.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleReplay(
            FlgContext context, FlgTangle tangle, FlgTangleHistory* history, FlgJob* out_job);

        /// <summary>
        /// FlgResult.NotReady while a job that changes the tangle isn't published; its error if its surface failed.
        /// Cost: tens of nanoseconds a region.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleGetInfo(FlgContext context, FlgTangle tangle, FlgTangleInfo* out_info);

        /// <summary>Not ready when the info isn't. Cost: tens of nanoseconds.</summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleGetRegion(
            FlgContext context, FlgTangle tangle, uint region, FlgTangleRegion* out_region);

        public static FlgTangleDivideDesc flgTangleDivideDefaults()
        {
            FlgTangleDivideDesc made;
            flgTangleDivideDescInit(&made, (uint)sizeof(FlgTangleDivideDesc));
            return made;
        }

        public static FlgTangleMacroDesc flgTangleMacroDefaults()
        {
            FlgTangleMacroDesc made;
            flgTangleMacroDescInit(&made, (uint)sizeof(FlgTangleMacroDesc));
            return made;
        }

        public static FlgTangleDisplaceDesc flgTangleDisplaceDefaults()
        {
            FlgTangleDisplaceDesc made;
            flgTangleDisplaceDescInit(&made, (uint)sizeof(FlgTangleDisplaceDesc));
            return made;
        }
    }
}
