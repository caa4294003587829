// SPDX-License-Identifier: MIT
// Second pass over a curve: points at equal steps of arc length, in order, in constant memory.
#pragma once

#include <algorithm>

#include "curves/segment_stream.h"
#include "curves/step_scale.h"

namespace flg {

// A point of the smooth curve, between the points `segment` and `segment` + 1 (around, if closed) of its polyline.
struct CurveSample {
    Vec3 position;
    Vec3 tangent;  // unit
    uint32_t segment = 0;
    float t = 0;  // where between them, 0 to 1; for columns that are interpolated linearly
};

// Of the segment that begins at point `index`.
inline StepScale step_scale(const CurveView& curve, const float* scales, uint32_t index) {
    return {scales[index], scales[curve.following(index)]};
}

class EvenSampler {
public:
    // `length` as measure_curve() finds it; `steps` >= 1, or 0 for a curve without length. `scales`: by how much steps
    // are longer at each point of the curve, lengths then being those of measure_steps(); null: by nothing.
    EvenSampler(const CurveView& curve, double length, uint32_t steps, const float* scales = nullptr);
    // Samples of which none is the curve's end: `step` metres apart, as many as there is room for.
    EvenSampler(const CurveView& curve, double step, const float* scales = nullptr);

    // The next of steps + 1 samples; the first and the last are the curve's ends exactly. Takes one of `units` for it
    // and for each point of the polyline read on the way; false, to be called again, if they ran out.
    bool next(CurveSample& out, uint32_t& units) {
        const bool last = next_ == steps_;
        const double s = next_ * step_;
        while (last ? !stream_.done() : (s >= segment_end_ && !stream_.done())) {
            if (units == 0) return false;
            --units;
            if (stream_.advance()) {
                segment_start_ = segment_end_;
                segment_end_ += scales_ ? scaled_length() : stream_.segment().length();
            }
        }
        if (units == 0) return false;
        --units;
        ++next_;
        if (last) {
            make_last(out);
            return true;
        }
        const Segment segment = stream_.segment();
        const double along = s - segment_start_;
        const double t =
            segment.parameter_at(scales_ ? std::min(scale_.length(segment.length(), along), segment.length()) : along);
        out.position = segment.position(t);
        out.tangent = segment.tangent(t);
        out.segment = stream_.index();
        out.t = static_cast<float>(t);
        return true;
    }

private:
    void make_last(CurveSample& out) const;
    double scaled_length() {
        scale_ = step_scale(curve_, scales_, stream_.index());
        return scale_.steps(stream_.segment().length());
    }

    SegmentStream stream_;
    CurveView curve_;
    uint32_t steps_;
    uint32_t next_ = 0;
    double step_;
    double segment_start_ = 0;  // arc length
    double segment_end_ = 0;
    const float* scales_;
    StepScale scale_;  // the segment's
};

}  // namespace flg
