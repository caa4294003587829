/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Skeletons of drawn shapes. Follows the grammar of filigree.h. Lengths are in the drawing's own unit, whatever it is:
 * drawings of size 1e-12 and 1e12 work alike.
 */
#ifndef FILIGREE_FILIGREE_SKELETON_H
#define FILIGREE_FILIGREE_SKELETON_H

#include "filigree.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The straight skeleton of a contour. Never changes once ready. */
FLG_HANDLE(FlgStraightSkeleton);

/* A drawn shape: ring 0 is its outer contour, the other rings are its holes. Rings may have either orientation and may
 * repeat their first point at the end. The host owns the arrays, which must live for the call. */
typedef struct FlgContourView {
    uint32_t struct_size;
    uint32_t point_count;         /* 3 to 2^24 */
    const double* points;         /* 2 per point: x, y; magnitude 0 or 1e-150 to 1e150 */
    const uint32_t* ring_offsets; /* ring_count + 1 values: the start of each ring, then point_count; null: one ring */
    uint32_t ring_count;          /* at least 1; default 1 */
    uint32_t reserved;
} FlgContourView;

FLG_API FlgResult flgContourViewInit(FlgContourView* view, uint32_t struct_size);

typedef struct FlgStraightSkeletonDesc {
    uint32_t struct_size;
    uint32_t repair; /* nonzero: the contour may cross and touch itself, see below. Default 0 */
    const FlgJobOptions* job;
    const FlgContourView* contour; /* copied */
} FlgStraightSkeletonDesc;

FLG_API FlgResult flgStraightSkeletonDescInit(FlgStraightSkeletonDesc* desc, uint32_t struct_size);

/* Starts a job that makes the straight skeleton of a contour: the paths of its corners as all edges move inwards at
 * unit speed. This call copies and cleans the contour: it orients rings (ring 0 counter-clockwise, holes clockwise)
 * and merges consecutive points closer than 1e-11 of the drawing's size into the first. Collinear points stay, each
 * with a face. The call refuses numbers that are not finite and rings without three points or an area; it takes
 * about 20 ns a point. The job fails with FLG_ERROR_INVALID_ARGUMENT where edges cross or touch, or a hole is not
 * inside; the message names points and place. FLG_ERROR_INTERNAL if too much happens at one time to find a valid
 * skeleton: not known to occur. Cost: about 3 us a point, growing with n log n.
 * With `repair` none of this fails while an area is left. The contour becomes the border of the area that ring 0
 * winds around, either way, minus the areas other rings wind around; of its connected parts, the largest is kept,
 * with its holes. Where nothing crosses or touches, points do not move, to the bit. Elsewhere they move by less than
 * 1e-7 of the drawing's size (about 1e-6 at points where the contour touches itself). Crossings get new points,
 * whose input_points are FLG_NO_INDEX. Repair adds about 2 us a point. */
FLG_API FlgResult flgStraightSkeletonCreate(FlgContext context, const FlgStraightSkeletonDesc* desc,
                                            FlgStraightSkeleton* out_skeleton, FlgJob* out_job);

/* The first nodes are the contour's points, ring by ring, at time 0. Face i is the area swept by the edge that starts
 * at point i. */
typedef struct FlgStraightSkeletonView {
    uint32_t struct_size;
    uint32_t contour_count;       /* points of the cleaned contour; also the number of faces */
    uint32_t node_count;
    uint32_t arc_count;
    const double* nodes;          /* 3 per node: x, y, and the time at which the front arrives: the distance to the
                                     lines of its edges */
    const uint32_t* arcs;         /* 4 per arc: nodes from and to, the later one last; faces to its left and right */
    const uint32_t* face_offsets; /* contour_count + 1 values */
    const uint32_t* face_nodes;   /* each face's nodes counter-clockwise, starting with its edge's two points */
    const uint32_t* input_points; /* one per point of the cleaned contour: its index in the input, or FLG_NO_INDEX */
    /* Both as fractions of the contour's box diagonal. Largest difference between a time and the distance: usually
     * 1e-13, up to 1e-6 with nearly parallel edges. */
    double residual;
    /* How far points were moved to find the skeleton: usually 0; 1e-9 or 1e-7 where events at nearly the same time
     * could not be told apart. The first nodes remain at the contour's points. */
    double perturbation;
} FlgStraightSkeletonView;

FLG_API FlgResult flgStraightSkeletonViewInit(FlgStraightSkeletonView* view, uint32_t struct_size);

/* The arrays live until the skeleton is released. FLG_NOT_READY until its job is published, the job's error if it
 * failed. */
FLG_API FlgResult flgStraightSkeletonGetView(FlgContext context, FlgStraightSkeleton skeleton,
                                             FlgStraightSkeletonView* out_view);

FLG_API FlgResult flgStraightSkeletonRelease(FlgContext context, FlgStraightSkeleton skeleton);

/* The front of a straight skeleton at a time. The host owns the arrays; null arrays are not written. */
typedef struct FlgOffsetPolygons {
    uint32_t struct_size;
    uint32_t point_capacity; /* capacity of `points` and `edges`, in points. Default 0 */
    uint32_t ring_capacity;  /* capacity of `ring_offsets`, in rings. Default 0 */
    uint32_t point_count;    /* always written, whatever the capacity */
    uint32_t ring_count;     /* likewise */
    uint32_t reserved;
    double* points;          /* 2 per point: x, y */
    uint32_t* edges;         /* one per point: the contour edge that made the side from it to the next point */
    uint32_t* ring_offsets;  /* ring_capacity + 1 values: the start of each ring, then point_count */
} FlgOffsetPolygons;

FLG_API FlgResult flgOffsetPolygonsInit(FlgOffsetPolygons* polygons, uint32_t struct_size);

/* The contour moved inwards by a distance, with sharp corners. Rings have their inside on the left; each starts at the
 * side of its lowest-numbered edge, and rings are ordered by these edges. 0 gives the contour; beyond the last node's
 * time nothing is left. Writes the counts, and the arrays if everything fits: call it without arrays to query the size.
 * FLG_NOT_READY until the skeleton's job is published, its error if it failed; FLG_ERROR_INVALID_ARGUMENT for a
 * distance below 0 or not finite. Cost: about 50 ns a point of the contour, each time. */
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
