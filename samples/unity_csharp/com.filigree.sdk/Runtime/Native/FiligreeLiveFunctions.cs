// SPDX-License-Identifier: MIT
// Functions of filigree_live.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Live strokes: curves that are stylized while they are drawn. Same grammar and rules as filigree.h.
//
//     flgStyleWarm(context, style, 0, NULL, &job);            once for each style and temperature, ahead of time
//     flgLiveStrokeBegin(context, &desc, &stroke);            trigger pressed
//     flgLiveStrokePush(context, stroke, &samples, &view);    each frame: `view` shows what is new, append it to a mesh
//     flgLiveStrokeGetTip(context, stroke, &tip);             each frame: what to draw behind the points so far
//     flgLiveStrokeEnd(context, stroke, NULL, &stylized, &samples, &job);  trigger released
//
// The curve        flgCurveSetResample's smooth curve through the samples. A sample's direction depends on the next
//                  sample. Points are therefore made only up to the last but one distinct sample: final geometry lags
//                  one sample behind (11 ms at 90 Hz), plus `smoothing` seconds if set. flgLiveStrokeGetTip gives the
//                  rest, up to the last sample, for this frame.
// The points       At even steps of arc length along the curve, FlgStyleInfo::spacing * scale, whatever the sample
//                  rate. Points never move. The last lies up to one step before the end. Columns: POSITION, TANGENT,
//                  NORMAL, RADIUS, STYLE_INDEX, TIME, and the style's attributes except RADIUS.
// Live is batch    flgCurveSetStylize, given the samples of flgLiveStrokeEnd and exact_spacing = 1, gives the same
//                  points to the bit: POSITION, TANGENT, NORMAL, STYLE_INDEX and attributes, for the same style,
//                  magnitude, temperature, scale, basis, start and seed. Without exact_spacing it takes the nearest
//                  whole number of steps, so that its last point is the curve's end: frames are the same, points lie up
//                  to half a step from those drawn, and the last run may go on to the style's end. What cannot be the
//                  same: RADIUS and TIME, which a live stroke makes of pressure and clock, the other carries over from
//                  its target; `smoothing`, which the samples lack; the first normal without ORIENTATION, since the
//                  other knows the whole curve; supplied frames (a NORMAL column there); end caps, unless `end_cap` is
//                  set; samples nearer to each other than a thousandth of a step (the first counts); strokes shorter
//                  than a step (one point here, two there), or than both caps; what passes max_points.
// Caps             A stroke begins with its style's start cap (FlgStyleDesc). Its points get no end cap: they never
//                  move, and the end is not known before it is there. With `end_cap` the set that flgLiveStrokeEnd
//                  makes ends with it: its last points, up to 256 and the cap, are not those drawn, but
//                  flgCurveSetStylize's. flgLiveStrokeGetPoints, resuming and splitting go by those drawn.
// Steering         `drives`, as flgCurveSetStylize has them: by the hand's pressure and its speed; 10 ns a point more.
// Several styles   A drive of FlgStyleDriven.Style chooses among `style` and `further_styles` while the hand draws.
//                  Points never move, so a blend begins where the choice changes and is over style_blend metres behind
//                  it; flgCurveSetStylize begins it half of that earlier. Where both have one style alone they give
//                  the same bits, if it is the one with the smallest spacing or has the same; but for NORMAL of a style
//                  with ANGLE, which differs by rounding. Between the points of a style with a wider spacing,
//                  flgCurveSetStylize interpolates its results and a live stroke its displacements: they differ by what
//                  the curve bends within a step of that style; and a driven temperature counts a step earlier there. A
//                  choice holds for at least a 16th of a blend, even if the hand changes its mind sooner. k styles
//                  share the 1,024 points of a push (see Delivery). Cost: some 35 ns a point for each style; a sample
//                  of 60 points takes some 8 us with 2 styles, some 21 us with 8.
// Radius           min_radius + (max_radius - min_radius) * pressure; if the style has a RADIUS attribute, multiplied
//                  by that attribute relative to its mean over the style, and by what drives the radius.
// Time             When the hand was there, in seconds since the first sample. If the style has a SPEED attribute: when
//                  a motion at that speed gets there, starting at 0.
// Frame            Rotation-minimizing (double reflection). The first normal is the y axis of the controller at the
//                  first sample, made perpendicular to the curve; or its x axis if the y axis is within 18 degrees of
//                  the curve's direction. Without an orientation: the coordinate axis furthest from the direction.
//                  Resampling and stylizing a set with an ORIENTATION column, such as these samples, begins the same
//                  way.
//                  Supplied: the controller's y axis at every point, interpolated between samples (and smoothed with
//                  them) and made perpendicular to the curve; where it is parallel to the curve, or samples have no
//                  orientation, carried on from the last point where it was defined.
// Cost             Depends only on the new samples: about 0.5 us a sample and 30 ns a point. Pushing allocates
//                  nothing; flgLiveStrokeBegin takes all memory.
// Delivery         Points come one sample late. A sample of a hand that moves at most 64 steps a sample (with steps of
//                  1 mm, 5 m/s at 90 Hz) takes under 8 us; samples that need more points than that are counted in
//                  FlgLiveStrokeInfo::dense_samples, and take in proportion longer. Each pushed sample makes at most
//                  1,024 points, some 50 us of processor time, however far the hand jumps and
//                  however fine the style is. What is left waits (waiting_samples, waiting_points): later samples make
//                  it in order, 1,024 points each, so that the points of a jump of 3,072 steps are there 3 samples
//                  later, and the job of flgLiveStrokeEnd makes the last.
// Threads          Functions marked [any thread, one per stroke] may run while another thread is inside any other call
//                  of the context, flgContextTick included: an input thread pushes and never waits for a tick. They
//                  take no lock. Only calls that take the same stroke must not overlap each other, and
//                  flgContextDestroy must not overlap anything. So hand a stroke to the input thread after
//                  flgLiveStrokeBegin, and take it back before flgLiveStrokeEnd, Resume, Split or Release.
// Style by stroke  Pass flgLiveStrokeEnd's samples to flgStyleCreate as the style. It is ready in the next frame at 90
//                  Hz (11 ms, one worker) for strokes of up to about 600 samples; 1,200 take about 4 frames, 2,400 take
//                  6. Preparation time grows faster than the number of style points, which stops at 2,048 by default.
// Determinism      Points depend only on the samples, not on their grouping into pushes, and not on undone samples.
//                  flgLiveStrokeReplay makes the same bits again from recorded samples.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>
        /// Starts a job that computes all path trees of a style at a temperature. Live strokes need them and never
        /// compute one. The style keeps those of the last four temperatures requested, including by flgCurveSetStylize
        /// and flgLiveStrokeBegin. `temperature` as in FlgCurveSetStylizeDesc; `job` may be null: defaults. Cost: 0.1
        /// ms of work for each of up to 256 trees.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStyleWarm(
            FlgContext context, FlgStyle style, float temperature, FlgJobOptions* job, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokeDescInit(FlgLiveStrokeDesc* desc, uint struct_size);

        /// <summary>
        /// Begins a stroke. FlgResult.NotReady while the style is not prepared, or not warm at this temperature
        /// (flgStyleWarm); flgErrorGetMessage() says which. Returns the error of the style's job if that failed. Cost:
        /// the allocation of its memory, which it does not touch. (An allocator that returns pages touched before
        /// spares pushes the system's cost of first touches.)
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokeBegin(
            FlgContext context, FlgLiveStrokeDesc* desc, FlgLiveStroke* out_stroke);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveSampleViewInit(FlgLiveSampleView* view, uint struct_size);

        /// <summary>
        /// [any thread, one per stroke] Adds samples; out_new (may be null) shows the points this call made. Checks all
        /// samples first: if one is invalid, none is added, and the stroke stays unchanged and can continue:
        ///   FlgResult.ErrorInvalidArgument  a number that is not finite or out of range, or a time before the previous
        ///   sample's
        ///   FlgResult.ErrorLimit             a jump beyond max_jump (end the stroke there and begin another), more
        ///   than max_samples,
        ///                               or the stroke is cut at max_points (FlgLiveStrokeInfo::cut): it can still be
        ///                               ended, and
        ///                               samples undone
        /// Repeated samples are accepted but make no points; nor do samples closer than 0.001 of a step to the last
        /// distinct one, or, with smoothing, samples with the same time as the previous one. The view lives until the
        /// next call for this stroke, its arrays until the stroke is released; curve_count is 0 if there is nothing
        /// new. After flgLiveStrokeEnd: FlgResult.ErrorInvalidArgument. Cost: about 0.2 us a sample and 0.1 us a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokePush(
            FlgContext context, FlgLiveStroke stroke, FlgLiveSampleView* samples, FlgCurveSetView* out_new);

        /// <summary>
        /// [any thread, one per stroke] All points so far; lives as long as flgLiveStrokePush's view. Once the job of
        /// flgLiveStrokeEnd is published: the whole stroke. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokeGetPoints(
            FlgContext context, FlgLiveStroke stroke, FlgCurveSetView* out_view);

        /// <summary>
        /// [any thread, one per stroke] Where the stroke would be if it ended now, so that what is drawn is not a
        /// sample behind the hand: a curve of the last point so far, if there is one, and the points that
        /// flgLiveStrokeEnd would add, bit for bit. All columns of flgLiveStrokeGetPoints. curve_count is 0 if the end
        /// would add nothing. Draw it for a frame, then drop it: the next sample bends it, and these points never
        /// become part of the stroke. The call changes no other result. It looks ahead by at most 256 points, fewer
        /// only where samples wait (4 less for each sample read); beyond that the tip stops short of the hand.
        /// Allocates nothing. The view and its arrays live until the next call of this function for this stroke, or the
        /// stroke's release. Works after flgLiveStrokeEnd too, until its job is published: then there is no tip any
        /// more. Cost: about 0.5 us, and 30 ns a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokeGetTip(
            FlgContext context, FlgLiveStroke stroke, FlgCurveSetView* out_tip);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokeInfoInit(FlgLiveStrokeInfo* info, uint struct_size);

        /// <summary>
        /// [any thread, one per stroke] The stroke's progress; set struct_size. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokeGetInfo(
            FlgContext context, FlgLiveStroke stroke, FlgLiveStrokeInfo* out_info);

        /// <summary>
        /// [any thread, one per stroke] Removes the last `count` samples and the points they made: restores the stroke
        /// as it was before they were pushed, to the bit. out_point_count (may be null): points left. Refused for an
        /// ended stroke: resume it first. Cost: that of pushing up to 5 samples.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokeUndo(
            FlgContext context, FlgLiveStroke stroke, uint count, uint* out_point_count);

        /// <summary>
        /// Ends a stroke: starts a job that follows the curve to its last sample. The job copies the stylized points
        /// into one set and the samples into another (POSITION, ORIENTATION, PRESSURE, TIME since the first one, s,
        /// RADIUS). Both can be used as inputs at once: `out_samples` as the style of flgStyleCreate, or as the target
        /// of flgCurveSetStylize. The last point lies up to one step before the last sample. A zero-length stroke is
        /// one point, not displaced. Either set may be null if not needed. `job` may be null: FlgPriority.High then,
        /// since somebody waits for it. The handle stays valid, for flgLiveStrokeResume, until it is released; if the
        /// job fails, the stroke continues as if it had not been ended. Refused for a stroke without samples. A stroke
        /// that reaches max_points is cut there, and the job succeeds with the points made so far; once the job is
        /// published, FlgLiveStrokeInfo::cut is set. `out_samples` has all samples, so the whole stroke can be stylized
        /// from it. Cost: about 6 ns a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokeEnd(
            FlgContext context, FlgLiveStroke stroke, FlgJobOptions* job, FlgCurveSet* out_stylized, FlgCurveSet*
            out_samples, FlgJob* out_job);

        /// <summary>
        /// Resumes an ended stroke, as if it had never been ended: removes the points its end added without knowing the
        /// next sample. FlgResult.NotReady while a job still reads the stroke. Sets already made do not change. Cost:
        /// that of pushing up to 5 samples.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokeResume(FlgContext context, FlgLiveStroke stroke);

        /// <summary>
        /// Starts a job that splits an ended stroke into two copies that meet: points 0 to `point`, and `point` to the
        /// last. `job` as for flgLiveStrokeEnd. FlgResult.NotReady until the job of flgLiveStrokeEnd is published.
        /// Cost: about 10 ns a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokeSplit(
            FlgContext context, FlgLiveStroke stroke, uint point, FlgJobOptions* job, FlgCurveSet* out_first,
            FlgCurveSet* out_second, FlgJob* out_job);

        /// <summary>
        /// Ends the stroke without results. Jobs that read the stroke keep its memory until they finish.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokeRelease(FlgContext context, FlgLiveStroke stroke);

        /// <summary>
        /// The batch form: starts a job that draws every curve of a set of recorded samples as a live stroke, and ends
        /// it. Curve c equals a live stroke through these samples with the same descriptor and seed `seed + c`, bit for
        /// bit. Missing columns mean: no orientation, pressure 1, all times 0 s; without TIME, `smoothing` must be 0.
        /// Values that flgLiveStrokePush would refuse fail the job with the same result. So does a curve of more than
        /// max_points points: FlgResult.ErrorLimit, before memory is taken (for the points needed, not for max_points).
        /// max_samples does not apply. Closed curves are drawn open. The style need not be ready or warm. `job` may be
        /// null. Cost: about 0.3 us a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiveStrokeReplay(
            FlgContext context, FlgLiveStrokeDesc* desc, FlgCurveSet samples, FlgJobOptions* job, FlgCurveSet*
            out_set, FlgJob* out_job);

        public static FlgLiveSampleView flgLiveSampleViewDefaults()
        {
            FlgLiveSampleView made;
            flgLiveSampleViewInit(&made, (uint)sizeof(FlgLiveSampleView));
            return made;
        }

        public static FlgLiveStrokeInfo flgLiveStrokeInfoDefaults()
        {
            FlgLiveStrokeInfo made;
            flgLiveStrokeInfoInit(&made, (uint)sizeof(FlgLiveStrokeInfo));
            return made;
        }

        public static FlgLiveStrokeDesc flgLiveStrokeDefaults()
        {
            FlgLiveStrokeDesc made;
            flgLiveStrokeDescInit(&made, (uint)sizeof(FlgLiveStrokeDesc));
            return made;
        }
    }
}
