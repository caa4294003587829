// SPDX-License-Identifier: MIT
// Functions of filigree_motion.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Smooth motions of rigid bodies through keyframes (Hofer, Pottmann: Energy-minimizing splines in manifolds, 2004, sec.
// 4). Follows the grammar of filigree.h. Metres, seconds, doubles. Also for cameras and anything else with a position
// and a rotation.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionDescInit(FlgMotionDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the motion of least energy through keys, or near them: the sum over the body's
        /// points of the energies of their paths. The barycentre's path is then the classical spline. At every moment
        /// the fourth derivatives (E1: the second ones) of the points' paths, taken as forces, are in balance: they
        /// neither push nor turn the body. Between keys a body turns the shorter way round; to force the longer way,
        /// add a key in between. Two consecutive keys with the same pose are a pause: the body comes to rest, stands
        /// still and leaves from rest (not with smoothing, which passes near both). The job fails with
        /// FlgResult.ErrorInvalidArgument for fewer than two keys, times that do not rise by 1e-9 of the whole motion,
        /// numbers that are not finite, poses that reflect or that stretch by more than 0.001 (less is removed), found
        /// times between keys with the same pose, eases that are not from 0 to 1, and keys whose barycentre is in an
        /// obstacle; the message names the key. Cost: some 15 us a position, closed 20, with E1 40; re-timing and
        /// looking 1 to 5 more; around obstacles what the spline there costs.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionCreate(
            FlgContext context, FlgMotionDesc* desc, FlgMotion* out_motion, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionViewInit(FlgMotionView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the motion is released; while it runs, until the next flgContextTick.
        /// FlgResult.NotReady until its job is published (with partial_results: until its first round), the job's error
        /// if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionGetView(FlgContext context, FlgMotion motion, FlgMotionView* out_view);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
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
