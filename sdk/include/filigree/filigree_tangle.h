/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Tangles: recursive ornament on surfaces (Nazzaro, Puppo, Pellacini: geoTangle, 2021). Follows the grammar of
 * filigree.h and filigree_surface.h.
 *
 * A tangle is a tree of regions of a surface, sec. 3 and appendix A of the paper. The root, region 0, is the whole
 * surface. Operators divide regions along isolines and streamlines of geodesic fields; the parts become their children.
 * Leaves partition the surface; each triangle's label is its leaf. An operator on a region already divided divides its
 * leaves: their borders stay, and the operator's borders pass through all of them.
 *
 * Groups       Each region belongs to one group; materials and scripts select by group. An operator's `grouping` says
 *              how it groups the regions it makes. Parts of several leaves share a group if their part of the operator
 *              and their leaf's group are the same.
 * Scaffolds    A scaffold's borders are invisible: its regions look like the region around them, and help to place
 *              others.
 * Looks        Two leaves look the same if no visible border may lie between them; visible borders lie where looks
 *              differ.
 * History      Each operator, macro, grouping and join is a step, which can be undone and redone, to the bit. Steps
 *              before the last can be changed, muted, moved and removed, and others inserted: what depends on them is
 *              computed again. Such an edit is undone and redone like a step.
 * Surface      The tangle changes its surface by jobs, in the order they were started. Do not cut a tangle's surface by
 *              other means, and do not make another tangle from it: all further changes to this tangle are then
 *              refused. Fields, tracing, picking and drawing work as on any surface.
 */
#ifndef FILIGREE_FILIGREE_TANGLE_H
#define FILIGREE_FILIGREE_TANGLE_H

#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A surface, the tree of its regions, and the steps that made them. */
FLG_HANDLE(FlgTangle);

/* Starts a job that makes a whole surface the root of a tangle: all labels become 0. The surface's own job may still
 * run. Cost: about 5 ns a triangle. */
FLG_API FlgResult flgTangleCreate(FlgContext context, FlgSurface surface, const FlgJobOptions* job,
                                 FlgTangle* out_tangle, FlgJob* out_job);

/* Releases the handle; the surface does not change. */
FLG_API FlgResult flgTangleRelease(FlgContext context, FlgTangle tangle);

/* ---- Regions --------------------------------------------------------------------------------------------------- */

/* Part of a border. Loops are the closed borders of the seeds' regions, taken together, including surface borders. They
 * are ordered by their least edges, as flgSurfaceSampleBorders gives them. `begin` and `end` are fractions of the
 * loop's length from its first vertex. */
typedef struct FlgBorderStretch {
    uint32_t loop; /* its index */
    float begin;   /* in [0, 1) */
    float end;     /* in (begin, begin + 1] */
} FlgBorderStretch;

/* The borders an operator starts from. */
typedef enum FlgTangleBorders {
    FLG_TANGLE_BORDERS_NONE = 0,  /* no borders */
    FLG_TANGLE_BORDERS_OUTER = 1, /* of all regions together */
    FLG_TANGLE_BORDERS_EACH = 2,  /* of each leaf separately */
    FLG_TANGLE_BORDERS_FORCE_32BIT = 0x7fffffff
} FlgTangleBorders;

/* Where an operator starts: everything named here, combined. Empty by default. Arrays are copied. */
typedef struct FlgTangleSeeds {
    uint32_t struct_size;
    FlgTangleBorders borders;
    uint32_t stretch_count;
    const FlgBorderStretch* stretches; /* parts of the outer borders */
    const FlgSurfacePoint* points;     /* points on the current surface */
    uint32_t point_count;
    uint32_t sample_count;   /* maximum Poisson samples; 0: as many as fit */
    float sample_radius;     /* minimum distance between samples, metres, and half that to a border; 0: no samples */
    float border_spacing;    /* distance between points along the outer borders, metres; 0: none */
    FlgSurfaceCurves curves; /* lines on the current surface; null: none */
    const uint32_t* regions; /* regions that supply the borders and samples; null: the operator's */
    uint32_t region_count;
} FlgTangleSeeds;

FLG_API FlgResult flgTangleSeedsInit(FlgTangleSeeds* seeds, uint32_t struct_size);

