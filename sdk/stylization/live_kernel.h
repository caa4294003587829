// SPDX-License-Identifier: MIT
// Live strokes: from samples to a smooth curve (LiveCurve), and from the curve to stylized points (LiveKernel).
//
// The curve is that of curves/segment_stream, fed sample by sample, and known one place behind the newest. A place is a
// sample that is further than `resolution` from the place before it. A segment runs from one place to the next; its
// end's tangent needs the place after that.
// Smoothing is the filter y' = (x - y) / tau, solved exactly for x that runs evenly from one sample to the next, so
// what it gives at a sample does not depend on how many others lie in between on the same way. An x that runs evenly
// for long is followed tau later. Position, pressure and the controller's axis go through it together; times don't.
//
// Points of a live stroke: even steps along the curve, the style's displacement at each (Minarcik, Fiser, Sykora, sec.
// 4.5, drawn instead of applied); with several styles what live_mix makes of them.
//
// Invariants
// - Only the past counts: points once made stay.
// - LiveState is a value. With the samples, and with LiveMixState if there are several styles, it says all that is to
//   come, whatever slices run() was called in.
#pragma once

#include <Eigen/Core>
#include <array>

#include "core/moving_frame.h"
#include "curves/sample_block.h"
#include "stylization/displaced_block.h"
#include "stylization/live_follower.h"
#include "stylization/live_mix.h"

namespace flg {

// Samples as they lie in columns; missing ones are null (but for positions).
struct LiveSamples {
    const float* positions = nullptr;
    const float* orientations = nullptr;
    const float* pressures = nullptr;
    const float* times = nullptr;  // seconds on any clock
};

// What a hand does besides being somewhere.
struct LiveHand {
    double pressure = 0;
    double time = 0;         // seconds from the first sample on
    Vec3 up = Vec3::Zero();  // the controller's y axis, shorter than 1 where smoothing has turned it; zero: unknown

    LiveHand between(const LiveHand& next, double t) const {
        return {pressure + t * (next.pressure - pressure), time + t * (next.time - time), up + t * (next.up - up)};
    }
};

// What of a hand steers the style.
struct HandReading {
    float pressure = 0, speed = 0;  // speed in metres a second, on the way to the place

    float of(FlgAttribute attribute) const { return attribute == FLG_ATTRIBUTE_PRESSURE ? pressure : speed; }
};

// From one place to the next.
struct LiveSegment {
    Vec3 start = Vec3::Zero(), end = Vec3::Zero(), direction = Vec3::Zero();  // direction unit, from start to end
    double chord = 0;
    Vec3 tangent_start = Vec3::Zero(), tangent_end = Vec3::Zero();
    LiveHand hand_start, hand_end;
    HandReading reading_start, reading_end;  // on leaving the one, on coming to the other

    // As the block's only segment.
    void load(SegmentBlock& block) const;
};

// A value: copies go on independently, so that a copy is a checkpoint.
class LiveCurve {
public:
    LiveCurve() = default;
    // Seconds, and metres that two places are apart at least.
    LiveCurve(double smoothing, double resolution) : smoothing_(smoothing), resolution_(resolution) {}

    // Takes the sample after the ones read so far; true if a segment became known by it.
    bool read(const LiveSamples& samples, uint32_t sample, LiveSegment& segment);
    // Takes the curve's end to be at the last place; false if there is no segment left.
    bool finish(LiveSegment& segment);
    bool has_place() const { return places_ > 0; }
    bool has_segment() const { return places_ == 2; }
    const Vec3& last_place() const { return end_; }
    const LiveHand& last_hand() const { return hand_end_; }
    const HandReading& last_reading() const { return left_end_; }

private:
    // Position, pressure, axis.
    using Reading = Eigen::Matrix<double, 7, 1, Eigen::DontAlign>;

    static Reading reading_of(const LiveSamples& samples, uint32_t sample);
    Reading filtered(const Reading& value, double time);
    LiveSegment segment_to(bool smooth_end, const Vec3& tangent_end) const;

