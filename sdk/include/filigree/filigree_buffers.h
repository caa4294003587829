/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Results into the host's own buffers: vertex and index buffers, mapped memory of a graphics card included. Each
 * column gets its own address, stride and number format. Same grammar and rules as filigree.h.
 *
 *     FlgBufferColumn columns[2] = {{0}};
 *     columns[0].attribute = FLG_ATTRIBUTE_POSITION;      columns[0].data = map;
 *     columns[0].format = FLG_NUMBER_FORMAT_FLOAT32;      columns[0].stride = 16;
 *     columns[1].attribute = FLG_ATTRIBUTE_COLOR;         columns[1].data = map + 12;
 *     columns[1].format = FLG_NUMBER_FORMAT_UNORM8;       columns[1].stride = 16;
 *     FlgBufferOutput output = flgBufferOutputDefaults(); output.columns = columns;
 *     output.column_count = 2;                            output.row_capacity = 100000;
 *     flgCurveSetWrite(context, curves, &output, NULL, &job);
 *
 * At once      flgColumnsWrite and flgIndicesWrite write what a view shows, of live strokes, tips and partial
 *              results too. They need no context and allocate nothing.
 * By a job     The other functions take a handle, whose job may still run, and write where jobs run: on a worker, or
 *              inside flgContextTick. The handle may be released at once. The buffers must live until the job is
 *              published; the structs that describe them only for the call.
 * Room         The counts of a result's view say how many rows and indices it has.
 * Writing      From front to back, only the components, nothing between them; buffers are never read. They must
 *              not overlap each other, nor the input.
 * Failure      Everything is checked before the first byte is written: a job or call that fails has written nothing. A
 *              job that is cancelled may have written a part.
 * Determinism  The same bits at once and by a job, under any number of workers. FLOAT32 keeps the bits of the view.
 */
#ifndef FILIGREE_FILIGREE_BUFFERS_H
#define FILIGREE_FILIGREE_BUFFERS_H

#include "filigree.h"
#include "filigree_model.h"
#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The buffers, and which part of a result they get. */
typedef struct FlgBufferOutput {
    uint32_t struct_size;
    uint32_t column_count;          /* 0 to 16 */
    const FlgBufferColumn* columns; /* those that are wanted */
    uint64_t row_capacity;          /* rows that every column has room for */
    /* The points or vertices to write, and the triangles. */
    uint32_t first_row;             /* default 0 */
    uint32_t row_count;             /* default FLG_UNLIMITED: all the rest */
    uint32_t first_triangle;        /* default 0 */
    uint32_t triangle_count;        /* default FLG_UNLIMITED: all the rest */
    void* indices;                  /* three a triangle, for meshes alone; null: not wanted */
    uint64_t index_capacity;        /* indices that `indices` has room for */
    void* regions;                  /* a label a triangle, for surfaces alone; null: not wanted */
    uint64_t region_capacity;       /* labels that `regions` has room for */
    FlgNumberFormat index_format;   /* UINT32 or UINT16. Default UINT32 */
    FlgNumberFormat region_format;  /* UINT32, UINT16 or UINT8. Default UINT32 */
    /* 3 doubles, metres, magnitude at most 1e30, read during the call: what the host counts positions from. The
     * result's own origin minus this is added in doubles. Null: positions stay as they are, relative to the result's
     * origin. */
    const double* origin;
    uint32_t base_vertex;           /* added to all indices: the buffer's vertices before these. Default 0 */
    /* Nonzero: for left-handed hosts with y up. Negates z of positions, normals, tangents and displacements, x and y of
     * orientations, angles about the tangent; and reverses triangles. Default 0. */
    uint32_t left_handed;
} FlgBufferOutput;

FLG_API FlgResult flgBufferOutputInit(FlgBufferOutput* output, uint32_t struct_size);

/* ---- At once --------------------------------------------------------------------------------------------------- */

