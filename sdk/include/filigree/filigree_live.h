/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Live strokes: curves that are stylized while they are drawn. Same grammar and rules as filigree.h.
 *
 *     flgStyleWarm(context, style, 0, NULL, &job);            once for each style and temperature, ahead of time
 *     flgLiveStrokeBegin(context, &desc, &stroke);            trigger pressed
 *     flgLiveStrokePush(context, stroke, &samples, &view);    each frame: `view` shows what is new, append it to a mesh
 *     flgLiveStrokeGetTip(context, stroke, &tip);             each frame: what to draw behind the points so far
 *     flgLiveStrokeEnd(context, stroke, NULL, &stylized, &samples, &job);  trigger released
 *
 * The curve        flgCurveSetResample's smooth curve through the samples. A sample's direction depends on the next
 *                  sample. Points are therefore made only up to the last but one distinct sample: final geometry lags
 *                  one sample behind (11 ms at 90 Hz), plus `smoothing` seconds if set. flgLiveStrokeGetTip gives the
 *                  rest, up to the last sample, for this frame.
 * The points       At even steps of arc length along the curve, FlgStyleInfo::spacing * scale, whatever the sample
 *                  rate. Points never move. The last lies up to one step before the end. Columns: POSITION, TANGENT,
 *                  NORMAL, RADIUS, STYLE_INDEX, TIME, and the style's attributes except RADIUS.
 * Live is batch    flgCurveSetStylize, given the samples of flgLiveStrokeEnd and exact_spacing = 1, gives the same
 *                  points to the bit: POSITION, TANGENT, NORMAL, STYLE_INDEX and attributes, for the same style,
 *                  magnitude, temperature, scale, basis, start and seed. Without exact_spacing it takes the nearest
 *                  whole number of steps, so that its last point is the curve's end: frames are the same, points lie up
 *                  to half a step from those drawn, and the last run may go on to the style's end. What cannot be the
 *                  same: RADIUS and TIME, which a live stroke makes of pressure and clock, the other carries over from
 *                  its target; `smoothing`, which the samples lack; the first normal without ORIENTATION, since the
 *                  other knows the whole curve; supplied frames (a NORMAL column there); end caps, unless `end_cap` is
 *                  set; samples nearer to each other than a thousandth of a step (the first counts); strokes shorter
 *                  than a step (one point here, two there), or than both caps; what passes max_points.
 * Caps             A stroke begins with its style's start cap (FlgStyleDesc). Its points get no end cap: they never
 *                  move, and the end is not known before it is there. With `end_cap` the set that flgLiveStrokeEnd
 *                  makes ends with it: its last points, up to 256 and the cap, are not those drawn, but
 *                  flgCurveSetStylize's. flgLiveStrokeGetPoints, resuming and splitting go by those drawn.
 * Steering         `drives`, as flgCurveSetStylize has them: by the hand's pressure and its speed; 10 ns a point more.
 * Several styles   A drive of FLG_STYLE_DRIVEN_STYLE chooses among `style` and `further_styles` while the hand draws.
 *                  Points never move, so a blend begins where the choice changes and is over style_blend metres behind
 *                  it; flgCurveSetStylize begins it half of that earlier. Where both have one style alone they give
 *                  the same bits, if it is the one with the smallest spacing or has the same; but for NORMAL of a style
 *                  with ANGLE, which differs by rounding. Between the points of a style with a wider spacing,
 *                  flgCurveSetStylize interpolates its results and a live stroke its displacements: they differ by what
 *                  the curve bends within a step of that style; and a driven temperature counts a step earlier there. A
 *                  choice holds for at least a 16th of a blend, even if the hand changes its mind sooner. k styles
 *                  share the 1,024 points of a push (see Delivery). Cost: some 35 ns a point for each style; a sample
 *                  of 60 points takes some 8 us with 2 styles, some 21 us with 8.
 * Radius           min_radius + (max_radius - min_radius) * pressure; if the style has a RADIUS attribute, multiplied
 *                  by that attribute relative to its mean over the style, and by what drives the radius.
 * Time             When the hand was there, in seconds since the first sample. If the style has a SPEED attribute: when
 *                  a motion at that speed gets there, starting at 0.
 * Frame            Rotation-minimizing (double reflection). The first normal is the y axis of the controller at the
 *                  first sample, made perpendicular to the curve; or its x axis if the y axis is within 18 degrees of
 *                  the curve's direction. Without an orientation: the coordinate axis furthest from the direction.
 *                  Resampling and stylizing a set with an ORIENTATION column, such as these samples, begins the same
 *                  way.
 *                  Supplied: the controller's y axis at every point, interpolated between samples (and smoothed with
 *                  them) and made perpendicular to the curve; where it is parallel to the curve, or samples have no
 *                  orientation, carried on from the last point where it was defined.
 * Cost             Depends only on the new samples: about 0.5 us a sample and 30 ns a point. Pushing allocates
 *                  nothing; flgLiveStrokeBegin takes all memory.
 * Delivery         Points come one sample late. A sample of a hand that moves at most 64 steps a sample (with steps of
 *                  1 mm, 5 m/s at 90 Hz) takes under 8 us; samples that need more points than that are counted in
 *                  FlgLiveStrokeInfo::dense_samples, and take in proportion longer. Each pushed sample makes at most
 *                  1,024 points, some 50 us of processor time, however far the hand jumps and
 *                  however fine the style is. What is left waits (waiting_samples, waiting_points): later samples make
 *                  it in order, 1,024 points each, so that the points of a jump of 3,072 steps are there 3 samples
 *                  later, and the job of flgLiveStrokeEnd makes the last.
 * Threads          Functions marked [any thread, one per stroke] may run while another thread is inside any other call
 *                  of the context, flgContextTick included: an input thread pushes and never waits for a tick. They
 *                  take no lock. Only calls that take the same stroke must not overlap each other, and
 *                  flgContextDestroy must not overlap anything. So hand a stroke to the input thread after
 *                  flgLiveStrokeBegin, and take it back before flgLiveStrokeEnd, Resume, Split or Release.
 * Style by stroke  Pass flgLiveStrokeEnd's samples to flgStyleCreate as the style. It is ready in the next frame at 90
 *                  Hz (11 ms, one worker) for strokes of up to about 600 samples; 1,200 take about 4 frames, 2,400 take
 *                  6. Preparation time grows faster than the number of style points, which stops at 2,048 by default.
 * Determinism      Points depend only on the samples, not on their grouping into pushes, and not on undone samples.
 *                  flgLiveStrokeReplay makes the same bits again from recorded samples.
 */