/* How an operator divides regions, sec. 3.3 of the paper. */
typedef enum FlgTangleOperator {
    FLG_TANGLE_OPERATOR_CONTOUR = 0,  /* cuts along isolines of the field of a, or of the blend between a and b */
    FLG_TANGLE_OPERATOR_STREAM = 1,   /* cuts along integral curves that start evenly spaced on a, which must be
                                         lines or borders; without b also along the ridge where those of
                                         borders meet */
    FLG_TANGLE_OPERATOR_VORONOI = 2,  /* cells of the points and samples of a */
    FLG_TANGLE_OPERATOR_POLYLINE = 3, /* cuts along shortest paths between consecutive points of a, and along its
                                         curves */
    FLG_TANGLE_OPERATOR_FORCE_32BIT = 0x7fffffff
} FlgTangleOperator;

/* How an operator groups the regions it makes. */
typedef enum FlgTangleGrouping {
    FLG_TANGLE_GROUPING_TWO = 0,   /* foreground (even parts) and background (odd parts) */
    FLG_TANGLE_GROUPING_ONE = 1,   /* all in one group */
    FLG_TANGLE_GROUPING_EACH = 2,  /* each region in its own group */
    FLG_TANGLE_GROUPING_CYCLE = 3, /* by part modulo `cycle` */
    FLG_TANGLE_GROUPING_FORCE_32BIT = 0x7fffffff
} FlgTangleGrouping;

/* An operator. It numbers parts as follows. Between isolines: outwards from the seeds. Between streams: along a. For a
 * polyline: 0 left of its curves (where most of the border is) and 1 elsewhere. Otherwise: in the order of their first
 * triangles. */
typedef struct FlgTangleDivideDesc {
    uint32_t struct_size;
    FlgTangleOperator kind; /* default FLG_TANGLE_OPERATOR_CONTOUR */
    const FlgJobOptions* job;
    FlgTangle tangle;
    const uint32_t* regions; /* divided together, as one piece; copied */
    uint32_t region_count;   /* at least 1 */
    /* Maximum isolines, at delta, 2 delta, ...: up to 256; 0: as many as the field has. Default 1. */
    uint32_t count;
    const FlgTangleSeeds* a;    /* where the operator starts */
    const FlgTangleSeeds* b;    /* the field is blended: 0 at a and 1 at b; null: it is not */
    float delta;                /* > 0. Contours: metres, or a fraction below 1 of the blend. Streams: metres along
                                   a; a closed border gets a multiple of two strips, or of `cycle`, where so
                                   many groups take turns. Default 0.1 */
    FlgTangleGrouping grouping; /* default FLG_TANGLE_GROUPING_TWO */
    uint32_t cycle;             /* group count for FLG_TANGLE_GROUPING_CYCLE, 1 to 65536; default 3 */
    uint32_t scaffold;          /* nonzero: the borders are invisible. Default 0 */
    uint32_t closed;            /* nonzero: a polyline returns to its first point. Default 0 */
    /* As in FlgFieldGeodesicDesc: Perlin noise on the metric, for an organic look. */
    float perturbation; /* metres, >= 0; default 0 */
    float frequency;    /* 1 / metre, > 0; default 1 */
    uint32_t reserved;
    uint64_t seed; /* for samples and noise; default 1 */
} FlgTangleDivideDesc;

FLG_API FlgResult flgTangleDivideDescInit(FlgTangleDivideDesc* desc, uint32_t struct_size);

/* Starts a job that divides regions by an operator. If it leaves them whole (delta beyond the field, no room for
 * samples, a line that does not separate), the step changes nothing. What it cuts off a region that is smaller than a
 * millionth of the surface stays with the part beside it. Fails if a region does not exist, if requested
 * borders do not exist, if streams have no line to start on, or above FLG_REGION_MAX regions. Cost: a field (40 ns a
 * triangle of the regions; with b two, with samples two more), and the cut (flgSurfaceCutIsolines). On 2 million
 * triangles a region of 10,000 takes some 10 ms where many edges are flipped. */
FLG_API FlgResult flgTangleDivide(FlgContext context, const FlgTangleDivideDesc* desc, FlgJob* out_job);

