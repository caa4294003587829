/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Live strokes: curves that are stylized while they are drawn. Same grammar and rules as filigree.h.
 *
 *     flgStyleWarm(context, style, 0, NULL, &job);            once for each style and temperature, ahead of time
 *     flgLiveStrokeBegin(context, &desc, &stroke);            trigger pressed
 *     flgLiveStrokePush(context, stroke, samples, n, &view);  each frame: `view` shows what is new, append it to a mesh
 *     flgLiveStrokeEnd(context, stroke, NULL, &stylized, &samples, &job);  trigger released
 *
 * The curve        The smooth curve of flgResample through the samples. A sample's direction depends on the one after it,
 *                  so the curve is known, and points are made, up to the last but one sample that is a place of its own:
 *                  the geometry is one sample behind (11 ms at 90 Hz), and `smoothing` seconds more if that is set.
 * The points       At even steps of arc length along it, FlgStyleInfo::spacing * scale, whatever the sample rate. Once
 *                  made, a point never moves. Columns: POSITION, TANGENT, NORMAL, RADIUS, STYLE_INDEX, TIME, and the
 *                  style's attributes but for RADIUS, all as flgStylize gives them. What differs: flgStylize knows a
 *                  curve's length, and takes as many whole steps as come nearest, so that its last point is the curve's
 *                  end; here the step is exact, and the last point lies up to one step before the end.
 * Radius           radius_min + (radius_max - radius_min) * pressure; if the style has a RADIUS attribute, times that in
 *                  units of its mean over the style.
 * Time             When the hand was there, seconds from the first sample on; if the style has a SPEED attribute, when a motion at
 *                  that speed is, from 0 on.
 * Frame            Rotation-minimizing (double reflection). The first normal is the first sample's controller's y axis
 *                  made perpendicular to the curve, or its x axis if the y axis is within 18 degrees of the curve's
 *                  direction. Without an orientation: the coordinate axis furthest from the direction.
 *                  Supplied: the controller's y axis at every point, interpolated between the samples (and smoothed with
 *                  them) and made perpendicular to the curve; where it points along the curve, or samples have no
 *                  orientation, carried on from the last point where it did not.
 * Cost             Depends on the new samples only, about 0.2 us a sample and 0.1 us a point. Pushing allocates nothing:
 *                  all memory is taken by flgLiveStrokeBegin.
 * Delivery         A pushed sample makes 64 points at most, so that no push is long (p99 under 20 us, longest under 100 us
 *                  of processor time), however far the hand has jumped and however fine the style is. What is due beyond
 *                  that is made by the samples after it, in order, and by the job of flgLiveStrokeEnd. So points come one
 *                  sample late as long as the hand goes no more than 64 steps a sample on average: with steps of 1 mm,
 *                  5 m/s at 90 Hz. A hand that goes further falls behind, and catches up by 64 steps a sample
 *                  (FlgLiveStrokeInfo::waiting_samples says how many samples it is behind).
 * Style by stroke  flgLiveStrokeEnd's samples as the style of flgStyleCreate: ready in the next frame at 90 Hz (11 ms, one
 *                  worker) for strokes of up to some 600 samples; of 1,200 in about 4 frames, of 2,400 in 6. Preparing grows
 *                  faster than the style's points, which end at 2,048 by themselves.
 * Determinism      Points depend on the samples alone, not on how they were grouped into pushes, and not on what was
 *                  undone. Recorded samples give the same bits again by flgLiveStrokeReplay.
 */
#ifndef FILIGREE_FILIGREE_LIVE_H
#define FILIGREE_FILIGREE_LIVE_H

#include "filigree.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A stroke that is being drawn. Strokes are independent of each other. */
FLG_HANDLE(FlgLiveStroke);

/* Starts a job that computes all path trees of a style at a temperature, as live strokes need them: they never compute
 * one. The style keeps those of the last four temperatures that were asked for (by flgStylize and flgLiveStrokeBegin
 * as well). `temperature` as in FlgStylizeDesc; `options` may be null: defaults. Cost: 0.1 ms of work for each of up to 256
 * trees. */
FLG_API FlgResult flgStyleWarm(FlgContext context, FlgStyle style, float temperature, const FlgJobOptions* options,
                               FlgJob* out_job);

