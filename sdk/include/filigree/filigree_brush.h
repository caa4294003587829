/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Brush meshes: triangles of ribbons and tubes along curves, written into the host's own buffers. Same grammar and
 * rules as filigree.h, but no context, no job and no allocation: the functions work on the calling thread.
 *
 *     FlgBrushMeshDesc desc = flgBrushMeshDefaults();      desc.curves = &view;
 *     flgBrushMeshGetSizes(&desc, NULL, &sizes);           how much room it takes
 *     ...                                                  map buffers, point `out` at them
 *     flgBrushMeshWrite(&desc, NULL, &out, NULL);          fill them
 *
 * A growing stroke keeps an FlgBrushMeshState. Each call then takes the new points alone, and writes their vertices and
 * triangles, those of the last point before them, which only now has a direction, and the end's cap:
 *
 *     FlgBrushMeshState state = flgBrushMeshStateDefaults();
 *     flgBrushMeshGetSizes(&desc, &state, &sizes);         desc.curves: the new points
 *     ...                                                  map sizes.vertex_count vertices from sizes.first_vertex on,
 *                                                          sizes.index_count indices from sizes.first_index on
 *     flgBrushMeshWrite(&desc, &state, &out, NULL);        after it the buffers hold the bits of the whole stroke
 *
 * A copy of the state is a bookmark: write a provisional tip with the copy, then go on from the original.
 *
 * Layout       By curve: the vertices of the start's cap, of the points in order, of the end's cap; triangles likewise.
 *              Triangles are counter-clockwise seen from outside, those of ribbons from the side of their normals.
 * Points       Consecutive repeated points count once. Curves without length leave nothing.
 * Frames       Rotation-minimizing (double reflection); closed curves spread their twist evenly. Ribbons follow a
 *              NORMAL column, made perpendicular to the curve, on the side that keeps them from crossing over
 *              themselves; where it lies along the curve, the frame is carried on. Tubes do not need one and ignore it.
 * Determinism  Same input, same bits, however a stroke is divided into calls.
 */
#ifndef FILIGREE_FILIGREE_BRUSH_H
#define FILIGREE_FILIGREE_BRUSH_H

#include "filigree.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The cross-section of a brush mesh. */
typedef enum FlgBrushShape {
    FLG_BRUSH_SHAPE_RIBBON = 0, /* flat, along the frame's second normal (tangent x normal), facing the first */
    FLG_BRUSH_SHAPE_TUBE = 1,   /* round, with `sides` sides */
    FLG_BRUSH_SHAPE_FORCE_32BIT = 0x7fffffff
} FlgBrushShape;

/* The end of an open curve. An end of radius 0 gets none. */
typedef enum FlgBrushCap {
    FLG_BRUSH_CAP_NONE = 0,    /* tubes are open */
    FLG_BRUSH_CAP_FLAT = 1,    /* a disc; ribbons end flat without one */
    FLG_BRUSH_CAP_ROUND = 2,   /* half a sphere, of ribbons half a disc, beyond the curve's end */
    FLG_BRUSH_CAP_TAPERED = 3, /* a tip beyond the curve's end: `cap_length` radii long */
    FLG_BRUSH_CAP_FORCE_32BIT = 0x7fffffff
} FlgBrushCap;

/* How the segments on both sides of a corner meet. Smaller turns are always mitered. */
typedef enum FlgBrushJoin {
    FLG_BRUSH_JOIN_MITER = 0,  /* extended until they meet; bevelled where that takes more than 4 radii (turns above 151
                                  degrees) */
    FLG_BRUSH_JOIN_BEVEL = 1,  /* cut straight */
    FLG_BRUSH_JOIN_ROUND = 2,  /* turned about the point, in steps as fine as the tube's sides */
    FLG_BRUSH_JOIN_NARROW = 3, /* not extended: the mesh gets thinner, also in turns that are no corner. Cheapest */
    FLG_BRUSH_JOIN_FORCE_32BIT = 0x7fffffff
} FlgBrushJoin;