/* Common combinations of operators. */
typedef enum FlgTangleMacro {
    FLG_TANGLE_MACRO_SUNBURST = 0,   /* strips from one border to the others: a stream of the blend */
    FLG_TANGLE_MACRO_POLKA_DOTS = 1, /* discs around samples: a contour */
    FLG_TANGLE_MACRO_FRAMES = 2,     /* bands along the outer borders: contours */
    FLG_TANGLE_MACRO_FLOWER = 3,     /* petals between the outer borders and samples: contours of the blend */
    FLG_TANGLE_MACRO_GRID =
        4, /* a chequerboard between one border and the others: contours of the blend, then a stream */
    FLG_TANGLE_MACRO_OUTLINE = 5, /* a band along every border: a contour */
    FLG_TANGLE_MACRO_LACE = 6,    /* scallops: a contour of points along the outer borders */
    FLG_TANGLE_MACRO_CELLS = 7,   /* Voronoi cells of samples */
    FLG_TANGLE_MACRO_FORCE_32BIT = 0x7fffffff
} FlgTangleMacro;

/* Common combinations of operators, sec. 3.4 and Fig. 13. */
typedef struct FlgTangleApplyMacroDesc {
    uint32_t struct_size;
    FlgTangleMacro kind; /* default FLG_TANGLE_MACRO_SUNBURST */
    const FlgJobOptions* job;
    FlgTangle tangle;
    const uint32_t* regions; /* as for an operator; copied */
    uint32_t region_count;   /* at least 1 */
    uint32_t count;          /* frames, nested petals, rows of the grid: 1 to 256; default 4 */
    /* Metres, > 0; default 0.1. Sunbursts and grids: width of strips and columns along the border they start from. Dots
     * and lace: radius. Frames and outlines: band width. Unused by flowers and cells. */
    float size;
    /* Minimum distance between samples, or between scallops; metres, > 0; default 0.3. Flowers have no larger one than
     * 1.5 times the largest distance from a border: there is a petal in every strip. */
    float spacing;
    uint64_t seed; /* for samples; default 1 */
    /* Sunbursts and grids: the border they start from, an index as in FlgBorderStretch. FLG_NO_INDEX (default): the
     * longest of each connected piece. */
    uint32_t border;
    uint32_t reserved;
} FlgTangleApplyMacroDesc;

FLG_API FlgResult flgTangleApplyMacroDescInit(FlgTangleApplyMacroDesc* desc, uint32_t struct_size);

/* Starts a job that applies a macro as one step, undone as a whole. Parts are grouped as by FLG_TANGLE_GROUPING_TWO.
 * Fails as its operators do; sunbursts and grids also fail if the regions together have fewer than two borders.
 * Cost: its operators'. */
FLG_API FlgResult flgTangleApplyMacro(FlgContext context, const FlgTangleApplyMacroDesc* desc, FlgJob* out_job);

/* Moves vertices of regions along the surface's normals, sec. 3.4, after an operator. Each leaf rises by `amount` at
 * the point farthest from its borders, or wherever the borders are `reach` or more away; borders stay. In between, the
 * height is a profile of the distance, by the bias and gain of Schlick (1994). The ridges of the distance are rounded,
 * by some percent of the largest one; normals are smoothed within the regions, over up to half of `amount`. Where a
 * triangle that is no sliver would turn over, the height is lowered. (Parts of the surface that face each other may
 * still meet.) Later distances are measured on the new surface. */
typedef struct FlgTangleDisplaceDesc {
    uint32_t struct_size;
    float amount; /* metres, any finite number; default 0.1 */
    const FlgJobOptions* job;
    FlgTangle tangle;
    const uint32_t* regions; /* their leaves are displaced; copied */
    uint32_t region_count;   /* at least 1 */
    float bias;              /* in (0, 1): below 0.5 spikes, above it domes; default 0.5: neither */
    float gain;              /* in (0, 1): below 0.5 steep at half height, above it a terrace there; default 0.5:
                                neither */
    float reach;             /* metres, >= 0; default 0: each leaf's own largest distance */
} FlgTangleDisplaceDesc;

FLG_API FlgResult flgTangleDisplaceDescInit(FlgTangleDisplaceDesc* desc, uint32_t struct_size);

