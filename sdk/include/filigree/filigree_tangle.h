/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Tangles: recursive ornament on surfaces (Nazzaro, Puppo, Pellacini: geoTangle, 2021). It follows the grammar of filigree.h
 * and filigree_surface.h.
 *
 * A tangle is a tree of regions of a surface, sec. 3 and appendix A of the paper. The root, region 0, is the whole surface;
 * operators divide regions along isolines and streamlines of geodesic fields, and the parts become their children. Leaves
 * partition the surface; the label of a triangle is its leaf. An operator on a region that was divided before divides its
 * leaves: their borders stay, its own go through all of them.
 *
 * Groups       Each region is of one group, which materials and scripts go by. How an operator groups what it makes is its
 *              `grouping`; parts of leaves are in one group if their part of the operator and the leaf's own group are the same.
 * Scaffolds    A scaffold's borders are not seen: its regions look like the region they lie in, and help to place others.
 * Looks        Two leaves look the same if no visible border may lie between them; borders are where looks differ.
 * History      Each operator, macro, grouping and join is a step, which can be taken back and made again, to the bit.
 * Surface      The tangle changes its surface by jobs, in the order they were started. Do not cut a tangle's surface by other
 *              means, nor make another tangle of it: then all further changes of this one are refused. Fields, tracing,
 *              picking and drawing go on as with any surface.
 */
#ifndef FILIGREE_FILIGREE_TANGLE_H
#define FILIGREE_FILIGREE_TANGLE_H

#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A surface with the tree of its regions and the steps that made them. */
FLG_HANDLE(FlgTangle);

/* Starts a job that makes the whole of a surface the root of a tangle: all labels become 0. The surface may still be in the
 * making. Cost: about 5 ns a triangle. */
FLG_API FlgResult flgTangleCreate(FlgContext context, FlgSurface surface, FlgTangle* out_tangle, FlgJob* out_job);

/* Gives the handle back; the surface stays as it is. */
FLG_API FlgResult flgTangleRelease(FlgContext context, FlgTangle tangle);

/* ---- Regions --------------------------------------------------------------------------------------------------- */

/* A part of a border. Loops are the closed borders of the seeds' regions, all regions together, also where the surface ends:
 * in the order of their least edges, as flgBorderSample gives them. Shares of the loop's length from its first vertex on. */
typedef struct FlgBorderStretch {
    uint32_t loop; /* its number */
    float begin; /* in [0, 1) */
    float end;   /* in (begin, begin + 1] */
} FlgBorderStretch;

/* Which borders an operator begins at. */
typedef enum FlgTangleBorders {
    FLG_TANGLE_BORDERS_NONE = 0,  /* no borders */
    FLG_TANGLE_BORDERS_OUTER = 1, /* of the regions together */
    FLG_TANGLE_BORDERS_EACH = 2,  /* of each leaf by itself */
    FLG_TANGLE_BORDERS_FORCE_32BIT = 0x7fffffff
} FlgTangleBorders;

/* What an operator begins at: all that is named here, together. By default nothing is. Arrays are copied. */
typedef struct FlgTangleSeeds {
    FlgTangleBorders borders;
    uint32_t stretch_count;
    const FlgBorderStretch* stretches; /* parts of the outer borders */
    const FlgSurfacePoint* points;     /* places on the surface as it is */
    uint32_t point_count;
    uint32_t sample_count;   /* Poisson samples at most; 0: as many as fit */
    float sample_radius;     /* no two samples are nearer, nor half as near to a border, metres; 0: no samples */
    float border_spacing;    /* points so far apart along the outer borders, metres; 0: none */
    FlgSurfaceCurves curves; /* lines, of the surface as it is; null: none */
    const uint32_t* regions; /* whose borders these are, and where samples lie; null: those of the operator */
    uint32_t region_count;
    uint32_t reserved;
} FlgTangleSeeds;

