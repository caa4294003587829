// SPDX-License-Identifier: MIT
// Functions of filigree_tangle.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Tangles: recursive ornament on surfaces (Nazzaro, Puppo, Pellacini: geoTangle, 2021). Follows the grammar of
// filigree.h and filigree_surface.h.
//
// A tangle is a tree of regions of a surface, sec. 3 and appendix A of the paper. The root, region 0, is the whole
// surface. Operators divide regions along isolines and streamlines of geodesic fields; the parts become their children.
// Leaves partition the surface; each triangle's label is its leaf. An operator on a region already divided divides its
// leaves: their borders stay, and the operator's borders pass through all of them.
//
// Groups       Each region belongs to one group; materials and scripts select by group. An operator's `grouping` says
//              how it groups the regions it makes. Parts of several leaves share a group if their part of the operator
//              and their leaf's group are the same.
// Scaffolds    A scaffold's borders are invisible: its regions look like the region around them, and help to place
//              others.
// Looks        Two leaves look the same if no visible border may lie between them; visible borders lie where looks
//              differ.
// History      Each operator, macro, grouping and join is a step, which can be undone and redone, to the bit. Steps
//              before the last can be changed, muted, moved and removed, and others inserted: what depends on them is
//              computed again. Such an edit is undone and redone like a step.
// Surface      The tangle changes its surface by jobs, in the order they were started. Do not cut a tangle's surface by
//              other means, and do not make another tangle from it: all further changes to this tangle are then
//              refused. Fields, tracing, picking and drawing work as on any surface.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>
        /// Starts a job that makes a whole surface the root of a tangle: all labels become 0. The surface's own job may
        /// still run. Cost: about 5 ns a triangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleCreate(
            FlgContext context, FlgSurface surface, FlgJobOptions* job, FlgTangle* out_tangle, FlgJob* out_job);

        /// <summary>Releases the handle; the surface does not change.</summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleRelease(FlgContext context, FlgTangle tangle);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleSeedsInit(FlgTangleSeeds* seeds, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleDivideDescInit(FlgTangleDivideDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that divides regions by an operator. If it leaves them whole (delta beyond the field, no room
        /// for samples, a line that does not separate), the step changes nothing. What it cuts off a region that is
        /// smaller than a millionth of the surface stays with the part beside it. Fails if a region does not exist, if
        /// requested borders do not exist, if streams have no line to start on, or above FLG_REGION_MAX regions. Cost:
        /// a field (40 ns a triangle of the regions; with b two, with samples two more), and the cut
        /// (flgSurfaceCutIsolines). On 2 million triangles a region of 10,000 takes some 10 ms where many edges are
        /// flipped.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleDivide(FlgContext context, FlgTangleDivideDesc* desc, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleApplyMacroDescInit(FlgTangleApplyMacroDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that applies a macro as one step, undone as a whole. Parts are grouped as by
        /// FlgTangleGrouping.Two. Fails as its operators do; sunbursts and grids also fail if the regions together have
        /// fewer than two borders. Cost: its operators'.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleApplyMacro(
            FlgContext context, FlgTangleApplyMacroDesc* desc, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleDisplaceDescInit(FlgTangleDisplaceDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that displaces regions, as a step. Fails if they have no borders. Cost: a field and about 1 us
        /// a vertex that moves.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleDisplace(
            FlgContext context, FlgTangleDisplaceDesc* desc, FlgJob* out_job);

        /// <summary>
        /// Starts a job that puts these regions into one new group, sec. 3.4 and appendix A, as a step. Regions may be
        /// leaves or not; fails if one does not exist. Cost: tens of nanoseconds a region.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleGroup(
            FlgContext context, FlgTangle tangle, uint* regions, uint region_count, FlgJobOptions* job, FlgJob*
            out_job);

        /// <summary>
        /// Starts a job that gives each region of the group its own new group, as a step. Fails if there is no such
        /// group. Cost: tens of nanoseconds a region of the tangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleUngroup(
            FlgContext context, FlgTangle tangle, uint group, FlgJobOptions* job, FlgJob* out_job);

        /// <summary>
        /// Starts a job that joins the leaves of these regions into one region, with their lowest identifier, as a
        /// step. Fails if they are not connected. Cost: about 20 ns a triangle of the surface.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleJoin(
            FlgContext context, FlgTangle tangle, uint* regions, uint region_count, FlgJobOptions* job, FlgJob*
            out_job);

        /// <summary>
        /// Starts a job that returns the visible borders as curves on the surface, chains of its edges. Lift them into
        /// space (flgSurfaceCurvesLift), stylize them, or draw them as ribbons and tubes. Open curves, from junction to
        /// junction, come first, then closed ones; curve_values are lengths. There are none if all looks are the same.
        /// Cost: about 30 ns a triangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleTraceBorders(
            FlgContext context, FlgTangle tangle, FlgJobOptions* job, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        /// <summary>
        /// Starts a job that undoes the last step, or the last edit of the history if that came later; fails if there
        /// is neither. (A failed job makes no step.) Cost: that of what the step changed; of an edit, that of the steps
        /// it computed or put elsewhere, before and after.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleUndo(
            FlgContext context, FlgTangle tangle, FlgJobOptions* job, FlgJob* out_job);

        /// <summary>
        /// Starts a job that redoes the last undone step or edit. A new step or edit discards what was undone. Cost:
        /// that of what the step changes.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleRedo(
            FlgContext context, FlgTangle tangle, FlgJobOptions* job, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleSeedPlacesInit(FlgTangleSeedPlaces* places, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleStepInit(FlgTangleStep* step, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleHistoryInit(FlgTangleHistory* history, uint struct_size);

        /// <summary>
        /// The arrays live until a job that changes the tangle is started, the function is called again for it, or the
        /// tangle is released. FlgResult.NotReady while the info is not ready. Cost: about 1 us a step and some ns a
        /// point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleGetHistory(
            FlgContext context, FlgTangle tangle, FlgTangleHistory* out_history);

        /// <summary>
        /// Starts a job that repeats all steps of a history on a tangle without steps, then undoes those that were
        /// undone; the steps become the tangle's own. On the same mesh, to the bit, this restores the original tangle,
        /// to the bit. On another mesh of that shape, such as a finer one, it locates points, samples, lines, borders
        /// and regions by their positions, each snapped to the surface. This call copies everything. Fails, and changes
        /// nothing, if the tangle has steps, if a step fails (the message names it), or if the meshes' boxes differ by
        /// more than 1/20 of their diagonal. Also refuses whatever flgTangleDivide and the other functions would
        /// refuse. Cost: that of the steps; on another mesh also about 0.2 us a triangle for each step that has points
        /// or made regions.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleReplay(
            FlgContext context, FlgTangle tangle, FlgTangleHistory* history, FlgJobOptions* job, FlgJob* out_job);

        /// <summary>
        /// Starts a job that replaces the arguments of a step. `desc` is read as flgTangleReplay reads a step of a
        /// history, so one from flgTangleGetHistory with other numbers will do; its regions are those before the step.
        /// The array is copied. Points are on the surface as it was then: where that is not known, set `placed` and
        /// give positions. A muted step stays muted. Fails if the step cannot be made. Cost: as above.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleEditStep(
            FlgContext context, FlgTangle tangle, uint step, FlgTangleStep* desc, FlgJobOptions* job, FlgJob* out_job);

        /// <summary>
        /// Likewise for a new step, which gets the index `step`: at most the number of steps that are not undone. Cost:
        /// as above.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleInsertStep(
            FlgContext context, FlgTangle tangle, uint step, FlgTangleStep* desc, FlgJobOptions* job, FlgJob* out_job);

        /// <summary>
        /// Starts a job that moves a step to another index, which it has afterwards. Before the step that makes its
        /// regions it is lost. Cost: as above.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleMoveStep(
            FlgContext context, FlgTangle tangle, uint step, uint to, FlgJobOptions* job, FlgJob* out_job);

        /// <summary>Starts a job that removes a step. Cost: as above.</summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleRemoveStep(
            FlgContext context, FlgTangle tangle, uint step, FlgJobOptions* job, FlgJob* out_job);

        /// <summary>
        /// Starts a job that mutes a step (`muted` nonzero), so that it does nothing, or makes it again (0). Cost: as
        /// above.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleMuteStep(
            FlgContext context, FlgTangle tangle, uint step, uint muted, FlgJobOptions* job, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleInfoInit(FlgTangleInfo* info, uint struct_size);

        /// <summary>
        /// FlgResult.NotReady until a job that changes the tangle is published; the surface's error if that failed.
        /// Cost: tens of nanoseconds a region.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleGetInfo(FlgContext context, FlgTangle tangle, FlgTangleInfo* out_info);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleRegionInit(FlgTangleRegion* region, uint struct_size);

        /// <summary>FlgResult.NotReady while the info is not ready. Cost: tens of nanoseconds.</summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleGetRegion(
            FlgContext context, FlgTangle tangle, uint region, FlgTangleRegion* out_region);

        public static FlgTangleSeedPlaces flgTangleSeedPlacesDefaults()
        {
            FlgTangleSeedPlaces made;
            flgTangleSeedPlacesInit(&made, (uint)sizeof(FlgTangleSeedPlaces));
            return made;
        }

        public static FlgTangleStep flgTangleStepDefaults()
        {
            FlgTangleStep made;
            flgTangleStepInit(&made, (uint)sizeof(FlgTangleStep));
            return made;
        }

        public static FlgTangleHistory flgTangleHistoryDefaults()
        {
            FlgTangleHistory made;
            flgTangleHistoryInit(&made, (uint)sizeof(FlgTangleHistory));
            return made;
        }

        public static FlgTangleRegion flgTangleRegionDefaults()
        {
            FlgTangleRegion made;
            flgTangleRegionInit(&made, (uint)sizeof(FlgTangleRegion));
            return made;
        }

        public static FlgTangleInfo flgTangleInfoDefaults()
        {
            FlgTangleInfo made;
            flgTangleInfoInit(&made, (uint)sizeof(FlgTangleInfo));
            return made;
        }

        public static FlgTangleSeeds flgTangleSeedsDefaults()
        {
            FlgTangleSeeds made;
            flgTangleSeedsInit(&made, (uint)sizeof(FlgTangleSeeds));
            return made;
        }

        public static FlgTangleDivideDesc flgTangleDivideDefaults()
        {
            FlgTangleDivideDesc made;
            flgTangleDivideDescInit(&made, (uint)sizeof(FlgTangleDivideDesc));
            return made;
        }

        public static FlgTangleApplyMacroDesc flgTangleApplyMacroDefaults()
        {
            FlgTangleApplyMacroDesc made;
            flgTangleApplyMacroDescInit(&made, (uint)sizeof(FlgTangleApplyMacroDesc));
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