/* Starts a job that displaces regions, as a step. Fails if they have no borders. Cost: a field and about 1 us a vertex
 * that moves. */
FLG_API FlgResult flgTangleDisplace(FlgContext context, const FlgTangleDisplaceDesc* desc, FlgJob* out_job);

/* Starts a job that puts these regions into one new group, sec. 3.4 and appendix A, as a step. Regions may be leaves or
 * not; fails if one does not exist. Cost: tens of nanoseconds a region. */
FLG_API FlgResult flgTangleGroup(FlgContext context, FlgTangle tangle, const uint32_t* regions, uint32_t region_count,
                                 const FlgJobOptions* job, FlgJob* out_job);

/* Starts a job that gives each region of the group its own new group, as a step. Fails if there is no such group.
 * Cost: tens of nanoseconds a region of the tangle. */
FLG_API FlgResult flgTangleUngroup(FlgContext context, FlgTangle tangle, uint32_t group, const FlgJobOptions* job,
                                  FlgJob* out_job);

/* Starts a job that joins the leaves of these regions into one region, with their lowest identifier, as a step. Fails
 * if they are not connected. Cost: about 20 ns a triangle of the surface. */
FLG_API FlgResult flgTangleJoin(FlgContext context, FlgTangle tangle, const uint32_t* regions, uint32_t region_count,
                                const FlgJobOptions* job, FlgJob* out_job);

/* Starts a job that returns the visible borders as curves on the surface, chains of its edges. Lift them into space
 * (flgSurfaceCurvesLift), stylize them, or draw them as ribbons and tubes. Open curves, from junction to junction, come
 * first, then closed ones; curve_values are lengths. There are none if all looks are the same. Cost: about 30 ns a
 * triangle. */
FLG_API FlgResult flgTangleTraceBorders(FlgContext context, FlgTangle tangle, const FlgJobOptions* job,
                                        FlgSurfaceCurves* out_curves, FlgJob* out_job);

/* ---- History ----------------------------------------------------------------------------------------------------- */

/* Starts a job that undoes the last step, or the last edit of the history if that came later; fails if there is
 * neither. (A failed job makes no step.) Cost: that of what the step changed; of an edit, that of the steps it computed
 * or put elsewhere, before and after. */
FLG_API FlgResult flgTangleUndo(FlgContext context, FlgTangle tangle, const FlgJobOptions* job, FlgJob* out_job);

/* Starts a job that redoes the last undone step or edit. A new step or edit discards what was undone. Cost: that of
 * what the step changes. */
FLG_API FlgResult flgTangleRedo(FlgContext context, FlgTangle tangle, const FlgJobOptions* job, FlgJob* out_job);

/* ---- Documents --------------------------------------------------------------------------------------------------- */

/* The function that made a step. */
typedef enum FlgTangleStepKind {
    FLG_TANGLE_STEP_KIND_DIVIDE = 0,   /* flgTangleDivide */
    FLG_TANGLE_STEP_KIND_MACRO = 1,    /* flgTangleApplyMacro */
    FLG_TANGLE_STEP_KIND_DISPLACE = 2, /* flgTangleDisplace */
    FLG_TANGLE_STEP_KIND_GROUP = 3,    /* flgTangleGroup */
    FLG_TANGLE_STEP_KIND_UNGROUP = 4,  /* flgTangleUngroup */
    FLG_TANGLE_STEP_KIND_JOIN = 5,     /* flgTangleJoin */
    FLG_TANGLE_STEP_KIND_FORCE_32BIT = 0x7fffffff
} FlgTangleStepKind;

/* Where an operator's seeds were: used to find them again on another mesh of the same shape. Positions are x, y, z in
 * metres. */
typedef struct FlgTangleSeedPlaces {
    uint32_t struct_size;
    uint32_t point_count;  /* the seeds' points, all or none */
    uint32_t loop_count;   /* first vertices of the outer borders, in order; 0: no borders were requested */
    uint32_t sample_count; /* the samples, in the order chosen */
    const float* points;         /* 3 per point */
    const float* loops;          /* 3 per loop */
    const float* samples;        /* 3 per sample */
    const FlgSurfaceCurvesView* curves; /* the seeds' lines, in place of a handle; null: none */
    const float* curve_points;          /* 3 for each of the curves' points; null: none */
} FlgTangleSeedPlaces;

