// SPDX-License-Identifier: MIT
// Second pass over a curve: points at equal steps of arc length, in order, in constant memory.
#pragma once

#include "curves/segment_stream.h"

namespace flg {

// A point of the smooth curve, between the points `segment` and `segment` + 1 (around, if closed) of its polyline.
struct CurveSample {
    Vec3 position;
    Vec3 tangent;  // unit
    uint32_t segment = 0;
    float t = 0;  // where between them, 0 to 1; for columns that are interpolated linearly
};

class EvenSampler {
public:
    // `length` as measure_curve() finds it; `steps` >= 1, or 0 for a curve without length.
    EvenSampler(const CurveView& curve, double length, uint32_t steps);
    // Samples of which none is the curve's end: `step` metres apart, as many as there is room for.
    EvenSampler(const CurveView& curve, double step);

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
                segment_end_ += stream_.segment().length();
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
        const double t = segment.parameter_at(s - segment_start_);
        out.position = segment.position(t);
        out.tangent = segment.tangent(t);
        out.segment = stream_.index();
        out.t = static_cast<float>(t);
        return true;
    }

private:
    void make_last(CurveSample& out) const;

    SegmentStream stream_;
    CurveView curve_;
    uint32_t steps_;
    uint32_t next_ = 0;
    double step_;
    double segment_start_ = 0;  // arc length
    double segment_end_ = 0;
};

}  // namespace flg
