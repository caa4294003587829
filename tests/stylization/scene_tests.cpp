// SPDX-License-Identifier: MIT
// Styles of several curves: how points are shared out.
#include <gtest/gtest.h>

#include "core/failure.h"
#include "stylization/style_curves.h"
#include "stylization/style_inputs.h"

namespace flg {
namespace {

StyleCurves of_lengths(const std::vector<double>& lengths) {
    StyleCurves curves(test::memory());
    for (double length : lengths) curves.emplace_back(test::memory()).guide_measure.length = length;
    return curves;
}

TEST(SharePoints, OneCurveGetsThemAll) {
    StyleCurves curves = of_lengths({3.3});
    share_points(curves, 600, 10, test::memory());
    EXPECT_EQ(curves[0].steps, 599u);
}

TEST(SharePoints, TheWholeIsExactAndSpacingsAgreeWithinAStep) {
    for (const std::vector<double>& lengths :
         {std::vector<double>{1, 2, 4}, {1, 1, 1}, {0.77, 12.3, 5.5, 5.4, 100}, {1e-3, 7, 7}}) {
        StyleCurves curves = of_lengths(lengths);
        const uint32_t count = 500;
        share_points(curves, count, 10, test::memory());
        double length = 0;
        uint32_t total = 0;
        for (const StyleCurve& curve : curves) {
            length += curve.guide_measure.length;
            total += curve.steps + 1;
        }
        // Curves too short for a step get one.
        EXPECT_GE(total, count);
        EXPECT_LE(total, count + (lengths[0] < 0.01 ? 1 : 0));
        const double spacing = length / (count - static_cast<double>(lengths.size()));
        for (const StyleCurve& curve : curves) {
            EXPECT_NEAR(curve.steps, curve.guide_measure.length / spacing, 1.0);
            EXPECT_GE(curve.steps, 1u);
        }
    }
}

TEST(SharePoints, EqualCurvesShareTheRestInOrder) {
    StyleCurves curves = of_lengths({1, 1, 1});
    share_points(curves, 103, 10, test::memory());
    EXPECT_EQ(curves[0].steps, 34u);
    EXPECT_EQ(curves[1].steps, 33u);
    EXPECT_EQ(curves[2].steps, 33u);
}

TEST(SharePoints, RefusesWhatLeavesNoPatch) {
    const auto words = [](std::vector<double> lengths, uint32_t count, uint32_t patch) -> std::string {
        StyleCurves curves = of_lengths(lengths);
        try {
            share_points(curves, count, patch, test::memory());
        } catch (const Failure& failure) {
            EXPECT_EQ(failure.result(), FLG_ERROR_INVALID_ARGUMENT);
            return failure.what();
        }
        return "";
    };
    EXPECT_EQ(words({1, 1}, 60, 14), "");
    EXPECT_EQ(words({1, 1}, 58, 14),
              "desc.patch is 14: its 29 points must be fewer than the style's longest curve's 29");
    EXPECT_EQ(words({1, 1, 1, 1, 1, 1, 1, 1, 1}, 16, 1),
              "desc.point_count is 16, too few for the 9 curves of desc.style");
}

}  // namespace
}  // namespace flg
