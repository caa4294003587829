// SPDX-License-Identifier: MIT
#include "stylization/corner_fit.h"

#include <algorithm>
#include <cmath>

#include "runtime/each.h"

namespace flg {

namespace {

// Targets have at most so many points.
constexpr double steps_max = 0x1.0p31;

struct Search {
    const CurveSet& target;
    TargetCorners corners;
    Buffer<CornerCount> counts;
    Buffer<uint8_t> marks;  // one a point of the target
};

Task<void> search_batch(Pace& pace, Search& search, uint32_t batch) {
    const CurveRange range = curves_of_batch(search.target, batch);
    for (uint32_t c = range.first; c < range.last; ++c) {
        const CurveView curve = curve_view(search.target, c);
        const TargetCorners& corners = search.corners;
        const double bend = corners.bend * (corners.scales.empty() ? 1.0 : double{corners.scales[c]});
        const std::span<uint8_t> marks(&search.marks[search.target.offsets()[c]], curve.count);
        const CornerCount count = co_await find_corners(pace, curve, {corners.angle_rad, bend}, marks);
        std::construct_at(&search.counts[c], count);
        co_await pace;
    }
}

struct Measuring {
    const CurveSet& target;
    const float* scales;
    TargetPieces& pieces;
};

Task<void> split_batch(Pace& pace, Measuring& measuring, uint32_t batch) {
    const CurveSet& target = measuring.target;
    const CurveRange range = curves_of_batch(target, batch);
    for (uint32_t c = range.first; c < range.last; ++c) {
        const std::span<CurvePiece> pieces = measuring.pieces.of(c);
        if (pieces.empty()) continue;
        const float* scales = measuring.scales ? measuring.scales + target.offsets()[c] : nullptr;
        co_await split_at_corners(pace, curve_view(target, c), scales, pieces);
        co_await pace;
    }
}

uint32_t whole_steps(double steps) {
    return static_cast<uint32_t>(std::min(steps, steps_max));
}

}  // namespace

Task<TargetPieces> find_pieces(Pace& pace, std::shared_ptr<const CurveSet>& target, TargetCorners corners) {
    pace.stage("corners");
    const uint32_t curves = target->curve_count();
    Search search{*target, corners, Buffer<CornerCount>(curves, pace.memory()),
                  Buffer<uint8_t>(target->point_count(), pace.memory())};
    co_await fork(pace, batch_count(*target), &search_batch, search);
    const Buffer<CornerCount>& counts = search.counts;
    TargetPieces found;
    found.offsets = Buffer<uint32_t>(curves + size_t{1}, pace.memory());
    uint32_t count = 0;
    co_await each(pace, curves, Cost::some_ns, [&](uint32_t c) {
        found.offsets[c] = count;
        const uint32_t of_curve = counts[c].corners;
        count += of_curve > 0 && !target->closed(c) ? of_curve + 1 : of_curve;
    });
    found.offsets[curves] = count;
    found.pieces = Buffer<CurvePiece>(count, pace.memory());
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) { std::construct_at(&found.pieces[i]); });
    // A closed curve begins at a corner, an open one at its end.
    Slice slice(Cost::some_ns);
    for (uint32_t c = 0; c < curves; ++c) {
        const std::span<CurvePiece> pieces = found.of(c);
        if (pieces.empty()) continue;
        const bool closed = target->closed(c);
        size_t piece = closed ? 0 : 1;
        const uint32_t begin = target->offsets()[c], points = target->offsets()[c + 1] - begin;
        const uint32_t first = closed ? counts[c].first_segment : 0;
        for (Portion part(slice, 0, points); part.next();) {
            for (uint32_t i = part.begin; i < part.end; ++i) {
                if (search.marks[begin + i] != 0) pieces[piece++].first_segment = i - first;
            }
            if (part.is_over()) co_await pace;
        }
    }
    target = co_await begin_at_corners(pace, std::move(target), {counts.data(), counts.size()});
    co_return found;
}

Task<TargetPieces> copy_pieces(Pace& pace, const TargetPieces& pieces) {
    TargetPieces copy;
    copy.offsets = Buffer<uint32_t>(pieces.offsets.size(), pace.memory());
    copy.pieces = Buffer<CurvePiece>(pieces.pieces.size(), pace.memory());
    co_await each(pace, copy.offsets.size(), Cost::some_ns, [&](uint32_t c) { copy.offsets[c] = pieces.offsets[c]; });
    co_await each(pace, copy.pieces.size(), Cost::tens_of_ns,
                  [&](uint32_t i) { std::construct_at(&copy.pieces[i], pieces.pieces[i]); });
    co_return copy;
}

Task<void> measure_pieces(Pace& pace, const CurveSet& target, const float* step_scales, TargetPieces& pieces) {
    Measuring measuring{target, step_scales, pieces};
    co_await fork(pace, batch_count(target), &split_batch, measuring);
}

Task<void> fit_pieces(Pace& pace, CornerFit fit, double spacing, std::span<CurvePiece> pieces, std::span<float> across,
                      SamplingPlan& plan) {
    const bool closed = plan.curve.closed;
    const auto nearest = [&](const CurvePiece& piece) { return even_step_count(piece.length, spacing, false); };
    const double length = plan.step_scales ? plan.scaled_length : plan.measure.length;
    // Closed results have three points.
    const double least = closed && pieces.size() < 3 ? 3 : 1;
    const bool as_wanted = closed || fit.motifs || plan.steps == even_step_count(length, spacing, false);
    double steps = 0, passed = 0;
    co_await each(pace, pieces.size(), Cost::hundreds_of_ns, [&](uint32_t p) {
        CurvePiece& piece = pieces[p];
        passed += piece.length;
        double own = std::max(nearest(piece), least);
        if (fit.motifs) {
            const bool starts = !closed && p == 0, ends = !closed && p + 1 == pieces.size();
            const StrokeCaps caps{starts || fit.caps ? fit.graph->start_cap : 0,
                                  ends || fit.caps ? fit.graph->end_cap : 0};
            const StrokeFit stroke = fit_stroke(*fit.graph, caps, fit.stroke, piece.length / spacing, whole_steps(own));
            own = std::max<double>(stroke.steps, least);
            across[p] = stroke.across;
        } else if (!as_wanted) {
            own = std::max(std::floor(plan.steps * (passed / length) + 0.5) - steps, 1.0);
        }
        piece.step = piece.length / own;
        steps += own;
        piece.end_step = whole_steps(steps);
    });
    plan.steps = whole_steps(steps);
    plan.pieces = pieces;
}

// At the piece's end, or at its start: the smaller one of both sides.
float PieceSizes::neighbour(bool next) const {
    const auto count = static_cast<uint32_t>(across_.size());
    const bool is_end = !closed_ && (next ? piece_ + 1 == count : piece_ == 0);
    if (is_end) return across_[piece_];
    const uint32_t other = next ? (piece_ + 1) % count : (piece_ + count - 1) % count;
    return std::min(across_[piece_], across_[other]);
}

float PieceSizes::at(uint32_t sample) {
    if (across_.empty()) return 1;
    while (piece_ + 1 < across_.size() && sample >= pieces_[piece_].end_step) ++piece_;
    const uint32_t begin = piece_ > 0 ? pieces_[piece_ - 1].end_step : 0;
    const float r = static_cast<float>(sample - begin) / static_cast<float>(pieces_[piece_].end_step - begin);
    const float inwards = 2 * std::min(r, 1 - r);
    const float at_end = neighbour(r > 0.5f);
    return at_end + (across_[piece_] - at_end) * (inwards * inwards * (3 - 2 * inwards));
}

}  // namespace flg
