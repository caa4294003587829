// SPDX-License-Identifier: MIT
// The smooth curve through a polyline's points, segment by segment, in one pass and constant memory.
//
// G1 piecewise cubic: at a vertex the curve has the direction of the circle through it and its two neighbours. Turns of
// more than 50 degrees are corners; there, and at open ends, a segment ends as the circular arc that its other end
// begins (that tangent mirrored at the chord), or along its chord if both ends are such. Points repeated in a row count
// once. Hence straight runs stay straight, circles round to fourth order, corners sharp.
#pragma once

#include <array>

#include "curves/segment_block.h"

namespace flg {

// Points as they lie in a curve set's POSITION column: three floats each, tightly packed, all finite. `count` >= 1.
struct CurveView {
    const float* positions = nullptr;
    uint32_t count = 0;
    bool closed = false;  // the last point is joined to the first

    const float* raw(uint32_t i) const { return positions + 3 * static_cast<size_t>(i); }
    Vec3 point(uint32_t i) const { return load_vec3(raw(i)); }
    // The point after i; the first one after the last.
    uint32_t following(uint32_t i) const { return i + 1 < count ? i + 1 : 0; }
    bool same_point(uint32_t i, uint32_t j) const {
        const float* a = raw(i);
        const float* b = raw(j);
        return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
    }
};

// Of 50 degrees: edges that turn by more meet in a corner. Live strokes go by the same rule.
constexpr double corner_cosine = 0.6427876096865394;

class SegmentStream {
public:
    explicit SegmentStream(const CurveView& curve);

    // Goes on by a point, on the whole; true when segment() has become the next one. Not to be called when done().
    bool advance() {
        if (next_ == ready_) return refill();
        current_ = next_++;
        return true;
    }
    // Instead of advance(), for those who take blocks as they are: all segments that become known by reading on, number
    // `first` to `last` - 1 of block(). None: to be called again.
    struct Range {
        uint32_t first = 0, last = 0;
    };
    Range take() {
        if (!refill()) return {};
        const Range range{current_, ready_};
        current_ = ready_ - 1;
        next_ = ready_;
        return range;
    }
    const SegmentBlock& block() const { return block_; }
    // As index(), of a segment of the block.
    uint32_t index_of(uint32_t j) const { return indices_[j]; }

    // No segment follows the current one. A curve without length is done before its first.
    bool done() const { return next_ == ready_ && ended_; }

    Segment segment() const { return {block_, current_}; }
    // The segment runs from point index() of the polyline to the one after it.
    uint32_t index() const { return indices_[current_]; }

private:
    // Vertices, and so the ends of two segments.
    enum Kind : uint8_t { corner, smooth };

    bool refill();
    void find_closing_edge();
    uint32_t take_edges();
    uint32_t read_points();
    void make_vertices(uint32_t points);
    void make_tangents(uint32_t count);

    CurveView curve_;
    // Edge 0 is the one that was waiting for the point after its end.
    SegmentBlock block_;
    SegmentBlock::Vectors vertices_;  // the tangents at smooth ones; vertex j is where edge j begins
    std::array<Kind, SegmentBlock::size> kinds_;
    std::array<uint32_t, SegmentBlock::size> indices_;
    bool all_smooth_ = true;
    uint32_t current_ = 0;
    uint32_t next_ = 0;  // of the block's segments
    uint32_t ready_ = 0;
    uint32_t cursor_ = 1;  // points read so far; on a closed curve goes on around
    uint32_t before_ = 0;  // closed: the next candidate for the point before the first
    uint32_t last_read_ = 0;
    uint32_t carried_ = 0;      // the edge and vertex with this number go on into the next block
    bool has_edge_ = false;     // edge 0 is one
    bool hidden_edge_ = false;  // but only there for the tangent at its end: a closed curve's last
    bool around_ = false;       // a closed curve has been read around to its second point
    bool ended_ = false;
};

}  // namespace flg