/* Columns of any view, and where they go. */
typedef struct FlgColumnsWriteDesc {
    uint32_t struct_size;
    uint32_t column_count;    /* 1 to 16, each attribute at most once */
    const FlgColumn* columns; /* those of a view, or made of its arrays: FLG_ATTRIBUTE_VALUE of a field's, say */
    uint32_t row_count;       /* rows that every column has */
    uint32_t reserved;
    const FlgBufferOutput* output;
    double origin[3];         /* metres: what positions are relative to; the view's. Default 0 */
} FlgColumnsWriteDesc;

FLG_API FlgResult flgColumnsWriteDescInit(FlgColumnsWriteDesc* desc, uint32_t struct_size);

/* [any thread] Writes columns of any view. Values may be infinite, as distances are, or no numbers: see
 * FlgNumberFormat. Errors: FLG_ERROR_INVALID_ARGUMENT, also for buffers that are too small, unaligned or overlap. Cost:
 * as memcpy for packed floats; else 1 to 3 ns a number. */
FLG_API FlgResult flgColumnsWrite(const FlgColumnsWriteDesc* desc);

/* [any thread] Writes indices of triangles: `index_count`, 3 each. Errors: FLG_ERROR_INVALID_ARGUMENT as above;
 * FLG_ERROR_LIMIT for indices that the format cannot hold: 65534 is the largest of UINT16, 2^32 - 2 of UINT32. Cost:
 * one pass to check and one to write, below 1 ns an index. */
FLG_API FlgResult flgIndicesWrite(const uint32_t* indices, uint32_t index_count, const FlgBufferOutput* output);

/* ---- By jobs --------------------------------------------------------------------------------------------------- */
/* Each starts a job. `job` may be null: defaults. The call itself fails where the result is ready and does not fit; the
 * job fails where that turns out later. Errors: those of flgColumnsWrite and flgIndicesWrite, and FLG_ERROR_LIMIT for
 * whole numbers that a narrow format cannot hold. */

/* Starts a job that writes the columns of curves. Cost: that of flgColumnsWrite. */
FLG_API FlgResult flgCurveSetWrite(FlgContext context, FlgCurveSet curves, const FlgBufferOutput* output,
                                   const FlgJobOptions* job, FlgJob* out_job);

/* Starts a job that writes columns, indices and regions of a surface, as it is after the changes that were started
 * before. Later changes wait for the job. Cost: that of flgColumnsWrite and flgIndicesWrite. */
FLG_API FlgResult flgSurfaceWrite(FlgContext context, FlgSurface surface, const FlgBufferOutput* output,
                                  const FlgJobOptions* job, FlgJob* out_job);

/* Starts a job that writes a field's columns: VALUE and, if it has labels, LABEL; FLG_NO_INDEX becomes the largest
 * number of a narrow format. Cost: that of flgColumnsWrite. */
FLG_API FlgResult flgFieldWrite(FlgContext context, FlgField field, const FlgBufferOutput* output,
                                const FlgJobOptions* job, FlgJob* out_job);

/* Starts a job that writes a skin's indices and columns: POSITION, NORMAL, JOINTS, WEIGHTS and PART. As UNORM8 and
 * UNORM16 the largest weight gets what makes the sum exactly 1. (flgSkinPose writes matrices into the host's memory
 * anyway.) Cost: that of flgColumnsWrite and flgIndicesWrite. */
FLG_API FlgResult flgSkinWrite(FlgContext context, FlgSkin skin, const FlgBufferOutput* output,
                               const FlgJobOptions* job, FlgJob* out_job);

/* Starts a job that writes indices and column POSITION of a part's body. Cost: that of flgColumnsWrite and
 * flgIndicesWrite. */
FLG_API FlgResult flgPartMeshWrite(FlgContext context, FlgPartMesh mesh, const FlgBufferOutput* output,
                                   const FlgJobOptions* job, FlgJob* out_job);

/* ---- Defaults by value --------------------------------------------------------------------------------------- */

static inline FlgColumnsWriteDesc flgColumnsWriteDefaults(void) {
    FlgColumnsWriteDesc desc;
    flgColumnsWriteDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgBufferOutput flgBufferOutputDefaults(void) {
    FlgBufferOutput output;
    flgBufferOutputInit(&output, (uint32_t)sizeof output);
    return output;
}

#ifdef __cplusplus
}
#endif

#endif
