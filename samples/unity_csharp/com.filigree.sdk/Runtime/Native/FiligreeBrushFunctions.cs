// SPDX-License-Identifier: MIT
// Functions of filigree_brush.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Brush meshes: triangles of ribbons and tubes along curves, written into the host's own buffers. Same grammar and
// rules as filigree.h, but no context, no job and no allocation: the functions work on the calling thread.
//
//     FlgBrushMeshDesc desc = flgBrushMeshDefaults();      desc.curves = &view;
//     flgBrushMeshGetSizes(&desc, NULL, &sizes);           how much room it takes
//     ...                                                  map buffers, point `out` at them
//     flgBrushMeshWrite(&desc, NULL, &out, NULL);          fill them
//
// A growing stroke keeps an FlgBrushMeshState. Each call then takes the new points alone, and writes their vertices and
// triangles, those of the last point before them, which only now has a direction, and the end's cap:
//
//     FlgBrushMeshState state = flgBrushMeshStateDefaults();
//     flgBrushMeshGetSizes(&desc, &state, &sizes);         desc.curves: the new points
//     ...                                                  map sizes.vertex_count vertices from sizes.first_vertex on,
//                                                          sizes.index_count indices from sizes.first_index on
//     flgBrushMeshWrite(&desc, &state, &out, NULL);        after it the buffers hold the bits of the whole stroke
//
// A copy of the state is a bookmark: write a provisional tip with the copy, then go on from the original.
//
// Layout       By curve: the vertices of the start's cap, of the points in order, of the end's cap; triangles likewise.
//              Triangles are counter-clockwise seen from outside, those of ribbons from the side of their normals.
// Points       Consecutive repeated points count once. Curves without length leave nothing.
// Frames       Rotation-minimizing (double reflection); closed curves spread their twist evenly. Ribbons follow a
//              NORMAL column, made perpendicular to the curve, on the side that keeps them from crossing over
//              themselves; where it lies along the curve, the frame is carried on. Tubes do not need one and ignore it.
// Determinism  Same input, same bits, however a stroke is divided into calls.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgBrushMeshDescInit(FlgBrushMeshDesc* desc, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgBrushMeshStateInit(FlgBrushMeshState* state, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgBrushMeshSizesInit(FlgBrushMeshSizes* sizes, uint struct_size);

        /// <summary>
        /// [any thread] The sizes of what flgBrushMeshWrite would write for the same arguments. `state` may be null and
        /// is not changed. FlgResult.ErrorLimit above 2^32 - 1 vertices. Cost: one pass over the points, about 20 ns
        /// each.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgBrushMeshGetSizes(
            FlgBrushMeshDesc* desc, FlgBrushMeshState* state, FlgBrushMeshSizes* out_sizes);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgBrushMeshOutputInit(FlgBrushMeshOutput* output, uint struct_size);

        /// <summary>
        /// [any thread] Writes vertices and triangles. With a `state` the range must be one open curve, which continues
        /// the points of the calls before; the descriptor must otherwise be the same for all of them. `out_sizes` may
        /// be null. On failure nothing is written, and the state stays as it was. Errors:
        /// FlgResult.ErrorInvalidArgument (also for values that are not finite, buffers that are too small, unaligned
        /// or overlap), FlgResult.ErrorLimit for indices that the format cannot hold. Cost: about 0.25 us a point of a
        /// tube of 8 sides with positions, normals and indices; one core.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgBrushMeshWrite(
            FlgBrushMeshDesc* desc, FlgBrushMeshState* state, FlgBrushMeshOutput* output, FlgBrushMeshSizes* out_sizes);

        public static FlgBrushMeshDesc flgBrushMeshDefaults()
        {
            FlgBrushMeshDesc made;
            flgBrushMeshDescInit(&made, (uint)sizeof(FlgBrushMeshDesc));
            return made;
        }

        public static FlgBrushMeshState flgBrushMeshStateDefaults()
        {
            FlgBrushMeshState made;
            flgBrushMeshStateInit(&made, (uint)sizeof(FlgBrushMeshState));
            return made;
        }

        public static FlgBrushMeshSizes flgBrushMeshSizesDefaults()
        {
            FlgBrushMeshSizes made;
            flgBrushMeshSizesInit(&made, (uint)sizeof(FlgBrushMeshSizes));
            return made;
        }

        public static FlgBrushMeshOutput flgBrushMeshOutputDefaults()
        {
            FlgBrushMeshOutput made;
            flgBrushMeshOutputInit(&made, (uint)sizeof(FlgBrushMeshOutput));
            return made;
        }
    }
}
