// SPDX-License-Identifier: MIT
// Functions of filigree_skeleton.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Skeletons of drawn shapes. Follows the grammar of filigree.h. Lengths are in the drawing's own unit, whatever it is:
// drawings of size 1e-12 and 1e12 work alike.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgContourViewInit(FlgContourView* view, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStraightSkeletonDescInit(FlgStraightSkeletonDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the straight skeleton of a contour: the paths of its corners as all edges move
        /// inwards at unit speed. This call copies and cleans the contour: it orients rings (ring 0 counter-clockwise,
        /// holes clockwise) and merges consecutive points closer than 1e-11 of the drawing's size into the first.
        /// Collinear points stay, each with a face. The call refuses numbers that are not finite and rings without
        /// three points or an area; it takes about 20 ns a point. The job fails with FlgResult.ErrorInvalidArgument
        /// where edges cross or touch, or a hole is not inside; the message names points and place.
        /// FlgResult.ErrorInternal if too much happens at one time to find a valid skeleton: not known to occur. Cost:
        /// about 3 us a point, growing with n log n. With `repair` none of this fails while an area is left. The
        /// contour becomes the border of the area that ring 0 winds around, either way, minus the areas other rings
        /// wind around; of its connected parts, the largest is kept, with its holes. Where nothing crosses or touches,
        /// points do not move, to the bit. Elsewhere they move by less than 1e-7 of the drawing's size (about 1e-6 at
        /// points where the contour touches itself). Crossings get new points, whose input_points are FLG_NO_INDEX.
        /// Repair adds about 2 us a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStraightSkeletonCreate(
            FlgContext context, FlgStraightSkeletonDesc* desc, FlgStraightSkeleton* out_skeleton, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStraightSkeletonViewInit(FlgStraightSkeletonView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the skeleton is released. FlgResult.NotReady until its job is published, the job's
        /// error if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStraightSkeletonGetView(
            FlgContext context, FlgStraightSkeleton skeleton, FlgStraightSkeletonView* out_view);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStraightSkeletonRelease(FlgContext context, FlgStraightSkeleton skeleton);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgOffsetPolygonsInit(FlgOffsetPolygons* polygons, uint struct_size);

        /// <summary>
        /// The contour moved inwards by a distance, with sharp corners. Rings have their inside on the left; each
        /// starts at the side of its lowest-numbered edge, and rings are ordered by these edges. 0 gives the contour;
        /// beyond the last node's time nothing is left. Writes the counts, and the arrays if everything fits: call it
        /// without arrays to query the size. FlgResult.NotReady until the skeleton's job is published, its error if it
        /// failed; FlgResult.ErrorInvalidArgument for a distance below 0 or not finite. Cost: about 50 ns a point of
        /// the contour, each time.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
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
