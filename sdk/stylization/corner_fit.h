// SPDX-License-Identifier: MIT
// How many steps of a style targets get from corner to corner.
//
// A style that goes on over corners gets the whole number of steps that is nearest to each piece's length. If caps or
// motifs ask for another number in all, that is shared out by length. With whole motifs from corner to corner each
// piece is fitted as an open target is (stroke_fit); one too short for a motif gets it smaller, and so that sides still
// meet, no larger at its ends than its neighbours' (PieceSizes).
#pragma once

#include "curves/corners.h"
#include "curves/sampling_job.h"
#include "stylization/stroke_fit.h"

namespace flg {

// Of all curves of a target, one behind the other.
struct TargetPieces {
    Buffer<uint32_t> offsets;  // where each curve's begin
    Buffer<CurvePiece> pieces;
    Buffer<float> across;  // StrokeFit's, of each piece; empty: 1

    bool empty() const { return pieces.empty(); }
    std::span<CurvePiece> of(uint32_t curve) {
        return {pieces.data() + offsets[curve], pieces.data() + offsets[curve + 1]};
    }
    std::span<float> across_of(uint32_t curve) {
        if (across.empty()) return {};
        return {across.data() + offsets[curve], across.data() + offsets[curve + 1]};
    }
    std::span<const float> across_of(uint32_t curve) const {
        if (across.empty()) return {};
        return {across.data() + offsets[curve], across.data() + offsets[curve + 1]};
    }
};

// What corners of a target are.
struct TargetCorners {
    double angle_rad = 0;
    double bend = 0;                  // metres: how far they are drawn round at most
    std::span<const float> scales{};  // factors on that, one a curve; none: 1
};
// Stage "corners": turns closed targets to their first corner. Curves without corners have no pieces.
Task<TargetPieces> find_pieces(Pace& pace, std::shared_ptr<const CurveSet>& target, TargetCorners corners);
// As found.
Task<TargetPieces> copy_pieces(Pace& pace, const TargetPieces& pieces);
// Once the step scales are known, null if there are none: what find_pieces() has laid out.
Task<void> measure_pieces(Pace& pace, const CurveSet& target, const float* step_scales, TargetPieces& pieces);

struct CornerFit {
    const PatchGraph* graph = nullptr;
    StrokeMotifs stroke;
    bool motifs = false;  // whole ones from corner to corner
    bool caps = false;    // at corners too
};
// Gives the curve's pieces their steps, and the plan those of all of them. The plan's own are what the whole curve is
// to have.
Task<void> fit_pieces(Pace& pace, CornerFit fit, double spacing, std::span<CurvePiece> pieces, std::span<float> across,
                      SamplingPlan& plan);

// A factor on the style that goes from piece to piece without steps.
class PieceSizes {
public:
    PieceSizes() = default;
    PieceSizes(std::span<const CurvePiece> pieces, std::span<const float> across, bool closed)
        : pieces_(pieces), across_(across), closed_(closed) {}

    // Samples come in order.
    float at(uint32_t sample);

private:
    float neighbour(bool next) const;

    std::span<const CurvePiece> pieces_;
    std::span<const float> across_;  // none: 1 everywhere
    bool closed_ = false;
    uint32_t piece_ = 0;
};

}  // namespace flg
