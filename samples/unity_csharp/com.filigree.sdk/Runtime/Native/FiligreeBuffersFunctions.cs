// SPDX-License-Identifier: MIT
// Functions of filigree_buffers.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Results into the host's own buffers: vertex and index buffers, mapped memory of a graphics card included. Each
// column gets its own address, stride and number format. Same grammar and rules as filigree.h.
//
//     FlgBufferColumn columns[2] = {{0}};
//     columns[0].attribute = FlgAttribute.Position;      columns[0].data = map;
//     columns[0].format = FlgNumberFormat.Float32;      columns[0].stride = 16;
//     columns[1].attribute = FlgAttribute.Color;         columns[1].data = map + 12;
//     columns[1].format = FlgNumberFormat.Unorm8;       columns[1].stride = 16;
//     FlgBufferOutput output = flgBufferOutputDefaults(); output.columns = columns;
//     output.column_count = 2;                            output.row_capacity = 100000;
//     flgCurveSetWrite(context, curves, &output, NULL, &job);
//
// At once      flgColumnsWrite and flgIndicesWrite write what a view shows, of live strokes, tips and partial
//              results too. They need no context and allocate nothing.
// By a job     The other functions take a handle, whose job may still run, and write where jobs run: on a worker, or
//              inside flgContextTick. The handle may be released at once. The buffers must live until the job is
//              published; the structs that describe them only for the call.
// Room         The counts of a result's view say how many rows and indices it has.
// Writing      From front to back, only the components, nothing between them; buffers are never read. They must
//              not overlap each other, nor the input.
// Failure      Everything is checked before the first byte is written: a job or call that fails has written nothing. A
//              job that is cancelled may have written a part.
// Determinism  The same bits at once and by a job, under any number of workers. FLOAT32 keeps the bits of the view.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgBufferOutputInit(FlgBufferOutput* output, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgColumnsWriteDescInit(FlgColumnsWriteDesc* desc, uint struct_size);

        /// <summary>
        /// [any thread] Writes columns of any view. Values may be infinite, as distances are, or no numbers: see
        /// FlgNumberFormat. Errors: FlgResult.ErrorInvalidArgument, also for buffers that are too small, unaligned or
        /// overlap. Cost: as memcpy for packed floats; else 1 to 3 ns a number.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgColumnsWrite(FlgColumnsWriteDesc* desc);

        /// <summary>
        /// [any thread] Writes indices of triangles: `index_count`, 3 each. Errors: FlgResult.ErrorInvalidArgument as
        /// above; FlgResult.ErrorLimit for indices that the format cannot hold: 65534 is the largest of UINT16, 2^32 -
        /// 2 of UINT32. Cost: one pass to check and one to write, below 1 ns an index.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgIndicesWrite(uint* indices, uint index_count, FlgBufferOutput* output);

        /// <summary>Starts a job that writes the columns of curves. Cost: that of flgColumnsWrite.</summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveSetWrite(
            FlgContext context, FlgCurveSet curves, FlgBufferOutput* output, FlgJobOptions* job, FlgJob* out_job);

        /// <summary>
        /// Starts a job that writes columns, indices and regions of a surface, as it is after the changes that were
        /// started before. Later changes wait for the job. Cost: that of flgColumnsWrite and flgIndicesWrite.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceWrite(
            FlgContext context, FlgSurface surface, FlgBufferOutput* output, FlgJobOptions* job, FlgJob* out_job);

        /// <summary>
        /// Starts a job that writes a field's columns: VALUE and, if it has labels, LABEL; FLG_NO_INDEX becomes the
        /// largest number of a narrow format. Cost: that of flgColumnsWrite.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldWrite(
            FlgContext context, FlgField field, FlgBufferOutput* output, FlgJobOptions* job, FlgJob* out_job);

        /// <summary>
        /// Starts a job that writes a skin's indices and columns: POSITION, NORMAL, JOINTS, WEIGHTS and PART. As UNORM8
        /// and UNORM16 the largest weight gets what makes the sum exactly 1. (flgSkinPose writes matrices into the
        /// host's memory anyway.) Cost: that of flgColumnsWrite and flgIndicesWrite.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinWrite(
            FlgContext context, FlgSkin skin, FlgBufferOutput* output, FlgJobOptions* job, FlgJob* out_job);

        /// <summary>
        /// Starts a job that writes indices and column POSITION of a part's body. Cost: that of flgColumnsWrite and
        /// flgIndicesWrite.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartMeshWrite(
            FlgContext context, FlgPartMesh mesh, FlgBufferOutput* output, FlgJobOptions* job, FlgJob* out_job);

        public static FlgColumnsWriteDesc flgColumnsWriteDefaults()
        {
            FlgColumnsWriteDesc made;
            flgColumnsWriteDescInit(&made, (uint)sizeof(FlgColumnsWriteDesc));
            return made;
        }

        public static FlgBufferOutput flgBufferOutputDefaults()
        {
            FlgBufferOutput made;
            flgBufferOutputInit(&made, (uint)sizeof(FlgBufferOutput));
            return made;
        }
    }
}
