// SPDX-License-Identifier: MIT
// Functions of filigree_bake.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Ornament as maps: what a tangle divided, drawn into the texture coordinates of the mesh that its surface was made of,
// for assets whose triangles must stay as they are. Follows the grammar of filigree.h and filigree_tangle.h.
//
// Maps         Square, `size` texels a side, rows from the top, tightly packed, in the host's memory. Texture
//              coordinates 0 0 are the upper left corner of the first texel, 1 1 the lower right one of the last. A
//              texel shows what is at its centre.
// Charts       What triangles cover. Each texel is covered once: overlapping triangles are refused.
// Padding      Texels up to `padding` texels from a chart are copies of the chart's nearest texel (of equally near
//              ones, that in the nearest column), so that filters and mip levels meet no background: level k needs
//              2^k texels. Texels farther away are background.
// Shape        Maps are for the mesh as it was before displacement: lengths are measured on it.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleBakeDescInit(FlgTangleBakeDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that draws maps of a tangle as it is after the changes that were started before; later changes
        /// wait for the job. It writes the maps and, for the padding, reads them back, on a worker or inside
        /// flgContextTick: they must live until it is published, and must not overlap. A job that fails or is cancelled
        /// may have written a part. Fails with FlgResult.ErrorInvalidArgument if a texture coordinate is not finite or
        /// outside 0 to 1, if triangles overlap, if none covers a texel, or if `mesh` is not what the surface was made
        /// of. Cost: about 60 ns a texel that is covered, and 0.5 us a triangle of the surface.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleBake(FlgContext context, FlgTangleBakeDesc* desc, FlgJob* out_job);

        public static FlgTangleBakeDesc flgTangleBakeDefaults()
        {
            FlgTangleBakeDesc made;
            flgTangleBakeDescInit(&made, (uint)sizeof(FlgTangleBakeDesc));
            return made;
        }
    }
}