#ifndef FILIGREE_FILIGREE_LIVE_H
#define FILIGREE_FILIGREE_LIVE_H

#include "filigree.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A stroke being drawn. Strokes are independent of each other. */
FLG_HANDLE(FlgLiveStroke);

/* Starts a job that computes all path trees of a style at a temperature. Live strokes need them and never compute one.
 * The style keeps those of the last four temperatures requested, including by flgCurveSetStylize and
 * flgLiveStrokeBegin. `temperature` as in FlgCurveSetStylizeDesc; `job` may be null: defaults. Cost: 0.1 ms of
 * work for each of up to 256 trees. */
FLG_API FlgResult flgStyleWarm(FlgContext context, FlgStyle style, float temperature, const FlgJobOptions* job,
                               FlgJob* out_job);

typedef struct FlgLiveStrokeDesc {
    uint32_t struct_size;
    /* FLG_STYLE_START_AUTO is FLG_STYLE_START_STYLE here. */
    FlgStyleStart start;
    FlgStyle style;
    /* As in FlgCurveSetStylizeDesc. */
    float magnitude;
    float temperature; /* the style must be warm at this temperature */
    /* > 0, or 0 = chosen from the radii, as a stroke's length is not known while it is drawn: the mean of the two radii
     * below becomes 0.14 of the style's swing, scale * displacement_rms, so that turns stay apart. 1 if both are 0 or
     * the style has no displacement. FlgLiveStrokeInfo::scale has the one chosen. Default 1. */
    float scale;
    /* Radius at pressure 0 and at pressure 1, metres, >= 0. Default 0.001 and 0.005. */
    float min_radius, max_radius;
    /* Time constant of an exponential filter on position and pressure, seconds, >= 0; adds that much lag to a steady
     * hand. Exact for hands that move evenly between samples, so independent of the sample rate. 0: none. Default 0. */
    float smoothing;
    /* Maximum distance between consecutive samples, metres, > 0; longer jumps are refused. Default 1. */
    float max_jump;
    /* Capacity in samples (1 to 2^20) and points (1 to 2^24): about 400 bytes a sample (with several styles 350 more
     * for each), 44 a point and 4 for each component of the style's attributes; 257 more points for the tip. Default
     * 16,384 and 65,536. */
    uint32_t max_samples;
    uint32_t max_points; /* points beyond this are cut off, see FlgLiveStrokeInfo */
    /* FLG_FRAME_METHOD_ROTATION_MINIMIZING or FLG_FRAME_METHOD_SUPPLIED (by the controller, see above).
     * FLG_FRAME_METHOD_FRENET is refused: its normal needs a point's next neighbour, which is not drawn yet. */
    FlgFrameMethod frame;
    /* Key for all random choices. Default 1. */
    uint64_t seed;
    /* As in FlgCurveSetStylizeDesc. Default: identity. */
    float basis[9];
    uint32_t reserved;
    double origin[3]; /* metres: what samples and points are relative to. flgLiveStrokeReplay takes its samples'
                         instead. Default 0 */
    /* What the hand drives along the stroke, at most 8; null: nothing. By PRESSURE, or by SPEED: metres a second from
     * the sample before (infinite in no time), for which samples need times. The style must be warm at both
     * temperatures of a drive. Copied by flgLiveStrokeBegin. */
    const FlgStyleDrive* drives;
    uint32_t drive_count;
    /* Nonzero: what flgLiveStrokeEnd and flgLiveStrokeReplay make ends with the style's end cap, see Caps. It is drawn
     * once more for that, as a job. Default 0. */
    uint32_t end_cap;
    /* More styles, at most 7, among which a drive of FLG_STYLE_DRIVEN_STYLE chooses while the hand draws; null: none.
     * They must be prepared and warm like `style`, and transfer the same attributes. The stroke's points are as close
     * together as those of the style with the smallest spacing. STYLE_INDEX counts through the points of all styles,
     * one style behind the other, and is that of the style that counts most. See Several styles. */
    const FlgStyle* further_styles;
    uint32_t further_style_count;
    /* Over which length of the stroke one style turns into the next, metres, >= 0: it begins where the choice changes
     * and goes on evenly, in direction too. 0: two patches of the style whose points are farthest apart. Default 0. */
    float style_blend;
} FlgLiveStrokeDesc;

