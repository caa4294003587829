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

/* How times of keys come about. */
typedef enum FlgMotionTiming {
    FLG_MOTION_TIMING_GIVEN = 0,
    FLG_MOTION_TIMING_CHORD = 1,       /* in proportion to the keys' distances */
    FLG_MOTION_TIMING_CENTRIPETAL = 2, /* to their square roots: calmer where distances differ much */
    FLG_MOTION_TIMING_FORCE_32BIT = 0x7fffffff
} FlgMotionTiming;

/* How fast the path is passed. */
typedef enum FlgMotionPacing {
    FLG_MOTION_PACING_KEYS = 0, /* as the times of keys say */
    FLG_MOTION_PACING_PATH = 1, /* the barycentre keeps its speed from pause to pause */
    FLG_MOTION_PACING_BODY = 2, /* the root mean square of the speeds of the body's points is kept: turns count too */
    FLG_MOTION_PACING_FORCE_32BIT = 0x7fffffff
} FlgMotionPacing;

/* Where the body's -z points, with its +y upwards, as a camera. */
typedef enum FlgMotionLook {
    FLG_MOTION_LOOK_KEYS = 0,   /* as the keys' rotations say */
    FLG_MOTION_LOOK_TARGET = 1, /* from its barycentre to a point, or to another one that moves */
    FLG_MOTION_LOOK_PATH = 2,   /* ahead along the path */
    FLG_MOTION_LOOK_FORCE_32BIT = 0x7fffffff
} FlgMotionLook;

typedef struct FlgMotionDesc {
    uint32_t struct_size;
    uint32_t key_count;       /* 2 to FLG_MOTION_MAX_KEYS */
    const FlgJobOptions* job; /* partial_results: every round is visible, of motions without pauses that neither are
                                 re-timed nor look */
    const double* times;      /* one per key, seconds, ascending; see also timing */
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
    /* Times. What follows moves no place of the path, only when it is passed: pacing, then eases, then limits. */
    FlgMotionTiming timing;       /* other than GIVEN: `times` is ignored and may be null, the motion begins at 0, and
                                     `end_time` is 0. Distances are root mean squares over the body's points. Default
                                     GIVEN */
    FlgMotionPacing pacing;       /* default FLG_MOTION_PACING_KEYS */
    double speed;                 /* m/s, at least 0. With a timing: the keys' distances, in straight lines, over the
                                     duration; 0: 1. With a pacing: the speed that is kept; 0: the motion takes as long
                                     as before. Default 0 */
    const double* eases;          /* two per key, 0 to 1: by how much the motion is slower just before the key, and just
                                     after it. 1: comes to rest, 0: as it is. Times of keys stay. Default null: 0 */
    /* Limits: where the motion passes them it is slowed, nowhere is it made faster. Times of later keys move. An open
     * motion with a limit of acceleration begins and ends at rest. At least 0; 0: none. Default 0 */
    double max_speed;             /* of the barycentre, m/s */
    double max_acceleration;      /* of the barycentre, in all directions, m/s^2 */
    double max_turn;              /* rad/s */
    double max_turn_acceleration; /* rad/s^2 */
    double clearance;             /* metres, at least 0: comes to that of `obstacles`. For cameras the distance of the
                                     near plane's corners; for bodies their radius. Default 0 */
    /* Looking. The keys' rotations are then ignored. */
    FlgMotionLook look;           /* default FLG_MOTION_LOOK_KEYS */
    uint32_t look_count;          /* of the target, 1 to FLG_MOTION_MAX_KEYS, with FLG_MOTION_LOOK_TARGET */
    const double* look_points;    /* 3 per point, relative to `origin`: one point, or those that the target passes
                                     through on a cubic spline; read during the call */
    const double* look_times;     /* one per point, ascending, on the clock of the keys' times: before the first and
                                     after the last the target stands. Re-timing moves it along. Default null: evenly
                                     over the motion, of closed ones around */
    double look_up[3];            /* not 0. Where the body looks straight along it, it keeps its right side. Default
                                     0, 1, 0 */
    double bank;                  /* 0 to 100: leans into curves, by the angle whose tangent is this times the
                                     acceleration to the side over 9.80665 m/s^2. 1: as riders do. Default 0 */
    double bank_time;             /* seconds, 0 to 1e6: over which that acceleration is smoothed. Default 0.25 */
} FlgMotionDesc;

FLG_API FlgResult flgMotionDescInit(FlgMotionDesc* desc, uint32_t struct_size);

/* Starts a job that makes the motion of least energy through keys, or near them: the sum over the body's points of the
 * energies of their paths. The barycentre's path is then the classical spline. At every moment the fourth derivatives
 * (E1: the second ones) of the points' paths, taken as forces, are in balance: they neither push nor turn the body.
 * Between keys a body turns the shorter way round; to force the longer way, add a key in between. Two consecutive keys
 * with the same pose are a pause: the body comes to rest, stands still and leaves from rest (not with smoothing, which
 * passes near both). The job fails with
 * FLG_ERROR_INVALID_ARGUMENT for fewer than two keys, times that do not rise by 1e-9 of the whole motion, numbers that
 * are not finite, poses that reflect or that stretch by more than 0.001 (less is removed), found times between keys
 * with the same pose, eases that are not from 0 to 1, and keys whose barycentre is in an obstacle; the message names
 * the key. Cost: some 15 us a position, closed 20, with E1 40; re-timing and looking 1 to 5 more; around obstacles what
 * the spline there costs. */
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
    double rotation_energy;        /* the rest: that of the rotations; 0 of a body that looks. Before re-timing */
    double residual;               /* of the rotations, see FlgSplineView */
    double origin[3];              /* as in the descriptor */
    double length;                 /* of the barycentre's path, metres */
    /* The largest at any position. */
    double greatest_speed;         /* of the barycentre, m/s */
    double greatest_acceleration;  /* of the barycentre, m/s^2; from second differences */
    double greatest_turn;          /* rad/s */
    double greatest_bank;          /* rad */
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
