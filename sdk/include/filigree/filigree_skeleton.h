/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Skeletons of drawn shapes. It follows the grammar of filigree.h. Lengths are in the drawing's own unit, whatever that is:
 * drawings of 1e-12 and of 1e12 are alike.
 */
#ifndef FILIGREE_FILIGREE_SKELETON_H
#define FILIGREE_FILIGREE_SKELETON_H

#include "filigree.h"

#ifndef FLG_NO_INDEX
#define FLG_NO_INDEX 0xffffffffu /* instead of an index: there is none */
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The straight skeleton of a contour. Never changes once ready. */
FLG_HANDLE(FlgStraightSkeleton);

/* What is drawn around a shape: ring 0, and around holes in it: the others. Rings may turn either way, and be closed
 * by a repeated first point or not. The host owns the arrays, for the time of the call. */
typedef struct FlgContourView {
    uint32_t struct_size;
    uint32_t point_count;         /* 3 to 2^24 */
    const double* points;         /* 2 a point: x, y; 0 or 1e-150 to 1e150 in size */
    const uint32_t* ring_offsets; /* ring_count + 1 values: where each ring begins, and point_count; null: one ring */
    uint32_t ring_count;          /* at least 1; default 1 */
    uint32_t reserved;
} FlgContourView;

FLG_API FlgResult flgContourViewInit(FlgContourView* view, uint32_t struct_size);

typedef struct FlgStraightSkeletonDesc {
    uint32_t struct_size;
    uint32_t repair; /* nonzero: the contour may cross and touch itself, see below. Default 0 */
    FlgJobOptions job;
    FlgContourView contour;
} FlgStraightSkeletonDesc;

FLG_API FlgResult flgStraightSkeletonDescInit(FlgStraightSkeletonDesc* desc, uint32_t struct_size);

/* Starts a job that makes the straight skeleton of a contour: what the corners draw when all edges move inwards at
 * unit speed. This call copies the contour and cleans it: rings are turned (ring 0 counter-clockwise, holes
 * clockwise), of points nearer to each other than 1e-11 of the drawing's size that follow each other the first is
 * kept; points on one line with those around them stay, each with a face. It refuses numbers that aren't finite and
 * rings without three points or an area, about 20 ns a point. The job fails with FLG_ERROR_INVALID_ARGUMENT, and a
 * sentence that names points and place, where edges cross or touch and where a hole isn't inside. FLG_ERROR_INTERNAL
 * if so much happens at one time that no skeleton is found that holds: not known to happen. Cost: about 3 us a point,
 * more in all the larger by n log n.
 * With `repair` nothing of this is refused while an area is left: the contour becomes the border of what ring 0 winds
 * around, either way, without what other rings wind around; of its connected parts the largest one, with its holes.
 * Where nothing crosses or touches points stay to the bit, else they move by less than 1e-7 of the drawing's size (at
 * points where it touches itself some 1e-6), and where edges cross there are new ones: their input_points are
 * FLG_NO_INDEX. Costs about 2 us a point more. */
FLG_API FlgResult flgStraightSkeletonCreate(FlgContext context, const FlgStraightSkeletonDesc* desc,
                                            FlgStraightSkeleton* out_skeleton, FlgJob* out_job);

/* The first nodes are the contour's points, ring by ring, with time 0. Face i is what the edge sweeps that begins at
 * point i. */
typedef struct FlgStraightSkeletonView {
    uint32_t struct_size;
    uint32_t contour_count;       /* points of the cleaned contour, and faces */
    uint32_t node_count;
    uint32_t arc_count;
    const double* nodes;          /* 3 a node: x, y, and when the front comes there: the distance to the lines of its edges */
    const uint32_t* arcs;         /* 4 an arc: nodes from and to, the later one last; faces to its left and to its right */
    const uint32_t* face_offsets; /* contour_count + 1 values */
    const uint32_t* face_nodes;   /* a face's nodes counter-clockwise, its edge's two points first */
    const uint32_t* input_points; /* one a point of the cleaned contour: which it was in the input, or FLG_NO_INDEX */
    /* Both in shares of the diagonal of the contour's box. How far a time is off a distance, at most: 1e-13 as a
     * rule, up to 1e-6 with edges that are nearly parallel. */
    double residual;
    /* How far points were moved to find it: 0 as a rule; 1e-9 or 1e-7 where changes at nearly one time could not be
     * told apart. The first nodes are where the contour's points are all the same. */
    double perturbation;
} FlgStraightSkeletonView;

FLG_API FlgResult flgStraightSkeletonViewInit(FlgStraightSkeletonView* view, uint32_t struct_size);

/* The arrays live until the skeleton is released. FLG_NOT_READY before its job is published, its error if it failed. */
FLG_API FlgResult flgStraightSkeletonGetView(FlgContext context, FlgStraightSkeleton skeleton,
                                             FlgStraightSkeletonView* out_view);

FLG_API FlgResult flgStraightSkeletonRelease(FlgContext context, FlgStraightSkeleton skeleton);

/* Where the front of a straight skeleton is at a time. The host owns the arrays; a null one isn't written. */
typedef struct FlgOffsetPolygons {
    uint32_t struct_size;
    uint32_t point_capacity; /* points that `points` and `edges` have room for. Default 0 */
    uint32_t ring_capacity;  /* rings that `ring_offsets` has room for. Default 0 */
    uint32_t point_count;    /* written, whatever there is room for */
    uint32_t ring_count;     /* the same */
    uint32_t reserved;
    double* points;          /* 2 a point: x, y */
    uint32_t* edges;         /* one a point: the contour's edge whose side goes from it to the next one */
    uint32_t* ring_offsets;  /* ring_capacity + 1 values: where each ring begins, and point_count */
} FlgOffsetPolygons;

FLG_API FlgResult flgOffsetPolygonsInit(FlgOffsetPolygons* polygons, uint32_t struct_size);

/* The contour moved inwards by a distance, with its corners kept sharp: rings with what is inside on their left, each
 * from the side of its edge of least number on, in the order of these. 0 gives the contour; beyond its last node's
 * time nothing is left. Writes the counts, and the arrays where all of it has room: call it without arrays to learn
 * how much. FLG_NOT_READY before the skeleton's job is published, its error if it failed; FLG_ERROR_INVALID_ARGUMENT
 * for a distance below 0 or not finite. Cost: about 50 ns a point of the contour, each time. */
FLG_API FlgResult flgStraightSkeletonOffset(FlgContext context, FlgStraightSkeleton skeleton, double distance,
                                            FlgOffsetPolygons* polygons);

/* ---- Defaults by value ------------------------------------------------------------------------------------------- */

static inline FlgContourView flgContourViewDefaults(void) {
    FlgContourView view;
    flgContourViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgStraightSkeletonDesc flgStraightSkeletonDefaults(void) {
    FlgStraightSkeletonDesc desc;
    flgStraightSkeletonDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgOffsetPolygons flgOffsetPolygonsDefaults(void) {
    FlgOffsetPolygons polygons;
    flgOffsetPolygonsInit(&polygons, (uint32_t)sizeof polygons);
    return polygons;
}

static inline FlgStraightSkeletonView flgStraightSkeletonViewDefaults(void) {
    FlgStraightSkeletonView view;
    flgStraightSkeletonViewInit(&view, (uint32_t)sizeof view);
    return view;
}

#ifdef __cplusplus
}
#endif

#endif