/* Along what regions are divided, sec. 3.3 of the paper. */
typedef enum FlgTangleOperator {
    FLG_TANGLE_CONTOUR = 0,  /* cuts along isolines of the field of a, or blended between a and b */
    FLG_TANGLE_STREAM = 1,   /* cuts along integral curves that begin evenly on a, which is lines or borders */
    FLG_TANGLE_VORONOI = 2,  /* cells of the points and samples of a */
    FLG_TANGLE_POLYLINE = 3, /* cuts along the shortest ways from point to point of a, and along its curves */
    FLG_TANGLE_OPERATOR_FORCE_32BIT = 0x7fffffff
} FlgTangleOperator;

/* How an operator groups the regions it makes. */
typedef enum FlgTangleGrouping {
    FLG_TANGLE_GROUP_TWO = 0,   /* foreground (even parts) and background (odd ones) */
    FLG_TANGLE_GROUP_ONE = 1,   /* all in one */
    FLG_TANGLE_GROUP_EACH = 2,  /* each region in its own */
    FLG_TANGLE_GROUP_CYCLE = 3, /* by part modulo `cycle` */
    FLG_TANGLE_GROUP_FORCE_32BIT = 0x7fffffff
} FlgTangleGrouping;

/* An operator. Parts are numbered: from the seeds outwards between isolines; along a between streams; 0 left of a polyline's
 * curves (where most of its border is) and 1 elsewhere; else in the order of their first triangles. */
typedef struct FlgTangleDivideDesc {
    uint32_t struct_size;
    FlgTangleOperator kind; /* default FLG_TANGLE_CONTOUR */
    FlgJobOptions job;
    FlgTangle tangle;
    const uint32_t* regions; /* divided together, as one piece; copied */
    uint32_t region_count;   /* at least 1 */
    /* Isolines at delta, 2 delta, ...: at most so many; 0: as many as the field has. At most 256. Default 1. */
    uint32_t count;
    FlgTangleSeeds a, b; /* b: with it the field is blended, 0 at a and 1 at b; by default it is empty */
    float delta; /* > 0. Contours: metres, or a share of the blend below 1. Streams: metres along a. Default 0.1 */
    FlgTangleGrouping grouping; /* default FLG_TANGLE_GROUP_TWO */
    uint32_t cycle;             /* groups of FLG_TANGLE_GROUP_CYCLE, 1 to 65536; default 3 */
    uint32_t scaffold;          /* nonzero: the borders are not seen. Default 0 */
    uint32_t closed;            /* nonzero: a polyline goes back to its first point. Default 0 */
    /* As in FlgGeodesicDesc: Perlin noise on the metric, for an organic look. */
    float perturbation; /* metres, >= 0; default 0 */
    float frequency;    /* 1 / metre, > 0; default 1 */
    uint32_t reserved;
    uint64_t seed; /* of samples and noise; default 1 */
} FlgTangleDivideDesc;

FLG_API FlgResult flgTangleDivideDescInit(FlgTangleDivideDesc* desc, uint32_t struct_size);

/* Starts a job that divides regions by an operator. One that leaves them whole (delta beyond the field, no room for samples,
 * a line that does not separate) is a step that changes nothing. Fails if a region does not exist, if borders are asked for
 * where there are none, if streams have no line to begin on, or with more than FLG_REGION_MAX regions. Cost: a field (40 ns a
 * triangle of the regions; with b two, with samples two more), the cut (flgCutIsolines), and several passes over the surface
 * (2 million triangles: 40 to 60 ms, however small the regions). */
FLG_API FlgResult flgTangleDivide(FlgContext context, const FlgTangleDivideDesc* desc, FlgJob* out_job);

/* Operators that are used together. */
typedef enum FlgTangleMacro {
    FLG_TANGLE_SUNBURST = 0,   /* strips from the first border to the others: a stream of the blend */
    FLG_TANGLE_POLKA_DOTS = 1, /* discs around samples: a contour */
    FLG_TANGLE_FRAMES = 2,     /* bands along the outer borders: contours */
    FLG_TANGLE_FLOWER = 3,     /* petals between the outer borders and samples: contours of the blend */
    FLG_TANGLE_GRID =
        4, /* a chequerboard between the first border and the others: contours of the blend, then a stream */
    FLG_TANGLE_OUTLINE = 5, /* a band along every border: a contour */
    FLG_TANGLE_LACE = 6,    /* scallops: a contour of points along the outer borders */
    FLG_TANGLE_CELLS = 7,   /* Voronoi cells of samples */
    FLG_TANGLE_MACRO_FORCE_32BIT = 0x7fffffff
} FlgTangleMacro;

