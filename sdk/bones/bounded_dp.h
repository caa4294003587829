// SPDX-License-Identifier: MIT
// BoundedDP (Ma, Wang, Li, Zhang 2021, sec. 3.1, Algorithms 1 and 2): which points of a branch's axis become joints. As
// with Douglas and Peucker a stretch is divided at the point of the largest error until that is below a threshold; but
// the error counts the shape as well as the axis,
//     E_i = distance to the chord
//           + shape_weight * (distances of the slice's ends to the sides of the trapezoid between the end slices),
// with the slices put side by side along the straightened axis; and the threshold falls by a fifth until all bones are
// inside of the shape: they cross every slice between the joints, and no edge of the contour.
//
// Departures: Algorithm 1 marks a point before it looks at the threshold; the text, and this, only if the error is
// larger. The weight is in the text and lost in Algorithm 1. A threshold can't fall for ever: after `max_rounds` all
// points are taken.
#pragma once

#include <span>
#include <vector>

#include "bones/axis.h"

namespace flg {

// Of the samples of one branch, two or more: the numbers of those that become joints, the first and the last among
// them.
Task<std::pmr::vector<uint32_t>> bounded_dp(Pace& pace, const Contour& contour, std::span<const AxisSample> samples,
                                            double threshold, double shape_weight);

// Whether a bone from one sample to a later one is inside of the shape.
Task<bool> bone_is_inside(Pace& pace, const Contour& contour, std::span<const AxisSample> samples, uint32_t from,
                          uint32_t to);

}  // namespace flg