    double smoothing_ = 0, resolution_ = 0;
    double time_ = 0;
    Reading raw_ = Reading::Zero(), smoothed_ = Reading::Zero();
    uint32_t samples_ = 0;
    uint32_t places_ = 0;
    // The last two places.
    Vec3 start_ = Vec3::Zero(), end_ = Vec3::Zero(), direction_ = Vec3::Zero();
    double chord_ = 0;
    LiveHand hand_start_, hand_end_;
    HandReading left_start_;              // when the hand left the start
    HandReading came_to_end_, left_end_;  // came to the end, and was last there
    Vec3 tangent_start_ = Vec3::Zero();
    bool smooth_start_ = false;
    bool moves_ = false;  // there has been a second place
};

Steered steered_by(const StyleDrives& drives, const HandReading& reading);

bool all_trees_made(const PathTrees& trees);

// The result's columns: POSITION, TANGENT, NORMAL, RADIUS, STYLE_INDEX, TIME, then the first style's attributes but for
// RADIUS.
constexpr uint32_t live_own_columns = 6;
constexpr uint32_t live_columns_max = live_own_columns + style_attributes_max;
struct LiveColumns {
    uint32_t count = 0;
    std::array<CurveSet::ColumnLayout, live_columns_max> layout;
    std::array<float*, live_columns_max> data{};
    uint32_t first = 0;  // the stroke's point that data begins with
};
LiveColumns live_columns(const PreparedStyle& style);

struct LiveState {
    LiveCurve curve;
    LiveSegment segment;  // being followed if in_segment
    bool in_segment = false;
    bool closing = false;           // no samples will follow
    bool cut = false;               // a point was due, and there was no room: the stroke ends before it
    double start = 0;               // arc length in metres where the segment begins
    uint32_t samples = 0;           // read
    uint32_t points = 0;            // made
    uint32_t segment_points = 0;    // of them, on the segment
    uint32_t dense_segments = 0;    // with more than dense_points
    double motion_s = 0;            // TIME of the last point, if the style has SPEED
    FrameChain chain;               // of rotation-minimizing frames
    RotationMinimizingFrame frame;  // of supplied ones
    FollowedStyle style;            // if there is one
};

// Stays a kernel: the host pushes samples into it, in the middle of a frame, and it allocates nothing.
class LiveKernel {
public:
    LiveKernel() = default;
    // `out` may have no data: then points are counted and not made. `mix`: of several styles, if points are made. What
    // the arguments refer to outlives the kernel.
    LiveKernel(const LiveSettings& settings, const LiveSamples& samples, const LiveColumns& out,
               const LiveMixState& mix = {});

    // Spends units, 1 a point and sample_units a sample, on the first `sample_count` samples; true if all was done that
    // can be.
    static constexpr uint32_t sample_units = 4;
    // What a push of one sample makes in so little time that it is nothing to be told of.
    static constexpr uint32_t dense_points = 64;
    bool run(uint32_t sample_count, uint32_t& units);
    // From now on run() goes to the last sample.
    void close() { state_.closing = true; }

    const LiveState& state() const { return state_; }
    const LiveMixState& mix_state() const { return mix_.state(); }
    void restore(const LiveState& state, const LiveMixState& mix);
    // From now on data begins with this point.
    void write_from(uint32_t point) { out_.first = point; }

private:
    bool only_counts() const { return out_.data[0] == nullptr; }
    // Where the next point goes.
    size_t row() const { return state_.points - out_.first; }
    bool follow_segment(uint32_t& units);
    void begin_segment();
    void choose(const HandReading& start, const HandReading& end, double length);
    void take_segment();
    void make_points();
    void make_frames();
    void make_lone_point();
    void take_supplied_normal(const Vec3& up);
    void make_point(uint32_t k, float t, const LiveHand& hand, const Steered& steered);
    double copy_style(uint32_t k, const Steered& steered);
    double copy_mix(uint32_t k, float t, const Steered& steered);
    void write();
    double motion_time();

    LiveSettings settings_;
    LiveSamples samples_;
    LiveColumns out_;
    LiveFollower follower_;          // of the first style
    LiveMix mix_;                    // empty if it is the only one
    const float* speeds_ = nullptr;  // the result's, if the style has them
    bool turns_ = false;             // the style has an angle
    double step_ = 0;
    LiveState state_;
    // Of the segment that is followed.
    SegmentBlock block_;
    SegmentRows rows_;
    Steered steered_start_, steered_end_;
    // Points that are being made.
    SampleBlock samples_made_;
    DisplacedBlock displaced_;
};

}  // namespace flg