FLG_API FlgResult flgTangleSeedPlacesInit(FlgTangleSeedPlaces* places, uint32_t struct_size);

/* What a step does. */
typedef enum FlgTangleStepState {
    FLG_TANGLE_STEP_STATE_MADE = 0,  /* what it says */
    FLG_TANGLE_STEP_STATE_MUTED = 1, /* nothing, by flgTangleMuteStep */
    FLG_TANGLE_STEP_STATE_LOST = 2,  /* nothing: an edit of an earlier step took away what it needs. It is tried again
                                        by every edit before it */
    FLG_TANGLE_STEP_STATE_FORCE_32BIT = 0x7fffffff
} FlgTangleStepState;

/* A region by how it was made: what it is known by while it is not there. */
typedef struct FlgTangleRegionName {
    uint32_t step;      /* that makes it: index in the history. FLG_NO_INDEX: the root, or a step that was removed */
    uint32_t operation; /* of the step: a macro's operators are counted from 0 */
    uint32_t part;      /* of the operation */
    uint32_t parent;    /* the region it is in: index of a name before this one. FLG_NO_INDEX: this is the root */
    float place[3];     /* a point in it: of several regions, the nearest is meant. Metres */
    float reach;        /* one whose point is this far away is another; 0: however far. Metres, >= 0 */
} FlgTangleRegionName;

/* The arguments of a step, and the data needed to repeat it. */
typedef struct FlgTangleStep {
    uint32_t struct_size;
    FlgTangleStepKind kind;
    const FlgTangleDivideDesc* divide;     /* for FLG_TANGLE_STEP_KIND_DIVIDE; its handles and job options are null */
    const FlgTangleApplyMacroDesc* macro;  /* for FLG_TANGLE_STEP_KIND_MACRO, likewise */
    const FlgTangleDisplaceDesc* displace; /* for FLG_TANGLE_STEP_KIND_DISPLACE, likewise */
    const uint32_t* regions;               /* grouped or joined */
    uint32_t region_count;
    uint32_t group; /* the group that was ungrouped */
    /* For the operator's a and b, or for each of the macro's operators. Null and 0: unknown. */
    const FlgTangleSeedPlaces* const* places;
    uint32_t place_count;
    /* The regions it made have identifiers from first_region on; `made` has a point inside each: x, y, z in metres.
     * When ungrouping, first_region is one of the group's regions, or FLG_NO_INDEX. */
    uint32_t first_region;
    uint32_t made_count;
    /* Nonzero: the step came from another mesh, so `places` located its seeds and must do so again. */
    uint32_t placed;
    const float* made; /* 3 per region */
    FlgTangleStepState state; /* default FLG_TANGLE_STEP_STATE_MADE */
    uint32_t name_count;
    /* Null, or names of regions: then the step's lists of regions are indices of these, and those it cannot find now
     * are left out; when ungrouping, the last one is of the group. Steps have names while some of their regions are
     * not there. */
    const FlgTangleRegionName* names;
    /* Why the step is lost, or which of its regions are not there: a sentence, empty if there is nothing to say. Of a
     * history; ignored where a host describes a step. */
    const char* why;
} FlgTangleStep;

FLG_API FlgResult flgTangleStepInit(FlgTangleStep* step, uint32_t struct_size);

/* All steps of a tangle: enough to make it again, or to save it in a file (flgTangleFileWrite of filigree_io.h). */
typedef struct FlgTangleHistory {
    uint32_t struct_size;
    uint32_t step_count; /* including undone steps, up to the first undone edit */
    uint32_t made_count; /* steps not undone */
    uint32_t reserved;
    const FlgTangleStep* const* steps; /* oldest first */
    uint64_t base;                /* identifies the mesh: from the tangle's initial positions and triangles, to the
                                     bit */
    float box_min[3], box_max[3]; /* box of those positions, relative to the surface's origin, as all positions are:
                                     a history does not depend on where its mesh is */
} FlgTangleHistory;

FLG_API FlgResult flgTangleHistoryInit(FlgTangleHistory* history, uint32_t struct_size);

