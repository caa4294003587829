// SPDX-License-Identifier: MIT
// Parts that are about as wide as long: the balls and cones around their bones miss the corners, so these are held
// against the outline, and against how far the inflated part comes out of its plane there.
#pragma once

#include "core/vec.h"
#include "runtime/task.h"
#include "skeletons/contour.h"

namespace flg {

struct WidePart {
    const Contour* outline = nullptr;  // null: the part is a long one
    Eigen::Matrix<double, 3, 4> placement;
    double scale = 1, thickness = 1;
    double widest = 0;  // clearance, in the drawing
};

// Whether a part counts as wide, by the area within and the length of its outline.
inline bool is_wide(double area, double length) {
    constexpr double of_a_square = 0.5;
    return area >= of_a_square * length * length / 16;
}

// How far a point of the drawing is from the outline, below 0: outside. Takes about 5 ns an edge.
Task<double> depth_in(Pace& pace, const Contour& outline, Point2 at);

// How far an inflated part comes out of its plane where it is so deep inside, by the drawing's unit.
double height_over(double depth, double widest, double thickness);

// Whether a ball meets the part.
Task<bool> meets_ball(Pace& pace, const WidePart& part, Vec3 centre, double radius);

}  // namespace flg