FLG_API FlgResult flgLiveStrokeDescInit(FlgLiveStrokeDesc* desc, uint32_t struct_size);

/* Begins a stroke. FLG_NOT_READY while the style is not prepared, or not warm at this temperature (flgStyleWarm);
 * flgErrorGetMessage() says which. Returns the error of the style's job if that failed. Cost: the allocation of its
 * memory, which it does not touch. (An allocator that returns pages touched before spares pushes the system's cost
 * of first touches.) */
FLG_API FlgResult flgLiveStrokeBegin(FlgContext context, const FlgLiveStrokeDesc* desc, FlgLiveStroke* out_stroke);

/* Samples of the controller, as columns: arrays of the host, or members of an array of structs. */
typedef struct FlgLiveSampleView {
    uint32_t struct_size;
    uint32_t sample_count;
    uint32_t stride;           /* bytes from a sample to the next in every column: the size of the host's struct.
                                  Default 0: every column is packed */
    uint32_t reserved;
    const float* positions;    /* 3 per sample, metres, magnitude at most 1e30 */
    const float* orientations; /* 4 per sample: a quaternion x y z w of any length; all zero: none; see Frame. Default
                                  null: none */
    const float* pressures;    /* one per sample, 0 to 1. Default null: 1 */
    const double* times;       /* one per sample, seconds on any clock; never decreasing. `smoothing` needs them.
                                  Default null: 0 */
} FlgLiveSampleView;