/* The operators that are used together most, sec. 3.4 and Fig. 13. */
typedef struct FlgTangleMacroDesc {
    uint32_t struct_size;
    FlgTangleMacro kind; /* default FLG_TANGLE_SUNBURST */
    FlgJobOptions job;
    FlgTangle tangle;
    const uint32_t* regions; /* as of an operator; copied */
    uint32_t region_count;   /* at least 1 */
    uint32_t count;          /* frames, petals one in another, rows of the grid: 1 to 256; default 4 */
    /* Metres, > 0; default 0.1. Strips and columns: their width along the first border; dots, lace: the radius; frames and
     * outlines: the width of a band. Flowers and cells have none. */
    float size;
    /* Metres, > 0; default 0.3: between samples, at least; between scallops. */
    float spacing;
    uint64_t seed; /* of samples; default 1 */
} FlgTangleMacroDesc;

FLG_API FlgResult flgTangleMacroDescInit(FlgTangleMacroDesc* desc, uint32_t struct_size);

/* Starts a job that applies a macro: one step, to be taken back at once. Parts are grouped as FLG_TANGLE_GROUP_TWO does. Fails as
 * its operators do; sunbursts and grids also if the regions together have fewer than two borders.
 * Cost: its operators'. */
FLG_API FlgResult flgTangleApplyMacro(FlgContext context, const FlgTangleMacroDesc* desc, FlgJob* out_job);

/* Moves vertices of regions along the surface's normals: sec. 3.4, after an operator. Each leaf rises by `amount` at the place
 * that is farthest from its borders, or everywhere `reach` and more away from them; borders stay. In between the height is
 * the profile of the distance, by the bias and gain of Schlick (1994). Distances measured later are those on the new surface. */
typedef struct FlgTangleDisplaceDesc {
    uint32_t struct_size;
    float amount; /* metres, any finite number; default 0.1 */
    FlgJobOptions job;
    FlgTangle tangle;
    const uint32_t* regions; /* their leaves are displaced; copied */
    uint32_t region_count;   /* at least 1 */
    float bias;              /* in (0, 1): below 0.5 spikes, above it domes; default 0.5: neither */
    float gain;  /* in (0, 1): below 0.5 steep at half height, above it a terrace there; default 0.5: neither */
    float reach; /* metres, >= 0; default 0: each leaf's own largest distance */
} FlgTangleDisplaceDesc;

FLG_API FlgResult flgTangleDisplaceDescInit(FlgTangleDisplaceDesc* desc, uint32_t struct_size);

/* Starts a job that displaces regions; a step. Fails if they have no borders. Cost: a field and about 2 us a vertex that moves. */
FLG_API FlgResult flgTangleDisplace(FlgContext context, const FlgTangleDisplaceDesc* desc, FlgJob* out_job);

/* Starts a job that gives all these regions one new group, sec. 3.4 and appendix A; a step. Any region may be named, leaf or
 * not; it fails if one does not exist. Cost: tens of nanoseconds a region. */
FLG_API FlgResult flgTangleGroup(FlgContext context, FlgTangle tangle, const uint32_t* regions, uint32_t region_count,
                                 FlgJob* out_job);

/* Starts a job that gives each region of the group a new group of its own; a step. It fails if there is no such group. Cost:
 * tens of nanoseconds a region of the tangle. */
FLG_API FlgResult flgTangleUngroup(FlgContext context, FlgTangle tangle, uint32_t group, FlgJob* out_job);

/* Starts a job that makes the leaves of these regions one region, with the lowest of their identifiers; a step. It fails if
 * they are not connected. Cost: about 20 ns a triangle of the surface. */
FLG_API FlgResult flgTangleJoin(FlgContext context, FlgTangle tangle, const uint32_t* regions, uint32_t region_count,
                                FlgJob* out_job);

