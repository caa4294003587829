// SPDX-License-Identifier: MIT
// Functions of filigree_skeleton.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Skeletons of drawn shapes. It follows the grammar of filigree.h. Lengths are in the drawing's own unit, whatever that
// is:
// drawings of 1e-12 and of 1e12 are alike.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContourViewInit(FlgContourView* view, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStraightSkeletonDescInit(FlgStraightSkeletonDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the straight skeleton of a contour: what the corners draw when all edges move
        /// inwards at unit speed. This call copies the contour and cleans it: rings are turned (ring 0
        /// counter-clockwise, holes clockwise), of points nearer to each other than 1e-11 of the drawing's size that
        /// follow each other the first is kept; points on one line with those around them stay, each with a face. It
        /// refuses numbers that aren't finite and rings without three points or an area, about 20 ns a point. The job
        /// fails with FlgResult.ErrorInvalidArgument, and a sentence that names points and place, where edges cross or
        /// touch and where a hole isn't inside. FlgResult.ErrorInternal if so much happens at one time that no skeleton
        /// is found that holds: not known to happen. Cost: about 3 us a point, more in all the larger by n log n. With
        /// `repair` nothing of this is refused while an area is left: the contour becomes the border of what ring 0
        /// winds around, either way, without what other rings wind around; of its connected parts the largest one, with
        /// its holes. Where nothing crosses or touches points stay to the bit, else they move by less than 1e-7 of the
        /// drawing's size (at points where it touches itself some 1e-6), and where edges cross there are new ones:
        /// their input_points are FLG_NO_INDEX. Costs about 2 us a point more.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStraightSkeletonCreate(
            FlgContext context, FlgStraightSkeletonDesc* desc, FlgStraightSkeleton* out_skeleton, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStraightSkeletonViewInit(FlgStraightSkeletonView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the skeleton is released. FlgResult.NotReady before its job is published, its error if
        /// it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStraightSkeletonGetView(
            FlgContext context, FlgStraightSkeleton skeleton, FlgStraightSkeletonView* out_view);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStraightSkeletonRelease(FlgContext context, FlgStraightSkeleton skeleton);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgOffsetPolygonsInit(FlgOffsetPolygons* polygons, uint struct_size);

        /// <summary>
        /// The contour moved inwards by a distance, with its corners kept sharp: rings with what is inside on their
        /// left, each from the side of its edge of least number on, in the order of these. 0 gives the contour; beyond
        /// its last node's time nothing is left. Writes the counts, and the arrays where all of it has room: call it
        /// without arrays to learn how much. FlgResult.NotReady before the skeleton's job is published, its error if it
        /// failed; FlgResult.ErrorInvalidArgument for a distance below 0 or not finite. Cost: about 50 ns a point of
        /// the contour, each time.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStraightSkeletonOffset(
            FlgContext context, FlgStraightSkeleton skeleton, double distance, FlgOffsetPolygons* polygons);

        public static FlgContourView flgContourViewDefaults()
        {
            FlgContourView made;
            flgContourViewInit(&made, (uint)sizeof(FlgContourView));
            return made;
        }

        public static FlgStraightSkeletonDesc flgStraightSkeletonDefaults()
        {
            FlgStraightSkeletonDesc made;
            flgStraightSkeletonDescInit(&made, (uint)sizeof(FlgStraightSkeletonDesc));
            return made;
        }

        public static FlgOffsetPolygons flgOffsetPolygonsDefaults()
        {
            FlgOffsetPolygons made;
            flgOffsetPolygonsInit(&made, (uint)sizeof(FlgOffsetPolygons));
            return made;
        }

        public static FlgStraightSkeletonView flgStraightSkeletonViewDefaults()
        {
            FlgStraightSkeletonView made;
            flgStraightSkeletonViewInit(&made, (uint)sizeof(FlgStraightSkeletonView));
            return made;
        }
    }
}