typedef struct FlgLiveStrokeDesc {
    uint32_t struct_size;
    /* FLG_START_AUTO is FLG_START_STYLE here. */
    FlgStart start;
    FlgStyle style;
    /* As in FlgStylizeDesc. */
    float magnitude;
    float temperature; /* the style has to be warm at this */
    float scale;       /* > 0 */
    /* Metres, >= 0: the radius at pressure 0 and at pressure 1. Default 0.001 and 0.005. */
    float radius_min, radius_max;
    /* Time constant of an exponential filter on position and pressure, seconds, >= 0; exact for hands that move evenly
     * between samples, so independent of the sample rate. A hand that moves evenly is followed this much later.
     * 0: none. Default 0. */
    float smoothing;
    /* The longest way from one sample to the next, metres, > 0: what jumps further is refused. Default 1. */
    float max_jump;
    /* Samples (1 to 2^20) and points (1 to 2^24) that memory is taken for: about 270 bytes a sample, 44 a point and 4 for
     * each component of the style's attributes.
     * Default 16,384 and 65,536. */
    uint32_t max_samples;
    uint32_t max_points; /* what is due beyond is cut off, see FlgLiveStrokeInfo */
    /* FLG_FRAME_ROTATION_MINIMIZING or FLG_FRAME_SUPPLIED: by the controller, see above. FLG_FRAME_FRENET is refused: its
     * normal lies between a point's neighbours, of which the later one is not drawn yet. */
    FlgFrameMethod frame;
    /* Key of all random choices. Default 1. */
    uint64_t seed;
    /* As in FlgStylizeDesc. Default: identity. */
    float basis[9];
    uint32_t reserved;
} FlgLiveStrokeDesc;

FLG_API FlgResult flgLiveStrokeDescInit(FlgLiveStrokeDesc* desc, uint32_t struct_size);

/* Begins a stroke. FLG_NOT_READY while the style is not prepared, or not warm at this temperature (flgStyleWarm), and
 * flgLastError() says which; the error of the style's job if that failed. Cost: the allocation of its memory; nothing is
 * touched. (An allocator that hands out pages that were touched before spares pushes the system's cost of first touches.) */
FLG_API FlgResult flgLiveStrokeBegin(FlgContext context, const FlgLiveStrokeDesc* desc, FlgLiveStroke* out_stroke);

/* What a controller says. */
typedef struct FlgLiveSample {
    float position[3];    /* metres, at most 1e30 in size */
    float orientation[4]; /* quaternion x y z w of any length; all zero: none; see Frame */
    float pressure;       /* 0 to 1 */
    double time;          /* seconds on any clock; not falling */
} FlgLiveSample;

/* Takes samples; out_new (may be null) shows the points that this call made. All samples are checked first; if one can't be
 * taken, none is, and the stroke stays as it was and can go on:
 *   FLG_ERROR_INVALID_ARGUMENT  a number that is not finite or out of range, a time before that of the sample before it
 *   FLG_ERROR_LIMIT             a jump beyond max_jump (end the stroke there and begin another), more than max_samples, or
 *                               the stroke is cut at max_points (FlgLiveStrokeInfo::cut): it can be ended, and samples
 *                               undone
 * Repeated samples are taken and make no points: nor do ones nearer to the last place than 0.001 of a step, or with smoothing
 * ones at the time of the one before. The view lives until the next call for this stroke, the arrays it points to
 * until the stroke is released; its curve_count is 0 if there is nothing new. After flgLiveStrokeEnd:
 * FLG_ERROR_INVALID_ARGUMENT. Cost: about 0.2 us a sample and 0.1 us a point. */
FLG_API FlgResult flgLiveStrokePush(FlgContext context, FlgLiveStroke stroke, const FlgLiveSample* samples,
                                    uint32_t count, FlgCurveSetView* out_new);

/* All points so far; lives as long as flgLiveStrokePush's. Once the job of flgLiveStrokeEnd is published: the whole stroke.
 * Cost: tens of nanoseconds. */
FLG_API FlgResult flgLiveStrokeGetPoints(FlgContext context, FlgLiveStroke stroke, FlgCurveSetView* out_view);

