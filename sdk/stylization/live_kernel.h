// SPDX-License-Identifier: MIT
// Points of a live stroke: even steps along the curve, the style's displacement at each (Minarcik, Fiser, Sykora, sec. 4.5,
// drawn instead of applied).
//
// Invariants
// - Only the past counts: points once made stay.
// - LiveState is a value. With the samples it says all that is to come, whatever slices run() was called in.
// Departure from synthesis: there is no last sample to aim at, so a run never goes on to the style's end instead of jumping
// (StyleWalk is told of more samples than there can be).
#pragma once

#include <array>

#include "curves/moving_frame.h"
#include "stylization/live_curve.h"
#include "stylization/style.h"
#include "stylization/synthesis.h"

namespace flg {

struct LiveSettings {
    const PreparedStyle* style = nullptr;
    PathTrees* trees = nullptr;  // all there
    double magnitude = 1;
    double scale = 1;
    double radius_min = 0, radius_max = 0;                   // metres
    double smoothing = 0;                                    // seconds
    FlgFrameMethod frame = FLG_FRAME_ROTATION_MINIMIZING;    // or FLG_FRAME_SUPPLIED
    std::array<double, 9> basis{1, 0, 0, 0, 1, 0, 0, 0, 1};  // row-major
    bool from_start = true;
    uint64_t seed = 1;
    uint32_t max_points = 0;

    double spacing() const { return style->spacing() * scale; }
};

bool all_trees_made(const PathTrees& trees);

// The result's columns: POSITION, TANGENT, NORMAL, RADIUS, STYLE_INDEX, TIME, then the style's attributes but for RADIUS.
constexpr uint32_t live_own_columns = 6;
constexpr uint32_t live_columns_max = live_own_columns + style_attributes_max;
struct LiveColumns {
    uint32_t count = 0;
    std::array<CurveSet::ColumnLayout, live_columns_max> layout;
    std::array<float*, live_columns_max> data{};
};
LiveColumns live_columns(const PreparedStyle& style);

// A point to be, on the drawn curve.
struct LivePlace {
    Vec3 position, tangent;  // tangent unit
    double t = 0;            // on the segment that is followed
};

struct LiveState {
    LiveCurve curve;
    LiveSegment segment;  // being followed if in_segment
    bool in_segment = false;
    bool closing = false;  // no samples will follow
    bool cut = false;      // a point was due, and there was no room: the stroke ends before it
    double ahead = 0;      // metres from the segment's start to the next point
    uint32_t samples = 0;  // read
    uint32_t points = 0;   // made
    double motion_s = 0;   // TIME of the last point, if the style has SPEED
    RotationMinimizingFrame frame;
    StyleWalk walk;
    SeamBlend blend;
};

class LiveKernel {
public:
    LiveKernel() = default;
    // `out` may have no data: then points are counted and not made. What the arguments refer to outlives the kernel.
    LiveKernel(const LiveSettings& settings, const LiveSamples& samples, const LiveColumns& out);

    // Spends units, 1 a point and sample_units a sample, on the first `sample_count` samples; true if all was done that
    // can be.
    static constexpr uint32_t sample_units = 4;
    bool run(uint32_t sample_count, uint32_t& units);
    // From now on run() goes to the last sample.
    void close() { state_.closing = true; }

    const LiveState& state() const { return state_; }
    void restore(const LiveState& state);

private:
    bool only_counts() const { return out_.data[0] == nullptr; }
    bool follow_segment(uint32_t& units);
    void take_segment();
    void make_point(const LivePlace& place);
    void make_lone_point();
    void begin_walk();
    void advance_walk();
    Vec3 displacement_of(uint32_t node) const;
    Vec3 first_normal(const Vec3& tangent) const;
    void take_supplied_normal(const Vec3& up);
    void write(const Vec3& position, const Vec3& tangent, const Vec3& frame_normal, const LiveHand& hand,
               double factor);
    void write_attributes(const Vec3& tangent, Vec3& normal, double& radius);
    double motion_time();

    LiveSettings settings_;
    LiveSamples samples_;
    LiveColumns out_;
    Eigen::Matrix3d basis_ = Eigen::Matrix3d::Identity();
    const float* speeds_ = nullptr;  // the result's, if the style has them
    double radius_unit_ = 1;         // the radius attribute's mean
    double step_ = 0;
    LiveState state_;
    SegmentBlock block_;
};

}  // namespace flg