/* Starts a job that gives the borders that are seen as curves on the surface, chains of its edges: to lift into space
 * (flgLiftCurves), to stylize, to draw as ribbons and tubes. Open ones from meeting point to meeting point, then closed ones;
 * curve_values are lengths. Where looks are all the same there are none. Cost: about 30 ns a triangle. */
FLG_API FlgResult flgTangleBorders(FlgContext context, FlgTangle tangle, FlgSurfaceCurves* out_curves, FlgJob* out_job);

/* ---- History ----------------------------------------------------------------------------------------------------- */

/* Starts a job that takes the last step back; it fails if there is none (steps whose job failed are none). Cost: that of
 * what the step changed. */
FLG_API FlgResult flgTangleUndo(FlgContext context, FlgTangle tangle, FlgJob* out_job);

/* Starts a job that makes the step again that was taken back last. A new step forgets those.
 * Cost: that of what the step changes. */
FLG_API FlgResult flgTangleRedo(FlgContext context, FlgTangle tangle, FlgJob* out_job);

/* ---- Documents --------------------------------------------------------------------------------------------------- */

/* What made a step. */
typedef enum FlgTangleStepKind {
    FLG_TANGLE_STEP_DIVIDE = 0,   /* flgTangleDivide */
    FLG_TANGLE_STEP_MACRO = 1,    /* flgTangleApplyMacro */
    FLG_TANGLE_STEP_DISPLACE = 2, /* flgTangleDisplace */
    FLG_TANGLE_STEP_GROUP = 3,    /* flgTangleGroup */
    FLG_TANGLE_STEP_UNGROUP = 4,  /* flgTangleUngroup */
    FLG_TANGLE_STEP_JOIN = 5,     /* flgTangleJoin */
    FLG_TANGLE_STEP_FORCE_32BIT = 0x7fffffff
} FlgTangleStepKind;

/* Where the seeds of an operator were: what finds them again on another mesh of the same shape. Positions are x, y, z in
 * metres. */
typedef struct FlgTangleSeedPlaces {
    uint32_t point_count;  /* of the seeds' points, all or none */
    uint32_t loop_count;   /* of the first vertices of the outer borders, in their order; 0: no borders were asked for */
    uint32_t sample_count; /* of the samples, in the order they were chosen */
    uint32_t reserved;
    const float* points;         /* 3 a point */
    const float* loops;          /* 3 a loop */
    const float* samples;        /* 3 a sample */
    FlgSurfaceCurvesView curves; /* the seeds' lines, in place of a handle; no curves: none */
    const float* curve_points;   /* of the curves' points; null: none */
} FlgTangleSeedPlaces;

/* What a step was asked to do, and what it needs to be done again. */
typedef struct FlgTangleStep {
    uint32_t struct_size;
    FlgTangleStepKind kind;
    const FlgTangleDivideDesc* divide;     /* of FLG_TANGLE_STEP_DIVIDE; handles and job options in it are null */
    const FlgTangleMacroDesc* macro;       /* of FLG_TANGLE_STEP_MACRO, likewise */
    const FlgTangleDisplaceDesc* displace; /* of FLG_TANGLE_STEP_DISPLACE, likewise */
    const uint32_t* regions;               /* grouped or joined */
    uint32_t region_count;
    uint32_t group; /* taken apart */
    /* Of a and b of the operator, or of each of the macro's operators. Null and 0: not known. */
    const FlgTangleSeedPlaces* places;
    uint32_t place_count;
    /* The regions it made have the identifiers first_region and up; inside of each there is a point of `made`: x, y, z in
     * metres. Of a group that was taken apart: first_region is one of its regions, or FLG_NO_INDEX. */
    uint32_t first_region;
    uint32_t made_count;
    /* Nonzero: it came from another mesh, so its seeds were found by `places`, and have to be again. */
    uint32_t placed;
    const float* made; /* 3 a region */
} FlgTangleStep;