/* The arrays live until a job that changes the tangle is started, the function is called again for it, or the tangle is
 * released. FLG_NOT_READY while the info is not ready. Cost: about 1 us a step and some ns a point. */
FLG_API FlgResult flgTangleGetHistory(FlgContext context, FlgTangle tangle, FlgTangleHistory* out_history);

/* Starts a job that repeats all steps of a history on a tangle without steps, then undoes those that were undone; the
 * steps become the tangle's own. On the same mesh, to the bit, this restores the original tangle, to the bit. On
 * another mesh of that shape, such as a finer one, it locates points, samples, lines, borders and regions by their
 * positions, each snapped to the surface. This call copies everything. Fails, and changes nothing, if the tangle has
 * steps, if a step fails (the message names it), or if the meshes' boxes differ by more than 1/20 of their diagonal.
 * Also refuses whatever flgTangleDivide and the other functions would refuse. Cost: that of the steps; on another mesh
 * also about 0.2 us a triangle for each step that has points or made regions. */
FLG_API FlgResult flgTangleReplay(FlgContext context, FlgTangle tangle, const FlgTangleHistory* history,
                                  const FlgJobOptions* job, FlgJob* out_job);

/* ---- Editing ----------------------------------------------------------------------------------------------------- */

/* These functions change the history before its end. Steps are counted from 0, a macro as one, as in
 * flgTangleGetHistory; those that are undone cannot be edited, and are discarded. Each starts a job, and is undone by
 * flgTangleUndo.
 *
 * Result       The tangle becomes what flgTangleReplay would make of the edited history, to the bit. Steps before the
 *              edit are not touched. Later ones are computed again only if what they read was changed: triangles of
 *              their regions, or around their vertices; the others keep their results. FlgTangleInfo counts those
 *              computed.
 * Regions      Identifiers of regions made from the edited step on may change. Later steps follow their regions: by the
 *              step that made them, its part, the region around them and their place. One all whose regions are gone,
 *              or that fails, is lost: it stays in the history, does nothing, says why, and is tried again by the next
 *              edit before it. One that misses some of its regions acts on the others, and gets them back likewise.
 * Seeds        Points and lines of later steps keep their places, each snapped to the surface; so do the samples of the
 *              same step. Other samples are drawn anew. Chosen borders are the nearest ones.
 * Meanwhile    The surface is not readable until the job is published: hosts go on to show what they have. A cancelled
 *              job stops after the step it is at, and leaves the tangle as it was; so does one that fails.
 * Cost         Undoing the steps from the edited one on, computing those that changed, and about as much as redoing the
 *              others. Memory: the steps before the edit are kept until it is discarded. */

/* Starts a job that replaces the arguments of a step. `desc` is read as flgTangleReplay reads a step of a history, so
 * one from flgTangleGetHistory with other numbers will do; its regions are those before the step. The array is copied.
 * Points are on the surface as it was then: where that is not known, set `placed` and give positions. A muted step
 * stays muted. Fails if the step cannot be made. Cost: as above. */
FLG_API FlgResult flgTangleEditStep(FlgContext context, FlgTangle tangle, uint32_t step, const FlgTangleStep* desc,
                                    const FlgJobOptions* job, FlgJob* out_job);

/* Likewise for a new step, which gets the index `step`: at most the number of steps that are not undone. Cost: as
 * above. */
FLG_API FlgResult flgTangleInsertStep(FlgContext context, FlgTangle tangle, uint32_t step, const FlgTangleStep* desc,
                                      const FlgJobOptions* job, FlgJob* out_job);

/* Starts a job that moves a step to another index, which it has afterwards. Before the step that makes its regions it
 * is lost. Cost: as above. */
FLG_API FlgResult flgTangleMoveStep(FlgContext context, FlgTangle tangle, uint32_t step, uint32_t to,
                                    const FlgJobOptions* job, FlgJob* out_job);

/* Starts a job that removes a step. Cost: as above. */
FLG_API FlgResult flgTangleRemoveStep(FlgContext context, FlgTangle tangle, uint32_t step, const FlgJobOptions* job,
                                      FlgJob* out_job);

