// SPDX-License-Identifier: MIT
// Functions of filigree_pull.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Surfaces pulled at any of their points (Sorkine, Alexa: As-rigid-as-possible surface modeling, 2007). Follows the
// grammar of filigree.h. Metres.
//
// Pull         What pulling needs of a mesh alone. Made once.
// Pulled       The mesh as handles pull it. Made again for each frame, from the one before.
// Keys         Positions of handles over time, recorded or made: a function of plain structs, no object.
//
// Neither Pull nor Pulled changes once ready. Both keep their inputs alive.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPullDescInit(FlgPullDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes and factors the mesh's matrix. Any triangles will do. Fails for meshes without
        /// triangles. Cost: 3 us and 0.5 KB a vertex.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPullCreate(
            FlgContext context, FlgPullDesc* desc, FlgPull* out_pull, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPullRelease(FlgContext context, FlgPull pull);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPullHandleInit(FlgPullHandle* handle, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPulledDescInit(FlgPulledDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that pulls a mesh. Handles are met after the first round; the rest follows, round by round,
        /// until each piece of the surface is turned against the pose but hardly stretched. Without handles the mesh is
        /// as the pose has it; handles that move as one body move all so. Pieces without handles stay. Of two handles
        /// at one place the first counts. Cost: 0.3 us a vertex and round, and 0.2 us a vertex for each handle that the
        /// previous one did not have: 3 ms for 10,000 vertices.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPulledCreate(
            FlgContext context, FlgPulledDesc* desc, FlgPulled* out_pulled, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPulledViewInit(FlgPulledView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the mesh is released. FlgResult.NotReady until its job is published, the job's error
        /// if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPulledGetView(FlgContext context, FlgPulled pulled, FlgPulledView* out_view);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPulledRelease(FlgContext context, FlgPulled pulled);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPullKeysInit(FlgPullKeys* keys, uint struct_size);

        /// <summary>
        /// [any thread] Where handles are at a time, for FlgPullHandle::position: at their keys exactly, smooth in
        /// between (velocities are continuous), at rest where two keys are at one place; before the first key and after
        /// the last where these are. `out_positions`: 3 per handle, metres. The same for the same keys, so a record can
        /// be played again, at any rate: the mesh too is the same if its frames are at the same times. Cost: 0.1 us a
        /// handle, and checking all keys.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPullKeysSample(FlgPullKeys* keys, double time, float* out_positions);

        public static FlgPullDesc flgPullDefaults()
        {
            FlgPullDesc made;
            flgPullDescInit(&made, (uint)sizeof(FlgPullDesc));
            return made;
        }

        public static FlgPullHandle flgPullHandleDefaults()
        {
            FlgPullHandle made;
            flgPullHandleInit(&made, (uint)sizeof(FlgPullHandle));
            return made;
        }

        public static FlgPulledDesc flgPulledDefaults()
        {
            FlgPulledDesc made;
            flgPulledDescInit(&made, (uint)sizeof(FlgPulledDesc));
            return made;
        }

        public static FlgPulledView flgPulledViewDefaults()
        {
            FlgPulledView made;
            flgPulledViewInit(&made, (uint)sizeof(FlgPulledView));
            return made;
        }

        public static FlgPullKeys flgPullKeysDefaults()
        {
            FlgPullKeys made;
            flgPullKeysInit(&made, (uint)sizeof(FlgPullKeys));
            return made;
        }
    }
}
