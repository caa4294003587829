/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Smooth motions of rigid bodies through keyframes (Hofer, Pottmann: Energy-minimizing splines in manifolds, 2004, sec. 4). It
 * follows the grammar of filigree.h. Metres, seconds, doubles. Also for cameras and whatever else has a place and a rotation.
 */
#ifndef FILIGREE_FILIGREE_MOTION_H
#define FILIGREE_FILIGREE_MOTION_H

#include "filigree_spline.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A motion of a rigid body. Never changes once ready. */
FLG_HANDLE(FlgMotion);

/* Keys of a motion, at most. */
#define FLG_MOTION_MAX_KEYS 65536u
/* Positions of a motion, at most. */
#define FLG_MOTION_MAX_POSITIONS (1u << 20)

typedef struct FlgMotionDesc {
    uint32_t struct_size;
    uint32_t key_count;        /* 2 to FLG_MOTION_MAX_KEYS */
    FlgJobOptions job;         /* partial_results: every round can be seen */
    const double* times;       /* one a key, seconds, ascending */
    const double* poses;       /* 12 a key: three rows of four, the rotation and the place. Points p of the body are then at
                                * rotation p + place. Both arrays are read during the call */
    uint32_t closed;           /* nonzero: from the last key back to the first. Default 0 */
    FlgSplineEnergy energy;    /* summed over the body's points. E2: smooth throughout; E1: between keys it flies freely, with kicks at
                                * keys; ET: between the two. Default FLG_SPLINE_E2 */
    double end_time;           /* of closed motions: when the first key comes again, seconds. Default 0: after the last one as
                                * long as keys are apart on the average */
    double tension;            /* of FLG_SPLINE_ET: w, 1 / square second, above 0 to 1e12. Default 1 */
    double smoothing;          /* 0: through the keys. Above: near them, the energy plus the squares of the distances of the
                                * body's points over this is least; seconds to the third (E1: seconds), to 1e9. Default 0 */
    /* The body. Only its barycentre and its inertia count. Points with masses; or, where there are none, a solid box. */
    const double* body_points; /* 3 a point, in the body's coordinates: a few feature points, or a mesh's vertices; read during the
                                * call. Default null: the box */
    const double* body_masses; /* one a point, at least 0, one above; null: 1 each */
    uint32_t body_point_count; /* 1 to 2^20, with body_points. Bodies whose points are on a line get a little thickness, 1/100 of
                                * their length, so that turns about the line are told apart; points in one place: see below */
    uint32_t position_count;   /* of the motion, keys included: key_count to FLG_MOTION_MAX_POSITIONS. Default 0: 32 intervals from
                                * key to key */
    double body_box[3];        /* its sides, about the origin, metres; at least 0. All 0: a point, which turns as a ball of 1 metre.
                                * Default 2, 2, 2: that ball */
    uint32_t max_rounds;       /* of the optimization, 1 to 10000. Default 200 */
    uint32_t reserved;
    double tolerance;          /* of the residual, see FlgSplineView; 1e-12 to 1. Default 1e-6 */
    /* Of space: the barycentre keeps out of these (sec. 5, Fig. 16), see FlgSplineDesc. If their clearance is the body's radius, the
     * distance of its farthest point from the barycentre, so does all of it. Not with smoothing. Default none */
    FlgObstacles obstacles;
    const FlgObstacleSide* sides; /* how the first path passes; default null: the shortest way */
    uint32_t side_count;          /* default 0 */
    uint32_t reserved2;
    double obstacle_radius;       /* 1e-5 to 0.1, see FlgSplineDesc. Default 1e-3 */
} FlgMotionDesc;

FLG_API FlgResult flgMotionDescInit(FlgMotionDesc* desc, uint32_t struct_size);

/* Starts a job that makes the motion of least energy through keys, or near them: the sum over the body's points of the
 * energies of their paths. Then the barycentre's path is the classical spline, and at every moment the fourth derivatives (E1: the
 * second ones) of the points' paths, taken as forces, are in balance: they neither push nor turn the body. Between keys a body
 * takes the shorter way round; put a key between where it is to take the longer one. The job fails with
 * FLG_ERROR_INVALID_ARGUMENT, and a sentence that names the key, for fewer than two keys, times that do not rise by 1e-9 of the whole motion, numbers that are
 * not finite, poses with reflections or that stretch by more than 0.001 (less is taken off), two keys in a row with one pose, and
 * keys whose barycentre is in an obstacle. Cost: some 15 us a position, closed 20; around obstacles
 * what the spline there costs. */
FLG_API FlgResult flgMotionCreate(FlgContext context, const FlgMotionDesc* desc, FlgMotion* out_motion, FlgJob* out_job);

typedef struct FlgMotionView {
    uint32_t struct_size;
    uint32_t position_count;
    uint32_t key_count;
    uint32_t closed;               /* as asked for */
    const double* times;           /* one a position, closed: one more, when the first comes again; seconds */
    const double* poses;           /* 12 a position, as given */
    const double* quaternions;     /* 4 a position, x, y, z, w: the same rotations, next ones on the same side */
    const uint32_t* key_positions; /* one a key: its position */
    double mass;                   /* of the body: its points' number or masses; a box has 6 */
    double barycentre[3];          /* in the body's coordinates */
    double axes[9];                /* principal axes in the body's coordinates, one after another, right-handed */
    double radius;                 /* the distance of its farthest point from the barycentre, metres */
    double inertia[3];             /* half the axes of its ellipsoid of inertia: sqrt(sum of mass * square along the axis / 2) */
    double greatest_stretch;       /* of the keys' poses: what was taken off */
    FlgSplineEnding ending;
    uint32_t rounds;               /* of the optimization of all positions */
    double energy;                 /* with all weights, summed over the body's points */
    double barycentre_energy;      /* of that, the barycentre's share: mass times its path's */
    double rotation_energy;        /* what is left: that of the rotations */
    double residual;               /* of the rotations, see FlgSplineView */
} FlgMotionView;

FLG_API FlgResult flgMotionViewInit(FlgMotionView* view, uint32_t struct_size);

/* The arrays live until the motion is released; of running ones until the next flgTick. FLG_NOT_READY before its job is
 * published (with partial_results: before its first round), its error if it failed. */
FLG_API FlgResult flgMotionGetView(FlgContext context, FlgMotion motion, FlgMotionView* out_view);

FLG_API FlgResult flgMotionRelease(FlgContext context, FlgMotion motion);

/* ---- Defaults by value ------------------------------------------------------------------------------------------- */

static inline FlgMotionDesc flgMotionDefaults(void) {
    FlgMotionDesc desc;
    flgMotionDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgMotionView flgMotionViewDefaults(void) {
    FlgMotionView view;
    flgMotionViewInit(&view, (uint32_t)sizeof view);
    return view;
}

#ifdef __cplusplus
}
#endif

#endif
