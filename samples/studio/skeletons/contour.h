// SPDX-License-Identifier: MIT
// Closed lines as they are drawn by hand: made even, and looked at for what is wrong with them. In the units of a
// drawing.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

namespace flg::studio {

using Ring = std::vector<glm::dvec2>;

// Ring 0 is the outline, the others are holes in it. Never changes once it is a part's; copies of drawings share it.
struct Contour {
    std::vector<Ring> rings;
};
using ContourPtr = std::shared_ptr<const Contour>;

// The closed line that a hand meant by a path: ends that overshoot each other are cut where they cross, what is open is
// closed by a straight line, points are about `spacing` apart and the hand's tremor is smoothed away. Empty if the path
// is no larger than some times the spacing, a click that is.
Ring ring_of_path(std::span<const glm::dvec2> path, double spacing);

double area_of(const Ring& ring);  // not negative
double length_of(const Ring& ring);
glm::dvec2 centre_of(const Ring& ring);  // of the area
// Half the width of a strip, and about the radius of what is round.
double radius_of(const Ring& ring);
bool is_inside(const Ring& ring, const glm::dvec2& point);

// Where edges cross, at most so many places; none for contours of more points than can be tried in a frame.
std::vector<glm::dvec2> crossings_of(const Contour& contour, size_t most);

}  // namespace flg::studio
