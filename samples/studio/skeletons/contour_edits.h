// SPDX-License-Identifier: MIT
// Points of a contour that are moved, added and removed one at a time.
#pragma once

#include "skeletons/contour.h"

namespace flg::studio {

struct ContourPoint {
    uint32_t ring = 0, index = 0;
    bool operator==(const ContourPoint&) const = default;
};

// How far the points of a ring follow one that is moved: 1 there, 0 from `reach` on, measured along the ring, so that
// the other side of a thin limb stays. 0: it moves alone.
std::vector<double> follow_shares(const Ring& ring, uint32_t point, double reach);
Contour with_point_moved(const Contour& contour, ContourPoint point, const glm::dvec2& by, double reach);
// Between a point and the next one.
Contour with_point_after(const Contour& contour, ContourPoint point, const glm::dvec2& at);
// The ring must keep three points.
Contour without_point(const Contour& contour, ContourPoint point);

// To so many digits that a thousandth of the spacing counts: drawings are read by people too.
glm::dvec2 rounded(const glm::dvec2& point, double spacing);

}  // namespace flg::studio
