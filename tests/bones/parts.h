// SPDX-License-Identifier: MIT
// Parts for the tests, made step by step.
#pragma once

#include "bones/axis.h"
#include "bones/bounded_dp.h"
#include "bones/contour_sampling.h"
#include "runtime/run_now.h"
#include "skeletons/point2.h"
#include "skeletons/random_contours.h"

namespace flg::test {

inline Memory* memory() {
    return std::pmr::new_delete_resource();
}

// What the task that make(pace) returns makes; it pauses at each opportunity if `haltingly`.
template <class Make>
auto made(const Make& make, bool haltingly) {
    return run_now(memory(), make, haltingly);
}

inline AxisGraph axis_of(const Contour& contour, const StraightSkeleton& skeleton, double collapse = 0.5,
                         bool haltingly = false) {
    return made([&](Pace& pace) { return axis_graph(pace, contour, skeleton, collapse); }, haltingly);
}

inline PartSkeleton part_of(const Contour& contour, double spacing, double collapse = 0.5, bool haltingly = false) {
    AxisGraph graph = axis_of(contour, skeleton_of(contour), collapse, haltingly);
    return made([&](Pace& pace) { return axis_branches(pace, contour, std::move(graph), spacing); }, haltingly);
}

inline std::vector<AxisSample> samples_of(const PartSkeleton& part, size_t branch) {
    return {part.samples.begin() + part.branches[branch].begin, part.samples.begin() + part.branches[branch].end};
}

inline std::vector<uint32_t> joints_of(const Contour& contour, const std::vector<AxisSample>& samples, double threshold,
                                       double shape_weight, bool haltingly = false) {
    const auto make = [&](Pace& pace) { return bounded_dp(pace, contour, samples, threshold, shape_weight); };
    const std::pmr::vector<uint32_t> joints = made(make, haltingly);
    return {joints.begin(), joints.end()};
}

// Whether a stretch lies in the shape: its ends by counting crossings, and no edge of the contour touches it.
inline bool is_in_shape(const Contour& contour, const Point2& a, const Point2& b) {
    uint32_t crossings = 0;
    for (uint32_t i = 0; i < contour.size(); ++i) {
        const Point2 &c = contour.points[i], &d = contour.points[contour.next(i)];
        if (stretches_meet(a, b, c, d)) return false;
        if ((c.y > a.y) != (d.y > a.y) && a.x < c.x + (a.y - c.y) / (d.y - c.y) * (d.x - c.x)) ++crossings;
    }
    return crossings % 2 == 1;
}

inline double size_of(const Contour& contour) {
    Point2 low = contour.points[0], high = low;
    for (const Point2& p : contour.points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return distance(low, high);
}

// Some contours of every kind, drawn by chance.
inline std::vector<Contour> some_contours() {
    std::vector<Contour> contours;
    for (uint64_t seed = 1; seed <= 12; ++seed) {
        const auto n = static_cast<uint32_t>(8 + 9 * seed);
        contours.push_back(contour_of(random_star(seed, n)));
        contours.push_back(contour_of(random_tour(seed, n)));
        contours.push_back(contour_of(rotated(grid_tour(seed, n, 12), 0.3)));
        contours.push_back(contour_of(pixel_shape(seed, 8 + static_cast<uint32_t>(seed), false)));
    }
    contours.push_back(contour_of(comb(9, 0.1)));
    contours.push_back(contour_of(gear(12)));
    contours.push_back(contour_of(spiral(60)));
    contours.push_back(contour_of(staircase(9)));
    contours.push_back(contour_of(star_with_holes(3, 40, 3, 7)));
    return contours;
}

}  // namespace flg::test
