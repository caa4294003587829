// SPDX-License-Identifier: MIT
// Contours that are their own mirror images: the axis, and outlines that are exactly so.
//
// The axis goes through the middle of the area, and turns all complex moments of the area, the integrals of z^n, to the
// real line: the largest of them has a few angles where that may be, the others and the line itself tell whether it is.
// Of several axes the one along the shape is taken, of those alike the most upright. Contours with holes count as
// without an axis.
#pragma once

#include <optional>

#include "runtime/task.h"
#include "skeletons/contour.h"

namespace flg {

struct MirrorAxis {
    Point2 at, along;  // along: of length 1

    // How far to the left of the axis.
    double side(const Point2& p) const { return along.x * (p.y - at.y) - along.y * (p.x - at.x); }
    Point2 image(const Point2& p) const { return moved(p, -2 * side(p)); }
    Point2 on_axis(const Point2& p) const { return moved(p, -side(p)); }

private:
    Point2 moved(const Point2& p, double left) const { return {p.x - left * along.y, p.y + left * along.x}; }
};

struct ContourArea {
    double area;
    Point2 centroid;
};
// Of all rings together. About 10 ns a point.
Task<ContourArea> area_within(Pace& pace, const Contour& contour);

// None where the line and its image are farther apart than `tolerance` somewhere. Takes about 0.3 us a point, and
// 0.1 ms for a line that has an axis.
Task<std::optional<MirrorAxis>> find_mirror(Pace& pace, const Contour& contour, double tolerance);

// What is to the left of the axis, closed along it; nothing where the line crosses the axis more than twice.
Task<std::optional<Contour>> left_half(Pace& pace, const Contour& contour, MirrorAxis axis);

// How near a left half comes to the axis, but for its first and last `reach`: half as wide as a gap between a shape and
// its image there.
Task<double> gap_at_axis(Pace& pace, const Contour& half, MirrorAxis axis, double reach);

// A left half and its image. Where the line crosses the axis about at right angles, to within `tolerance`, no point is.
Task<Contour> with_image(Pace& pace, const Contour& half, MirrorAxis axis, double tolerance);

}  // namespace flg