FLG_API FlgResult flgLiveSampleViewInit(FlgLiveSampleView* view, uint32_t struct_size);

/* [any thread, one per stroke] Adds samples; out_new (may be null) shows the points this call made. Checks all
 * samples first: if one is invalid, none is added, and the stroke stays unchanged and can continue:
 *   FLG_ERROR_INVALID_ARGUMENT  a number that is not finite or out of range, or a time before the previous sample's
 *   FLG_ERROR_LIMIT             a jump beyond max_jump (end the stroke there and begin another), more than max_samples,
 *                               or the stroke is cut at max_points (FlgLiveStrokeInfo::cut): it can still be ended, and
 *                               samples undone
 * Repeated samples are accepted but make no points; nor do samples closer than 0.001 of a step to the last distinct
 * one, or, with smoothing, samples with the same time as the previous one. The view lives until the next call for this
 * stroke, its arrays until the stroke is released; curve_count is 0 if there is nothing new. After flgLiveStrokeEnd:
 * FLG_ERROR_INVALID_ARGUMENT. Cost: about 0.2 us a sample and 0.1 us a point. */
FLG_API FlgResult flgLiveStrokePush(FlgContext context, FlgLiveStroke stroke, const FlgLiveSampleView* samples,
                                    FlgCurveSetView* out_new);

/* [any thread, one per stroke] All points so far; lives as long as flgLiveStrokePush's view. Once the job of
 * flgLiveStrokeEnd is published: the whole stroke. Cost: tens of nanoseconds. */
FLG_API FlgResult flgLiveStrokeGetPoints(FlgContext context, FlgLiveStroke stroke, FlgCurveSetView* out_view);

/* [any thread, one per stroke] Where the stroke would be if it ended now, so that what is drawn is not a sample behind
 * the hand: a curve of the last point so far, if there is one, and the points that flgLiveStrokeEnd would add, bit for
 * bit. All columns of flgLiveStrokeGetPoints. curve_count is 0 if the end would add nothing. Draw it for a frame, then
 * drop it: the next sample bends it, and these points never become part of the stroke. The call changes no other
 * result. It looks ahead by at most 256 points, fewer only where samples wait (4 less for each sample read); beyond
 * that the tip stops short of the hand. Allocates nothing. The view and its arrays live until the next call of this
 * function for this stroke, or the stroke's release. Works after flgLiveStrokeEnd too, until its job is published: then
 * there is no tip any more. Cost: about 0.5 us, and 30 ns a point. */
FLG_API FlgResult flgLiveStrokeGetTip(FlgContext context, FlgLiveStroke stroke, FlgCurveSetView* out_tip);

/* Progress of a stroke. */
typedef struct FlgLiveStrokeInfo {
    uint32_t struct_size;
    uint32_t sample_count;
    uint32_t point_count;
    uint32_t waiting_samples; /* not read yet, because earlier samples still have points to make: see Delivery; usually
                                 0 */
    uint32_t ended;           /* nonzero from flgLiveStrokeEnd to flgLiveStrokeResume */
    float spacing;            /* metres: one step */
    uint32_t cut;             /* nonzero: the samples need more than max_points points; the stroke ends before its
                                 samples do */
    float scale;              /* of the style: FlgLiveStrokeDesc::scale, or the one chosen for 0 */
    uint32_t waiting_points;  /* about how many points the samples so far still have to get; usually 0. Every sample to
                                 come makes 1,024 of them at most: see Delivery */
    uint32_t dense_samples;   /* samples from which on the stroke has had more than 64 points to the next: pushing them
                                 takes longer. A larger scale or more samples a second make it fewer */
} FlgLiveStrokeInfo;

FLG_API FlgResult flgLiveStrokeInfoInit(FlgLiveStrokeInfo* info, uint32_t struct_size);

/* [any thread, one per stroke] The stroke's progress; set struct_size. Cost: tens of nanoseconds. */
FLG_API FlgResult flgLiveStrokeGetInfo(FlgContext context, FlgLiveStroke stroke, FlgLiveStrokeInfo* out_info);