/* In what texture coordinates are measured. */
typedef enum FlgBrushUv {
    FLG_BRUSH_UV_UNIT = 0,   /* 0 to 1 */
    FLG_BRUSH_UV_METRES = 1, /* metres */
    FLG_BRUSH_UV_FORCE_32BIT = 0x7fffffff
} FlgBrushUv;

/* What to make, and of which curves. */
typedef struct FlgBrushMeshDesc {
    uint32_t struct_size;
    FlgBrushShape shape; /* default FLG_BRUSH_SHAPE_TUBE */
    /* The curves. Columns read: POSITION; RADIUS, a tube's, or half the width of a ribbon; COLOR; NORMAL by ribbons.
     * They must live for the call. */
    const FlgCurveSetView* curves;
    /* The range to make, as if the view held nothing else: `curve_count` curves from `first_curve` on; of each, the
     * points from number `first_point` on. */
    uint32_t first_curve;      /* default 0 */
    uint32_t curve_count;      /* at least 1. Default FLG_UNLIMITED: all the rest */
    uint32_t first_point;      /* of each curve of the range. Default 0 */
    uint32_t sides;            /* of a tube, 3 to 64; also sets how fine round caps and joins are. Default 8 */
    /* Metres, >= 0: a curve gets as few sides as keep its tube within it of a round one, 3 to `sides`: for levels of
     * detail. 0: always `sides`. Must be 0 with a state. Default 0. */
    float tolerance;
    float default_radius;      /* metres, >= 0, without a RADIUS column. Default 0.005 */
    float radius_scale;        /* >= 0: factor on all radii. Default 1 */
    float default_color[4];    /* linear RGBA, without a COLOR column. Default white */
    FlgBrushCap start_cap;     /* default FLG_BRUSH_CAP_FLAT */
    FlgBrushCap end_cap;       /* default FLG_BRUSH_CAP_FLAT */
    float cap_length;          /* of tapered caps, in radii, >= 0, at most 1000. Default 2 */
    FlgBrushJoin join;         /* default FLG_BRUSH_JOIN_MITER */
    float corner_angle;        /* radians, 0 to pi: larger turns are corners for BEVEL and ROUND. Default pi / 4 */
    uint32_t hard_normals;     /* nonzero: each side of a tube is flat, with vertices of its own. Default 0 */
    /* Nonzero: vertices for texture coordinates: where these jump, from the last side of a tube to the first and from
     * the end of a closed curve to its start, vertices are repeated. Default 0: shared; no UV column. */
    uint32_t uv;
    FlgBrushUv uv_along;       /* the first coordinate. UNIT must not be used with a state. Default METRES */
    FlgBrushUv uv_around;      /* the second: around a tube, across a ribbon. Default UNIT */
    /* Nonzero: for left-handed hosts with y up. Negates z of positions, normals and tangents, and reverses triangles.
     * Default 0. */
    uint32_t left_handed;
    uint32_t base_vertex;      /* added to all indices: the buffer's vertices before this mesh. Default 0 */
    uint32_t reserved;         /* 0 */
} FlgBrushMeshDesc;

FLG_API FlgResult flgBrushMeshDescInit(FlgBrushMeshDesc* desc, uint32_t struct_size);

/* Where a growing stroke is. One per stroke; plain data that the host may copy, but not change. */
typedef struct FlgBrushMeshState {
    uint32_t struct_size;
    uint32_t begun;        /* 0 until points were written */
    uint64_t vertex_count; /* of the stroke as it is in the buffers, with its end's cap */
    uint64_t index_count;  /* likewise */
    double opaque[44];     /* the library's own */
} FlgBrushMeshState;

FLG_API FlgResult flgBrushMeshStateInit(FlgBrushMeshState* state, uint32_t struct_size);

