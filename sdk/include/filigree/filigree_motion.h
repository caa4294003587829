/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Smooth motions of rigid bodies through keyframes (Hofer, Pottmann: Energy-minimizing splines in manifolds, 2004, sec.
 * 4). Follows the grammar of filigree.h. Metres, seconds, doubles. Also for cameras and anything else with a position
 * and a rotation.
 */
#ifndef FILIGREE_FILIGREE_MOTION_H
#define FILIGREE_FILIGREE_MOTION_H

#include "filigree_spline.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A motion of a rigid body. Never changes once ready. */
FLG_HANDLE(FlgMotion);

/* Maximum keys of a motion. */
#define FLG_MOTION_MAX_KEYS 65536u
/* Maximum positions of a motion. */
#define FLG_MOTION_MAX_POSITIONS (1u << 20)

typedef struct FlgMotionDesc {
    uint32_t struct_size;
    uint32_t key_count;       /* 2 to FLG_MOTION_MAX_KEYS */
    const FlgJobOptions* job; /* partial_results: every round is visible */
    const double* times;      /* one per key, seconds, ascending */
    const double* poses;      /* 12 per key: three rows of four, the rotation and the position. Point p of the body
                                 is then at rotation p + position. Both arrays are read during the call */
    uint32_t closed;          /* nonzero: the last key leads back to the first. Default 0 */
    FlgSplineEnergy energy;   /* summed over the body's points. E2: smooth throughout; E1: free flight between keys,
                                 with kicks at keys; ET: between the two. Default FLG_SPLINE_ENERGY_E2 */
    double end_time;          /* for closed motions: when the first key recurs, seconds. Default 0: one average key
                                 interval after the last key */
    double tension;           /* for FLG_SPLINE_ENERGY_ET: w, 1 / square second, above 0 to 1e12. Default 1 */
    double smoothing;         /* 0: passes through the keys. Above: passes near them, minimizing the energy plus the
                                 squared distances of the body's points over this; seconds to the third (E1:
                                 seconds), to 1e9. Default 0 */
    /* The body; only its barycentre and inertia matter. Points with masses or, without points, a solid box. */
    const double* body_points; /* 3 per point, in the body's coordinates: a few feature points, or a mesh's vertices;
                                  read during the call. Default null: the box */
    const double* body_masses; /* one per point, at least 0, and one above 0; null: 1 each */
    uint32_t body_point_count; /* 1 to 2^20, with body_points. Collinear points get a small thickness, 1/100 of their
                                  length, to define turns about the line; coincident points: see below */
    uint32_t position_count;   /* of the motion, including keys: key_count to FLG_MOTION_MAX_POSITIONS. Default 0: 32
                                  intervals between keys */
    double body_box[3];        /* sides, centred at the origin, metres; at least 0. All 0: a point, which turns like a
                                  ball of 1 metre. Default 2, 2, 2: that ball */
    uint32_t max_rounds;       /* of the optimization, 1 to 10000. Default 200 */
    uint32_t reserved;
    double tolerance;          /* for the residual, see FlgSplineView; 1e-12 to 1. Default 1e-6 */
    /* In space: the barycentre avoids these (sec. 5, Fig. 16), see FlgSplineDesc. The whole body avoids them if
     * their clearance is its radius, the distance of its farthest point from the barycentre. Not with smoothing.
     * Default none */
    FlgObstacles obstacles;
    const FlgObstacleSide* sides; /* how the initial path passes; default null: the shortest way */
    uint32_t side_count;          /* default 0 */
    uint32_t reserved2;
    double obstacle_radius;       /* 1e-5 to 0.1, see FlgSplineDesc. Default 1e-3 */
    double origin[3];             /* metres: what the poses' positions are relative to. Default 0 */
} FlgMotionDesc;

FLG_API FlgResult flgMotionDescInit(FlgMotionDesc* desc, uint32_t struct_size);

/* Starts a job that makes the motion of least energy through keys, or near them: the sum over the body's points of the
 * energies of their paths. The barycentre's path is then the classical spline. At every moment the fourth derivatives
 * (E1: the second ones) of the points' paths, taken as forces, are in balance: they neither push nor turn the body.
 * Between keys a body turns the shorter way round; to force the longer way, add a key in between. The job fails with
 * FLG_ERROR_INVALID_ARGUMENT for fewer than two keys, times that do not rise by 1e-9 of the whole motion, numbers that
 * are not finite, poses that reflect or that stretch by more than 0.001 (less is removed), two consecutive keys with
 * the same pose, and keys whose barycentre is in an obstacle; the message names the key. Cost: some 15 us a position,
 * closed 20; around obstacles what the spline there costs. */
FLG_API FlgResult flgMotionCreate(FlgContext context, const FlgMotionDesc* desc, FlgMotion* out_motion,
                                  FlgJob* out_job);

typedef struct FlgMotionView {
    uint32_t struct_size;
    uint32_t position_count;
    uint32_t key_count;
    uint32_t closed;               /* as in the descriptor */
    const double* times;           /* one per position, closed: one more, when the first recurs; seconds */
    const double* poses;           /* 12 per position, laid out as in the descriptor */
    const double* quaternions;     /* 4 per position, x, y, z, w: the same rotations, consecutive ones in the same
                                      hemisphere */
    const uint32_t* key_positions; /* one per key: its position */
    double mass;                   /* of the body: its point count or total mass; a box has 6 */
    double barycentre[3];          /* in the body's coordinates */
    double axes[9];                /* principal axes in the body's coordinates, one after another, right-handed */
    double radius;                 /* distance of the body's farthest point from the barycentre, metres */
    double inertia[3];             /* half axes of its ellipsoid of inertia: sqrt(sum of mass * square along the axis /
                                      2) */
    double greatest_stretch;       /* largest stretch removed from the keys' poses */
    FlgSplineEnding ending;
    uint32_t rounds;               /* of the optimization of all positions */
    double energy;                 /* with all weights, summed over the body's points */
    double barycentre_energy;      /* the barycentre's share: mass times its path's energy */
    double rotation_energy;        /* the rest: that of the rotations */
    double residual;               /* of the rotations, see FlgSplineView */
    double origin[3];              /* as in the descriptor */
} FlgMotionView;

FLG_API FlgResult flgMotionViewInit(FlgMotionView* view, uint32_t struct_size);

/* The arrays live until the motion is released; while it runs, until the next flgContextTick. FLG_NOT_READY until
 * its job is published (with partial_results: until its first round), the job's error if it failed. */
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
