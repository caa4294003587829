// SPDX-License-Identifier: MIT
// Drawn lines made even and short (Ma, Wang, Li, Zhang: Real-time skeletonization for sketch-based modeling, 2021, sec.
// 3.1): points at equal distances smooth a hand's noise out, then the algorithm of Douglas and Peucker keeps those that
// matter.
#pragma once

#include <vector>

#include "skeletons/contour.h"

namespace flg {

// The length of a ring, closed.
class RingLength {
public:
    RingLength(const Contour& contour, uint32_t ring)
        : contour_(&contour), at_(contour.offsets[ring]), end_(contour.offsets[ring + 1]), before_(end_ - 1) {}

    // A unit is a point, about 3 ns.
    bool run(uint32_t count);
    double length() const { return length_; }

private:
    const Contour* contour_;
    uint32_t at_, end_, before_;
    double length_ = 0;
};

// All rings with points every `spacing` along them; the spacing of each is rounded so that a whole number of at least 8
// fits. Points that an edge as long as that begins or ends at are corners that somebody meant: they stay, and each
// stretch between two of them begins anew. Lines drawn by hand have points much nearer to each other, and no such
// corners.
class EvenContour {
public:
    // `out` has no points yet, and is complete when run() returns true. Throws if it would have more than 2^24 points.
    EvenContour(const Contour& contour, double spacing, Contour& out);

    // A unit is a point that is read or made, about 10 ns.
    bool run(uint32_t count);

private:
    void begin_points();
    void add_point();
    bool is_corner(uint32_t edge) const;

    const Contour& contour_;
    double spacing_;
    Contour& out_;
    uint32_t ring_ = 0;
    RingLength length_;
    uint32_t edge_ = 0;  // of the ring
    double begin_ = 0;   // how far from the last corner the edge begins
    double step_ = 0;
    uint32_t made_ = 0;    // since that corner
    uint32_t wanted_ = 0;  // no points are wanted before the ring's length is known
};

// Of all rings the points that are needed to stay within `tolerance` of them (Douglas, Peucker 1973). A ring is halved
// at the point farthest from the middle of its points and the point farthest from that one, so that it doesn't matter
// where it begins. A ring keeps at least three points.
class SimplifiedContour {
public:
    // `out` has no points yet, and is complete when run() returns true.
    SimplifiedContour(const Contour& contour, double tolerance, Contour& out, Memory* memory);

    // A unit is 16 points looked at, about 50 ns. About n log n points in all on drawings, n squared at worst.
    bool run(uint32_t count);

private:
    struct Range {
        uint32_t begin, end;  // places on the ring that are kept; the end may be beyond the ring's, and begins it anew
        bool must_split;
    };
    enum class Pass { middle, first, second, scan, collect, done };

    void begin_ring();
    void step();
    void scan(uint32_t end);
    void end_range();
    void enter(Pass pass) {
        pass_ = pass;
        at_ = 0;
        most_ = -1;
        farthest_ = 0;
    }
    uint32_t place(uint32_t at) const { return begin_ + (at >= size_ ? at - size_ : at); }
    const Point2& point(uint32_t at) const { return contour_.points[place(at)]; }
    void look(uint32_t at, double distance) {
        if (distance > most_) most_ = distance, farthest_ = at;
    }

    const Contour& contour_;
    double tolerance_;
    Contour& out_;
    std::pmr::vector<bool> kept_;
    std::pmr::vector<Range> ranges_;
    Pass pass_ = Pass::middle;
    uint32_t ring_ = 0, begin_ = 0, size_ = 0;  // the ring and its points
    uint32_t at_ = 0;
    Point2 sum_{}, from_{};
    uint32_t first_ = 0;
    double most_ = -1;
    uint32_t farthest_ = 0;
};

}  // namespace flg
