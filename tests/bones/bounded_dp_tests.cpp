// SPDX-License-Identifier: MIT
// BoundedDP against the paper's algorithms as they are written, and against shapes whose joints are known.
#include <cmath>

#include "bones/parts.h"
#include "reference/literal_bounded_dp.h"

namespace flg::test {
namespace {

// Whether a bone crosses all slices between its ends, and no edge of the contour: written once more, with lines in
// full.
bool is_inside(const Contour& contour, const std::vector<AxisSample>& samples, size_t first, size_t last) {
    const Point2 &a = samples[first].at, &b = samples[last].at;
    for (size_t i = first + 1; i < last; ++i) {
        const AxisSample& s = samples[i];
        // a + t (b - a) is on the slice's line where the distance along the axis is none.
        const double dx = b.x - a.x, dy = b.y - a.y;
        const double ahead = dx * s.left_of.y - dy * s.left_of.x;
        const double t = ((s.at.x - a.x) * s.left_of.y - (s.at.y - a.y) * s.left_of.x) / ahead;
        if (!(ahead > 0) || t < 0 || t > 1) return false;
        const Point2 at = {a.x + t * dx, a.y + t * dy};
        const double left = (at.x - s.at.x) * s.left_of.x + (at.y - s.at.y) * s.left_of.y;
        if (left > s.left || -left > s.right) return false;
    }
    for (uint32_t i = 0; i < contour.size(); ++i)
        if (stretches_meet(a, b, contour.points[i], contour.points[contour.next(i)])) return false;
    return true;
}

TEST(BoundedDp, KeepsWhatThePapersAlgorithmsKeep) {
    size_t branches = 0, joints = 0;
    for (const Contour& contour : some_contours()) {
        const PartSkeleton part = part_of(contour, 0.01 * size_of(contour));
        for (size_t b = 0; b < part.branches.size(); ++b) {
            const std::vector<AxisSample> samples = samples_of(part, b);
            for (const double share : {0.5, 0.02, 0.002}) {
                const double threshold = share * size_of(contour);
                const std::vector<bool> kept = reference::bounded_dp(
                    samples, threshold, 0.3, [&](size_t i, size_t k) { return is_inside(contour, samples, i, k); });
                std::vector<uint32_t> expected;
                for (uint32_t i = 0; i < samples.size(); ++i)
                    if (kept[i]) expected.push_back(i);
                ASSERT_EQ(joints_of(contour, samples, threshold, 0.3), expected);
                ++branches;
                joints += expected.size();
            }
        }
    }
    EXPECT_GT(branches, 1000u);
    EXPECT_GT(joints, 3 * branches);
}

TEST(BoundedDp, NeverLeavesTheShapeHoweverCoarse) {
    for (const Contour& contour : some_contours()) {
        if (skeleton_of(contour).perturbation > 0) continue;
        const PartSkeleton part = part_of(contour, 0.01 * size_of(contour));
        for (size_t b = 0; b < part.branches.size(); ++b) {
            const std::vector<AxisSample> samples = samples_of(part, b);
            const std::vector<uint32_t> joints = joints_of(contour, samples, 10 * size_of(contour), 1);
            ASSERT_EQ(joints.front(), 0u);
            ASSERT_EQ(joints.back(), samples.size() - 1);
            for (size_t i = 1; i < joints.size(); ++i)
                ASSERT_TRUE(is_in_shape(contour, samples[joints[i - 1]].at, samples[joints[i]].at));
        }
    }
}

TEST(BoundedDp, AStraightBarHasNoInnerJoint) {
    const Contour contour = contour_of({{{0, 0}, {10, 0}, {10, 1}, {0, 1}}});
    const PartSkeleton part = part_of(contour, 0.1);
    EXPECT_EQ(joints_of(contour, samples_of(part, 0), 1e-9, 1).size(), 2u);
}

TEST(BoundedDp, AnElbowHasAJointWhereItBends) {
    const Contour contour = contour_of({{{0, 0}, {10, 0}, {10, 10}, {9, 10}, {9, 1}, {0, 1}}});
    const PartSkeleton part = part_of(contour, 0.05, 0.1);
    ASSERT_EQ(part.branches.size(), 1u);
    const std::vector<AxisSample> samples = samples_of(part, 0);
    const std::vector<uint32_t> joints = joints_of(contour, samples, 10, 0);
    ASSERT_GE(joints.size(), 3u) << "without one the bone would leave the shape";
    double nearest = 1e9;
    for (const uint32_t j : joints) nearest = std::min(nearest, distance(samples[j].at, {9.5, 0.5}));
    EXPECT_LT(nearest, 0.5);
}

TEST(BoundedDp, TheShapeCountsByItsWeight) {
    // A straight axis; but the shape has a waist.
    const Contour contour = contour_of({{{0, -2}, {10, -0.5}, {20, -2}, {20, 2}, {10, 0.5}, {0, 2}}});
    const PartSkeleton part = part_of(contour, 0.1);
    ASSERT_EQ(part.branches.size(), 1u);
    const std::vector<AxisSample> samples = samples_of(part, 0);
    EXPECT_EQ(joints_of(contour, samples, 0.1, 0).size(), 2u);
    const std::vector<uint32_t> joints = joints_of(contour, samples, 0.3, 1);
    ASSERT_EQ(joints.size(), 3u);
    EXPECT_NEAR(samples[joints[1]].at.x, 10, 0.1);
}

TEST(BoundedDp, FinerThresholdsKeepMore) {
    const Contour contour = contour_of(spiral(80));
    const PartSkeleton part = part_of(contour, 0.005 * size_of(contour));
    for (size_t b = 0; b < part.branches.size(); ++b) {
        const std::vector<AxisSample> samples = samples_of(part, b);
        size_t before = 0;
        for (double threshold = size_of(contour); threshold > 1e-4 * size_of(contour); threshold *= 0.5) {
            const size_t joints = joints_of(contour, samples, threshold, 0.25).size();
            EXPECT_GE(joints, before);
            before = joints;
        }
    }
}

TEST(BoundedDp, SameBitsWithPauses) {
    const Contour contour = contour_of(random_tour(6, 120));
    const PartSkeleton part = part_of(contour, 0.01 * size_of(contour));
    for (size_t b = 0; b < part.branches.size(); ++b) {
        const std::vector<AxisSample> samples = samples_of(part, b);
        EXPECT_EQ(joints_of(contour, samples, 0.01, 1), joints_of(contour, samples, 0.01, 1, true));
    }
}

}  // namespace
}  // namespace flg::test
