// SPDX-License-Identifier: MIT
#include "curves/block_sampler.h"

#include <algorithm>

#include "curves/step_scale.h"

namespace flg {

BlockSampler::BlockSampler(const CurveView& curve, double length, uint32_t steps, const float* scales)
    : stream_(curve), curve_(curve), steps_(steps), step_(steps > 0 ? length / steps : 0), scales_(scales) {}

BlockSampler::BlockSampler(const CurveView& curve, double step, const float* scales)
    : stream_(curve), curve_(curve), steps_(no_end), step_(step), scales_(scales) {}

BlockSampler::BlockSampler(const CurveView& curve, uint32_t steps, const float* scales,
                           std::span<const CurvePiece> pieces)
    : stream_(curve), curve_(curve), steps_(steps), step_(1), scales_(scales), pieces_(pieces) {}

bool BlockSampler::next(SampleBlock& out, uint32_t& units) {
    out.count = 0;
    if (steps_ == 0) {
        // A curve without length has no direction; any will do.
        while (!stream_.done()) {
            if (units == 0) return false;
            --units;
            stream_.take();
        }
        out.count = 1;
        out.segment[0] = 0;
        out.t[0] = 0;
        out.set_place(0, curve_.raw(curve_.closed ? 0 : curve_.count - 1), Vec3::UnitX());
        return true;
    }
    if (units == 0) return false;
    const uint32_t first = next_;
    bool has_end = false;
    for (;;) {
        fill(out);
        has_end = add_end(out);
        if (out.count > 0) break;
        if (units == 0 || !read_on(units)) return false;
    }
    units -= std::min(units, out.count);
    find_places(starts_.data(), first, step_, out);
    for (uint32_t k = 0; k < out.count; ++k) out.segment[k] = stream_.index_of(static_cast<uint32_t>(out.row[k]));
    if (scales_ || !pieces_.empty()) scale_places(out);
    place_samples(rows_, out);
    if (has_end) {
        const uint32_t last = out.count - 1;
        out.t[last] = 1;
        out.set_place(last, curve_.raw(curve_.closed ? 0 : curve_.count - 1), stream_.segment().tangent_end());
    }
    return true;
}

// The samples of the segments that are there, as many as there is room for.
void BlockSampler::fill(SampleBlock& out) {
    uint32_t row = row_, next = next_, filled = out.count;
    while (row < last_row_) {
        const uint32_t stop = stops_[row];
        const uint32_t count = std::min(stop - next, SampleBlock::capacity - filled);
        int32_t* rows = out.row + filled;
        // Most segments have no more than two: the block has room for them, and there is no branch to be guessed.
        rows[0] = rows[1] = static_cast<int32_t>(row);
        for (uint32_t k = 2; k < count; ++k) rows[k] = static_cast<int32_t>(row);
        filled += count;
        next += count;
        if (next < stop) break;
        ++row;
    }
    row_ = row;
    next_ = next;
    out.count = filled;
}

// The sample at the curve's end, if it is time.
bool BlockSampler::add_end(SampleBlock& out) {
    if (next_ != steps_ || row_ < last_row_ || !stream_.done() || out.count == SampleBlock::capacity) return false;
    out.row[out.count++] = static_cast<int32_t>(last_row_ - 1);
    ++next_;
    return true;
}

// From steps to metres.
void BlockSampler::scale_places(SampleBlock& out) const {
    for (uint32_t k = 0; k < out.count; ++k) {
        const auto row = static_cast<uint32_t>(out.row[k]);
        const double length = stream_.block().lengths[row];
        if (!pieces_.empty()) out.along[k] = static_cast<float>(out.along[k] * row_steps_[row]);
        if (scales_) out.along[k] = step_scale(curve_, scales_, out.segment[k]).place(length, out.along[k]);
    }
}

bool BlockSampler::read_on(uint32_t& units) {
    const SegmentStream::Range range = stream_.take();
    units -= std::min(units, range.last - range.first + 1);
    if (range.first == range.last) return units > 0;
    const SegmentBlock& block = stream_.block();
    make_rows(block, range.first, range.last, rows_);
    const auto add = [&](const auto& length_of) {
        double end = end_;
        for (uint32_t j = range.first; j < range.last; ++j) {
            starts_[j] = end;
            end += length_of(j);
            ends_[j] = end;
        }
        end_ = end;
    };
    if (!pieces_.empty())
        add_pieces(range);
    else if (scales_)
        add([&](uint32_t j) { return step_scale(curve_, scales_, stream_.index_of(j)).steps(block.lengths[j]); });
    else
        add([&](uint32_t j) { return block.lengths[j]; });
    find_stops(ends_.data(), range.first, range.last, step_, stops_.data());
    // What the arc length comes to has no samples behind it.
    if (stream_.done()) stops_[range.last - 1] = steps_;
    row_ = range.first;
    last_row_ = range.last;
    return true;
}

// Pieces end at whole steps, to the bit.
void BlockSampler::add_pieces(SegmentStream::Range range) {
    const SegmentBlock& block = stream_.block();
    for (uint32_t j = range.first; j < range.last; ++j) {
        const CurvePiece& piece = pieces_[piece_];
        const uint32_t index = stream_.index_of(j);
        const double length = scales_ ? step_scale(curve_, scales_, index).steps(block.lengths[j]) : block.lengths[j];
        starts_[j] = end_;
        end_ = std::min(end_ + length / piece.step, static_cast<double>(piece.end_step));
        if (index == piece.last_segment) {
            end_ = piece.end_step;
            piece_ += piece_ + 1 < pieces_.size() ? 1 : 0;
        }
        ends_[j] = end_;
        row_steps_[j] = piece.step;
    }
}

}  // namespace flg
