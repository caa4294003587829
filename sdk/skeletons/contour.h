// SPDX-License-Identifier: MIT
// Contours: what is drawn around a shape, and around the holes in it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/failure.h"
#include "core/memory.h"
#include "runtime/task.h"
#include "skeletons/contour_fault.h"
#include "skeletons/point2.h"

namespace flg {

// Rings without repeated ends: the first goes around the shape counter-clockwise, the others around holes clockwise.
struct Contour {
    explicit Contour(Memory* memory) : points(memory), input_points(memory), offsets(memory) {}

    uint32_t size() const { return static_cast<uint32_t>(points.size()); }
    uint32_t ring_count() const { return static_cast<uint32_t>(offsets.size()) - 1; }
    // The ring that a point is on.
    uint32_t ring_of(uint32_t point) const;
    // The point after it on its ring.
    uint32_t next(uint32_t point) const;

    std::pmr::vector<Point2> points;
    std::pmr::vector<uint32_t> input_points;  // one a point: which it was before it was cleaned
    std::pmr::vector<uint32_t> offsets;       // where each ring begins, and the end
    uint32_t pieces_left_out = 0;             // by its repair
};

// Makes a contour of rings as they were drawn, ring r from point offsets[r] to the next offset: each is turned as it
// has to be, and of points nearer to each other than 1e-11 of the size of all that follow each other the first is
// kept. Points on one line with those around them stay. Throws for rings of fewer than three points or no area (all
// points within 1e-10 of its size of one line) and for numbers that are not finite or whose squares are not; whether
// rings cross is found when they are triangulated. Linear in the points, which outlive the task.
Task<Contour> clean_contour(Pace& pace, std::span<const Point2> points, std::span<const uint32_t> offsets);
// At once.
Contour clean_contour(std::span<const Point2> points, std::span<const uint32_t> offsets, Memory* memory);

// The rings as they are, for what repairs them: only numbers are checked, and that not all are in one place. Rings of
// fewer than three points are left out, but for the first.
Contour gather_contour(std::span<const Point2> points, std::span<const uint32_t> offsets, Memory* memory);

// A sentence that says what is wrong, and where.
Failure describe_fault(const Contour& contour, const ContourFault& fault);

// Whether the stretch from a to b meets one of the edges [begin, end), which are numbered by the points they begin at.
// Exact. About 10 ns an edge.
inline bool meets_edges(const Contour& contour, const Point2& a, const Point2& b, uint32_t begin, uint32_t end) {
    for (uint32_t ring = contour.ring_of(begin); begin < end; ++ring) {
        const uint32_t ring_end = contour.offsets[ring + 1], stop = std::min(end, ring_end);
        for (; begin < stop; ++begin) {
            const uint32_t next = begin + 1 == ring_end ? contour.offsets[ring] : begin + 1;
            if (stretches_meet(a, b, contour.points[begin], contour.points[next])) return true;
        }
    }
    return false;
}

}  // namespace flg
