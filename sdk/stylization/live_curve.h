// SPDX-License-Identifier: MIT
// The smooth curve through controller samples, known one place behind the newest: the curve of curves/segment_stream,
// fed sample by sample.
//
// A place is a sample that is further than `resolution` from the place before it. A segment runs from one place to the
// next; its end's tangent needs the place after that.
// The filter is y' = (x - y) / tau, solved exactly for x that runs evenly from one sample to the next, so what it gives
// at a sample does not depend on how many others lie in between on the same way. An x that runs evenly for long is
// followed tau later. Position, pressure and the controller's axis go through it together; times don't.
#pragma once

#include <Eigen/Core>

#include "curves/segment_block.h"

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

// `v` turned by a quaternion x y z w of any length; zero if that is zero.
Vec3 turned_by(const float* quaternion, const Vec3& v);

// From one place to the next.
struct LiveSegment {
    Vec3 start = Vec3::Zero(), end = Vec3::Zero(), direction = Vec3::Zero();  // direction unit, from start to end
    double chord = 0;
    Vec3 tangent_start = Vec3::Zero(), tangent_end = Vec3::Zero();
    LiveHand hand_start, hand_end;

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
    const Vec3& last_place() const { return end_; }
    const LiveHand& last_hand() const { return hand_end_; }

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
    Vec3 tangent_start_ = Vec3::Zero();
    bool smooth_start_ = false;
};

}  // namespace flg
