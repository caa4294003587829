// SPDX-License-Identifier: MIT
// Second pass over a curve: samples at equal steps of arc length, in order, in constant memory; a block of them at a
// time.
#pragma once

#include <array>
#include <span>

#include "curves/corners.h"
#include "curves/sample_block.h"
#include "curves/segment_stream.h"

namespace flg {

class BlockSampler {
public:
    // `length` as measure_curve() finds it; `steps` >= 1, or 0 for a curve without length. `scales`: by how much steps
    // are longer at each point of the curve, lengths then being those of measure_steps(); null: by nothing.
    BlockSampler(const CurveView& curve, double length, uint32_t steps, const float* scales = nullptr);
    // Samples of which none is the curve's end: `step` metres apart, as many as there is room for.
    BlockSampler(const CurveView& curve, double step, const float* scales = nullptr);
    // The pieces in their own steps, `steps` together. A sample at a corner is the first one behind it.
    BlockSampler(const CurveView& curve, uint32_t steps, const float* scales, std::span<const CurvePiece> pieces);

    // Some of the samples to come, 1 to SampleBlock::capacity of steps + 1; the first and the last are the curve's ends
    // exactly. Takes one of `units` for each and for each point of the polyline read on the way, as far as there are
    // any; false, to be called again, if there were none.
    bool next(SampleBlock& out, uint32_t& units);

private:
    bool read_on(uint32_t& units);
    void fill(SampleBlock& out);
    bool add_end(SampleBlock& out);
    void add_pieces(SegmentStream::Range range);
    void scale_places(SampleBlock& out) const;

    static constexpr uint32_t no_end = UINT32_MAX;

    SegmentStream stream_;
    CurveView curve_;
    uint32_t steps_;  // or no_end
    double step_;
    const float* scales_;
    std::span<const CurvePiece> pieces_;  // lengths are then counted in steps
    uint32_t piece_ = 0;
    uint32_t next_ = 0;  // sample to come
    // Segments whose samples are coming.
    SegmentRows rows_;
    std::array<double, SegmentRows::size> starts_, ends_;  // arc lengths, in scaled steps
    std::array<uint32_t, SegmentRows::size> stops_;        // the first sample behind
    std::array<double, SegmentRows::size> row_steps_;      // of the pieces that they belong to
    uint32_t row_ = 0, last_row_ = 0;
    double end_ = 0;  // likewise of all segments read
};

}  // namespace flg
