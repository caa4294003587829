// SPDX-License-Identifier: MIT
// Even samples of a curve with a moving frame: the stream that resampling and synthesis are made of.
//
// On closed curves the rotation-minimizing frame comes back turned by an angle; a pass ahead measures it, and each
// sample's normal is turned back by its share. The Frenet normal is the direction in which the tangent turns between the
// two neighbouring samples. A supplied normal is interpolated between the curve's points and made perpendicular to the
// tangent. Where the tangent doesn't turn, or a supplied normal points along it, the last normal is carried on (at the
// start: the initial normal).
#pragma once

#include "curves/arc_length.h"
#include "curves/even_sampler.h"
#include "curves/moving_frame.h"
#include "filigree/filigree.h"

namespace flg {

// (Samples come in blocks of about this size: small enough for the cache.)
constexpr uint32_t sample_block = 64;

struct FramedSample : CurveSample {
    Vec3 normal;  // unit, across the tangent
};

// How a curve is to be sampled. On closed curves the first point doesn't come again at the end.
struct SamplingPlan {
    CurveView curve;
    CurveMeasure measure;
    uint32_t steps = 0;  // 0 exactly if the curve has no length
    FlgFrameMethod frame = FLG_FRAME_ROTATION_MINIMIZING;
    const float* normals = nullptr;  // FLG_FRAME_SUPPLIED: three floats a point of the curve, of any length

    uint32_t sample_count() const { return steps == 0 ? 1 : (curve.closed ? steps : steps + 1); }
};

class FramedSampler {
public:
    explicit FramedSampler(const SamplingPlan& plan);

    // The next of plan.sample_count() samples, `capacity` at most, and as many as `units` last for (see
    // EvenSampler::next()). Returns how many; to be called again until all have come.
    uint32_t next(FramedSample* out, uint32_t capacity, uint32_t& units);

private:
    bool next_special(FramedSample& out, uint32_t& units);
    bool measure_twist(uint32_t& units);
    bool next_twisted(FramedSample& out, uint32_t& units);
    bool next_frenet(FramedSample& out, uint32_t& units);
    bool next_supplied(FramedSample& out, uint32_t& units);
    void begin_frame(const CurveSample& first);

    SamplingPlan plan_;
    EvenSampler sampler_;
    RotationMinimizingFrame frame_;
    uint32_t left_;  // samples to come
    bool special_;   // anything but a rotation-minimizing frame on an open curve
    bool twist_known_ = false;
    bool has_ahead_ = false;
    uint32_t next_ = 0;          // index of the sample to come
    double twist_per_step_ = 0;  // radians
    double straight_ = 0;        // tangents that turn by less than this between samples, radians, do not turn
    Vec3 first_tangent_, first_normal_, before_;
    CurveSample ahead_;  // Frenet: the sample to come
};

}  // namespace flg