/* How far a stroke is. */
typedef struct FlgLiveStrokeInfo {
    uint32_t struct_size;
    uint32_t sample_count;
    uint32_t point_count;
    uint32_t waiting_samples; /* not read yet, because points of those before are due: see Delivery; 0 on the whole */
    uint32_t ended;           /* nonzero from flgLiveStrokeEnd to flgLiveStrokeResume */
    float spacing;            /* metres: a step */
    uint32_t cut;             /* nonzero: more points were due than max_points; the stroke ends before its samples do */
} FlgLiveStrokeInfo;

/* How far the stroke is; set its struct_size. Cost: tens of nanoseconds. */
FLG_API FlgResult flgLiveStrokeGetInfo(FlgContext context, FlgLiveStroke stroke, FlgLiveStrokeInfo* out_info);

/* Takes the last `count` samples back, and the points that they made: the stroke is as it was before they were pushed, to the
 * bit. out_point_count (may be null): points left. Refused for an ended stroke: resume it first.
 * Cost: that of pushing up to 5 samples. */
FLG_API FlgResult flgLiveStrokeUndo(FlgContext context, FlgLiveStroke stroke, uint32_t count,
                                    uint32_t* out_point_count);

/* Ends a stroke: starts a job that follows the curve to its last sample and copies the stylized points into one set, the
 * samples into another (POSITION, ORIENTATION, PRESSURE, TIME from the first sample on, seconds). Both can be used at once
 * as inputs: `out_samples` as the style of flgStyleCreate, or as the target of flgStylize. The last
 * point is up to one step before the last sample. A stroke without length is one point, not displaced. Either set may be null:
 * not wanted; `options` may be null. The handle stays valid, for flgLiveStrokeResume, until it is released; if the job
 * does not succeed, the stroke goes on as if it had not been ended. Refused for a stroke without samples.
 * A stroke that comes to max_points is cut there, and the job succeeds with the points that there are: once it is published,
 * FlgLiveStrokeInfo::cut says so. `out_samples` has all samples, to be stylized whole. Cost: about 6 ns a point. */
FLG_API FlgResult flgLiveStrokeEnd(FlgContext context, FlgLiveStroke stroke, const FlgJobOptions* options,
                                   FlgCurveSet* out_stylized, FlgCurveSet* out_samples, FlgJob* out_job);

/* Goes on with an ended stroke, as if it had never been ended: the points that its end added, not knowing what follows, are
 * taken back. FLG_NOT_READY while a job still reads the stroke. Sets that were made stay as they are.
 * Cost: that of pushing up to 5 samples. */
FLG_API FlgResult flgLiveStrokeResume(FlgContext context, FlgLiveStroke stroke);

/* Starts a job that copies an ended stroke in two: points 0 to `point` and `point` to the last, so that they meet.
 * FLG_NOT_READY while the job of flgLiveStrokeEnd is not published. Cost: about 10 ns a point. */
FLG_API FlgResult flgLiveStrokeSplit(FlgContext context, FlgLiveStroke stroke, uint32_t point,
                                     const FlgJobOptions* options, FlgCurveSet* out_first, FlgCurveSet* out_second,
                                     FlgJob* out_job);

/* Ends without results. Jobs that read the stroke keep its memory until they are done. */
FLG_API FlgResult flgLiveStrokeRelease(FlgContext context, FlgLiveStroke stroke);

/* The batch form: starts a job that draws every curve of a set of recorded samples as a live stroke, and ends it. Curve c
 * is what a live stroke with the same descriptor and seed `seed + c` gives for these samples, bit for bit. Missing columns:
 * no orientation, pressure 1; without TIME `smoothing` must be 0, and the hand was everywhere at 0 s. What flgLiveStrokePush would refuse for its values fails the
 * job with the same result, and so does a curve of more than max_points points: FLG_ERROR_LIMIT, before memory is taken
 * (which is for the points there are, not for max_points); max_samples does not count. Closed curves are drawn open. The style
 * need not be ready or warm. `options` may be null. Cost: about 0.3 us a point. */
FLG_API FlgResult flgLiveStrokeReplay(FlgContext context, const FlgLiveStrokeDesc* desc, FlgCurveSet samples,
                                      const FlgJobOptions* options, FlgCurveSet* out_set, FlgJob* out_job);

static inline FlgLiveStrokeDesc flgLiveStrokeDefaults(void) {
    FlgLiveStrokeDesc desc;
    flgLiveStrokeDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

#ifdef __cplusplus
}
#endif

#endif
