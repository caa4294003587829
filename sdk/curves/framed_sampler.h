// SPDX-License-Identifier: MIT
// Even samples of a curve with a moving frame: the stream that resampling and synthesis are made of.
//
// The Frenet normal is the direction in which the tangent turns between the two neighbouring samples. A supplied normal
// is interpolated between the curve's points and made perpendicular to the tangent. Where the tangent doesn't turn, or
// a supplied normal points along it, the last normal is carried on (at the start: the initial normal).
//
// Closed curves are gone around twice, so that where they begin makes no difference: Frenet and supplied normals are
// carried on over the first point; the rotation-minimizing frame comes back turned by an angle, and each sample's
// normal is turned back by its share. So it is where no sample has a normal of its own.
#pragma once

#include "core/moving_frame.h"
#include "curves/arc_length.h"
#include "curves/even_sampler.h"
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
    FlgFrameMethod frame = FLG_FRAME_METHOD_ROTATION_MINIMIZING;
    const float* normals = nullptr;      // FLG_FRAME_METHOD_SUPPLIED: three floats a point of the curve, of any length
    const float* orientation = nullptr;  // the controller's at the first point, if it was drawn: quaternion x y z w
    double exact_step = 0;               // metres; 0: the curve's length in equal steps
    const float* step_scales = nullptr;  // by how much steps are longer at each point of the curve; null: by nothing
    double scaled_length = 0;            // the curve's, if there are step_scales

    uint32_t sample_count() const { return steps == 0 ? 1 : (curve.closed ? steps : steps + 1); }
};

class FramedSampler {
public:
    explicit FramedSampler(const SamplingPlan& plan);

    // The next of plan.sample_count() samples, `capacity` at most, and as many as `units` last for (see
    // EvenSampler::next()). Returns how many; to be called again until all have come.
    uint32_t next(FramedSample* out, uint32_t capacity, uint32_t& units);

private:
    EvenSampler begin() const;
    bool next_special(FramedSample& out, uint32_t& units);
    bool next_by_method(FramedSample& out, uint32_t& units);
    bool go_around(uint32_t& units);
    bool next_twisted(FramedSample& out, uint32_t& units);
    bool next_frenet(FramedSample& out, uint32_t& units);
    bool next_supplied(FramedSample& out, uint32_t& units);
    void begin_frame(const CurveSample& first);
    void carry_frame(const CurveSample& to);
    void take_normal(const Vec3& normal);

    SamplingPlan plan_;
    EvenSampler sampler_;
    RotationMinimizingFrame frame_;
    uint32_t left_;  // samples to come
    bool special_;   // anything but a rotation-minimizing frame on an open curve
    bool been_around_ = false;
    bool has_normal_ = false;  // a Frenet or supplied one, from some sample before
    bool has_ahead_ = false;
    uint32_t next_ = 0;          // index of the sample to come
    double twist_per_step_ = 0;  // radians
    double straight_ = 0;        // tangents that turn by less than this between samples, radians, do not turn
    FramedSample first_;         // closed: as it was at first
    Vec3 before_;                // Frenet: the last tangent
    CurveSample ahead_;          // and the sample to come
};

}  // namespace flg
