// SPDX-License-Identifier: MIT
// The smooth curve through controller samples, known one place behind the newest: the curve of curves/segment_stream,
// fed sample by sample.
//
// A place is a sample that is further than `resolution` from the place before it. A segment runs from one place to the
// next; its end's tangent needs the place after that.
// The filter is y' = (x - y) / tau, solved exactly for x that runs evenly from one sample to the next, so what it gives
// at a sample does not depend on how many others lie in between on the same way. An x that runs evenly for long is
// followed tau later.
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

// From one place to the next.
struct LiveSegment {
    Vec3 start = Vec3::Zero(), end = Vec3::Zero(), direction = Vec3::Zero();  // direction unit, from start to end
    double chord = 0;
    Vec3 tangent_start = Vec3::Zero(), tangent_end = Vec3::Zero();
    double pressure_start = 0, pressure_end = 0;

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
    double last_pressure() const { return pressure_end_; }

private:
    using PositionAndPressure = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;

    PositionAndPressure filtered(const PositionAndPressure& value, double time);
    LiveSegment segment_to(bool smooth_end, const Vec3& tangent_end) const;

    double smoothing_ = 0, resolution_ = 0;
    double time_ = 0;
    PositionAndPressure raw_ = PositionAndPressure::Zero(), smoothed_ = PositionAndPressure::Zero();
    uint32_t samples_ = 0;
    uint32_t places_ = 0;
    // The last two places.
    Vec3 start_ = Vec3::Zero(), end_ = Vec3::Zero(), direction_ = Vec3::Zero();
    double chord_ = 0, pressure_start_ = 0, pressure_end_ = 0;
    Vec3 tangent_start_ = Vec3::Zero();
    bool smooth_start_ = false;
};

}  // namespace flg
