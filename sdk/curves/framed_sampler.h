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
#include "curves/block_sampler.h"
#include "filigree/filigree.h"

namespace flg {

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
    std::span<const CurvePiece> pieces{};  // with their own steps, `steps` together; none: the curve's

    uint32_t sample_count() const { return steps == 0 ? 1 : (curve.closed ? steps : steps + 1); }
};

class FramedSampler {
public:
    explicit FramedSampler(const SamplingPlan& plan);

    // The next of plan.sample_count() samples, some at least, and as many as `units` last for (see
    // BlockSampler::next()). Returns how many; to be called again until all have come.
    uint32_t next(SampleBlock& out, uint32_t& units);

private:
    // A sample by itself, for frames that need more than the one before.
    struct Sample {
        float start[3], offset[3];
        Vec3 position, tangent, normal;
        uint32_t segment = 0;
        float t = 0;
    };

    BlockSampler begin() const;
    Vec3 first_normal(const Vec3& tangent) const;
    bool place(Sample& out, uint32_t& units);
    bool next_special(Sample& out, uint32_t& units);
    bool next_by_method(Sample& out, uint32_t& units);
    bool go_around(uint32_t& units);
    bool next_twisted(Sample& out, uint32_t& units);
    bool next_frenet(Sample& out, uint32_t& units);
    bool next_supplied(Sample& out, uint32_t& units);
    void carry_frame(const Sample& to);
    void take_normal(const Vec3& normal);

    SamplingPlan plan_;
    BlockSampler sampler_;
    uint32_t left_;  // samples to come
    bool special_;   // anything but a rotation-minimizing frame on an open curve
    FrameChain chain_;

    // ---- special ones ----
    SampleBlock placed_;
    uint32_t placed_at_ = 0;
    RotationMinimizingFrame frame_;
    bool been_around_ = false;
    bool has_normal_ = false;  // a Frenet or supplied one, from some sample before
    bool has_ahead_ = false;
    uint32_t next_ = 0;          // index of the sample to come
    double twist_per_step_ = 0;  // radians
    double straight_ = 0;        // tangents that turn by less than this between samples, radians, do not turn
    Sample first_;               // closed: as it was at first
    Vec3 before_;                // Frenet: the last tangent
    Sample ahead_;               // and the sample to come
};

}  // namespace flg
