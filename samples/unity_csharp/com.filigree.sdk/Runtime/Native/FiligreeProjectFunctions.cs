// SPDX-License-Identifier: MIT
// Functions of filigree_project.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Projects curves in space onto surfaces: strokes drawn near a surface, stylized borders, outlines. Follows the grammar
// of filigree.h and filigree_surface.h.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetProjectDescInit(FlgCurveSetProjectDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that projects curves in space onto a surface, ready to be cut along: each point snaps to the
        /// nearest point of the surface. Between two points the curve follows the plane through both and the surface's
        /// normal there or, if that leads nowhere, a shortest path. curve_values are lengths. Curves that collapse to a
        /// single point are omitted. Fails if consecutive points fall on disconnected parts of the surface. Cost: 0.1
        /// us a triangle of the surface, some us a point near it (more the farther off) and 0.1 us a triangle passed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetProject(
            FlgContext context, FlgCurveSetProjectDesc* desc, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        public static FlgCurveSetProjectDesc flgCurveSetProjectDefaults()
        {
            FlgCurveSetProjectDesc made;
            flgCurveSetProjectDescInit(&made, (uint)sizeof(FlgCurveSetProjectDesc));
            return made;
        }
    }
}