/* What a call of flgBrushMeshWrite writes. */
typedef struct FlgBrushMeshSizes {
    uint32_t struct_size;
    uint32_t reserved;
    uint64_t first_vertex; /* with a state: the mesh's first vertex that is written; else 0 */
    uint64_t vertex_count; /* vertices that are written */
    uint64_t first_index;  /* likewise */
    uint64_t index_count;  /* three per triangle */
} FlgBrushMeshSizes;

FLG_API FlgResult flgBrushMeshSizesInit(FlgBrushMeshSizes* sizes, uint32_t struct_size);

/* [any thread] The sizes of what flgBrushMeshWrite would write for the same arguments. `state` may be null and is not
 * changed. FLG_ERROR_LIMIT above 2^32 - 1 vertices. Cost: one pass over the points, about 20 ns each. */
FLG_API FlgResult flgBrushMeshGetSizes(const FlgBrushMeshDesc* desc, const FlgBrushMeshState* state,
                                       FlgBrushMeshSizes* out_sizes);

/* The columns that vertices have, as FLG_ATTRIBUTE_...; others are refused. Rows have at most 4 numbers.
 *
 *     POSITION   3, metres
 *     NORMAL     3, unit length
 *     TANGENT    4: unit length, across the normal, along the first texture coordinate; then the sign of the
 *                bitangent, w * cross(normal, tangent)
 *     COLOR      4, linear RGBA
 *     UV         2; if desc.uv is 0, filled where `optional`, else refused
 */

/* The buffers. They must not overlap each other, nor the input. Written from front to back and never read: mapped
 * memory of a graphics card will do. */
typedef struct FlgBrushMeshOutput {
    uint32_t struct_size;
    uint32_t column_count;          /* 0 to 5 */
    const FlgBufferColumn* columns; /* those that are wanted */
    uint64_t vertex_capacity;       /* vertices that every column has room for */
    void* indices;                  /* null: not wanted */
    uint64_t index_capacity;        /* indices that `indices` has room for */
    FlgNumberFormat index_format;   /* UINT32 or UINT16. Default UINT32 */
    uint32_t reserved;
} FlgBrushMeshOutput;

FLG_API FlgResult flgBrushMeshOutputInit(FlgBrushMeshOutput* output, uint32_t struct_size);

/* [any thread] Writes vertices and triangles. With a `state` the range must be one open curve, which continues the
 * points of the calls before; the descriptor must otherwise be the same for all of them. `out_sizes` may be null. On
 * failure nothing is written, and the state stays as it was. Errors: FLG_ERROR_INVALID_ARGUMENT (also for values that
 * are not finite, buffers that are too small, unaligned or overlap), FLG_ERROR_LIMIT for indices that the format cannot
 * hold. Cost: about 0.25 us a point of a tube of 8 sides with positions, normals and indices; one core. */
FLG_API FlgResult flgBrushMeshWrite(const FlgBrushMeshDesc* desc, FlgBrushMeshState* state,
                                    const FlgBrushMeshOutput* output, FlgBrushMeshSizes* out_sizes);

/* ---- Defaults by value --------------------------------------------------------------------------------------- */

static inline FlgBrushMeshDesc flgBrushMeshDefaults(void) {
    FlgBrushMeshDesc desc;
    flgBrushMeshDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgBrushMeshState flgBrushMeshStateDefaults(void) {
    FlgBrushMeshState state;
    flgBrushMeshStateInit(&state, (uint32_t)sizeof state);
    return state;
}

static inline FlgBrushMeshSizes flgBrushMeshSizesDefaults(void) {
    FlgBrushMeshSizes sizes;
    flgBrushMeshSizesInit(&sizes, (uint32_t)sizeof sizes);
    return sizes;
}

static inline FlgBrushMeshOutput flgBrushMeshOutputDefaults(void) {
    FlgBrushMeshOutput output;
    flgBrushMeshOutputInit(&output, (uint32_t)sizeof output);
    return output;
}

#ifdef __cplusplus
}
#endif

#endif
