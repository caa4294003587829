// SPDX-License-Identifier: MIT
// Contours for the tests, and their skeletons.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "runtime/run_now.h"
#include "skeletons/skeleton_checks.h"
#include "skeletons/straight_skeleton.h"

namespace flg::test {

using Rings = std::vector<std::vector<Point2>>;

inline Contour contour_of(const Rings& rings) {
    std::vector<Point2> points;
    std::vector<uint32_t> offsets = {0};
    for (const auto& ring : rings) {
        points.insert(points.end(), ring.begin(), ring.end());
        offsets.push_back(static_cast<uint32_t>(points.size()));
    }
    return clean_contour(points, offsets, std::pmr::new_delete_resource());
}

inline StraightSkeleton skeleton_of(const Contour& contour, bool haltingly = false) {
    StraightSkeleton skeleton(std::pmr::new_delete_resource());
    run_now(
        std::pmr::new_delete_resource(), [&](Pace& pace) { return straight_skeleton(pace, contour, skeleton); },
        haltingly);
    return skeleton;
}

inline std::string joined(const std::vector<std::string>& sentences) {
    std::string all;
    for (const std::string& s : sentences) all += s + "; ";
    return all;
}

// With all invariants checked.
inline StraightSkeleton checked_skeleton(const Rings& rings, double tolerance = 1e-9) {
    const Contour contour = contour_of(rings);
    StraightSkeleton skeleton = skeleton_of(contour);
    EXPECT_EQ(joined(broken_invariants(contour, skeleton, tolerance)), "");
    return skeleton;
}

}  // namespace flg::test
