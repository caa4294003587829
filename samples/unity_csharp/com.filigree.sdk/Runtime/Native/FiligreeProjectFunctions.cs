// SPDX-License-Identifier: MIT
// Functions of filigree_project.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Curves in space laid onto surfaces: strokes drawn near a surface, stylized borders, outlines. It follows the grammar
// of filigree.h
// and filigree_surface.h.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgProjectDescInit(FlgProjectDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that lays curves in space onto a surface, to be cut in: each point goes to the surface's point
        /// nearest to it, and between two points the curve follows the plane through both and the surface's normal
        /// there, or, where no such way leads from one to the other, a shortest path. curve_values are lengths. Curves
        /// that come to a single point are left out. Fails if consecutive points come to parts of the surface that do
        /// not hang together. Cost: 0.1 us a triangle of the surface, some us a point near it (more the farther off)
        /// and 0.1 us a triangle passed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgProjectCurves(
            FlgContext context, FlgProjectDesc* desc, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        public static FlgProjectDesc flgProjectDefaults()
        {
            FlgProjectDesc made;
            flgProjectDescInit(&made, (uint)sizeof(FlgProjectDesc));
            return made;
        }
    }
}