/* All steps of a tangle: with them it can be made again, and kept in a file (flgTangleFileWrite of filigree_io.h). */
typedef struct FlgTangleHistory {
    uint32_t struct_size;
    uint32_t step_count; /* with those taken back */
    uint32_t made_count; /* those not taken back */
    uint32_t reserved;
    const FlgTangleStep* steps; /* the first one first */
    uint64_t base; /* tells meshes apart: of the positions and triangles that the tangle began with, to the bit */
    float box_min[3], box_max[3]; /* of these positions */
} FlgTangleHistory;

/* The arrays live until a job that changes the tangle is started, the function is called again for it, or the tangle
 * is released. Not ready when the info isn't. Cost: about 1 us a step and some ns a point. */
FLG_API FlgResult flgTangleGetHistory(FlgContext context, FlgTangle tangle, FlgTangleHistory* out_history);

/* Starts a job that makes all steps of a history again on a tangle that has none, and takes those back that were: afterwards the
 * tangle has them as its own. On the same mesh, to the bit, it becomes the tangle that the history is of, to the bit. On
 * another mesh of that shape, such as a finer one, points, samples, lines, borders and regions are found by where they
 * were: the nearest point of the surface stands for each. All is copied in this call.
 * Fails, and changes nothing, if the tangle has steps; if a step fails, naming it; if the meshes' boxes differ by more
 * than 1/20 of their diagonal. What the arguments of flgTangleDivide and the others may not be is refused here too.
 * Cost: that of the steps; on another mesh also about 0.2 us a triangle for each step that has points or made regions. */
FLG_API FlgResult flgTangleReplay(FlgContext context, FlgTangle tangle, const FlgTangleHistory* history,
                                  FlgJob* out_job);

/* ---- What a tangle is like --------------------------------------------------------------------------------------- */

typedef struct FlgTangleInfo {
    uint32_t struct_size;
    uint32_t region_count; /* identifiers are below it */
    uint32_t group_count;  /* likewise */
    uint32_t leaf_count;   /* regions that are not divided */
    uint32_t undo_count, redo_count; /* steps that can be taken back, and made again */
    uint32_t depth;                  /* of the deepest leaf; the root's is 0 */
    uint32_t reserved;
} FlgTangleInfo;

/* FLG_NOT_READY while a job that changes the tangle isn't published; its error if its surface failed. Cost: tens of
 * nanoseconds a region. */
FLG_API FlgResult flgTangleGetInfo(FlgContext context, FlgTangle tangle, FlgTangleInfo* out_info);

typedef struct FlgTangleRegion {
    uint32_t struct_size;
    uint32_t parent; /* FLG_NO_INDEX: the root */
    uint32_t group;  /* that it is of */
    uint32_t look; /* borders are seen where looks differ */
    uint32_t operation; /* number of the operator that made it, from 1, a macro's each by itself; the root: 0 */
    uint32_t part; /* of that operator */
    uint32_t first_child; /* children have consecutive identifiers */
    uint32_t child_count;
    uint32_t joined_into; /* the region it belongs to since they were joined; FLG_NO_INDEX: none */
    uint32_t scaffold;    /* nonzero: its borders are not seen */
    uint32_t visible_group; /* the group of the nearest region around it, itself included, that is no scaffold's */
    uint32_t depth;         /* of the tree; the root has 0 */
} FlgTangleRegion;

/* Not ready when the info isn't. Cost: tens of nanoseconds. */
FLG_API FlgResult flgTangleGetRegion(FlgContext context, FlgTangle tangle, uint32_t region,
                                     FlgTangleRegion* out_region);

/* ---- Defaults by value ------------------------------------------------------------------------------------------- */

static inline FlgTangleDivideDesc flgTangleDivideDefaults(void) {
    FlgTangleDivideDesc desc;
    flgTangleDivideDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgTangleMacroDesc flgTangleMacroDefaults(void) {
    FlgTangleMacroDesc desc;
    flgTangleMacroDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgTangleDisplaceDesc flgTangleDisplaceDefaults(void) {
    FlgTangleDisplaceDesc desc;
    flgTangleDisplaceDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

#ifdef __cplusplus
}
#endif

#endif
