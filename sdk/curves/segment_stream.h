// SPDX-License-Identifier: MIT
// The smooth curve through a polyline's points, segment by segment, in one pass and constant memory.
//
// G1 piecewise cubic: at a vertex the curve has the direction of the circle through it and its two neighbours. Turns of
// more than 50 degrees are corners; there, and at open ends, a segment ends as the circular arc that its other end
// begins (that tangent mirrored at the chord), or along its chord if both ends are such. Points repeated in a row count
// once. Hence straight runs stay straight, circles round to fourth order, corners sharp.
#pragma once

#include "curves/curve_view.h"
#include "curves/hermite_segment.h"

namespace flg {

class SegmentStream {
public:
    explicit SegmentStream(const CurveView& curve);

    // Reads one point; true when segment() has become the next one. Not to be called when done().
    bool advance();
    // No segment follows the current one. A curve without length is done before its first.
    bool done() const { return done_; }

    const HermiteSegment& segment() const { return segment_; }
    // The segment runs from point index() to the one after it.
    uint32_t index() const { return index_; }

private:
    // An end of a segment: with the tangent shared with its neighbour, or sharp.
    struct Vertex {
        Vec3 tangent = Vec3::Zero();
        bool smooth = false;
    };
    // From the one distinct point to the next.
    struct Edge {
        Vec3 direction;
        double length = 0;
        uint32_t index = 0;
    };

    bool find_closing_edge();
    bool read(uint32_t index);
    void make_segment(const Vertex& end);

    CurveView curve_;
    HermiteSegment segment_;
    uint32_t index_ = 0;
    uint32_t cursor_ = 0;   // points read so far; on a closed curve goes on around
    uint32_t before_ = 0;   // closed: the next candidate for the point before the first
    uint32_t current_ = 0;  // the last distinct point read
    Vec3 start_, end_;      // of edge_
    Edge edge_;             // waits for the point after its end
    Vertex edge_start_;
    bool has_edge_ = false;
    bool closing_edge_ = false;  // edge_ is the closed curve's last, seen before its first: gives a tangent only
    bool done_ = false;
};

}  // namespace flg
