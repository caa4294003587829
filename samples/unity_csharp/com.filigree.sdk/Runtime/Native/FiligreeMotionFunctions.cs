// SPDX-License-Identifier: MIT
// Functions of filigree_motion.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Smooth motions of rigid bodies through keyframes (Hofer, Pottmann: Energy-minimizing splines in manifolds, 2004, sec.
// 4). It
// follows the grammar of filigree.h. Metres, seconds, doubles. Also for cameras and whatever else has a place and a
// rotation.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionDescInit(FlgMotionDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the motion of least energy through keys, or near them: the sum over the body's
        /// points of the energies of their paths. Then the barycentre's path is the classical spline, and at every
        /// moment the fourth derivatives (E1: the second ones) of the points' paths, taken as forces, are in balance:
        /// they neither push nor turn the body. Between keys a body takes the shorter way round; put a key between
        /// where it is to take the longer one. The job fails with FlgResult.ErrorInvalidArgument, and a sentence that
        /// names the key, for fewer than two keys, times that do not rise by 1e-9 of the whole motion, numbers that are
        /// not finite, poses with reflections or that stretch by more than 0.001 (less is taken off), two keys in a row
        /// with one pose, and keys whose barycentre is in an obstacle. Cost: some 15 us a position, closed 20; around
        /// obstacles what the spline there costs.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionCreate(
            FlgContext context, FlgMotionDesc* desc, FlgMotion* out_motion, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionViewInit(FlgMotionView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the motion is released; of running ones until the next flgTick. FlgResult.NotReady
        /// before its job is published (with partial_results: before its first round), its error if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionGetView(FlgContext context, FlgMotion motion, FlgMotionView* out_view);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionRelease(FlgContext context, FlgMotion motion);

        public static FlgMotionDesc flgMotionDefaults()
        {
            FlgMotionDesc made;
            flgMotionDescInit(&made, (uint)sizeof(FlgMotionDesc));
            return made;
        }

        public static FlgMotionView flgMotionViewDefaults()
        {
            FlgMotionView made;
            flgMotionViewInit(&made, (uint)sizeof(FlgMotionView));
            return made;
        }
    }
}
