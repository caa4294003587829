// SPDX-License-Identifier: MIT
#include "stylization/live_curve.h"

#include <cmath>

#include "curves/segment_stream.h"

namespace flg {

namespace {

Vec3 mirrored(const Vec3& tangent, const Vec3& direction) {
    return (2.0 * tangent.dot(direction)) * direction - tangent;
}

}  // namespace

void LiveSegment::load(SegmentBlock& block) const {
    block.points.set(0, start);
    block.points.set(1, end);
    block.directions.set(0, direction);
    block.chords[0] = chord;
    block.tangents_start.set(0, tangent_start);
    block.tangents_end.set(0, tangent_end);
    block.measure(1);
}

Vec3 turned_by(const float* quaternion, const Vec3& v) {
    const Vec3 axis(quaternion[0], quaternion[1], quaternion[2]);
    const double w = quaternion[3];
    const double size_sq = axis.squaredNorm() + w * w;
    if (!(size_sq > 0)) return Vec3::Zero();
    return v + (2.0 / size_sq) * axis.cross(axis.cross(v) + w * v);
}

LiveCurve::Reading LiveCurve::reading_of(const LiveSamples& samples, uint32_t sample) {
    Reading reading;
    reading.head<3>() = load_vec3(samples.positions + 3 * size_t{sample});
    reading[3] = samples.pressures ? samples.pressures[sample] : 1.0;
    const bool has_up = samples.orientations != nullptr;
    reading.tail<3>() = has_up ? turned_by(samples.orientations + 4 * size_t{sample}, Vec3::UnitY()) : Vec3::Zero();
    return reading;
}

LiveCurve::Reading LiveCurve::filtered(const Reading& value, double time) {
    if (samples_ == 0 || smoothing_ == 0) {
        smoothed_ = value;
    } else if (time > time_) {
        const double elapsed = time - time_;
        // The state runs behind the input by this when it has settled.
        const Reading lag = (smoothing_ / elapsed) * (value - raw_);
        const double kept = std::exp(-elapsed / smoothing_);
        smoothed_ = value - lag + kept * (smoothed_ - raw_ + lag);
    }
    raw_ = value;
    time_ = time;
    ++samples_;
    return smoothed_;
}

LiveSegment LiveCurve::segment_to(bool smooth_end, const Vec3& tangent_end) const {
    const Vec3& u = direction_;
    LiveSegment segment{start_, end_, u, chord_, u, u, hand_start_, hand_end_};
    if (smooth_start_) {
        segment.tangent_start = tangent_start_;
        segment.tangent_end = mirrored(tangent_start_, u);
    }
    if (smooth_end) {
        segment.tangent_end = tangent_end;
        if (!smooth_start_) segment.tangent_start = mirrored(tangent_end, u);
    }
    return segment;
}

bool LiveCurve::read(const LiveSamples& samples, uint32_t sample, LiveSegment& segment) {
    // Counted from the first sample in float, as the host gets the samples back.
    const double time =
        samples.times ? static_cast<float>(double{samples.times[sample]} - double{samples.times[0]}) : 0.0;
    const Reading value = filtered(reading_of(samples, sample), time);
    const Vec3 place = value.head<3>();
    const LiveHand hand{value[3], time, value.tail<3>()};
    if (places_ == 0) {
        end_ = place;
        hand_end_ = hand;
        places_ = 1;
        return false;
    }
    const Vec3 way = place - end_;
    const double chord = way.norm();
    if (!(chord > resolution_)) {
        hand_end_ = hand;
        return false;
    }
    const Vec3 direction = way / chord;
    const bool has_segment = places_ == 2;
    bool smooth = false;
    Vec3 tangent = direction;
    if (has_segment) {
        smooth = direction_.dot(direction) >= corner_cosine;
        tangent = (chord * direction_ + chord_ * direction).normalized();
        segment = segment_to(smooth, tangent);
    }
    start_ = end_;
    end_ = place;
    direction_ = direction;
    chord_ = chord;
    hand_start_ = hand_end_;
    hand_end_ = hand;
    tangent_start_ = tangent;
    smooth_start_ = smooth;
    places_ = 2;
    return has_segment;
}

bool LiveCurve::finish(LiveSegment& segment) {
    if (places_ < 2) return false;
    segment = segment_to(false, direction_);
    places_ = 1;
    return true;
}

}  // namespace flg