/* [any thread, one per stroke] Removes the last `count` samples and the points they made: restores the stroke as it
 * was before they were pushed, to the bit. out_point_count (may be null): points left. Refused for an ended stroke:
 * resume it first. Cost: that of pushing up to 5 samples. */
FLG_API FlgResult flgLiveStrokeUndo(FlgContext context, FlgLiveStroke stroke, uint32_t count,
                                    uint32_t* out_point_count);

/* Ends a stroke: starts a job that follows the curve to its last sample. The job copies the stylized points into one
 * set and the samples into another (POSITION, ORIENTATION, PRESSURE, TIME since the first one, s, RADIUS). Both
 * can be used as inputs at once: `out_samples` as the style of flgStyleCreate, or as the target of
 * flgCurveSetStylize. The last point lies up to one step before the last sample. A zero-length stroke is one point,
 * not displaced. Either set may be null if not needed. `job` may be null: FLG_PRIORITY_HIGH then, since somebody waits
 * for it. The handle stays valid, for flgLiveStrokeResume, until it is released; if the job fails, the stroke
 * continues as if it had not been ended.
 * Refused for a stroke without samples. A stroke that reaches max_points is cut there, and the job succeeds with the
 * points made so far; once the job is published, FlgLiveStrokeInfo::cut is set. `out_samples` has all samples, so
 * the whole stroke can be stylized from it. Cost: about 6 ns a point. */
FLG_API FlgResult flgLiveStrokeEnd(FlgContext context, FlgLiveStroke stroke, const FlgJobOptions* job,
                                   FlgCurveSet* out_stylized, FlgCurveSet* out_samples, FlgJob* out_job);

/* Resumes an ended stroke, as if it had never been ended: removes the points its end added without knowing the next
 * sample. FLG_NOT_READY while a job still reads the stroke. Sets already made do not change. Cost: that of pushing up
 * to 5 samples. */
FLG_API FlgResult flgLiveStrokeResume(FlgContext context, FlgLiveStroke stroke);

/* Starts a job that splits an ended stroke into two copies that meet: points 0 to `point`, and `point` to the last.
 * `job` as for flgLiveStrokeEnd. FLG_NOT_READY until the job of flgLiveStrokeEnd is published. Cost: about 10 ns a
 * point. */
FLG_API FlgResult flgLiveStrokeSplit(FlgContext context, FlgLiveStroke stroke, uint32_t point,
                                     const FlgJobOptions* job, FlgCurveSet* out_first, FlgCurveSet* out_second,
                                     FlgJob* out_job);

/* Ends the stroke without results. Jobs that read the stroke keep its memory until they finish. */
FLG_API FlgResult flgLiveStrokeRelease(FlgContext context, FlgLiveStroke stroke);

/* The batch form: starts a job that draws every curve of a set of recorded samples as a live stroke, and ends it.
 * Curve c equals a live stroke through these samples with the same descriptor and seed `seed + c`, bit for bit.
 * Missing columns mean: no orientation, pressure 1, all times 0 s; without TIME, `smoothing` must be 0. Values that
 * flgLiveStrokePush would refuse fail the job with the same result. So does a curve of more than max_points points:
 * FLG_ERROR_LIMIT, before memory is taken (for the points needed, not for max_points). max_samples does not apply.
 * Closed curves are drawn open. The style need not be ready or warm. `job` may be null. Cost: about 0.3 us a
 * point. */
FLG_API FlgResult flgLiveStrokeReplay(FlgContext context, const FlgLiveStrokeDesc* desc, FlgCurveSet samples,
                                      const FlgJobOptions* job, FlgCurveSet* out_set, FlgJob* out_job);

static inline FlgLiveSampleView flgLiveSampleViewDefaults(void) {
    FlgLiveSampleView view;
    flgLiveSampleViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgLiveStrokeInfo flgLiveStrokeInfoDefaults(void) {
    FlgLiveStrokeInfo info;
    flgLiveStrokeInfoInit(&info, (uint32_t)sizeof info);
    return info;
}

static inline FlgLiveStrokeDesc flgLiveStrokeDefaults(void) {
    FlgLiveStrokeDesc desc;
    flgLiveStrokeDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

#ifdef __cplusplus
}
#endif

#endif