/* Starts a job that mutes a step (`muted` nonzero), so that it does nothing, or makes it again (0). Cost: as above. */
FLG_API FlgResult flgTangleMuteStep(FlgContext context, FlgTangle tangle, uint32_t step, uint32_t muted,
                                    const FlgJobOptions* job, FlgJob* out_job);

/* ---- What a tangle is like --------------------------------------------------------------------------------------- */

typedef struct FlgTangleInfo {
    uint32_t struct_size;
    uint32_t region_count;           /* identifiers are below this */
    uint32_t group_count;            /* likewise */
    uint32_t leaf_count;             /* undivided regions */
    uint32_t undo_count, redo_count; /* steps, and edits of the history, that can be undone and redone */
    uint32_t depth;                  /* of the deepest leaf; the root's is 0 */
    uint32_t computed_count;         /* operators, displacements and joins that the last change computed */
} FlgTangleInfo;

FLG_API FlgResult flgTangleInfoInit(FlgTangleInfo* info, uint32_t struct_size);

/* FLG_NOT_READY until a job that changes the tangle is published; the surface's error if that failed. Cost: tens of
 * nanoseconds a region. */
FLG_API FlgResult flgTangleGetInfo(FlgContext context, FlgTangle tangle, FlgTangleInfo* out_info);

typedef struct FlgTangleRegion {
    uint32_t struct_size;
    uint32_t parent;      /* FLG_NO_INDEX: the root */
    uint32_t group;       /* its group */
    uint32_t look;        /* visible borders lie where looks differ */
    uint32_t operation;   /* index of the operator that made it, from 1; each operator of a macro counts; the root: 0 */
    uint32_t part;        /* its part of that operator */
    uint32_t first_child; /* children have consecutive identifiers */
    uint32_t child_count;
    uint32_t joined_into;   /* the region it was joined into; FLG_NO_INDEX: none */
    uint32_t scaffold;      /* nonzero: its borders are invisible */
    uint32_t visible_group; /* the group of the nearest enclosing region, itself included, that does not belong to a
                               scaffold */
    uint32_t depth;         /* in the tree; the root's is 0 */
} FlgTangleRegion;

FLG_API FlgResult flgTangleRegionInit(FlgTangleRegion* region, uint32_t struct_size);

/* FLG_NOT_READY while the info is not ready. Cost: tens of nanoseconds. */
FLG_API FlgResult flgTangleGetRegion(FlgContext context, FlgTangle tangle, uint32_t region,
                                     FlgTangleRegion* out_region);

/* ---- Defaults by value ------------------------------------------------------------------------------------------- */

static inline FlgTangleSeedPlaces flgTangleSeedPlacesDefaults(void) {
    FlgTangleSeedPlaces places;
    flgTangleSeedPlacesInit(&places, (uint32_t)sizeof places);
    return places;
}

static inline FlgTangleStep flgTangleStepDefaults(void) {
    FlgTangleStep step;
    flgTangleStepInit(&step, (uint32_t)sizeof step);
    return step;
}

static inline FlgTangleHistory flgTangleHistoryDefaults(void) {
    FlgTangleHistory history;
    flgTangleHistoryInit(&history, (uint32_t)sizeof history);
    return history;
}

static inline FlgTangleRegion flgTangleRegionDefaults(void) {
    FlgTangleRegion region;
    flgTangleRegionInit(&region, (uint32_t)sizeof region);
    return region;
}

static inline FlgTangleInfo flgTangleInfoDefaults(void) {
    FlgTangleInfo info;
    flgTangleInfoInit(&info, (uint32_t)sizeof info);
    return info;
}

static inline FlgTangleSeeds flgTangleSeedsDefaults(void) {
    FlgTangleSeeds seeds;
    flgTangleSeedsInit(&seeds, (uint32_t)sizeof seeds);
    return seeds;
}

static inline FlgTangleDivideDesc flgTangleDivideDefaults(void) {
    FlgTangleDivideDesc desc;
    flgTangleDivideDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgTangleApplyMacroDesc flgTangleApplyMacroDefaults(void) {
    FlgTangleApplyMacroDesc desc;
    flgTangleApplyMacroDescInit(&desc, (uint32_t)sizeof desc);
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
